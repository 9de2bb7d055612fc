// SPDX-License-Identifier: Apache-2.0
// The curve of the segments, its joints, and one cycle in time.
#include "profile/segments/segment_cam.h"

#include "profile/laws/laws.h"
#include "profile/model/bounds.h"
#include "text/marked.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

constexpr int curveDerivatives = 5;

std::vector<SegmentMotionInfo> motionTable()
{
    std::vector<SegmentMotionInfo> table{
        {SegmentMotion::Dwell, "dwell", CAMPANEL_TEXT("Recipe", "Dwell"), nullptr, 0},
        {SegmentMotion::ConstantSpeed, "constant_speed", CAMPANEL_TEXT("Recipe", "Constant speed"), nullptr,
         0},
        {SegmentMotion::Polynomial3, "polynomial_3", CAMPANEL_TEXT("Recipe", "Polynomial 3, with speeds"),
         nullptr, 1},
        {SegmentMotion::Polynomial5, "polynomial_5",
         CAMPANEL_TEXT("Recipe", "Polynomial 5, with speeds and accelerations"), nullptr, 2}};
    for (const Law& law : laws()) {
        if (law.isDisplacementLaw && law.isSymmetric) // backward it is the same law
            table.push_back({segmentMotion(law.id), law.key, law.name, &law, 0});
    }
    return table;
}

// The cubic with these ends: x from 0 to the width.
void setCubic(SegmentPiece& piece, double endSpeed)
{
    const double w = piece.width;
    const double h = piece.distanceMm;
    const double v = piece.boundary.speedMmPerDeg;
    piece.boundary.accelerationMmPerDeg2 = 2 * (3 * h - (2 * v + endSpeed) * w) / (w * w);
    piece.thirdMmPerDeg3 = 6 * ((v + endSpeed) * w - 2 * h) / (w * w * w);
}

// The polynomial of the fifth degree with these ends.
void setQuintic(SegmentPiece& piece, const SegmentBoundary& end)
{
    const double w = piece.width;
    const double h = piece.distanceMm;
    const double v0 = piece.boundary.speedMmPerDeg * w;
    const double v1 = end.speedMmPerDeg * w;
    const double a0 = piece.boundary.accelerationMmPerDeg2 * w * w;
    const double a1 = end.accelerationMmPerDeg2 * w * w;
    const double cubed = w * w * w;
    piece.thirdMmPerDeg3 = 3 * (20 * h - 8 * v1 - 12 * v0 - 3 * a0 + a1) / cubed;
    piece.fourthMmPerDeg4 = 12 * (-30 * h + 14 * v1 + 16 * v0 + 3 * a0 - 2 * a1) / (cubed * w);
    piece.fifthMmPerDeg5 = 60 * (12 * h - 6 * (v1 + v0) + a1 - a0) / (cubed * w * w);
}

SegmentPiece pieceOf(const CamSegment& segment, double startMm, double endMm)
{
    SegmentPiece piece;
    piece.start = segment.fromDeg;
    piece.width = segment.toDeg - segment.fromDeg;
    piece.startMm = startMm;
    piece.distanceMm = endMm - startMm;
    const SegmentMotionInfo* motion = findSegmentMotion(segment.motion);
    piece.law = motion->law;
    piece.lawParameters = segment.lawParameters;
    if (segment.motion == SegmentMotion::ConstantSpeed)
        piece.boundary.speedMmPerDeg = piece.distanceMm / piece.width;
    if (motion->boundaryOrder > 0)
        piece.boundary = segment.start;
    if (motion->boundaryOrder == 1)
        setCubic(piece, segment.end.speedMmPerDeg);
    if (motion->boundaryOrder == 2)
        setQuintic(piece, segment.end);
    return piece;
}

// Returns true when the slave stands in all of the segment.
bool isAtRest(const SegmentPiece& piece)
{
    return piece.distanceMm == 0 && piece.boundary == SegmentBoundary{} && piece.thirdMmPerDeg3 == 0 &&
           piece.fourthMmPerDeg4 == 0 && piece.fifthMmPerDeg5 == 0;
}

// Returns the sizes of the terms that slope and curvature at the end of the piece are sums of.
SegmentBoundary termsOf(const SegmentPiece& piece)
{
    const double w = piece.width;
    const double fifth = std::abs(piece.fifthMmPerDeg5) * w / 3;
    const double third = std::abs(piece.thirdMmPerDeg3) + (std::abs(piece.fourthMmPerDeg4) + fifth) * w / 2;
    const double curvature =
        std::abs(piece.boundary.accelerationMmPerDeg2) + std::abs(piece.distanceMm) / (w * w) + third * w;
    return {std::abs(piece.boundary.speedMmPerDeg) + curvature * w, curvature};
}

