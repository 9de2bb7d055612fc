// SPDX-License-Identifier: Apache-2.0
// Cams of segments: what is refused and where, curve and cycle against independent numbers, joints and their
// repair, the panel's edits, CSV, and random cams through all of it.
#include "profile/cam/cam_table.h"
#include "profile/laws/laws.h"
#include "profile/segments/segment_edit.h"
#include "profile/segments/segments_csv.h"
#include "random_cases.h"
#include "random_segments.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

Q_DECLARE_METATYPE(std::vector<campanel::profile::CamSegment>)

namespace test_segments {

using namespace campanel::profile;
using campanel::profile::test::RandomSegments;
using campanel::profile::test::SegmentRecipe;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr SegmentMotion quintic = segmentMotion(LawId::Quintic);
constexpr SegmentMotion harmonic = segmentMotion(LawId::Harmonic);

bool near(double actual, double expected, double tolerance = 1e-9)
{
    return std::abs(actual - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

CamSegment segment(double fromDeg, double toDeg, SegmentMotion motion, double endMm = 0)
{
    return {fromDeg, toDeg, motion, endMm, {}, {}, {}};
}

SegmentCamProgram camOf(std::vector<CamSegment> segments)
{
    SegmentCamProgram program;
    program.segments = std::move(segments);
    return program;
}

// A polynomial 5 of 40 mm over 100 degrees, a polynomial 3 back to 10 mm over 80 degrees, a quintic to 0.
SegmentCamProgram polynomials()
{
    SegmentCamProgram program =
        camOf({segment(0, 100, SegmentMotion::Polynomial5, 40),
               segment(100, 180, SegmentMotion::Polynomial3, 10), segment(180, 360, quintic, 0)});
    program.segments[0].end = {0.5, -0.01};
    program.segments[1].start = {0.5, 0};
    return program;
}

AxisMotion solvedCam(const SegmentCamProgram& program, const Machine& machine = {})
{
    const auto motion = solve(program, machine);
    if (!motion)
        qFatal("%s", describe(motion.error()).c_str());
    return *motion;
}

bool isContinuous(const SegmentCamProgram& program)
{
    return std::ranges::all_of(segmentJoints(program), &SegmentJoint::isSmooth);
}

// The slave by the definition of the cycle: the angle at this time, its segment, the curve there.
double slaveMmAt(const SegmentCamProgram& program, double timeS)
{
    const double degPerS = 360 / camCycleS(program) * (program.masterRateRevPerMin < 0 ? -1 : 1);
    double deg = std::fmod(program.phaseDeg + degPerS * timeS, 360.0);
    deg += deg < 0 ? 360 : 0;
    for (const SegmentPiece& piece : segmentPieces(program.segments)) {
        if (deg <= piece.end())
            return program.slaveScale * piece.at(deg).value;
    }
    return noNumber;
}

} // namespace

class TestSegments : public QObject {
    Q_OBJECT

private slots:
    void refusesBadSegments_data();
    void refusesBadSegments();
    void refusesNoMotion();
    void everyDisplacementLawIsAMotion();
    void curveOfPolynomials();
    void cycleOfLaws();
    void peaksOfAPolynomial();
    void jumpNamesThePlaceAndTheRate();
    void repairTakesEveryJump_data();
    void repairTakesEveryJump();
    void repairMendsTheLayout();
    void divides();
    void removes();
    void movesEnds();
    void changesMotions();
    void tripsAsCsv();
    void refusesBadCsv_data();
    void refusesBadCsv();
    void randomCams();

private:
    static void verifyCycle(const SegmentRecipe& recipe, const AxisMotion& cam, RandomSegments& random);
    static void verifyEdits(const SegmentRecipe& recipe, RandomSegments& random);
    static void verifyTable(const SegmentRecipe& recipe, const CamTable& table);
};

void TestSegments::refusesBadSegments_data()
{
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("allowed");
    QTest::addColumn<std::vector<CamSegment>>("segments");
    const auto row = [](const char* name, std::vector<CamSegment> segments, Limit limit, int index,
                        double allowed) {
        QTest::newRow(name) << static_cast<int>(limit) << index << allowed << std::move(segments);
    };
    row("none", {}, Limit::SegmentCount, 0, 1);
    row("forty-one", std::vector<CamSegment>(41), Limit::SegmentCount, 0, 40);
    row("overlap", {segment(0, 120, quintic, 5), segment(110, 360, quintic)}, Limit::SegmentOverlap, 1, 120);
    row("gap", {segment(0, 120, quintic, 5), segment(130, 360, quintic)}, Limit::SegmentGap, 1, 120);
    row("begins late", {segment(1, 360, quintic, 5)}, Limit::SegmentEnds, 0, 0);
    row("ends early", {segment(0, 120, quintic, 5), segment(120, 350, quintic)}, Limit::SegmentEnds, 1, 360);
    row("no width", {segment(0, 120, quintic, 5), segment(120, 120, quintic), segment(120, 360, quintic)},
        Limit::SegmentWidth, 1, 0.1);
    row("backward", {segment(0, 120, quintic, 5), segment(120, 110, quintic), segment(110, 360, quintic)},
        Limit::SegmentWidth, 1, 0.1);
    row("beyond the cycle", {segment(0, 361, quintic, 5)}, Limit::SegmentRange, 0, 360);
    row("no angle", {segment(0, noNumber, quintic, 5)}, Limit::SegmentRange, 0, 0);
    row("too far", {segment(0, 360, quintic, 2e6)}, Limit::SegmentRange, 0, 1e6);
    std::vector<CamSegment> fast{segment(0, 360, SegmentMotion::Polynomial3, 5)};
    fast[0].end.speedMmPerDeg = -3000;
    row("boundary speed", fast, Limit::SegmentRange, 0, -2000);
    fast[0].end = {0, 300};
    row("boundary acceleration", fast, Limit::SegmentRange, 0, 200);
    row("unknown motion", {segment(0, 360, static_cast<SegmentMotion>(77), 5)}, Limit::SegmentMotion, 0, 105);
    row("a speed law", {segment(0, 360, segmentMotion(LawId::Exponential), 5)}, Limit::SegmentMotion, 0, 105);
    row("parameter", {segment(0, 360, segmentMotion(LawId::Trapezoid), 5)}, Limit::LawParameter, 0,
        findLaw(LawId::Trapezoid)->parameters[0].min);
}

void TestSegments::refusesBadSegments()
{
    QFETCH(int, limit);
    QFETCH(int, index);
    QFETCH(double, allowed);
    QFETCH(std::vector<CamSegment>, segments);
    const auto motion = solve(camOf(segments), {});
    QVERIFY(!motion.has_value());
    QCOMPARE(limitId(motion.error().limit), limitId(static_cast<Limit>(limit)));
    QCOMPARE(motion.error().index, index);
    QCOMPARE(motion.error().allowed, allowed);
    // The repair always leads to a possible cam.
    QVERIFY(!checkSegments(repaired(camOf(segments)).segments));
}

void TestSegments::refusesNoMotion()
{
    SegmentCamProgram program = camOf({segment(0, 360, SegmentMotion::Dwell)});
    QVERIFY(solve(program, {}).error().limit == Limit::NoMotion);
    program = camOf({segment(0, 360, SegmentMotion::Polynomial3)});
    program.segments[0].start.speedMmPerDeg = 0.1;
    QVERIFY(solve(program, {}).has_value()); // leaves 0 and comes back
    program = {};
    program.masterRateRevPerMin = 0;
    QVERIFY(solve(program, {}).error().field == Field::MasterRate);
    for (const Field field : {Field::MasterRate, Field::MasterRamp, Field::MasterRatio, Field::MasterScale,
                              Field::SlaveScale, Field::Phase, Field::CamPoints}) {
        program = {};
        setValue(program, field, info(field).max + 1);
        QVERIFY(solve(program, {}).error().field == field);
    }
}

void TestSegments::everyDisplacementLawIsAMotion()
{
    for (const Law& law : laws())
        QCOMPARE(findSegmentMotion(law.key) != nullptr, law.isDisplacementLaw);
    for (const SegmentMotionInfo& each : segmentMotions()) {
        QCOMPARE(findSegmentMotion(each.motion), &each);
        QCOMPARE(findSegmentMotion(each.key), &each);
    }
}

// The coefficients come from a linear system of equations in fractions, outside of this project.
void TestSegments::curveOfPolynomials()
{
    const auto pieces = segmentPieces(polynomials().segments);
    const auto check = [&](std::size_t index, double deg, double value, double slope, double curvature) {
        const SplinePoint point = pieces[index].at(deg);
        QVERIFY(near(point.value, value) && near(point.slope, slope) && near(point.curvature, curvature));
    };
    check(0, 25, 1.796875, 0.1953125, 0.0125);
    check(0, 60, 16.0704, 0.5832, 0.00648);
    check(0, 100, 40, 0.5, -0.01);
    QVERIFY(near(pieces[0].at(60).third, -0.000396));
    check(1, 120, 40.9375, -0.328125, -0.0296875);
    check(1, 150, 23.0078125, -0.69140625, 0.00546875);
    check(2, 270, 5, -10 * 1.875 / 180, 0);
}

// 50 mm over a third of a second: quintic up, modified sine down.
void TestSegments::cycleOfLaws()
{
    const AxisMotion cam = solvedCam({});
    QVERIFY(cam.broken.empty());
    QVERIFY(near(cam.motion.durationS(), 1));
    QVERIFY(near(cam.peaks.speedMmPerS, 281.25));
    QVERIFY(near(cam.peaks.accelerationMmPerS2, 2598.0762113533165));
    QVERIFY(near(cam.motion.at(0.25).positionMm, 50 * 0.896484375)); // x = 0.75
    QVERIFY(near(cam.motion.at(0.5 + 30.0 / 360).positionMm, 44.141075769269655));
    QVERIFY(near(cam.motion.at(0.9).positionMm, 0));
    SegmentCamProgram back;
    back.masterRateRevPerMin = -30;
    back.phaseDeg = 60;
    back.slaveScale = 2;
    const AxisMotion slow = solvedCam(back);
    QVERIFY(near(slow.motion.durationS(), 2));
    QVERIFY(near(slow.motion.at(0).positionMm, 50)); // in the middle of the rise
    QVERIFY(near(slow.motion.at(0).velocityMmPerS, -281.25));
    QVERIFY(near(slow.motion.at(30.0 / 180).positionMm, 2 * 50 * (1 - 0.896484375)));
    QVERIFY(near(slow.motion.at(1).positionMm, 2 * 50 * 0.5)); // 240 degrees: half way down
}

void TestSegments::peaksOfAPolynomial()
{
    const SegmentCamProgram program = polynomials();
    const AxisMotion cam = solvedCam(program);
    // Of the first segment; the second one is faster at its start and in the middle.
    MotionProfile first;
    const Segment& segmentInTime = cam.motion.segments()[0];
    first.addPart(segmentInTime);
    const Peaks peaks = axisPeaks(first, {});
    QVERIFY(near(peaks.speedMmPerS, 227.8125) && near(peaks.speedTimeS, 75.0 / 360));
    QVERIFY(near(peaks.accelerationMmPerS2, 1683.5533848858176, 1e-8));
    QVERIFY(near(peaks.accelerationTimeS, 31.6985 / 360, 1e-5));
}

void TestSegments::jumpNamesThePlaceAndTheRate()
{
    SegmentCamProgram program =
        camOf({segment(0, 100, SegmentMotion::ConstantSpeed, 100), segment(100, 200, SegmentMotion::Dwell),
               segment(200, 360, quintic, 0)});
    program.masterRateRevPerMin = 120; // 720 mm/s; 50 000 mm/s2 in 2 ms is 100 mm/s
    const AxisMotion cam = solvedCam(program);
    const Refusal& jump = cam.broken.back();
    QVERIFY(jump.limit == Limit::JointJump);
    QCOMPARE(jump.index, 0); // the first of the two equal jumps
    QVERIFY(near(jump.actual, 720));
    QVERIFY(near(jump.allowed, 100));
    QVERIFY(near(*jump.angleDeg, 0));
    QVERIFY(std::isinf(cam.peaks.jerkMmPerS3));
    QCOMPARE(jump.nearest.size(), std::size_t{1});
    setValue(program, jump.nearest[0].field, jump.nearest[0].value);
    QVERIFY(solvedCam(program).broken.empty());
    QCOMPARE(jump.nearest[0].value, 16.6);
    program.masterRateRevPerMin = 120;
    QVERIFY(!isContinuous(program));
    const AxisMotion mended = solvedCam(repaired(program));
    QVERIFY(mended.broken.empty());
    QVERIFY(std::isfinite(mended.peaks.jerkMmPerS3));
}

void TestSegments::repairTakesEveryJump_data()
{
    QTest::addColumn<std::vector<CamSegment>>("segments");
    QTest::addColumn<int>("changed"); // segments with another motion
    QTest::newRow("nothing to do") << SegmentCamProgram{}.segments << 0;
    QTest::newRow("constant and dwell")
        << std::vector{segment(0, 90, SegmentMotion::ConstantSpeed, 50),
                       segment(90, 180, SegmentMotion::Dwell, 50), segment(180, 360, quintic, 0)}
        << 2;
    QTest::newRow("harmonic and dwell")
        << std::vector{segment(0, 90, harmonic, 50), segment(90, 180, SegmentMotion::Dwell, 50),
                       segment(180, 360, quintic, 0)}
        << 1;
    QTest::newRow("two speeds") << std::vector{segment(0, 90, SegmentMotion::ConstantSpeed, 50),
                                               segment(90, 360, SegmentMotion::ConstantSpeed, 80)}
                                << 1;
    QTest::newRow("one speed") << std::vector{segment(0, 360, SegmentMotion::ConstantSpeed, 80)} << 0;
    QTest::newRow("a single harmonic") << std::vector{segment(0, 360, harmonic, 80)} << 1;
    QTest::newRow("not quite closed")
        << std::vector{segment(0, 90, quintic, 50), segment(90, 180, quintic, 0.3)} << 0;
    QTest::newRow("polynomials") << polynomials().segments << 1;
}

void TestSegments::repairTakesEveryJump()
{
    QFETCH(std::vector<CamSegment>, segments);
    QFETCH(int, changed);
    const SegmentCamProgram before = camOf(segments);
    const SegmentCamProgram after = repaired(before);
    QVERIFY(isContinuous(after));
    QVERIFY(!checkSegments(after.segments));
    int differing = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        differing += after.segments[i].motion != segments[i].motion;
        QVERIFY(i + 1 == segments.size() || near(after.segments[i].endMm, segments[i].endMm));
    }
    QCOMPARE(differing, changed);
    QCOMPARE(repaired(after).segments == after.segments, true);
}

void TestSegments::repairMendsTheLayout()
{
    const SegmentCamProgram after =
        repaired(camOf({segment(5, 120, quintic, 50), segment(100, 90, SegmentMotion::Dwell),
                        segment(200, 300, quintic, 0), segment(310, 340, SegmentMotion::Dwell)}));
    QVERIFY(isContinuous(after));
    const std::vector<std::pair<double, double>> places{{0, 120}, {120, 120.1}, {120.1, 300}, {300, 360}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        QCOMPARE(after.segments[i].fromDeg, places[i].first);
        QCOMPARE(after.segments[i].toDeg, places[i].second);
    }
    std::vector<CamSegment> late(40, segment(0, 360, quintic, 5));
    QVERIFY(!checkSegments(repaired(camOf(late)).segments)); // squeezed before the end
}

void TestSegments::divides()
{
    SegmentCamProgram program = polynomials();
    const auto before = segmentPieces(program.segments);
    QCOMPARE(splitSegment(program, 0), std::optional<std::size_t>(1));
    QCOMPARE(splitSegment(program, 2), std::optional<std::size_t>(3));
    QCOMPARE(program.segments.size(), std::size_t{5});
    const auto after = segmentPieces(program.segments);
    for (double deg = 1; deg < 180; deg += 7) { // the curve of polynomials stays, but for the grid
        const double was = before[deg < 100 ? 0 : 1].at(deg).value;
        const double is = after[deg < 50 ? 0 : (deg < 100 ? 1 : (deg < 140 ? 2 : 3))].at(deg).value;
        QVERIFY2(std::abs(is - was) < 2e-3, qPrintable(QString::number(deg)));
    }
    QCOMPARE(insertDwell(program, 4), std::optional<std::size_t>(5));
    QVERIFY(program.segments[5].motion == SegmentMotion::Dwell);
    QCOMPARE(program.segments[5].fromDeg, 270.0);
    QVERIFY(!checkSegments(program.segments));
    SegmentCamProgram narrow = camOf({segment(0, 0.1, quintic, 1), segment(0.1, 360, quintic, 0)});
    QVERIFY(!splitSegment(narrow, 0) && !insertDwell(narrow, 0));
    SegmentCamProgram full;
    for (std::size_t i = 0; full.segments.size() < maxSegments; i = (i + 2) % full.segments.size())
        QVERIFY(splitSegment(full, i).has_value());
    QVERIFY(!splitSegment(full, 39));
}

void TestSegments::removes()
{
    SegmentCamProgram program;
    QVERIFY(!removeSegment(program, 4));
    QVERIFY(removeSegment(program, 2)); // the return: the dwell behind it cannot take it, the one before does
    QVERIFY(!checkSegments(program.segments));
    program = {};
    QVERIFY(removeSegment(program, 1));
    QCOMPARE(program.segments[0].toDeg, 180.0);
    QCOMPARE(program.segments[0].endMm, 50.0);
    QVERIFY(removeSegment(program, 0));
    QCOMPARE(program.segments[0].fromDeg, 0.0);
    QVERIFY(removeSegment(program, 1) && !removeSegment(program, 0));
}

void TestSegments::movesEnds()
{
    SegmentCamProgram program;
    moveSegmentEnd(program, 0, 100.00004, 45.0004);
    QCOMPARE(program.segments[0].toDeg, 100.0);
    QCOMPARE(program.segments[1].fromDeg, 100.0);
    QCOMPARE(program.segments[0].endMm, 45.0);
    moveSegmentEnd(program, 0, 400, 45);
    QCOMPARE(program.segments[0].toDeg, 179.9);
    moveSegmentEnd(program, 1, 200, 60); // a dwell takes the rise along
    QCOMPARE(program.segments[0].endMm, 60.0);
    QCOMPARE(program.segments[1].endMm, 60.0);
    moveSegmentEnd(program, 3, 300, 0.5); // the end of the cycle snaps to its beginning
    QCOMPARE(program.segments[3].toDeg, 360.0);
    QCOMPARE(program.segments[3].endMm, 0.0);
    moveSegmentEnd(program, 3, 300, 20);
    QCOMPARE(netAdvanceMm(program), 20.0);
    SegmentCamProgram first = camOf({segment(0, 90, SegmentMotion::Dwell), segment(90, 360, quintic, 50)});
    moveSegmentEnd(first, 0, 80, 7); // nothing before it can move
    QCOMPARE(first.segments[0].endMm, 0.0);
    QCOMPARE(first.segments[0].toDeg, 80.0);
}

void TestSegments::changesMotions()
{
    SegmentCamProgram program =
        camOf({segment(0, 90, SegmentMotion::ConstantSpeed, 45), segment(90, 360, quintic, 0)});
    setSegmentMotion(program, 0, SegmentMotion::Polynomial5);
    QVERIFY(near(program.segments[0].start.speedMmPerDeg, 0.5));
    QVERIFY(near(program.segments[0].end.speedMmPerDeg, 0.5));
    setSegmentMotion(program, 1, segmentMotion(LawId::Trapezoid));
    QCOMPARE(program.segments[1].lawParameters[0], findLaw(LawId::Trapezoid)->parameters[0].defaultValue);
    setSegmentMotion(program, 0, SegmentMotion::Dwell);
    QCOMPARE(program.segments[0].endMm, 0.0);
    QCOMPARE(program.segments[0].start.speedMmPerDeg, 0.0);
    QVERIFY(!checkSegments(program.segments));
}

void TestSegments::tripsAsCsv()
{
    const std::string text = writeSegmentsCsv(polynomials().segments);
    const auto read = readSegmentsCsv(text);
    QVERIFY(read.has_value());
    QVERIFY(*read == onSegmentGrid(polynomials().segments));
    const auto european = readSegmentsCsv(
        "from_deg;to_deg;motion;end_mm;start_speed_mm_per_deg;start_acceleration_mm_per_deg2;end_speed_mm_"
        "per_deg;"
        "end_acceleration_mm_per_deg2;law_parameter1;law_parameter2\n0;90,5;trapezoid;12,25;;;;;0,3;\n"
        "90,5;360;dwell;;;;;;;\n");
    QVERIFY(european.has_value());
    QCOMPARE(european->at(0).toDeg, 90.5);
    QCOMPARE(european->at(0).lawParameters[0], 0.3);
    QCOMPARE(european->at(1).endMm, 12.25); // a dwell stays
    // A spreadsheet quotes, and leaves out empty cells at the end of a line.
    const auto quoted = readSegmentsCsv(
        "from_deg,to_deg,motion,end_mm,start_speed_mm_per_deg,start_acceleration_mm_per_deg2,end_speed_mm_"
        "per_deg,end_acceleration_mm_per_deg2,law_parameter1,law_parameter2,,\r\n"
        "0,\"90,5\",\"trapezoid\",\"12,25\",,,,,\"0,3\",,,\r\n\"90,5\",360,dwell\r\n,,,,,,,,,,,\r\n");
    QVERIFY2(quoted, quoted ? "" : quoted.error().found.c_str());
    QVERIFY(*quoted == *european);
}

void TestSegments::refusesBadCsv_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("expected");
    QTest::newRow("motion") << QByteArray("0,360,hop,5,,,,,,") << static_cast<int>(CsvExpectation::Motion);
    QTest::newRow("columns") << QByteArray("0,360") << static_cast<int>(CsvExpectation::Values);
    QTest::newRow("too many") << QByteArray("0,360,dwell,,,,,,,,x")
                              << static_cast<int>(CsvExpectation::Values);
    QTest::newRow("left out") << QByteArray("0,360,quintic") << static_cast<int>(CsvExpectation::Number);
    QTest::newRow("no end") << QByteArray("0,360,quintic,,,,,,,") << static_cast<int>(CsvExpectation::Number);
    QTest::newRow("no speed") << QByteArray("0,360,polynomial_3,5,,,,,,")
                              << static_cast<int>(CsvExpectation::Number);
    QTest::newRow("angle") << QByteArray("x,360,dwell,,,,,,,") << static_cast<int>(CsvExpectation::Number);
    QTest::newRow("nothing") << QByteArray() << static_cast<int>(CsvExpectation::Rows);
}

