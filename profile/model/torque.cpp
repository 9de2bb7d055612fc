// SPDX-License-Identifier: Apache-2.0
// Integrates squares over the smooth pieces of a law by Gauss-Legendre quadrature.
#include "profile/model/torque.h"

#include "profile/model/bounds.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace campanel::profile {
namespace {

constexpr double kgM2PerKgCm2 = 1e-4;
constexpr double unlimited = std::numeric_limits<double>::max();
constexpr double rounding = 1e-9; // share: the first of equal peaks is named

struct QuadratureNode {
    double place = 0; // on both sides of the middle of -1..1
    double weight = 0;
};

// Exact for polynomials up to degree 15; other functions are parted until the sum stands.
constexpr std::array<QuadratureNode, 4> quadrature{{{0.1834346424956498, 0.3626837833783620},
                                                    {0.5255324099163290, 0.3137066458778873},
                                                    {0.7966664774136267, 0.2223810344533745},
                                                    {0.9602898564975363, 0.1012285362903763}}};

double squareBetween(const Law& law, const LawParameters& parameters, double LawPoint::*derivative,
                     double from, double to)
{
    const double middle = (from + to) / 2;
    const double half = (to - from) / 2;
    double sum = 0;
    for (const QuadratureNode& node : quadrature) {
        for (const double side : {-1.0, 1.0}) {
            const double value = law.at(middle + side * node.place * half, parameters).*derivative;
            sum += node.weight * value * value;
        }
    }
    return half * sum;
}

double lawSquare(const Law& law, const LawParameters& parameters, double LawPoint::*derivative,
                 double lawFrom = 0, double lawTo = 1)
{
    constexpr double precision = 1e-12;
    constexpr int maxParts = 64;
    const LawPieces pieces = law.pieces(parameters);
    double sum = 0;
    double from = lawFrom;
    const auto add = [&](double to) {
        to = minOf(to, lawTo);
        if (!(to > from))
            return;
        double before = 0;
        double piece = squareBetween(law, parameters, derivative, from, to);
        for (int parts = 2; parts <= maxParts && std::abs(piece - before) > precision * piece; parts *= 2) {
            before = std::exchange(piece, 0);
            for (int i = 0; i < parts; ++i)
                piece += squareBetween(law, parameters, derivative, std::lerp(from, to, i / double(parts)),
                                       std::lerp(from, to, (i + 1) / double(parts)));
        }
        sum += piece;
        from = to;
    };
    for (const double joint : pieces.joints)
        add(joint);
    add(1);
    return sum;
}

bool isStanding(const Segment& s)
{
    return s.startVelocityMmPerS == 0 && s.distanceMm == 0 && s.startAccelerationMmPerS2 == 0 &&
           s.jerkMmPerS3 == 0 && s.snapMmPerS4 == 0 && s.crackleMmPerS5 == 0 &&
           (s.form != SegmentForm::Ramp || s.endVelocityMmPerS == 0);
}

// Returns the integral of a^2 over a segment, mm^2/s^3.
double squareOf(const Segment& s)
{
    const double t = s.durationS;
    if (!(t > 0))
        return 0;
    switch (s.form) {
    case SegmentForm::Ramp: {
        const double change = s.endVelocityMmPerS - s.startVelocityMmPerS;
        return change == 0 ? 0 : change * change / t * lawSpeedSquare(*s.law, s.parameters);
    }
    case SegmentForm::Displacement:
        return s.distanceMm == 0 ? 0
                                 : s.distanceMm * s.distanceMm / std::pow(s.lawDurationS(), 3) *
                                       lawSquare(*s.law, s.parameters, &LawPoint::g2, s.lawFrom, s.lawTo);
    case SegmentForm::Polynomial: {
        const std::array terms{s.startAccelerationMmPerS2, s.jerkMmPerS3 * t, s.snapMmPerS4 * t * t / 2,
                               s.crackleMmPerS5 * t * t * t / 6};
        double sum = 0;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            for (std::size_t k = 0; k < terms.size(); ++k)
                sum += terms[i] * terms[k] / static_cast<double>(i + k + 1);
        }
        return t * sum;
    }
    case SegmentForm::Constant:
        break;
    }
    return 0;
}

} // namespace

double TorqueLoad::at(double velocityMmPerS, double accelerationMmPerS2) const
{
    if (!isKnown())
        return std::numeric_limits<double>::quiet_NaN();
    const double direction = velocityMmPerS > 0 ? 1 : velocityMmPerS < 0 ? -1 : 0;
    return nmPerMmPerS2 * accelerationMmPerS2 + direction * frictionNm;
}

