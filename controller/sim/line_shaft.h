// SPDX-License-Identifier: Apache-2.0
// The main shaft of the line in front of the machine, with an encoder on it or on a wheel that runs on the
// film. Somebody else starts and stops it; its speed ramps, ripples and swings slowly. The encoder has an
// index mark and its own faults. The same options and calls give the same counts, whatever the steps of time.
#pragma once

#include <cstdint>

namespace campanel::controller {

struct ShaftOptions {
    std::uint32_t counts = 0; // of the encoder per revolution, behind quadrature; 0: none
    double revolutionMm = 250.0;
    bool drivesFilm = false;  // and the infeed with it; the encoder is on a wheel on the film
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
    double noise = 0.0;        // share of the edges that come with another one: an illegal transition
};

class LineShaft {
public:
    explicit LineShaft(const ShaftOptions& options);

    [[nodiscard]] bool hasEncoder() const { return m_options.counts != 0; }
    // The speed ramps to this one.
    void setSpeed(double mmPerS);
    void advance(double stepS);
    // Change the encoder's faults; what it has counted before stays.
    void setReversed(bool isReversed);
    void setSlip(double share);
    void setLost(std::uint32_t countsPerRevolution) { m_options.lost = countsPerRevolution; }
    void setNoise(double share) { m_options.noise = share; }
    // Adds half a revolution at once.
    void jump() { m_countsBefore += m_options.counts / 2; }
    // Returns the options with the present speed and faults.
    [[nodiscard]] const ShaftOptions& options() const { return m_options; }

    // Returns the film that should have passed.
    [[nodiscard]] double positionMm() const { return m_positionMm; }
    [[nodiscard]] double speedMmPerS() const { return m_speedMmPerS; }
    // Returns what the encoder has counted since power-up.
    [[nodiscard]] std::int64_t counts() const;
    // Returns the illegal transitions of its signals since then.
    [[nodiscard]] std::uint32_t errors() const { return m_errors; }
    // Return how often its index mark was passed, in either direction, and the counts latched there last.
    [[nodiscard]] std::uint32_t indexPasses() const { return m_indexPasses; }
    [[nodiscard]] std::int64_t indexCounts() const { return m_indexCounts; }

private:
    [[nodiscard]] double swingAt(double timeS) const;
    [[nodiscard]] double turns() const;
    [[nodiscard]] std::int64_t edges() const;
    [[nodiscard]] std::int64_t countsAt(std::int64_t edges) const;
    void passIndex(double before);
    void passNoise(std::int64_t before);

    ShaftOptions m_options;
    double m_timeS = 0.0;
    double m_evenMmPerS; // without ripple and wave
    double m_targetMmPerS;
    double m_speedMmPerS;
    double m_positionMm = 0.0;
    // The encoder since the last change of its slip, or of its direction.
    double m_slipFromMm = 0.0;
    double m_turnedMm = 0.0;
    std::int64_t m_edgesBefore = 0;
    std::int64_t m_countsBefore = 0;
    std::int64_t m_lost = 0; // counts
    std::uint32_t m_errors = 0;
    std::uint32_t m_indexPasses = 0;
    std::int64_t m_indexCounts = 0;
};

} // namespace campanel::controller