void TestSegments::refusesBadCsv()
{
    QFETCH(QByteArray, line);
    QFETCH(int, expected);
    std::string text = writeSegmentsCsv({});
    text += line.toStdString();
    const auto read = readSegmentsCsv(text);
    QVERIFY(!read.has_value());
    QCOMPARE(static_cast<int>(read.error().expected), expected);
    QVERIFY(line.isEmpty() || read.error().line == 2);
    QVERIFY(readSegmentsCsv("master_deg,slave_mm\n").error().expected == CsvExpectation::Header);
}

void TestSegments::verifyCycle(const SegmentRecipe& recipe, const AxisMotion& cam, RandomSegments& random)
{
    const double room = 1e-8 * std::max(1.0, std::abs(recipe.program.slaveScale) * 1000);
    const double advanceMm = jointPositionsMm(recipe.program.segments).back() * recipe.program.slaveScale;
    for (int i = 0; i < 5; ++i) {
        const double timeS = random.uniform(0, cam.motion.durationS());
        // An advance is added where the cycle passes its wrap.
        const double off = cam.motion.at(timeS).positionMm - slaveMmAt(recipe.program, timeS);
        const double wrapped = off - (recipe.program.masterRateRevPerMin < 0 ? -advanceMm : advanceMm);
        QVERIFY(std::min(std::abs(off), std::abs(wrapped)) <= room);
    }
    const double sign = recipe.program.masterRateRevPerMin > 0 ? 1 : -1;
    const MotionPoint last = cam.motion.at(cam.motion.durationS());
    QVERIFY(std::abs(last.positionMm - cam.motion.at(0).positionMm - sign * advanceMm) <= room);
    for (int i = 0; i <= 200; ++i) {
        const MotionPoint p = cam.motion.at(cam.motion.durationS() * i / 200);
        QVERIFY(std::abs(p.velocityMmPerS) <= cam.peaks.speedMmPerS * (1 + 1e-6) + 1e-9);
        QVERIFY(std::abs(p.accelerationMmPerS2) <= cam.peaks.accelerationMmPerS2 * (1 + 1e-6) + 1e-6);
    }
    if (cam.broken.empty())
        QVERIFY(isWithinLimits(cam.peaks, recipe.machine));
    for (const Refusal& refusal : cam.broken) {
        for (const Suggestion& s : refusal.nearest) {
            SegmentCamProgram mended = recipe.program;
            setValue(mended, s.field, s.value);
            QVERIFY2(solvedCam(mended, recipe.machine).broken.empty(), describe(refusal).c_str());
        }
    }
}

