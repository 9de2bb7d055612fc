// SPDX-License-Identifier: Apache-2.0
// Approximates a speed curve by few straight lines: the plan of an interval table before its pulses are
// whole.
#pragma once

#include "profile/intervals/link_path.h"
#include "profile/intervals/speed_curve.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

// The places where a line is horizontal on purpose. One row then covers two lines: a ramp, and a stretch at
// its last speed.
enum class Flats : std::uint8_t {
    None,
    Peaks,       // at each maximum and minimum of speed inside the motion
    PeaksAndEnd, // at these, and at the end of the motion
};

struct LineStyle {
    Flats flats = Flats::None;
    // 1: the error averages out over each bend of the curve, which takes a quarter of it; 0: no error is
    // spent on this.
    double evenness = 0;
};

struct Lines {
    std::vector<PathPoint> knots; // ends of the lines: one more than the lines
    double errorHz = 0;           // maximum
};

struct SpeedPeak {
    std::size_t sample = 0; // the first or only sample
    double sign = 0;        // 1: a maximum of speed, -1: a minimum, 0: either, held for some time
};

class IntervalLines {
public:
    // Keeps references. The lines stay between minHz and maxHz.
    IntervalLines(const SpeedCurve& curve, double minHz, double maxHz);

    // Returns the lower bound of the number of lines that keep the true motion's speed within the error, for
    // any distance and duration. Returns 0 when no lines do, or only more than maxLines.
    [[nodiscard]] std::size_t fewest(double errorHz, std::size_t maxLines);

    // Returns how many lines of a style are horizontal on purpose and follow another line.
    [[nodiscard]] std::size_t flatCount(Flats flats) const;

    // Returns whether at most `lineCount` lines can keep within the error, for any distance. Never false
    // where find() has lines with that error, horizontal or not. Never false for a larger error where true
    // for a smaller one.
    [[nodiscard]] bool canKeep(double errorHz, std::size_t lineCount, double evenness);

    // Returns at most `lineCount` lines with the distance and duration of the curve and the smallest error
    // found. Returns nothing when there are none.
    [[nodiscard]] std::optional<Lines> find(std::size_t lineCount, const LineStyle& style);

private:
    struct Tried {
        std::vector<PathPoint> knots;
        double errorHz = 0;
        double missingHz = 0; // deficit of the mean speed
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
    double m_bendIntegral = 0; // integral of the root of the jerk over time
    std::vector<SpeedPeak> m_peaks;
    std::vector<Gate> m_channel;
};

} // namespace campanel::profile::detail
