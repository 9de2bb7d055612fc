// SPDX-License-Identifier: Apache-2.0
// Laws against the sine and cosine of the standard library, cam tables against scipy, and the preview of
// every kind of program against one frame.
#include "bench_report.h"

#include "app/program/program_image.h"
#include "app/program/program_kinds.h"
#include "app/program/solved_program.h"
#include "profile/cam/cam_table.h"
#include "profile/cam/point_cam.h"
#include "profile/intervals/intervals.h"
#include "profile/laws/laws.h"

#include <QProcess>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace campanel::bench {
namespace {

using Seconds = std::chrono::duration<double>;

// Returns the fastest of many short rounds, in seconds per call: other load on the machine only makes a round
// slower.
double secondsPerCall(int calls, const std::function<void()>& call)
{
    constexpr int rounds = 25;
    double fastest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i)
            call();
        fastest = std::min(fastest, Seconds(std::chrono::steady_clock::now() - begin).count() / calls);
    }
    return fastest;
}

constexpr int places = 1000;
constexpr int passes = 20;
volatile double sink = 0;

double sineAndCosineS()
{
    return secondsPerCall(passes, [] {
        double sum = 0;
        for (int i = 0; i < places; ++i) {
            const double x = (i + 0.5) / places;
            sum += std::sin(x) + std::cos(x);
        }
        sink = sum;
    });
}

double lawS(const profile::Law& law)
{
    const profile::LawParameters parameters = profile::defaultParameters(law);
    return secondsPerCall(passes, [&] {
        double sum = 0;
        for (int i = 0; i < places; ++i) {
            const profile::LawPoint p = law.at((i + 0.5) / places, parameters);
            sum += p.g + p.g1 + p.g2 + p.g3;
        }
        sink = sum;
    });
}

Figure slowestLaw()
{
    const double peer = sineAndCosineS();
    std::string name;
    double slowest = 0;
    for (const profile::Law& law : profile::laws()) {
        const double time = lawS(law);
        if (time > slowest) {
            slowest = time;
            name = law.key;
        }
    }
    return {"(s, v, a, j) of the slowest law (" + name + ")",
            slowest / peer,
            3,
            "sin + cos",
            "three times std::sin and std::cos",
            true};
}

profile::PointCamProgram hundredKnots()
{
    profile::PointCamProgram cam;
    cam.knots.clear();
    for (int i = 0; i <= 99; ++i) {
        const double deg = 360.0 * i / 99;
        cam.knots.push_back({deg, 50 * (1 - std::cos(deg * 3.14159265358979 / 180))});
    }
    return cam;
}

// Returns scipy's time for the same: a periodic spline through 100 knots and its values and slopes at 1001
// places.
double scipyS()
{
    const char* program =
        "import numpy, time\n"
        "from scipy.interpolate import CubicSpline\n"
        "x = numpy.linspace(0, 360, 100); y = 50 * (1 - numpy.cos(numpy.radians(x))); y[-1] = y[0]\n"
        "q = numpy.linspace(0, 360, 1001)\n"
        "def once():\n"
        "    s = CubicSpline(x, y, bc_type='periodic'); return s(q), s(q, 1)\n"
        "times = []\n"
        "for r in range(25):\n"
        "    b = time.perf_counter()\n"
        "    for i in range(10): once()\n"
        "    times.append((time.perf_counter() - b) / 10)\n"
        "print(min(times))\n";
    QProcess python;
    python.start(QStringLiteral("/usr/bin/python3"), {QStringLiteral("-c"), QString::fromLatin1(program)});
    if (!python.waitForFinished() || python.exitCode() != 0)
        throw std::runtime_error("scipy could not be timed; install python3-scipy");
    return python.readAllStandardOutput().trimmed().toDouble();
}

Figure camTable()
{
    const profile::PointCamProgram cam = hundredKnots();
    const profile::Machine machine;
    if (!profile::buildCamTable(cam, machine))
        throw std::runtime_error("the cam to be timed does not give a table");
    const double own =
        secondsPerCall(10, [&] { sink = profile::buildCamTable(cam, machine)->rows[1].slope256; });
    return {"table of 1000 points from 100 knots",
            own / scipyS(),
            0.2,
            "scipy",
            "a fifth of scipy's CubicSpline",
            true};
}

Figure slowestPreview()
{
    constexpr double msPerS = 1000;
    std::string name;
    double slowest = 0;
    for (const program::KindInfo& kind : program::kinds()) {
        program::Recipe recipe = program::defaultRecipe(kind.kind);
        if (auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
            *cam = hundredKnots();
        const double time = secondsPerCall(5, [&] {
            const auto solved = program::solveProgram(program::quantised(recipe));
            sink = program::sampleCurves(*solved, 1000).positionMm[1];
        });
        if (time > slowest) {
            slowest = time;
            name = kind.key;
        }
    }
    return {
        "solve and sample the slowest kind (" + name + ")", slowest * msPerS, 16, "ms", "one frame", true};
}

// Returns the slowest move over all laws as intervals, as compiled by the panel.
Figure slowestIntervals()
{
    constexpr double msPerS = 1000;
    std::string name;
    double slowest = 0;
    for (const profile::Law& law : profile::laws()) {
        program::Recipe recipe = program::defaultRecipe(
            law.isDisplacementLaw ? profile::ProgramKind::PositionMove : profile::ProgramKind::SpeedMove);
        program::setChoice(recipe.program, program::Choice::Law, static_cast<std::uint16_t>(law.id));
        program::setChoice(recipe.program, program::Choice::Execution,
                           static_cast<std::uint16_t>(profile::Execution::Intervals));
        bool isBuilt = false;
        const double time = secondsPerCall(5, [&] { isBuilt = program::buildProgram(recipe).has_value(); });
        if (isBuilt && time > slowest) {
            slowest = time;
            name = law.key;
        }
    }
    return {
        "build the slowest move as intervals (" + name + ")", slowest * msPerS, 16, "ms", "one frame", true};
}

// Times a long move at almost the smallest speed error that whole pulses allow: hundreds of rows.
Figure finestIntervals()
{
    constexpr double speedErrorMmPerS = 0.001;
    program::Recipe recipe = program::defaultRecipe(profile::ProgramKind::PositionMove);
    profile::PositionMoveProgram move;
    move.law = profile::LawId::Harmonic;
    move.distanceMm = 600;
    move.timeS = 5;
    move.execution = profile::Execution::Intervals;
    recipe.program = move;
    recipe.machine.pulsesPerMotorRev = 100'000;
    const auto solved = program::solveProgram(recipe);
    bool isBuilt = false;
    const double time = secondsPerCall(1, [&] {
        isBuilt = solved && profile::compileIntervals(solved->motion, solved->machine, speedErrorMmPerS,
                                                      profile::IntervalMode::Corrected)
                                .has_value();
    });
    if (!isBuilt)
        throw std::runtime_error("the long move to be timed does not give intervals");
    return {"intervals of a long move at the smallest speed error", time, 1, "s", "one second", true};
}

} // namespace

Figures measurePrograms()
{
    return {slowestLaw(), camTable(), slowestPreview(), slowestIntervals(), finestIntervals()};
}

} // namespace campanel::bench