void TestSegments::verifyEdits(const SegmentRecipe& recipe, RandomSegments& random)
{
    const SegmentCamProgram mended = repaired(recipe.program);
    QVERIFY(!checkSegments(mended.segments));
    QVERIFY(isContinuous(mended));
    QVERIFY(repaired(mended).segments == mended.segments);
    const auto read = readSegmentsCsv(writeSegmentsCsv(mended.segments));
    QVERIFY(read && onSegmentGrid(*read) == mended.segments);
    SegmentCamProgram edited = recipe.program;
    for (int i = 0; i < 6; ++i) {
        const std::size_t index = random.pick(edited.segments.size());
        switch (random.pick(5)) {
        case 0:
            static_cast<void>(splitSegment(edited, index));
            break;
        case 1:
            static_cast<void>(insertDwell(edited, index));
            break;
        case 2:
            static_cast<void>(removeSegment(edited, index));
            break;
        case 3:
            moveSegmentEnd(edited, index, random.uniform(-50, 400), random.uniform(-200, 200));
            break;
        default:
            setSegmentMotion(edited, index, segmentMotions()[random.pick(segmentMotions().size())].motion);
        }
        QVERIFY(!checkSegments(edited.segments));
    }
    // Damage as a file may have it: refused or possible, and mended in any case.
    edited.segments[random.pick(edited.segments.size())].toDeg = random.uniform(-10, 400);
    edited.segments[random.pick(edited.segments.size())].fromDeg = random.uniform(-10, 400);
    QVERIFY(!checkSegments(repaired(edited).segments));
}

