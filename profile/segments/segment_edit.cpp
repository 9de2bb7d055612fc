// SPDX-License-Identifier: Apache-2.0
#include "profile/segments/segment_edit.h"

#include "profile/laws/laws.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::profile {
namespace {

double limitedTo(double value, double limit, double step)
{
    return std::isfinite(value) ? detail::onStep(clamped(value, -limit, limit), step) : 0;
}

SegmentBoundary boundaryOnGrid(double speedMmPerDeg, double accelerationMmPerDeg2)
{
    return {limitedTo(speedMmPerDeg, maxBoundarySpeedMmPerDeg, boundarySpeedStepMmPerDeg),
            limitedTo(accelerationMmPerDeg2, maxBoundaryAccelerationMmPerDeg2,
                      boundaryAccelerationStepMmPerDeg2)};
}

SegmentBoundary boundaryAt(const SegmentPiece& piece, double masterDeg)
{
    const SplinePoint point = piece.at(masterDeg);
    return boundaryOnGrid(point.slope, point.curvature);
}

// Rounds; a value far beyond any range is unchanged, so that its refusal names it.
double roundedTo(double value, double step)
{
    const double rounded = detail::onStep(value, step);
    return std::isfinite(rounded) ? rounded : value;
}

CamSegment segmentPart(double fromDeg, double toDeg, SegmentMotion motion, double endMm)
{
    CamSegment segment;
    segment.fromDeg = fromDeg;
    segment.toDeg = toDeg;
    segment.motion = motion;
    segment.endMm = endMm;
    return segment;
}

// Makes every number possible, and the segments follow each other from 0 to 360 degrees.
void mendLayout(std::vector<CamSegment>& segments)
{
    if (segments.empty())
        segments = {segmentPart(0, camCycleDeg, SegmentMotion::Dwell, 0)};
    segments.resize(minOf(segments.size(), maxSegments));
    double least = 0;
    for (CamSegment& segment : segments) {
        least += minMasterSpacingDeg;
        const double to = std::isfinite(segment.toDeg) ? clamped(segment.toDeg, 0.0, camCycleDeg) : 0;
        segment.toDeg = detail::onStep(maxOf(to, least), masterStepDeg);
        least = segment.toDeg;
        segment.endMm = detail::slaveOnGrid(segment.endMm);
        segment.start = boundaryOnGrid(segment.start.speedMmPerDeg, segment.start.accelerationMmPerDeg2);
        segment.end = boundaryOnGrid(segment.end.speedMmPerDeg, segment.end.accelerationMmPerDeg2);
        const SegmentMotionInfo* motion = findSegmentMotion(segment.motion);
        if (motion == nullptr)
            segment.motion = SegmentMotion::Polynomial5;
        else if (motion->law != nullptr)
            for (std::size_t i = 0; i < motion->law->parameters.size(); ++i) {
                const LawParameterInfo& range = motion->law->parameters[i];
                double& value = segment.lawParameters[i];
                value = std::isfinite(value) ? clamped(value, range.min, range.max) : range.defaultValue;
            }
    }
    double most = camCycleDeg;
    for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment) {
        segment->toDeg = segment == segments.rbegin() ? most : minOf(segment->toDeg, most);
        most = detail::onStep(segment->toDeg - minMasterSpacingDeg, masterStepDeg);
    }
    for (std::size_t i = 0; i < segments.size(); ++i)
        segments[i].fromDeg = i == 0 ? 0 : segments[i - 1].toDeg;
}

// The order in which motions keep the values at their ends.
enum class Rigidity : std::uint8_t { Free, Law, ConstantSpeed, Dwell };

Rigidity rigidity(const CamSegment& segment, const SegmentPiece& piece, double masterDeg)
{
    if (segment.motion == SegmentMotion::Dwell)
        return Rigidity::Dwell;
    if (segment.motion == SegmentMotion::ConstantSpeed)
        return Rigidity::ConstantSpeed;
    return piece.law != nullptr && boundaryAt(piece, masterDeg).accelerationMmPerDeg2 == 0 ? Rigidity::Law
                                                                                           : Rigidity::Free;
}

