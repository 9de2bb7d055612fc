// SPDX-License-Identifier: Apache-2.0
// What hangs on the motor of a press: a transmission with error and play, the ram with its scale, and the
// work piece under it. Positions in mm below the upper position.
#pragma once

#include <cstdint>
#include <random>

namespace campanel::controller {

struct PressOptions {
    double workPieceMm = 75.0;       // where the work piece begins
    double workPieceScatterMm = 0.2; // standard deviation of that from piece to piece
    double missing = 0.0;            // share of the strokes that find none
    double stiffnessNPerMm = 200.0;  // of the work piece
    double backlashMm = 0.037;       // between motor and ram
    double travelError = 0.00012;    // the ram goes that much farther than the motor says
    double driftMm = 0.005; // by which heat moves the ram against the motor from stroke to stroke, st. dev.
    double screwErrorMm = 0.001; // and is wrong by this much to both sides within each turn of the screw
};

class PressRam {
public:
    static constexpr double scaleResolutionMm = 0.005;
    static constexpr double screwPitchMm = 10.0;

    PressRam(const PressOptions& options, std::uint64_t seed);

    // The motor stands where it would have moved the ram to without error or play.
    void follow(double motorMm);

    [[nodiscard]] double positionMm() const { return m_positionMm; } // the true one
    [[nodiscard]] double scaleMm() const;                            // as the scale reads it
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