void TestSegments::verifyTable(const SegmentRecipe& recipe, const CamTable& table)
{
    const MotionProfile motion = forwardMotion(recipe.program);
    const double units = 256 * axisPulsesPerMm(recipe.machine);
    const CamErrors errors = camErrors(table, motion, recipe.machine, CamUse::Repeats);
    const double netMm = jointPositionsMm(recipe.program.segments).back() * recipe.program.slaveScale;
    QVERIFY(std::abs(table.advance.asDouble() - netMm * axisPulsesPerMm(recipe.machine)) <=
            1e-9 * std::max(1.0, std::abs(table.advance.asDouble())));
    for (int i = 0; i < 400; ++i) {
        const double place = (i + 0.3) / 400 * recipe.program.camPoints;
        const auto index = static_cast<std::size_t>(place);
        const double is = interpolate(table, index, place - static_cast<double>(index)).position256 / units;
        const double wanted = motion.at(motion.durationS() * place / recipe.program.camPoints).positionMm -
                              motion.at(0).positionMm;
        QVERIFY(std::abs(is - wanted) <= errors.positionMm * (1 + 1e-9) + 1e-9);
    }
}

void TestSegments::randomCams()
{
    constexpr unsigned seed = 20'261'124;
    const int count = campanel::test::randomCases();
    qInfo("seed %u, %d cams", seed, count);
    RandomSegments random(seed);
    int refused = 0;
    int broken = 0;
    int tables = 0;
    for (int i = 0; i < count && !QTest::currentTestFailed(); ++i) {
        const SegmentRecipe recipe = random.next();
        verifyEdits(recipe, random);
        const auto cam = solve(recipe.program, recipe.machine);
        if (!cam) {
            ++refused;
            continue;
        }
        verifyCycle(recipe, *cam, random);
        broken += !cam->broken.empty();
        const auto table = buildCamTable(recipe.program, recipe.machine);
        if (!table)
            continue;
        ++tables;
        if (tables % 20 == 0)
            verifyTable(recipe, *table);
    }
    qInfo("%d refused, %d beyond a limit, %d tables", refused, broken, tables);
    if (QTest::currentTestFailed())
        return;
    QVERIFY(refused > 0 && broken > count / 50 && tables > count / 50 && broken < count);
}

CAMPANEL_TEST(TestSegments)

} // namespace test_segments

#include "test_segments.moc"