// Makes the segment a polynomial with the same values at its ends.
void makeFree(CamSegment& segment, const SegmentPiece& piece)
{
    if (segment.motion == SegmentMotion::Polynomial5)
        return;
    segment.start = boundaryAt(piece, piece.start);
    segment.end = boundaryAt(piece, piece.end());
    segment.motion = SegmentMotion::Polynomial5;
    segment.lawParameters = {};
}

// Smooths the joint at which segment `index` begins.
void smoothJoint(std::vector<CamSegment>& segments, std::size_t index)
{
    CamSegment& behind = segments[index];
    CamSegment& before = segments[index == 0 ? segments.size() - 1 : index - 1];
    const std::vector<SegmentPiece> pieces = segmentPieces(segments);
    const SegmentPiece& pieceBehind = pieces[index];
    const SegmentPiece& pieceBefore = pieces[index == 0 ? pieces.size() - 1 : index - 1];
    const SegmentBoundary last = boundaryAt(pieceBefore, pieceBefore.end());
    const SegmentBoundary first = boundaryAt(pieceBehind, pieceBehind.start);
    const Rigidity rigidBefore = rigidity(before, pieceBefore, pieceBefore.end());
    const Rigidity rigidBehind = rigidity(behind, pieceBehind, pieceBehind.start);
    const bool bothGiveWay = rigidBefore == Rigidity::Free && rigidBehind == Rigidity::Free;
    SegmentBoundary target = rigidBehind > rigidBefore ? first : last;
    if (bothGiveWay)
        target = boundaryOnGrid((last.speedMmPerDeg + first.speedMmPerDeg) / 2,
                                (last.accelerationMmPerDeg2 + first.accelerationMmPerDeg2) / 2);
    if (bothGiveWay || rigidBehind > rigidBefore) {
        makeFree(before, pieceBefore);
        before.end = target;
    }
    if (bothGiveWay || rigidBehind <= rigidBefore) {
        makeFree(behind, pieceBehind);
        behind.start = target;
    }
}

// Returns the middle of a segment that can be divided.
std::optional<double> dividedAt(const SegmentCamProgram& program, std::size_t index)
{
    if (index >= program.segments.size() || program.segments.size() >= maxSegments)
        return std::nullopt;
    const CamSegment& segment = program.segments[index];
    return detail::masterBetween(segment.fromDeg, segment.toDeg, (segment.fromDeg + segment.toDeg) / 2);
}

void insertBehind(SegmentCamProgram& program, std::size_t index, const CamSegment& segment)
{
    program.segments.insert(program.segments.begin() + static_cast<std::ptrdiff_t>(index) + 1, segment);
    program.segments = onSegmentGrid(program.segments);
}

} // namespace

std::vector<CamSegment> onSegmentGrid(std::span<const CamSegment> segments)
{
    const std::vector<double> positions = detail::enteredPositionsMm(segments);
    std::vector<CamSegment> result(segments.begin(), segments.end());
    for (std::size_t i = 0; i < result.size(); ++i) {
        CamSegment& segment = result[i];
        segment.fromDeg = roundedTo(segment.fromDeg, masterStepDeg);
        segment.toDeg = roundedTo(segment.toDeg, masterStepDeg);
        segment.endMm = roundedTo(positions[i + 1], slaveStepMm);
        const SegmentMotionInfo* motion = findSegmentMotion(segment.motion);
        const int order = motion != nullptr ? motion->boundaryOrder : 0;
        for (SegmentBoundary* boundary : {&segment.start, &segment.end}) {
            boundary->speedMmPerDeg =
                order > 0 ? roundedTo(boundary->speedMmPerDeg, boundarySpeedStepMmPerDeg) : 0;
            boundary->accelerationMmPerDeg2 =
                order > 1 ? roundedTo(boundary->accelerationMmPerDeg2, boundaryAccelerationStepMmPerDeg2) : 0;
        }
        const std::size_t parameters =
            motion != nullptr && motion->law != nullptr ? motion->law->parameters.size() : 0;
        for (std::size_t each = 0; each < segment.lawParameters.size(); ++each) {
            constexpr double parameterStep = 1e-6;
            segment.lawParameters[each] =
                each < parameters ? roundedTo(segment.lawParameters[each], parameterStep) : 0;
        }
    }
    return result;
}

SegmentCamProgram closed(SegmentCamProgram program)
{
    std::vector<double> positions = detail::enteredPositionsMm(program.segments);
    detail::closePositions(positions);
    for (std::size_t i = 0; i < program.segments.size(); ++i)
        program.segments[i].endMm = positions[i + 1];
    return program;
}

