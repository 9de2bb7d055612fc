// SPDX-License-Identifier: Apache-2.0
// Visits the parts in which the table is one cubic and the motion smooth. Between two samples the motion is
// bounded by the largest fourth derivative of its position.
#include "profile/cam/cam_table.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace campanel::profile {
namespace {

// A section of the motion without a joint inside.
struct SmoothStretch {
    const Segment* segment = nullptr;
    double fromS = 0;
    double toS = 0;
    double snapMmPerS4 = 0; // bound of the fourth derivative of the position
};

std::vector<SmoothStretch> smoothStretches(const MotionProfile& motion)
{
    std::vector<SmoothStretch> stretches;
    for (const Segment& s : motion.segments()) {
        if (s.law == nullptr || !(s.durationS > 0)) {
            const double snap =
                maxOf(std::abs(s.snapMmPerS4), std::abs(s.snapMmPerS4 + s.crackleMmPerS5 * s.durationS));
            stretches.push_back({&s, s.startS, s.endS(), snap});
            continue;
        }
        const LawPieces pieces = s.law->pieces(s.parameters);
        const bool isRamp = s.form == SegmentForm::Ramp;
        const double lawS = s.lawDurationS();
        const double cubedS = lawS * lawS * lawS;
        const double snap = isRamp
                                ? std::abs(s.endVelocityMmPerS - s.startVelocityMmPerS) * pieces.g3 / cubedS
                                : std::abs(s.distanceMm) * pieces.g4 / (cubedS * lawS);
        std::vector<double> ends(pieces.joints.begin(), pieces.joints.end());
        if (s.isMirrored) {
            std::ranges::reverse(ends);
            for (double& x : ends)
                x = 1 - x;
        }
        ends.push_back(1);
        double from = s.startS;
        for (const double x : ends) {
            const double to = clamped(s.startS + (x - s.lawFrom) * lawS, s.startS, s.endS());
            stretches.push_back({&s, from, to, snap});
            from = to;
        }
    }
    return stretches;
}

// The table minus the motion at one time.
struct Difference {
    double timeS = 0;
    double positionMm = 0;
    double velocityMmPerS = 0;
    double jerkMmPerS3 = 0;
};

// Returns the extrema of the cubic with these values and slopes per unit, within 0..1.
std::array<double, 2> turns(double first, double firstSlope, double last, double lastSlope)
{
    const double c2 = 3 * (last - first) - 2 * firstSlope - lastSlope;
    const double c3 = firstSlope + lastSlope - 2 * (last - first);
    const double q = -(c2 + std::copysign(std::sqrt(maxOf(c2 * c2 - 3 * c3 * firstSlope, 0.0)), c2));
    const auto inside = [](double x) { return x > 0 && x < 1 ? x : 0; };
    return {inside(q / (3 * c3)), inside(firstSlope / q)};
}

class CamErrorSearch {
public:
    CamErrorSearch(const CamTable& table, const MotionProfile& motion, const Machine& machine)
        : m_table(table)
        , m_unitsPerMm(camUnitsPerPulse * axisPulsesPerMm(machine))
        , m_intervalS(motion.durationS() / static_cast<double>(table.rows.size() - 1))
        , m_startMm(motion.at(0).positionMm)
    {
    }

    void walk(const SmoothStretch& stretch)
    {
        const auto last = static_cast<double>(m_table.rows.size() - 2);
        const auto indexAt = [&](double timeS) {
            return static_cast<std::size_t>(clamped(std::floor(timeS / m_intervalS), 0.0, last));
        };
        for (std::size_t i = indexAt(stretch.fromS); i <= indexAt(stretch.toS); ++i) {
            const double fromS = maxOf(stretch.fromS, static_cast<double>(i) * m_intervalS);
            const double toS = static_cast<double>(i) < last
                                   ? minOf(stretch.toS, static_cast<double>(i + 1) * m_intervalS)
                                   : stretch.toS;
            if (toS > fromS)
                walkInterval(stretch, i, fromS, toS);
        }
    }