// Returns behind - before, or 0 within the rounding of sums of such terms.
double jumpBetween(double before, double behind, double terms)
{
    constexpr double roundingShare = 1e-12;
    return std::abs(behind - before) <= roundingShare * terms ? 0 : behind - before;
}

// The slave and its five derivatives by the angle, of a polynomial.
std::array<double, curveDerivatives + 1> polynomialAt(const SegmentPiece& piece, double masterDeg)
{
    std::array<double, curveDerivatives + 1> values{
        piece.startMm,        piece.boundary.speedMmPerDeg, piece.boundary.accelerationMmPerDeg2,
        piece.thirdMmPerDeg3, piece.fourthMmPerDeg4,        piece.fifthMmPerDeg5};
    const double x = masterDeg == piece.end() ? piece.width : masterDeg - piece.start;
    // Taylor's series of each derivative, from its last term back.
    for (int order = 0; order < curveDerivatives; ++order) {
        double sum = 0;
        for (int i = curveDerivatives; i > order; --i)
            sum = (sum + values[static_cast<std::size_t>(i)]) * x / (i - order);
        values[static_cast<std::size_t>(order)] += sum;
    }
    return values;
}

void addSegmentPart(MotionProfile& motion, const SegmentPiece& piece, double fromDeg, double toDeg,
                    double degPerS, double scale)
{
    Segment part;
    part.durationS = std::abs(toDeg - fromDeg) / std::abs(degPerS);
    if (piece.law != nullptr && piece.distanceMm != 0) {
        const bool isForward = degPerS > 0;
        const double from = (fromDeg - piece.start) / piece.width;
        const double to = (toDeg - piece.start) / piece.width;
        part.form = SegmentForm::Displacement;
        part.law = piece.law;
        part.parameters = piece.lawParameters;
        part.distanceMm = scale * (isForward ? piece.distanceMm : -piece.distanceMm);
        part.lawFrom = isForward ? from : 1 - from;
        part.lawTo = isForward ? to : 1 - to;
        motion.addPart(part);
        return;
    }
    const auto values = polynomialAt(piece, fromDeg);
    if (piece.law != nullptr ||
        std::all_of(values.begin() + 2, values.end(), [](double v) { return v == 0; })) {
        motion.addConstant(part.durationS, piece.law != nullptr ? 0 : scale * values[1] * degPerS);
        return;
    }
    part.form = SegmentForm::Polynomial;
    const std::array members{&part.startVelocityMmPerS, &part.startAccelerationMmPerS2, &part.jerkMmPerS3,
                             &part.snapMmPerS4, &part.crackleMmPerS5};
    double unit = scale;
    for (std::size_t i = 0; i < members.size(); ++i) {
        unit *= degPerS;
        *members[i] = values[i + 1] * unit;
    }
    motion.addPart(part);
}

MotionProfile segmentMotionOf(const SegmentCamProgram& program, double degPerS)
{
    const std::vector<SegmentPiece> pieces = segmentPieces(program.segments);
    const double phase = detail::phaseWithinCycleDeg(program);
    const auto first =
        std::ranges::find_if(pieces, [phase](const SegmentPiece& p) { return phase < p.end(); });
    const double startMm = first == pieces.end() ? pieces.back().at(phase).value : first->at(phase).value;
    return detail::camCycleMotion(
        program, degPerS, std::span<const SegmentPiece>(pieces), program.slaveScale * startMm,
        [&](MotionProfile& motion, const SegmentPiece& piece, double fromDeg, double toDeg) {
            addSegmentPart(motion, piece, fromDeg, toDeg, degPerS, program.slaveScale);
        });
}

AxisMotion solveValidSegments(const SegmentCamProgram& program, const Machine& machine)
{
    std::vector<detail::SpeedStep> steps;
    for (const SegmentJoint& joint : segmentJoints(program)) {
        const bool isRounding = std::abs(joint.speedMmPerDeg) <= boundarySpeedStepMmPerDeg;
        steps.push_back({joint.masterDeg, isRounding ? 0 : joint.speedMmPerDeg});
    }
    AxisMotion solved =
        detail::solveCycle(program, machine, segmentMotionOf(program, detail::camDegPerS(program)), steps,
                           {Limit::JointJump, true}, std::nullopt);
    for (const CamSegment& segment : program.segments)
        solved.marksS.push_back(detail::timeOfAngleS(program, segment.fromDeg));
    std::ranges::sort(solved.marksS);
    return solved;
}

} // namespace

std::span<const SegmentMotionInfo> segmentMotions()
{
    static const std::vector<SegmentMotionInfo> table = motionTable();
    return table;
}

