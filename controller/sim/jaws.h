// SPDX-License-Identifier: Apache-2.0
// The jaws of a knife press on a seal at each cut, and now and then on something that lies between them. That
// is a spring along the way of the knife's tip, until the jaws have cut through it or somebody takes it
// out. Angles in degrees of the shaft from the nearest cut, negative before it.
#pragma once

#include <cstdint>
#include <optional>
#include <random>

namespace campanel::controller {

struct JawOptions {
    double sealNm = 0.0;         // largest torque of a seal, which differs from bag to bag by a tenth
    double jams = 0.0;           // share of the cuts with something between the jaws
    double stiffnessNPerMm = 20; // of it
    double touchDegrees = 30.0;  // before the cut the jaws touch it
};

class Jaws {
public:
    Jaws(const JawOptions& options, std::uint64_t seed);

    // Returns true when they never press on anything.
    [[nodiscard]] bool areIdle() const;
    // Moves to this angle from cut number `cut`; returns the torque against the shaft, Nm.
    double moveTo(double degrees, double cut, double tipRadiusMm);
    // Something lies between them at every cut, until this is switched off.
    void setBlocked(bool blocked);
    // Somebody takes out what lies there.
    void clear();
    // Returns how far they have pressed into it, degrees; none: they do not touch it.
    [[nodiscard]] std::optional<double> pressedDegrees() const { return m_pressed; }
    [[nodiscard]] std::uint32_t touched() const { return m_touched; }
    [[nodiscard]] std::uint32_t cutThrough() const { return m_cutThrough; }
    [[nodiscard]] double largestForceN() const { return m_largestForceN; }

private:
    void draw();
    double sealNm(double degrees) const;
    double jamNm(double degrees, double tipRadiusMm);

    JawOptions m_options;
    std::mt19937_64 m_random;
    bool m_isBlocked = false;
    bool m_hasCut = false;
    double m_cut = 0.0;
    bool m_isJam = false;
    bool m_wasTouched = false;
    double m_sealShare = 1.0;
    std::optional<double> m_pressed;
    std::uint32_t m_touched = 0;
    std::uint32_t m_cutThrough = 0;
    double m_largestForceN = 0.0;
};

} // namespace campanel::controller