SegmentCamProgram repaired(SegmentCamProgram program)
{
    mendLayout(program.segments);
    if (netAdvanceMm(program) == 0)
        program = closed(std::move(program));
    std::vector<CamSegment>& segments = program.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!segmentJoints(program)[i].isSmooth)
            smoothJoint(segments, i);
    }
    segments = onSegmentGrid(segments);
    return program;
}

std::optional<std::size_t> splitSegment(SegmentCamProgram& program, std::size_t index)
{
    const auto middle = dividedAt(program, index);
    if (!middle)
        return std::nullopt;
    const SegmentPiece piece = segmentPieces(program.segments)[index];
    CamSegment& first = program.segments[index];
    CamSegment second = first;
    if (piece.law != nullptr)
        first.motion = second.motion = SegmentMotion::Polynomial5;
    first.toDeg = second.fromDeg = *middle;
    first.endMm = detail::slaveOnGrid(piece.at(*middle).value);
    first.start = boundaryAt(piece, piece.start);
    first.end = second.start = boundaryAt(piece, *middle);
    second.end = boundaryAt(piece, piece.end());
    insertBehind(program, index, second);
    return index + 1;
}

std::optional<std::size_t> insertDwell(SegmentCamProgram& program, std::size_t index)
{
    const auto middle = dividedAt(program, index);
    if (!middle)
        return std::nullopt;
    CamSegment& first = program.segments[index];
    const CamSegment dwell = segmentPart(*middle, first.toDeg, SegmentMotion::Dwell, first.endMm);
    first.toDeg = *middle;
    insertBehind(program, index, dwell);
    return index + 1;
}

bool removeSegment(SegmentCamProgram& program, std::size_t index)
{
    std::vector<CamSegment>& segments = program.segments;
    if (segments.size() <= 1 || index >= segments.size())
        return false;
    const CamSegment removed = segments[index];
    const bool isLast = index + 1 == segments.size();
    const bool previousMoves = index > 0 && segments[index - 1].motion != SegmentMotion::Dwell;
    if (isLast || previousMoves || (index > 0 && removed.motion == SegmentMotion::Dwell)) {
        segments[index - 1].toDeg = removed.toDeg;
        segments[index - 1].endMm = removed.endMm; // a dwell keeps its own
    } else {
        segments[index + 1].fromDeg = removed.fromDeg;
    }
    segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(index));
    segments = onSegmentGrid(segments);
    return true;
}

void moveSegmentEnd(SegmentCamProgram& program, std::size_t index, double masterDeg, double slaveMm)
{
    std::vector<CamSegment>& segments = program.segments;
    if (index + 1 < segments.size()) {
        const auto deg = detail::masterBetween(segments[index].fromDeg, segments[index + 1].toDeg, masterDeg);
        segments[index].toDeg = segments[index + 1].fromDeg = deg.value_or(segments[index].toDeg);
    }
    const auto moves = [](const CamSegment& segment) { return segment.motion != SegmentMotion::Dwell; };
    const auto end = segments.begin() + static_cast<std::ptrdiff_t>(index) + 1;
    const auto moved = std::find_if(std::make_reverse_iterator(end), segments.rend(), moves);
    if (moved == segments.rend() || !std::isfinite(slaveMm))
        return;
    moved->endMm = detail::slaveOnGrid(slaveMm);
    if (std::none_of(end, segments.end(), moves) && netAdvanceMm(program) == 0)
        moved->endMm = 0;
    segments = onSegmentGrid(segments);
}

void setSegmentMotion(SegmentCamProgram& program, std::size_t index, SegmentMotion motion)
{
    const SegmentMotionInfo* wanted = findSegmentMotion(motion);
    CamSegment& segment = program.segments[index];
    if (wanted == nullptr || segment.motion == motion)
        return;
    const SegmentPiece piece = segmentPieces(program.segments)[index];
    segment.start = boundaryAt(piece, piece.start);
    segment.end = boundaryAt(piece, piece.end());
    segment.motion = motion;
    segment.lawParameters = wanted->law != nullptr ? defaultParameters(*wanted->law) : LawParameters{};
    program.segments = onSegmentGrid(program.segments);
}

} // namespace campanel::profile