    [[nodiscard]] const CamErrors& errors() const { return m_errors; }

private:
    [[nodiscard]] Difference at(const SmoothStretch& stretch, std::size_t index, double timeS) const
    {
        const double share = timeS / m_intervalS - static_cast<double>(index);
        const CamPoint point = interpolate(m_table, index, share);
        const MotionPoint exact = stretch.segment->at(timeS);
        const CamRow& a = m_table.rows[index];
        const CamRow& b = m_table.rows[index + 1];
        const double third = static_cast<double>(a.slope256) + b.slope256 -
                             2 * (static_cast<double>(b.position256) - a.position256);
        return {timeS, point.position256 / m_unitsPerMm - (exact.positionMm - m_startMm),
                point.slope256 / m_unitsPerMm / m_intervalS - exact.velocityMmPerS,
                6 * third / m_unitsPerMm / (m_intervalS * m_intervalS * m_intervalS) - exact.jerkMmPerS3};
    }

    void walkInterval(const SmoothStretch& stretch, std::size_t index, double fromS, double toS)
    {
        const int parts = stretch.snapMmPerS4 > 0 ? 8 : 1;
        const double partS = (toS - fromS) / parts;
        Difference a = at(stretch, index, fromS);
        for (int part = 1; part <= parts; ++part) {
            const Difference b = at(stretch, index, part < parts ? fromS + part * partS : toS);
            const Difference middle = at(stretch, index, (a.timeS + b.timeS) / 2);
            keepSpeed(a, b, middle.jerkMmPerS3, stretch.snapMmPerS4);
            keepPosition(a, b, stretch.snapMmPerS4);
            a = b;
        }
    }

    // Records the speed error. The speed is a parabola with the jerk of the middle; the jerk differs from
    // that by at most snap times half the width. This changes the speed by at most snap width^3 / 16.
    void keepSpeed(const Difference& a, const Difference& b, double jerk, double snap)
    {
        const double width = b.timeS - a.timeS;
        const double room = snap * width * width * width / 16;
        const double change = b.velocityMmPerS - a.velocityMmPerS;
        const double bend = jerk * width * width;
        const double x = 2 * std::abs(change) < std::abs(bend) ? 0.5 - change / bend : 0; // of the extremum
        for (const double share : {0.0, x, 1.0}) {
            const double faster =
                std::abs(a.velocityMmPerS + share * change - bend / 2 * share * (1 - share)) + room;
            raise(m_errors.speedMmPerS, m_errors.speedTimeS, faster, a.timeS + share * width);
        }
    }

    // Records the position error. The cubic through both ends misses the position by at most snap width^4 /
    // 384.
    void keepPosition(const Difference& a, const Difference& b, double snap)
    {
        const double width = b.timeS - a.timeS;
        const double room = snap * width * width * width * width / 384;
        const double slopeA = a.velocityMmPerS * width;
        const double slopeB = b.velocityMmPerS * width;
        const double step = b.positionMm - a.positionMm;
        const auto inner = turns(a.positionMm, slopeA, b.positionMm, slopeB);
        for (const double share : {0.0, inner[0], inner[1], 1.0}) {
            const double curved = 3 * step - 2 * slopeA - slopeB + share * (slopeA + slopeB - 2 * step);
            const double away = std::abs(a.positionMm + share * (slopeA + share * curved)) + room;
            raise(m_errors.positionMm, m_errors.positionTimeS, away, a.timeS + share * width);
        }
    }

    const CamTable& m_table;
    double m_unitsPerMm;
    double m_intervalS;
    double m_startMm;
    CamErrors m_errors;
};

} // namespace

CamErrors camErrors(const CamTable& table, const MotionProfile& motion, const Machine& machine, CamUse use)
{
    CamErrorSearch search(table, motion, machine);
    for (const SmoothStretch& stretch : smoothStretches(motion))
        search.walk(stretch);
    CamErrors errors = search.errors();
    errors.positionPulses = errors.positionMm * axisPulsesPerMm(machine);
    if (use == CamUse::Repeats)
        errors.wrapSpeedStepMmPerS =
            std::abs(static_cast<double>(table.rows.front().slope256) - table.rows.back().slope256) /
            (camUnitsPerPulse * axisPulsesPerMm(machine)) / motion.durationS() *
            static_cast<double>(table.rows.size() - 1);
    return errors;
}

} // namespace campanel::profile
