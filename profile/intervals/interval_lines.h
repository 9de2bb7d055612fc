// SPDX-License-Identifier: Apache-2.0
// A speed curve as few straight lines: the plan of a table of intervals before its pulses are whole.
#pragma once

#include "profile/intervals/link_path.h"
#include "profile/intervals/speed_curve.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

// Where a line is horizontal on purpose. A row goes along two lines then: a ramp, and a stretch at its last
// speed.
enum class Flats : std::uint8_t {
    None,
    Peaks,       // at each largest and smallest speed inside the motion
    PeaksAndEnd, // there, and at the end of the motion
};

struct LineStyle {
    Flats flats = Flats::None;
    // 1: the error evens out over each bend of the curve, for which the lines need a quarter of it; 0: none
    // of it is spent on that.
    double evenness = 0;
};

struct Lines {
    std::vector<PathPoint> knots; // ends of the lines: one more than lines
    double errorHz = 0;           // largest
};

struct SpeedPeak {
    std::size_t sample = 0; // its first or only one
    double sign = 0;        // 1: a largest speed, -1: a smallest one, 0: either, held for a while
};

class IntervalLines {
public:
    // Lines stay between minHz and maxHz. Keeps references.
    IntervalLines(const SpeedCurve& curve, double minHz, double maxHz);

    // Returns the number below which no straight lines keep the true motion's speed within the error,
    // whatever distance they make and in whatever time; 0 when none do, or only with more than maxLines.
    [[nodiscard]] std::size_t fewest(double errorHz, std::size_t maxLines);

    // Returns how many lines of a style are horizontal on purpose and follow another.
    [[nodiscard]] std::size_t flatCount(Flats flats) const;

    // Can at most so many lines keep within the error, whatever distance they make? Never false where find()
    // has lines with that error, horizontal ones or not; never false for more error where true for less.
    [[nodiscard]] bool canKeep(double errorHz, std::size_t lineCount, double evenness);

    // Returns at most so many lines that make the curve's distance in its time, with the smallest error
    // found. Nothing when there are none.
    [[nodiscard]] std::optional<Lines> find(std::size_t lineCount, const LineStyle& style);

private:
    struct Tried {
        std::vector<PathPoint> knots;
        double errorHz = 0;
        double missingHz = 0; // by which their mean speed is too low
    };
    void lay(double errorHz, const LineStyle& style, double shiftHz);
    void pinch(const SpeedPeak& peak, double errorHz);
    void fixEnds();
    std::optional<std::vector<PathPoint>> within(double errorHz, std::size_t lineCount,
                                                 const LineStyle& style, double shiftHz);
    std::optional<Tried> tightest(std::size_t lineCount, const LineStyle& style, double shiftHz,
                                  double guessHz);

    const SpeedCurve& m_curve;
    double m_minHz;
    double m_maxHz;
    double m_bendIntegral = 0; // of the root of the jerk over time
    std::vector<SpeedPeak> m_peaks;
    std::vector<Gate> m_channel;
};

} // namespace campanel::profile::detail
