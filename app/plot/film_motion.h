// SPDX-License-Identifier: Apache-2.0
// How far the film has gone on since it was last reported: at its speed, and without a jump when the next
// report says that it was a little elsewhere.
#pragma once

namespace campanel::plot {

class FilmMotion {
public:
    // The film was at `positionMm` and moves at `speedMmPerS`, at `timeS` of any steady clock. Positions wrap
    // at wrapMm.
    void report(double positionMm, double speedMmPerS, double timeS);
    void forget() { *this = {}; }

    // mm since the last report; it ends a second after it, however fast the film was.
    [[nodiscard]] double travelledMm(double timeS) const;
    // It still changes.
    [[nodiscard]] bool isMoving(double timeS) const;

    static constexpr double wrapMm = 4294967.296; // the controller tells 32 bits of a micrometer
    static constexpr double jumpMm = 40;          // what is farther off is another place: no blending
    static constexpr double blendS = 0.1;
    static constexpr double longestS = 1;

private:
    double m_positionMm = 0;
    double m_speedMmPerS = 0;
    double m_timeS = 0;
    double m_offsetMm = 0; // at m_timeS, shown minus reported
    bool m_isKnown = false;
};

} // namespace campanel::plot
