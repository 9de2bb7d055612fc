// SPDX-License-Identifier: Apache-2.0
// Compares the slices with the curve, one part of a slice after the other. Within a part the table is linear
// and the curve's speed monotone. The position error is therefore largest at an end or where the speeds are
// equal.
#include "profile/cutter/table_error.h"

#include "profile/model/bounds.h"

#include <array>
#include <cmath>
#include <optional>

namespace campanel::profile {
namespace {

// The part of a slice within one segment of the curve.
struct SlicePart {
    const Segment& segment;
    double fromS = 0;
    double toS = 0;
    double sliceStartS = 0;
    double sliceStartMm = 0; // in the table
    double speedMmPerS = 0;  // in the table

    // Returns how far the table is ahead of the curve; the next one, how much faster it is.
    [[nodiscard]] double aheadMm(double timeS) const
    {
        return sliceStartMm + speedMmPerS * (timeS - sliceStartS) - segment.at(timeS).positionMm;
    }
    [[nodiscard]] double fasterMmPerS(double timeS) const
    {
        return speedMmPerS - segment.at(timeS).velocityMmPerS;
    }
};

// The point of equal speeds, if it is inside, and a bound of the additional position error beside it.
struct Agreement {
    double timeS = 0;
    double roomMm = 0;
};

std::optional<Agreement> speedAgreement(const SlicePart& part)
{
    constexpr double roomMm = 1e-9;
    constexpr int maxSteps = 100;
    double low = part.fromS;
    double high = part.toS;
    double fasterLow = part.fasterMmPerS(low);
    double fasterHigh = part.fasterMmPerS(high);
    if (fasterLow * fasterHigh >= 0)
        return std::nullopt;
    // The false position method in Illinois form: the weight of an unchanged end is halved.
    Agreement found;
    int side = 0;
    for (int step = 0; step < maxSteps; ++step) {
        const double share = fasterLow / (fasterLow - fasterHigh);
        found.timeS = low + (high - low) * share;
        const double faster = part.fasterMmPerS(found.timeS);
        found.roomMm = std::abs(faster) * (high - low);
        if (found.roomMm <= roomMm)
            break;
        if (faster * fasterHigh > 0) {
            high = found.timeS;
            fasterHigh = faster;
            fasterLow /= side == -1 ? 2 : 1;
            side = -1;
        } else {
            low = found.timeS;
            fasterLow = faster;
            fasterHigh /= side == 1 ? 2 : 1;
            side = 1;
        }
    }
    return found;
}

// Returns the integral of the squared position error over [fromS, toS], by Gauss' rule of four points.
double squaresBetween(const SlicePart& part, double fromS, double toS)
{
    constexpr std::array places{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                0.8611363115940526};
    constexpr std::array weights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                 0.3478548451374538};
    const double half = (toS - fromS) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double ahead = part.aheadMm(fromS + half * (1 + places[i]));
        sum += weights[i] * ahead * ahead;
    }
    return sum * half;
}

// Returns the integral over the whole part, with increasing subdivision. The change by the last doubling is
// added, so that the result is not too small.
double squaresOf(const SlicePart& part)
{
    constexpr double enough = 1e-6;       // share of the integral
    constexpr double roundingMm2 = 1e-20; // of the squared error
    constexpr int maxPieces = 256;
    const double rounding = roundingMm2 * (part.toS - part.fromS);
    double sum = squaresBetween(part, part.fromS, part.toS);
    for (int pieces = 2;; pieces *= 2) {
        const double before = sum;
        sum = 0;
        for (int i = 0; i < pieces; ++i)
            sum += squaresBetween(part, part.fromS + (part.toS - part.fromS) * i / pieces,
                                  part.fromS + (part.toS - part.fromS) * (i + 1) / pieces);
        if (std::abs(sum - before) <= enough * sum + rounding || pieces >= maxPieces)
            return sum + std::abs(sum - before);
    }
}

// Adds the part to the largest errors; returns the integral of the squared position error, mm^2 s.
double addErrors(const SlicePart& part, double perMm, TableErrors& errors)
{
    for (const double timeS : {part.fromS, part.toS}) {
        raise(errors.speedMmPerS, errors.speedTimeS, part.fasterMmPerS(timeS), timeS);
        raise(errors.insidePulses, errors.insideTimeS, part.aheadMm(timeS) * perMm, timeS);
    }
    if (const auto agreement = speedAgreement(part)) {
        const double maxMm = std::abs(part.aheadMm(agreement->timeS)) + agreement->roomMm;
        raise(errors.insidePulses, errors.insideTimeS, maxMm * perMm, agreement->timeS);
    }
    return squaresOf(part);
}

} // namespace

TableErrors tableErrors(const RotaryCutter& cutter, std::span<const TableSlice> slices)
{
    TableErrors errors;
    if (slices.empty())
        return errors;
    const double clock = cutter.machine.timerClockHz;
    const double perMm = pulsesPerMm(cutter.machine);
    const auto frequency = [clock](const TableSlice& s) {
        return static_cast<double>(s.pulses) / static_cast<double>(s.ticks) * clock;
    };
    double squares = 0; // integral of the squared position error, mm^2 s
    std::int64_t pulsesBefore = 0;
    const TableSlice* last = &slices.back();
    for (const TableSlice& slice : slices) {
        const double startS = static_cast<double>(slice.startTick) / clock;
        const double endS = static_cast<double>(slice.startTick + slice.ticks) / clock;
        for (const Segment& segment : cutter.motion.segments()) {
            const SlicePart part{segment,
                                 maxOf(startS, segment.startS),
                                 minOf(endS, segment.endS()),
                                 startS,
                                 static_cast<double>(pulsesBefore) / perMm,
                                 frequency(slice) / perMm};
            if (part.toS > part.fromS)
                squares += addErrors(part, perMm, errors);
        }
        pulsesBefore += slice.pulses;
        const double travelMm = cutter.motion.at(endS).positionMm;
        if (slice.endsSlice)
            raise(errors.boundaryPulses, errors.boundaryTimeS,
                  static_cast<double>(pulsesBefore) - travelMm * perMm, endS);
        raise(errors.frequencyStepHz, errors.frequencyStepTimeS, frequency(slice) - frequency(*last), startS);
        last = &slice;
    }
    raise(errors.insidePulses, errors.insideTimeS, errors.boundaryPulses, errors.boundaryTimeS);
    errors.rmsPulses = perMm * std::sqrt(squares / cutter.cycle.cycleTimeS);
    errors.speedPercent =
        100 * errors.speedMmPerS / maxOf(cutter.cycle.baseSpeedMmPerS, cutter.cycle.filmSpeedMmPerS);
    return errors;
}

} // namespace campanel::profile
