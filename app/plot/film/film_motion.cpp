// SPDX-License-Identifier: Apache-2.0
#include "app/plot/film/film_motion.h"

#include <algorithm>
#include <cmath>

namespace campanel::plot {

void FilmMotion::report(double positionMm, double speedMmPerS, double timeS)
{
    const double shownMm = m_positionMm + travelledMm(timeS);
    const double offsetMm = std::remainder(shownMm - positionMm, wrapMm);
    m_offsetMm = m_isKnown && std::abs(offsetMm) <= jumpMm ? offsetMm : 0;
    m_positionMm = positionMm;
    m_speedMmPerS = speedMmPerS;
    m_timeS = timeS;
    m_isKnown = true;
}

double FilmMotion::travelledMm(double timeS) const
{
    const double sinceS = std::clamp(timeS - m_timeS, 0.0, longestS);
    return m_speedMmPerS * sinceS + m_offsetMm * std::max(0.0, 1 - sinceS / blendS);
}

} // namespace campanel::plot
