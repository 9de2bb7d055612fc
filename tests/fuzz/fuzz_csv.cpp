// SPDX-License-Identifier: Apache-2.0
// Knots and segments from CSV text: what is read is written and read back the same, and a valid list makes a
// cam.
#include "profile/cam/knots_csv.h"
#include "profile/cam/point_cam.h"
#include "profile/cam/point_cam_validate.h"
#include "profile/segments/segment_cam.h"
#include "profile/segments/segments_csv.h"
#include "tests/fuzz/fuzz_target.h"

#include <cmath>
#include <string_view>

namespace campanel::fuzz {
namespace {

using namespace campanel::profile;

void checkError(const CsvError& error)
{
    require(error.line >= 1, "an error has its line");
    require(error.found.size() <= 40, "an error quotes at most 40 bytes");
}

void runKnots(std::string_view text)
{
    const auto knots = readKnotsCsv(text);
    if (!knots)
        return checkError(knots.error());
    require(!knots->empty(), "a list has rows");
    const std::string written = writeKnotsCsv(*knots);
    const auto back = readKnotsCsv(written);
    require(back && writeKnotsCsv(*back) == written, "knots come back as they were written");
    if (checkKnots(*knots))
        return;
    PointCamProgram program;
    program.knots = *knots;
    const auto solved = solve(program, Machine{});
    require(!solved || std::isfinite(solved->motion.durationS()), "a cam has a time");
}

void runSegments(std::string_view text)
{
    const auto segments = readSegmentsCsv(text);
    if (!segments)
        return checkError(segments.error());
    const std::string written = writeSegmentsCsv(*segments);
    const auto back = readSegmentsCsv(written);
    require(back && writeSegmentsCsv(*back) == written, "segments come back as they were written");
    if (checkSegments(*segments))
        return;
    SegmentCamProgram program;
    program.segments = *segments;
    const auto solved = solve(program, Machine{});
    require(!solved || std::isfinite(solved->motion.durationS()), "a cam has a time");
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    (void)csvLineOfRow(text, bytes.size() % 7);
    runKnots(text);
    runSegments(text);
}

std::vector<Bytes> targetSeeds()
{
    return {bytesOf(writeKnotsCsv(PointCamProgram{}.knots)),
            bytesOf(writeSegmentsCsv(SegmentCamProgram{}.segments)),
            bytesOf("\xEF\xBB\xBFmaster_deg;slave_mm\r\n0;0\r\n90;12,5\r\n\r\n 180 ; 25,0 \r\n270;12,5\r\n"),
            bytesOf("master_deg,slave_mm\n0,1e300\n90,-0\n180,1e-320\n")};
}

} // namespace campanel::fuzz
