// SPDX-License-Identifier: Apache-2.0
// Extrapolates the film's position from the last report at its speed, without a jump when the next report
// differs slightly.
#pragma once

namespace campanel::plot {

class FilmMotion {
public:
    // Sets the position and the speed of the film at `timeS` of any steady clock. Positions wrap at wrapMm.
    void report(double positionMm, double speedMmPerS, double timeS);
    void forget() { *this = {}; }

    // Returns mm since the last report; limited to one second after it at any speed.
    [[nodiscard]] double travelledMm(double timeS) const;

    static constexpr double wrapMm = 4294967.296; // the controller sends 32 bits of micrometers
    static constexpr double jumpMm = 40;          // larger differences are not blended
    static constexpr double blendS = 0.1;
    static constexpr double longestS = 1;

private:
    double m_positionMm = 0;
    double m_speedMmPerS = 0;
    double m_timeS = 0;
    double m_offsetMm = 0; // displayed minus reported position at m_timeS
    bool m_isKnown = false;
};

} // namespace campanel::plot
