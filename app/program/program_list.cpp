// SPDX-License-Identifier: Apache-2.0
#include "app/program/program_list.h"

#include "app/program/register_words.h"
#include "modbus/map/register_map.h"
#include "profile/cam/cam_cycle.h"
#include "profile/cam/knots_csv.h"
#include "profile/cam/point_cam_edit.h"
#include "profile/segments/segment_edit.h"
#include "profile/segments/segments_csv.h"
#include "text/marked.h"

#include <algorithm>
#include <cmath>

namespace campanel::program {
namespace {

using profile::PointCamProgram;
using profile::Program;
using profile::SegmentCamProgram;

// The steps of the registers.
constexpr double stepsPerDeg = 10000;
constexpr double stepsPerMm = 1000;
constexpr double speedSteps = 1e6;
constexpr double accelerationSteps = 1e7;
constexpr double parameterSteps = 1e6;

double onListGrid(double value, double steps)
{
    const double rounded = std::round(value * steps) / steps;
    return std::isfinite(rounded) ? rounded : value;
}

void appendUnsigned(std::vector<std::uint16_t>& registers, double value, double steps)
{
    append32(registers, static_cast<std::uint32_t>(std::lround(value * steps)));
}

void appendSigned(std::vector<std::uint16_t>& registers, double value, double steps)
{
    append32(registers, static_cast<std::int32_t>(std::lround(value * steps)));
}

double unsignedAt(std::span<const std::uint16_t> registers, std::size_t at, double steps)
{
    return get32(registers, at) / steps;
}

double signedAt(std::span<const std::uint16_t> registers, std::size_t at, double steps)
{
    return static_cast<std::int32_t>(get32(registers, at)) / steps;
}

std::vector<profile::Knot>& knotsOf(Program& program)
{
    return std::get<PointCamProgram>(program).knots;
}

const std::vector<profile::Knot>& knotsOf(const Program& program)
{
    return std::get<PointCamProgram>(program).knots;
}

std::vector<profile::CamSegment>& segmentsOf(Program& program)
{
    return std::get<SegmentCamProgram>(program).segments;
}

const std::vector<profile::CamSegment>& segmentsOf(const Program& program)
{
    return std::get<SegmentCamProgram>(program).segments;
}

void quantiseKnots(Program& program)
{
    for (profile::Knot& knot : knotsOf(program)) {
        knot.masterDeg = onListGrid(knot.masterDeg, stepsPerDeg);
        knot.slaveMm = onListGrid(knot.slaveMm, stepsPerMm);
    }
    auto& cam = std::get<PointCamProgram>(program);
    if (!cam.knots.empty() && netAdvanceMm(cam) == 0)
        cam = profile::closed(std::move(cam));
}

void quantiseSegments(Program& program)
{
    auto& cam = std::get<SegmentCamProgram>(program);
    cam.segments = profile::onSegmentGrid(cam.segments);
    if (netAdvanceMm(cam) == 0)
        cam = profile::closed(std::move(cam));
}

void appendKnots(const Program& program, std::vector<std::uint16_t>& registers)
{
    for (const profile::Knot& knot : knotsOf(program)) {
        appendUnsigned(registers, knot.masterDeg, stepsPerDeg);
        appendSigned(registers, knot.slaveMm, stepsPerMm);
    }
}

void readKnots(std::span<const std::uint16_t> registers, Program& program)
{
    knotsOf(program).clear();
    for (std::size_t at = 0; at + modbus::knotRegisters <= registers.size(); at += modbus::knotRegisters)
        knotsOf(program).push_back(
            {unsignedAt(registers, at, stepsPerDeg), signedAt(registers, at + 2, stepsPerMm)});
}

void appendSegments(const Program& program, std::vector<std::uint16_t>& registers)
{
    for (const profile::CamSegment& segment : segmentsOf(program)) {
        appendUnsigned(registers, segment.toDeg, stepsPerDeg);
        appendSigned(registers, segment.endMm, stepsPerMm);
        registers.push_back(static_cast<std::uint16_t>(segment.motion));
        for (const profile::SegmentBoundary& boundary : {segment.start, segment.end}) {
            appendSigned(registers, boundary.speedMmPerDeg, speedSteps);
            appendSigned(registers, boundary.accelerationMmPerDeg2, accelerationSteps);
        }
        for (const double parameter : segment.lawParameters)
            appendUnsigned(registers, parameter, parameterSteps);
    }
}

void readSegments(std::span<const std::uint16_t> registers, Program& program)
{
    std::vector<profile::CamSegment>& segments = segmentsOf(program);
    segments.clear();
    constexpr std::size_t size = modbus::segmentRegisters;
    for (std::size_t at = 0; at + size <= registers.size(); at += size) {
        profile::CamSegment segment;
        segment.fromDeg = segments.empty() ? 0 : segments.back().toDeg;
        segment.toDeg = unsignedAt(registers, at, stepsPerDeg);
        segment.endMm = signedAt(registers, at + 2, stepsPerMm);
        segment.motion = static_cast<profile::SegmentMotion>(registers[at + 4]);
        segment.start = {signedAt(registers, at + 5, speedSteps),
                         signedAt(registers, at + 7, accelerationSteps)};
        segment.end = {signedAt(registers, at + 9, speedSteps),
                       signedAt(registers, at + 11, accelerationSteps)};
        segment.lawParameters = {unsignedAt(registers, at + 13, parameterSteps),
                                 unsignedAt(registers, at + 15, parameterSteps)};
        segments.push_back(segment);
    }
}

// Moves the entries of a file into the list, or returns the error.
template <typename Entries>
std::optional<profile::CsvError> takeCsv(tl::expected<Entries, profile::CsvError> read, Entries& list)
{
    if (!read)
        return std::move(read.error());
    list = std::move(*read);
    return std::nullopt;
}

std::pair<double, double> slaveRangeOfKnots(const Program& program)
{
    const auto [lowest, highest] = std::ranges::minmax(knotsOf(program), {}, &profile::Knot::slaveMm);
    return {lowest.slaveMm, highest.slaveMm};
}

std::pair<double, double> slaveRangeOfSegments(const Program& program)
{
    const auto [lowest, highest] = std::ranges::minmax(profile::jointPositionsMm(segmentsOf(program)));
    return {lowest, highest};
}

} // namespace

constinit const ListInfo knotList{
    "knots",
    CAMPANEL_TEXT("Recipe", "Knots"),
    "cam.knot_count",
    [](const Program& program) { return knotsOf(program).size(); },
    [](const Program& a, const Program& b) { return knotsOf(a) == knotsOf(b); },
    quantiseKnots,
    appendKnots,
    readKnots,
    profile::knotColumns,
    [](const Program& program, const profile::CsvDialect& dialect) {
        return profile::writeKnotsCsv(knotsOf(program), dialect);
    },
    [](std::string_view text, Program& program) {
        return takeCsv(profile::readKnotsCsv(text), knotsOf(program));
    },
    [](const Program& program) { return profile::checkKnots(knotsOf(program)); },
    slaveRangeOfKnots};

constinit const ListInfo segmentList{
    "segments",
    CAMPANEL_TEXT("Recipe", "Segments"),
    "cam.segment_count",
    [](const Program& program) { return segmentsOf(program).size(); },
    [](const Program& a, const Program& b) { return segmentsOf(a) == segmentsOf(b); },
    quantiseSegments,
    appendSegments,
    readSegments,
    profile::segmentColumns,
    [](const Program& program, const profile::CsvDialect& dialect) {
        return profile::writeSegmentsCsv(segmentsOf(program), dialect);
    },
    [](std::string_view text, Program& program) {
        return takeCsv(profile::readSegmentsCsv(text), segmentsOf(program));
    },
    [](const Program& program) { return profile::checkSegments(segmentsOf(program)); },
    slaveRangeOfSegments};

} // namespace campanel::program