void AccelerationExtremes::add(double alongMmPerS2, double timeS)
{
    if (alongMmPerS2 > 0) {
        raise(speedingMmPerS2, speedingTimeS, alongMmPerS2, timeS, rounding);
        return;
    }
    raise(slowingMmPerS2, slowingTimeS, alongMmPerS2, timeS, rounding);
    if (-alongMmPerS2 < leastMmPerS2) {
        leastMmPerS2 = -alongMmPerS2;
        leastTimeS = timeS;
    }
}

TorquePeak TorqueLoad::peak(const AccelerationExtremes& e) const
{
    if (!isKnown())
        return {std::numeric_limits<double>::quiet_NaN(), 0};
    TorquePeak peak;
    if (e.speedingMmPerS2 > 0)
        peak = {nmPerMmPerS2 * e.speedingMmPerS2 + frictionNm, e.speedingTimeS};
    const double slowingNm = nmPerMmPerS2 * e.slowingMmPerS2 - frictionNm;
    if (slowingNm > 0)
        raise(peak.nm, peak.timeS, slowingNm, e.slowingTimeS);
    const double frictionLeftNm = frictionNm - nmPerMmPerS2 * e.leastMmPerS2;
    if (frictionLeftNm > 0)
        raise(peak.nm, peak.timeS, frictionLeftNm, e.leastTimeS);
    return peak;
}

double TorqueLoad::rmsNm(const TorqueMeans& means) const
{
    if (!isKnown())
        return std::numeric_limits<double>::quiet_NaN();
    const double square = nmPerMmPerS2 * nmPerMmPerS2 * means.squareMm2PerS4 +
                          2 * nmPerMmPerS2 * frictionNm * means.speedGainMmPerS2 +
                          frictionNm * frictionNm * means.movingShare;
    return std::sqrt(maxOf(square, 0.0));
}

double TorqueLoad::speedingAllowance(double maxTorqueNm) const
{
    return isKnown() && maxTorqueNm > 0 ? (maxTorqueNm - frictionNm) / nmPerMmPerS2 : unlimited;
}

double TorqueLoad::slowingAllowance(double maxTorqueNm) const
{
    return isKnown() && maxTorqueNm > 0 ? (maxTorqueNm + frictionNm) / nmPerMmPerS2 : unlimited;
}

double TorqueLoad::peakShare(const AccelerationExtremes& e, double maxTorqueNm) const
{
    const double speeding = speedingAllowance(maxTorqueNm);
    if (!(speeding > 0) && e.speedingMmPerS2 > 0)
        return 0;
    const double share =
        minOf(e.speedingMmPerS2 > 0 ? speeding / e.speedingMmPerS2 : unlimited,
              e.slowingMmPerS2 > 0 ? slowingAllowance(maxTorqueNm) / e.slowingMmPerS2 : unlimited);
    return share * e.leastMmPerS2 < -speeding ? 0 : share;
}

double TorqueLoad::rmsAllowance(double ratedTorqueNm, double movingShare) const
{
    if (!isKnown() || !(ratedTorqueNm > 0))
        return unlimited;
    const double left = ratedTorqueNm * ratedTorqueNm - frictionNm * frictionNm * movingShare;
    return left >= 0 ? std::sqrt(left) / nmPerMmPerS2 : std::numeric_limits<double>::lowest();
}

TorqueLoad knifeLoad(const Machine& machine)
{
    const double gear = static_cast<double>(machine.gearNumerator) / machine.gearDenominator;
    return {machine.inertiaKgCm2 * kgM2PerKgCm2 * gear / machine.knifeRadiusMm, machine.frictionNm};
}

TorqueLoad axisLoad(const Machine& machine)
{
    return {machine.inertiaKgCm2 * kgM2PerKgCm2 * 2 * std::numbers::pi / machine.feedMmPerMotorRev,
            machine.frictionNm};
}

TorqueMeans torqueMeans(const MotionProfile& motion)
{
    TorqueMeans means;
    const double duration = motion.durationS();
    if (!(duration > 0))
        return means;
    double standing = 0;
    for (const Segment& segment : motion.segments()) {
        means.squareMm2PerS4 += squareOf(segment) / duration;
        means.speedGainMmPerS2 += (std::abs(segment.at(segment.endS()).velocityMmPerS) -
                                   std::abs(segment.at(segment.startS).velocityMmPerS)) /
                                  duration;
        standing += isStanding(segment) ? segment.durationS : 0;
    }
    means.movingShare = 1 - standing / duration;
    return means;
}

double lawSpeedSquare(const Law& law, const LawParameters& parameters)
{
    return lawSquare(law, parameters, &LawPoint::g1);
}

double lawAccelerationSquare(const Law& law, const LawParameters& parameters)
{
    return lawSquare(law, parameters, &LawPoint::g2);
}

} // namespace campanel::profile
