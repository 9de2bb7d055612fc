// SPDX-License-Identifier: Apache-2.0
// The film of a packing machine from the mark sensor to the knife. Its material is counted in mm of
// unstretched film; it comes stretched by some tenths of a percent, which change slowly along the reel, and
// what was printed at equal distances comes at unequal ones. It slips against the roll that draws it. All of
// it follows from where the roll stands, so that it does not depend on the steps in which the roll is moved.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <random>

namespace campanel::controller {

struct FilmOptions {
    double slipMm = 0.03;          // standard deviation from bag to bag
    double stretch = 0.005;        // largest slow one; half of it is always there
    double stretchStep = 0.0;      // stretch that sets in at once ...
    double stretchStepM = 0.0;     // ... after so many metres of film
    double markNoiseMm = 0.05;     // standard deviation of the sensor
    double marksMissing = 0.0;     // share that the sensor does not see
    double marksFalse = 0.0;       // share of bags with a second mark somewhere
    double printError = 0.0;       // the print's distance is this share longer than the bag
    double misplacedMm = 0.0;      // the film lies so far from its marks at the first cut
    double markDistanceMm = 900.0; // from the sensor to the knife
};

class Film {
public:
    Film(const FilmOptions& options, std::uint64_t seed);

    // A film printed for bags of this length; the first cut comes when `toFirstCutMm` more have been drawn.
    void load(double bagMm, double toFirstCutMm, double rollMm);
    // The roll has drawn so much since power-up.
    void drawTo(double rollMm);
    // Where the roll stood at a mark that passed the sensor, mm; false: no more.
    bool takeMark(double& rollMm);

    // Film drawn, slip included, when the roll stands there; at most one bag before the last drawTo().
    [[nodiscard]] double drawnMm(double rollMm) const;
    // Material under the knife with so much film drawn.
    [[nodiscard]] double materialMm(double drawnMm) const;
    // Distance of that material from the next printed cut, mm; positive: the cut came late.
    [[nodiscard]] double offMarkMm(double materialMm) const;

private:
    struct Wave {
        double share = 0.0;
        double lengthMm = 0.0;
        double phase = 0.0;
    };
    // Length on the machine of the material up to there.
    [[nodiscard]] double stretched(double materialMm) const;
    void nextMark();
    void seeMarks(double rollMm);

    FilmOptions m_options;
    std::mt19937_64 m_slipRandom;
    std::mt19937_64 m_markRandom;
    std::normal_distribution<double> m_normal;
    std::array<Wave, 2> m_waves;
    double m_bagMm = 0.0;   // 0: no film
    double m_firstMm = 0.0; // material of the first printed cut
    // Slip: straight lines from knot to knot, one bag apart on the roll.
    double m_knotMm = 0.0;
    double m_slipAtKnotMm = 0.0;
    double m_slipBeforeMm = 0.0; // at the knot before
    double m_slipAfterMm = 0.0;  // at the knot after
    std::int64_t m_mark = 0;
    double m_markDrawnMm = 0.0; // film drawn when the next mark is seen
    double m_falseDrawnMm = 0.0;
    bool m_markSeen = true;
    bool m_hasFalse = false;
    std::deque<double> m_seen;
};

} // namespace campanel::controller
