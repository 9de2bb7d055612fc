// SPDX-License-Identifier: Apache-2.0
// The main shaft of the line in front of the machine, with an encoder on it or on a wheel that runs on the
// film. Somebody else starts and stops it; its speed ramps, ripples and swings slowly. The encoder has its
// own faults. The same options and calls give the same counts, whatever the steps of time.
#pragma once

#include <cstdint>

namespace campanel::controller {

struct ShaftOptions {
    std::uint32_t counts = 0; // of the encoder per revolution, behind quadrature; 0: none
    double revolutionMm = 250.0;
    double speedMmPerS = 0.0; // at power-up, and of later starts
    double accelerationMmPerS2 = 500.0;
    double ripple = 0.0; // share of the speed
    double rippleHz = 3.0;
    double wave = 0.0; // a slow one, share of the speed
    double wavePeriodS = 10.0;
    // Faults of the encoder.
    double jitterCounts = 0.0; // an edge is off its place by this at most
    bool isReversed = false;   // its wires are swapped
    double slip = 0.0;         // share of the way that a wheel does not turn
    std::uint32_t lost = 0;    // counts lost in each revolution
};

class LineShaft {
public:
    explicit LineShaft(const ShaftOptions& options);

    [[nodiscard]] bool hasEncoder() const { return m_options.counts != 0; }
    // The speed ramps to this one.
    void setSpeed(double mmPerS) { m_targetMmPerS = mmPerS; }
    void advance(double stepS);

    // Returns the film that should have passed.
    [[nodiscard]] double positionMm() const { return m_positionMm; }
    [[nodiscard]] double speedMmPerS() const { return m_speedMmPerS; }
    // Returns what the encoder has counted since power-up.
    [[nodiscard]] std::int64_t counts() const;

private:
    [[nodiscard]] double swingAt(double timeS) const;

    ShaftOptions m_options;
    double m_timeS = 0.0;
    double m_evenMmPerS; // without ripple and wave
    double m_targetMmPerS;
    double m_speedMmPerS;
    double m_positionMm = 0.0;
};

} // namespace campanel::controller
