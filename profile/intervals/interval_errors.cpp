// SPDX-License-Identifier: Apache-2.0
// Branch and bound. A time span is halved until the bound of the error between its ends hardly exceeds an
// error already found. The bound follows from those of acceleration and jerk.
#include "profile/intervals/interval_errors.h"

#include "profile/intervals/speed_curve.h"
#include "profile/model/bounds.h"

#include <cmath>
#include <limits>
#include <vector>

namespace campanel::profile::detail {

namespace {

constexpr double precision = 0.0005;    // share by which a stated error may exceed the true one
constexpr double cellsPerSegment = 256; // minimum, so that no cell contains two steps of the acceleration

// Returns the bound of a curve between two points, when its slope is between low and high.
double summit(double first, double last, double width, double low, double high)
{
    const double ends = maxOf(first, last);
    if (low >= 0 || high <= 0)
        return ends;
    return maxOf(ends, (high * last - low * first - low * high * width) / (high - low));
}

// The state of the motion and the rows at one iteration; speeds in Hz, along the motion.
struct Point {
    double timeS = 0;
    double speedError = 0; // relative to the rows' linear ramp
    double acceleration = 0;
    double positionError = 0;
};

// The largest error found, and the bound of the errors beside it.
class Largest {
public:
    void see(double error, double timeS)
    {
        raise(m_seen, m_timeS, error, timeS);
        m_bound = maxOf(m_bound, error);
    }
    bool admits(double bound) const { return bound <= m_seen * (1 + precision) + smallest; }
    void admit(double bound) { m_bound = maxOf(m_bound, bound); }
    double bound() const { return m_bound; }
    double timeS() const { return m_timeS; }

private:
    static constexpr double smallest = 1e-6; // Hz, pulses

    double m_seen = 0;
    double m_bound = 0;
    double m_timeS = 0;
};

// A part of the rows' motion with one acceleration: the ramp of a row, or the rest of it.
struct Part {
    IntervalRow row;
    std::uint64_t begin = 0; // iterations before the row
    std::uint64_t from = 0;  // iterations of the row
    std::uint64_t to = 0;
    std::uint64_t rest = 0;  // of the position accumulator before the row
    double pulses = 0;       // before the row
    double speed = 0;        // at `from`, in units of the registers
    double acceleration = 0; // units per iteration
    bool stands = false;     // after the last row of a motion that ends at rest
};

class Comparison {
public:
    Comparison(int fractionBits, double iterationS, const MotionProfile& motion, double pulsesPerMm)
        : m_motion(motion)
        , m_bits(accumulatorBits + fractionBits)
        , m_iterationS(iterationS)
        , m_pulsesPerMm(pulsesPerMm)
        , m_durationS(motion.durationS())
        , m_startMm(motion.at(0).positionMm)
        , m_last(motion.at(m_durationS))
    {
        constexpr double restShare = 1e-9; // share of the mean speed
        const double travel = m_last.positionMm - m_startMm;
        m_sign = travel < 0 ? -1 : 1;
        m_endsAtRest = std::abs(m_last.velocityMmPerS) * m_durationS <= restShare * std::abs(travel);
        double shortestS = m_durationS;
        for (const Segment& segment : motion.segments()) {
            m_jerk = maxOf(m_jerk, jerkBound(segment) * pulsesPerMm);
            if (segment.durationS > 0) {
                shortestS = minOf(shortestS, segment.durationS);
                m_cutsS.push_back(segment.startS);
            }
        }
        m_cutsS.push_back(m_durationS);
        m_longestCell = static_cast<std::uint64_t>(maxOf(1.0, shortestS / cellsPerSegment / iterationS));
    }

    IntervalErrors of(std::span<const IntervalRow> rows, int fractionBits);

private:
    void compare(const Part& part);
    void compareCell(const Part& part, const Point& first, std::uint64_t from, const Point& last,
                     std::uint64_t to);
    Point at(const Part& part, std::uint64_t iteration) const;
    double hertz(double units) const { return std::ldexp(units / m_iterationS, -m_bits); }

