// SPDX-License-Identifier: Apache-2.0
#include "jaws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::controller {
namespace {

constexpr double sealDegrees = 12.0; // to each side of the cut
constexpr double sealScatter = 0.1;
constexpr double radiansPerDegree = std::numbers::pi / 180.0;
constexpr double mmPerMeter = 1000.0;

} // namespace

Jaws::Jaws(const JawOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_random(seed)
{
}

bool Jaws::areIdle() const
{
    return m_options.sealNm == 0.0 && m_options.jams == 0.0 && !m_isBlocked && !m_isJam;
}

void Jaws::setBlocked(bool blocked)
{
    m_isBlocked = blocked;
    m_isJam = blocked;
}

void Jaws::clear()
{
    m_isJam = m_isBlocked;
    m_pressed.reset();
}

void Jaws::draw()
{
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::normal_distribution<double> scatter(1.0, sealScatter);
    m_isJam = m_isBlocked || part(m_random) < m_options.jams;
    m_wasTouched = false;
    m_sealShare = scatter(m_random);
}

double Jaws::moveTo(double degrees, double cut, double tipRadiusMm)
{
    if (!m_hasCut || cut > m_cut) {
        m_hasCut = true;
        m_cut = cut;
        draw();
    }
    return cut == m_cut ? sealNm(degrees) + jamNm(degrees, tipRadiusMm) : 0.0;
}

double Jaws::sealNm(double degrees) const
{
    const double share = std::clamp(degrees / sealDegrees, -1.0, 1.0);
    return m_options.sealNm * m_sealShare * 0.5 * (1.0 + std::cos(share * std::numbers::pi));
}

double Jaws::jamNm(double degrees, double tipRadiusMm)
{
    const double pressed = degrees + m_options.touchDegrees;
    if (!m_isJam || pressed <= 0.0) {
        m_pressed.reset();
        return 0.0;
    }
    if (degrees >= 0.0) {
        ++m_cutThrough;
        m_isJam = false;
        m_pressed.reset();
        return 0.0;
    }
    m_touched += m_wasTouched ? 0u : 1u;
    m_wasTouched = true;
    m_pressed = pressed;
    const double forceN = m_options.stiffnessNPerMm * pressed * radiansPerDegree * tipRadiusMm;
    m_largestForceN = std::max(m_largestForceN, forceN);
    return forceN * tipRadiusMm / mmPerMeter;
}

} // namespace campanel::controller
