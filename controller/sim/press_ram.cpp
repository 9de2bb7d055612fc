// SPDX-License-Identifier: Apache-2.0
#include "press_ram.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::controller {
namespace {

constexpr double topMm = 1.0; // above this position the next work piece is inserted
constexpr std::uint64_t ownSequence = 0x9E3779B97F4A7C15u; // separate from the film's random numbers

} // namespace

PressRam::PressRam(const PressOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_random(seed ^ ownSequence)
{
    nextStroke();
}

void PressRam::nextStroke()
{
    // Always draws all numbers, so that a missing piece does not change the others.
    m_hasPiece = std::uniform_real_distribution<double>(0.0, 1.0)(m_random) >= m_options.missing;
    m_pieceMm =
        m_options.workPieceMm + m_options.workPieceScatterMm * std::normal_distribution<double>()(m_random);
    m_driftMm = m_options.driftMm * std::normal_distribution<double>()(m_random);
}

void PressRam::follow(double motorMm)
{
    const double turn = 2.0 * std::numbers::pi * motorMm / screwPitchMm;
    const double drivenMm =
        motorMm * (1.0 + m_options.leadError) + m_options.screwErrorMm * std::sin(turn) + m_driftMm;
    m_positionMm = std::clamp(m_positionMm, drivenMm - m_options.backlashMm, drivenMm);
    const bool isUp = m_positionMm < topMm;
    if (isUp && !m_isUp)
        nextStroke();
    m_isUp = isUp;
}

double PressRam::scaleMm() const
{
    return std::round(m_positionMm / scaleResolutionMm) * scaleResolutionMm;
}

std::int32_t PressRam::forceN() const
{
    if (!m_hasPiece)
        return 0;
    const double force = m_options.stiffnessNPerMm * std::max(0.0, m_positionMm - m_pieceMm);
    return static_cast<std::int32_t>(std::lround(std::min(force, 1e6)));
}

} // namespace campanel::controller