    const MotionProfile& m_motion;
    int m_bits;
    double m_iterationS;
    double m_pulsesPerMm;
    double m_durationS;
    double m_startMm;
    MotionPoint m_last;
    double m_sign = 1;
    bool m_endsAtRest = true;
    double m_jerk = 0; // bound, in Hz/s^2
    std::vector<double> m_cutsS;
    std::uint64_t m_longestCell = 1;
    Largest m_speed;
    Largest m_position;
};

Point Comparison::at(const Part& part, std::uint64_t iteration) const
{
    Point point;
    point.timeS = static_cast<double>(part.begin + iteration) * m_iterationS;
    MotionPoint here = m_last;
    if (point.timeS < m_durationS) {
        here = m_motion.at(point.timeS);
    } else {
        if (m_endsAtRest)
            here.velocityMmPerS = 0;
        here.positionMm += here.velocityMmPerS * (point.timeS - m_durationS);
        here.accelerationMmPerS2 = 0;
    }
    const double elapsed = static_cast<double>(iteration - part.from);
    const double speed = part.stands ? 0 : part.speed + part.acceleration * elapsed;
    double position = part.pulses;
    if (!part.stands)
        position += std::ldexp(static_cast<double>(positionAfter(part.row, part.rest, iteration)), -m_bits);
    point.speedError = hertz(speed) - m_sign * here.velocityMmPerS * m_pulsesPerMm;
    point.acceleration = m_sign * here.accelerationMmPerS2 * m_pulsesPerMm;
    point.positionError = position - m_sign * (here.positionMm - m_startMm) * m_pulsesPerMm;
    return point;
}

void Comparison::compareCell(const Part& part, const Point& first, std::uint64_t from, const Point& last,
                             std::uint64_t to)
{
    // The speed register is up to a unit behind the linear ramp, and changes by the step of an iteration at
    // once.
    const double step = hertz(std::abs(part.acceleration));
    const double above = step + (part.acceleration < 0 ? hertz(1) : 0);
    const double below = step + (part.acceleration > 0 ? hertz(1) : 0);
    for (const Point* point : {&first, &last}) {
        m_speed.see(maxOf(point->speedError + above, below - point->speedError), point->timeS);
        m_position.see(std::abs(point->positionError), point->timeS);
    }
    if (to - from <= 1)
        return;
    const double width = static_cast<double>(to - from) * m_iterationS;
    const double rowSlope = hertz(part.acceleration) / m_iterationS;
    const double jerk = m_jerk * width;
    const double high = rowSlope - minOf(first.acceleration, last.acceleration) + jerk;
    const double low = rowSlope - maxOf(first.acceleration, last.acceleration) - jerk;
    const double fastest = summit(first.speedError, last.speedError, width, low, high) + above;
    const double slowest = summit(-first.speedError, -last.speedError, width, -high, -low) + below;
    const double ahead = summit(first.positionError, last.positionError, width, -slowest, fastest);
    const double behind = summit(-first.positionError, -last.positionError, width, -fastest, slowest);
    const double speed = maxOf(fastest, slowest);
    const double position = maxOf(ahead, behind);
    if (to - from <= m_longestCell && m_speed.admits(speed) && m_position.admits(position)) {
        m_speed.admit(speed);
        m_position.admit(position);
        return;
    }
    const std::uint64_t middle = from + (to - from) / 2;
    const Point point = at(part, middle);
    compareCell(part, first, from, point, middle);
    compareCell(part, point, middle, last, to);
}

// Compares cell by cell between the segments' joints; each joint is in a cell of one iteration.
void Comparison::compare(const Part& part)
{
    std::uint64_t from = part.from;
    Point first = at(part, from);
    const auto goTo = [&](std::uint64_t to) {
        if (to <= from || to > part.to)
            return;
        const Point last = at(part, to);
        compareCell(part, first, from, last, to);
        from = to;
        first = last;
    };
    for (const double cutS : m_cutsS) {
        const double cut = cutS / m_iterationS - static_cast<double>(part.begin);
        if (cut > static_cast<double>(part.from) && cut < static_cast<double>(part.to)) {
            goTo(static_cast<std::uint64_t>(cut));
            goTo(static_cast<std::uint64_t>(cut) + 1);
        }
    }
    goTo(part.to);
}

IntervalErrors Comparison::of(std::span<const IntervalRow> rows, int fractionBits)
{
    Part part;
    for (const IntervalRow& row : rows) {
        const RowEnd end = rowEnd(row, part.rest, fractionBits);
        const std::uint64_t ramp = minOf(rampIterations(row), end.iterations);
        const double sign = row.lastSpeed > row.firstSpeed ? 1 : -1;
        part.row = row;
        part.from = 0;
        part.to = ramp;
        part.speed = row.firstSpeed;
        part.acceleration = ramp == 0 ? 0 : sign * std::ldexp(row.acceleration, -accumulatorBits);
        if (ramp > 0)
            compare(part);
        part.from = ramp;
        part.to = end.iterations;
        part.speed = row.lastSpeed;
        part.acceleration = 0;
        if (part.to > part.from)
            compare(part);
        part.begin += end.iterations;
        part.rest = end.rest;
        part.pulses += row.pulses;
    }
    const double endS = static_cast<double>(part.begin) * m_iterationS;
    part.from = 0;
    part.to = endS < m_durationS ? static_cast<std::uint64_t>((m_durationS - endS) / m_iterationS) + 1 : 1;
    part.speed = rows.empty() ? 0 : rows.back().lastSpeed;
    part.acceleration = 0;
    part.stands = m_endsAtRest;
    if (!part.stands)
        part.row = {std::numeric_limits<std::uint32_t>::max(), rows.back().lastSpeed, rows.back().lastSpeed,
                    0};
    compare(part);
    return {m_speed.bound() / m_pulsesPerMm, m_speed.timeS(), m_position.bound(), m_position.timeS()};
}

} // namespace

IntervalErrors intervalErrors(std::span<const IntervalRow> rows, int fractionBits, double iterationS,
                              const MotionProfile& motion, double pulsesPerMm)
{
    return Comparison(fractionBits, iterationS, motion, pulsesPerMm).of(rows, fractionBits);
}

} // namespace campanel::profile::detail
