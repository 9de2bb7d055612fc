// SPDX-License-Identifier: Apache-2.0
// The film of a packing machine from the mark sensor to the knife. Its material is counted in mm of
// unstretched film. It is stretched by some tenths of a percent, which change slowly along the reel, so that
// equal printed distances become unequal. It slips on the roll that draws it. Everything follows from the
// position of the roll and does not depend on the steps of its movement.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <random>

namespace campanel::controller {

inline constexpr double mmPerM = 1000.0;

struct FilmOptions {
    double slipMm = 0.03;      // standard deviation from bag to bag
    double stretch = 0.005;    // largest slow stretch; half of it is constant
    double stretchStep = 0.0;  // sudden additional stretch ...
    double stretchStepM = 0.0; // ... after this many meters of film
    double markNoiseMm = 0.05; // standard deviation of the sensor
    double marksMissing = 0.0; // share that the sensor does not detect
    double marksFalse = 0.0;   // share of bags with a false mark
    double markWidthMm = 5.0;  // of the printed marks
    double falseWidthMm = 5.0; // of the false ones
    double printAtMm = 0.0;    // every mark has another print so far behind it; 0: none
    double printWidthMm = 5.0;
    double printError = 0.0;       // the printed distance is longer than the bag by this share
    double misplacedMm = 0.0;      // offset of the film from its marks at the first cut
    double markDistanceMm = 900.0; // from the sensor to the knife
    double slipPerAcceleration =
        0.0; // mm per m/s^2: so far the film stays behind its roll while it speeds up
};

// The acceleration that the film feels, m/s^2: that of its roll behind the give of a loose film.
class FilmAcceleration {
public:
    // Returns it at the end of a step that ends with this speed, m/s.
    double step(double speed, double stepS);

private:
    double m_follower = 0.0; // the speed, low-pass filtered
};

class Film {
public:
    Film(const FilmOptions& options, std::uint64_t seed);

    // Loads film printed for bags of this length; the first cut comes after another `toFirstCutMm`.
    void load(double bagMm, double toFirstCutMm, double rollMm);
    // Pulls the film over its roll by hand.
    void pull(double mm);
    // Advances the roll to this distance since power-up, with this acceleration of the film at the end,
    // m/s^2.
    void drawTo(double rollMm, double acceleration = 0.0);
    // The beginning or the end of a mark at the sensor. Prints that overlap are one.
    struct Edge {
        double rollMm = 0.0;
        bool on = false;
    };
    // Returns the next edge that passed the sensor; false: no more edges.
    bool takeEdge(Edge& edge);

    // Returns the film drawn at this position of the roll, including slip; at most one bag before the last
    // drawTo().
    [[nodiscard]] double drawnMm(double rollMm) const;
    // Returns the material under the knife with this much film drawn.
    [[nodiscard]] double materialMm(double drawnMm) const;
    // Returns the printed bags that have passed the knife with this much film drawn, whole at a printed cut.
    [[nodiscard]] double bagsAt(double drawnMm) const;
    // Returns the distance of that material from the next printed cut, mm; positive: the cut was late.
    [[nodiscard]] double offMarkMm(double materialMm) const;

private:
    struct Wave {
        double share = 0.0;
        double lengthMm = 0.0;
        double phase = 0.0;
    };
    // Returns the length on the machine of the material up to there.
    [[nodiscard]] double stretched(double materialMm) const;
    void nextMark();
    void print(double drawnMm, double widthMm);
    void seePrints(double rollMm);

    FilmOptions m_options;
    std::mt19937_64 m_slipRandom;
    std::mt19937_64 m_markRandom;
    std::normal_distribution<double> m_normal;
    std::array<Wave, 2> m_waves;
    double m_bagMm = 0.0;   // 0: no film
    double m_firstMm = 0.0; // material of the first printed cut
    // The slip: straight lines between knots, one bag apart on the roll.
    double m_knotMm = 0.0;
    double m_slipAtKnotMm = 0.0;
    double m_slipBeforeMm = 0.0; // at the previous knot
    double m_slipAfterMm = 0.0;  // at the next knot
    std::int64_t m_mark = 0;
    double m_markDrawnMm = 0.0; // film drawn when the sensor detects the next mark
    // Beginnings (1) and ends (-1) of the prints before the sensor, by the film drawn there.
    std::multimap<double, int> m_prints;
    int m_printsThere = 0; // at the sensor
    std::deque<Edge> m_seen;
    // How far acceleration keeps the film behind, at the beginning and the end of the last step.
    double m_stepFromMm = 0.0;
    double m_stepToMm = 0.0;
    double m_behindBeforeMm = 0.0;
    double m_behindMm = 0.0;
};

} // namespace campanel::controller