const SegmentMotionInfo* findSegmentMotion(SegmentMotion motion)
{
    const auto found = std::ranges::find(segmentMotions(), motion, &SegmentMotionInfo::motion);
    return found == segmentMotions().end() ? nullptr : &*found;
}

const SegmentMotionInfo* findSegmentMotion(std::string_view key)
{
    const auto found = std::ranges::find(segmentMotions(), key, &SegmentMotionInfo::key);
    return found == segmentMotions().end() ? nullptr : &*found;
}

SplinePoint SegmentPiece::at(double masterDeg) const
{
    if (law == nullptr) {
        const auto values = polynomialAt(*this, masterDeg);
        return {values[0], values[1], values[2], values[3]};
    }
    const double x = masterDeg == end() ? 1 : clamped((masterDeg - start) / width, 0.0, 1.0);
    const LawPoint p = law->at(x, lawParameters);
    return {startMm + distanceMm * p.g, distanceMm / width * p.g1, distanceMm / (width * width) * p.g2,
            distanceMm / (width * width * width) * p.g3};
}

std::vector<double> detail::enteredPositionsMm(std::span<const CamSegment> segments)
{
    std::vector<double> positions{0};
    for (const CamSegment& segment : segments)
        positions.push_back(segment.motion == SegmentMotion::Dwell ? positions.back() : segment.endMm);
    return positions;
}

void detail::closePositions(std::vector<double>& positionsMm)
{
    const double endMm = positionsMm.back();
    for (auto each = positionsMm.rbegin(); each != positionsMm.rend() && *each == endMm; ++each)
        *each = 0;
}

std::vector<double> jointPositionsMm(std::span<const CamSegment> segments)
{
    std::vector<double> positions = detail::enteredPositionsMm(segments);
    Extent extent;
    for (const double position : positions)
        extent.add(position);
    if (detail::withoutClosingError(positions.back(), extent.span()) == 0)
        detail::closePositions(positions);
    return positions;
}

std::vector<SegmentPiece> segmentPieces(std::span<const CamSegment> segments)
{
    const std::vector<double> positions = jointPositionsMm(segments);
    std::vector<SegmentPiece> pieces;
    for (std::size_t i = 0; i < segments.size(); ++i)
        pieces.push_back(pieceOf(segments[i], positions[i], positions[i + 1]));
    return pieces;
}

double netAdvanceMm(const SegmentCamProgram& program)
{
    return jointPositionsMm(program.segments).back();
}

double closingErrorMm(const SegmentCamProgram& program)
{
    return detail::enteredPositionsMm(program.segments).back() - netAdvanceMm(program);
}

std::vector<SegmentJoint> segmentJoints(const SegmentCamProgram& program)
{
    const std::vector<SegmentPiece> pieces = segmentPieces(program.segments);
    std::vector<SegmentJoint> joints;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const SegmentPiece& previous = i == 0 ? pieces.back() : pieces[i - 1];
        const SplinePoint before = previous.at(previous.end());
        const SplinePoint behind = pieces[i].at(pieces[i].start);
        const SegmentBoundary termsBefore = termsOf(previous);
        const SegmentBoundary termsBehind = termsOf(pieces[i]);
        SegmentJoint joint;
        joint.masterDeg = pieces[i].start;
        joint.speedMmPerDeg =
            jumpBetween(before.slope, behind.slope, termsBefore.speedMmPerDeg + termsBehind.speedMmPerDeg);
        joint.accelerationMmPerDeg2 =
            jumpBetween(before.curvature, behind.curvature,
                        termsBefore.accelerationMmPerDeg2 + termsBehind.accelerationMmPerDeg2);
        joint.isSmooth = std::abs(joint.speedMmPerDeg) <= boundarySpeedStepMmPerDeg &&
                         std::abs(joint.accelerationMmPerDeg2) <= boundaryAccelerationStepMmPerDeg2;
        joints.push_back(joint);
    }
    return joints;
}

MotionProfile forwardMotion(const SegmentCamProgram& program)
{
    return segmentMotionOf(program, std::abs(detail::camDegPerS(program)));
}

tl::expected<AxisMotion, Refusal> solve(const SegmentCamProgram& program, const Machine& machine)
{
    const auto findInvalid = [](const SegmentCamProgram& cam, const Machine& axis) {
        if (auto refusal = detail::findInvalidMaster(cam, axis))
            return refusal;
        if (auto refusal = checkSegments(cam.segments))
            return refusal;
        return detail::findNoMotion(cam, std::ranges::all_of(segmentPieces(cam.segments), isAtRest));
    };
    return detail::solveCam(program, machine, findInvalid, solveValidSegments);
}

} // namespace campanel::profile
