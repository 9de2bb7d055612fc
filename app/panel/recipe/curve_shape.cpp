// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/curve_shape.h"

#include "app/program/solved_program.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace campanel::panel {

namespace {

constexpr int intervals = 60; // one for each pixel or two of a picture
// A cycle ends where it began within this share of its stroke, and a curve that is flatter is a line.
constexpr double sameShare = 1e-6;
constexpr double restShare = 0.35; // before and after a move, of its time

CurveShape scaled(const std::vector<double>& values)
{
    const auto [low, high] = std::ranges::minmax_element(values);
    const double span = *high - *low;
    const bool isFlat = span <= sameShare * std::max(std::abs(*high), std::abs(*low));
    CurveShape shape;
    for (std::size_t i = 0; i < values.size(); ++i)
        shape << QPointF(static_cast<double>(i) / static_cast<double>(values.size() - 1),
                         isFlat ? 0.5 : (values[i] - *low) / span);
    return shape;
}

template <typename Value> CurveShape sampled(Value value)
{
    std::vector<double> values;
    for (int i = 0; i <= intervals; ++i)
        values.push_back(value(static_cast<double>(i) / intervals));
    return scaled(values);
}

} // namespace

CurveShape shapeOf(const program::Recipe& recipe)
{
    const auto solved = program::solveProgram(recipe);
    if (!solved)
        return {};
    const profile::MotionProfile& motion = solved->motion;
    const double cycleS = solved->cycleS();
    const auto position = [&](double x) { return motion.at(x * cycleS).positionMm; };
    double low = position(0);
    double high = low;
    for (int i = 1; i <= intervals; ++i) {
        const double mm = position(static_cast<double>(i) / intervals);
        low = std::min(low, mm);
        high = std::max(high, mm);
    }
    if (recipe.kind() == profile::ProgramKind::PositionMove)
        return sampled(
            [&](double x) { return position(std::clamp(x * (1 + 2 * restShare) - restShare, 0.0, 1.0)); });
    if (std::abs(position(1) - position(0)) <= sameShare * (high - low))
        return sampled(position);
    return sampled([&](double x) { return motion.at(x * cycleS).velocityMmPerS; });
}

CurveShape shapeOf(const profile::Law& law)
{
    const profile::LawParameters parameters = profile::defaultParameters(law);
    // The slope begins and ends at 0, also where it jumps there.
    CurveShape shape = sampled([&](double x) { return law.at(x, parameters).g1; });
    if (shape.first().y() > 0)
        shape.prepend({0, 0});
    if (shape.last().y() > 0)
        shape.append({1, 0});
    return shape;
}

CurveShape shapeOf(const profile::SegmentMotionInfo& motion)
{
    constexpr double cycleDeg = 360;
    profile::CamSegment segment{0, cycleDeg, motion.motion, 1, {}, {}, {}};
    if (motion.motion == profile::SegmentMotion::Dwell)
        segment.endMm = 0;
    if (motion.law)
        segment.lawParameters = profile::defaultParameters(*motion.law);
    const std::array segments{segment};
    const profile::SegmentPiece piece = profile::segmentPieces(segments).front();
    return sampled([&](double x) { return piece.at(x * cycleDeg).value; });
}

} // namespace campanel::panel
