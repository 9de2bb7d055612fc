// SPDX-License-Identifier: Apache-2.0
// The mechanics of a press: a transmission with error and backlash, the ram with its scale, and the work
// piece under it. Positions in mm below the upper position.
#pragma once

#include <cstdint>
#include <random>

namespace campanel::controller {

struct PressOptions {
    double workPieceMm = 75.0;       // upper side of the work piece
    double workPieceScatterMm = 0.2; // standard deviation from piece to piece
    double missing = 0.0;            // share of the strokes without a work piece
    double stiffnessNPerMm = 200.0;  // stiffness of the work piece
    double backlashMm = 0.037;       // between motor and ram
    double leadError = 0.00012;      // the ram moves farther than the motor by this share
    double driftMm = 0.005; // thermal drift between ram and motor from stroke to stroke, standard deviation
    double screwErrorMm = 0.001; // amplitude of the error within each turn of the screw
};

class PressRam {
public:
    static constexpr double scaleResolutionMm = 0.005;
    static constexpr double screwPitchMm = 10.0;

    PressRam(const PressOptions& options, std::uint64_t seed);

    // Sets the motor position, in mm of an ideal ram.
    void follow(double motorMm);

    [[nodiscard]] double positionMm() const { return m_positionMm; } // true position
    [[nodiscard]] double scaleMm() const;                            // position on the scale
    [[nodiscard]] std::int32_t forceN() const;

private:
    void nextStroke();

    PressOptions m_options;
    std::mt19937_64 m_random;
    double m_positionMm = 0.0;
    double m_pieceMm = 0.0;
    double m_driftMm = 0.0;
    bool m_hasPiece = true;
    bool m_isUp = true;
};

} // namespace campanel::controller
