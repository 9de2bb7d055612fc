// SPDX-License-Identifier: Apache-2.0
// campanelctl intervals: any recipe as intervals of constant acceleration, or one interval of the paper with
// the time of each of its pulses.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/program/interval_speeds.h"
#include "app/program/solved_program.h"
#include "profile/intervals/interval_times.h"
#include "profile/intervals/intervals.h"

#include <QJsonArray>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

QJsonArray timesMs(const std::vector<double>& timesS)
{
    constexpr double msPerS = 1000;
    QJsonArray list;
    for (const double time : timesS)
        list.append(time * msPerS);
    return list;
}

// Handles "10,50,800,40000": distance, first speed, last speed, acceleration.
Outcome runCamMov(const Invocation& call)
{
    std::array<double, 4> values{};
    const QStringList parts = call.value(u"cam-mov"_s).split(u',');
    bool isGood = parts.size() == 4;
    for (qsizetype i = 0; isGood && i < parts.size(); ++i) {
        values[static_cast<std::size_t>(i)] = parts[i].trimmed().toDouble(&isGood);
        isGood = isGood && values[static_cast<std::size_t>(i)] > 0;
    }
    constexpr double maxPulses = 1e6; // limit of the number of lines
    if (!isGood || values[0] != std::floor(values[0]) || values[0] > maxPulses)
        return fail(
            ExitCode::Usage,
            u"--cam-mov takes four numbers above zero: whole pulses (at most a million), first and last speed, acceleration."_s);
    const auto pulses = static_cast<std::uint32_t>(values[0]);
    QJsonObject object;
    for (const auto mode : {profile::IntervalMode::Published, profile::IntervalMode::Corrected}) {
        const auto row = profile::intervalRow(pulses, values[1], values[2], values[3], mode);
        if (!row)
            return fail(row.error());
        const std::vector<double> times = profile::pulseTimesS(row->row, row->fractionBits);
        const QString name = mode == profile::IntervalMode::Published ? u"published"_s : u"corrected"_s;
        object[name] =
            QJsonObject{{u"total_ms"_s, times.back() * 1000}, {u"pulse_times_ms"_s, timesMs(times)}};
    }
    object[u"theory_total_ms"_s] = profile::intervalTheoryS(pulses, values[1], values[2], values[3]) * 1000;
    if (call.format() != u"text")
        return call.deliver(formatted(object, call.format()));
    QString text = u"theory %1 ms\n"_s.arg(object[u"theory_total_ms"_s].toDouble(), 0, 'f', 7);
    for (const QString& mode : {u"published"_s, u"corrected"_s}) {
        const QJsonObject result = object[mode].toObject();
        text += u"%1 %2 ms, pulses at"_s.arg(mode, QString::number(result[u"total_ms"_s].toDouble(), 'f', 5));
        for (const QJsonValue& time : result[u"pulse_times_ms"_s].toArray())
            text += u" %1"_s.arg(time.toDouble(), 0, 'f', 5);
        text += u'\n';
    }
    return call.deliver(text.toUtf8());
}

} // namespace

Outcome runIntervals(const Invocation& call)
{
    if (call.isSet(u"cam-mov"_s))
        return runCamMov(call);
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto solved = program::solveProgram(*recipe);
    if (!solved)
        return fail(solved.error());
    bool isNumber = false;
    const double error = call.value(u"speed-error-mm-per-s"_s).toDouble(&isNumber);
    if (!isNumber)
        return fail(ExitCode::Usage, u"--speed-error-mm-per-s takes a number."_s);
    profile::Machine machine = solved->machine;
    // The compiler gets pulses per mm from the feed; a knife has a circumference.
    if (solved->cutter)
        machine.feedMmPerMotorRev = machine.pulsesPerMotorRev / solved->pulsesPerMm;
    const auto mode =
        call.isSet(u"published"_s) ? profile::IntervalMode::Published : profile::IntervalMode::Corrected;
    const auto table = profile::compileIntervals(solved->motion, machine, error, mode);
    if (!table)
        return fail(table.error());
    std::vector<double> pulses;
    std::vector<double> first;
    std::vector<double> last;
    std::vector<double> acceleration;
    for (const profile::IntervalRow& row : table->rows) {
        const program::IntervalSpeeds speeds = program::speedsOf(row, table->fractionBits);
        pulses.push_back(row.pulses);
        first.push_back(speeds.firstHz);
        last.push_back(speeds.lastHz);
        acceleration.push_back(speeds.accelerationHzPerS);
    }
    if (call.format() == u"csv")
        return call.deliver(csvTable({{"pulses", &pulses},
                                      {"first_hz", &first},
                                      {"last_hz", &last},
                                      {"acceleration_hz_per_s", &acceleration}}));
    QJsonArray rows;
    for (std::size_t i = 0; i < pulses.size(); ++i)
        rows.append(QJsonArray{pulses[i], first[i], last[i], acceleration[i]});
    QJsonObject object{{u"rows_used"_s, static_cast<qint64>(table->rows.size())},
                       {u"fewest_lines"_s, table->minLinks},
                       {u"pulses"_s, static_cast<qint64>(table->advance)},
                       {u"time_s"_s, table->timeS},
                       {u"profile_time_s"_s, table->profileTimeS},
                       {u"errors"_s, QJsonObject{{u"speed_mm_per_s"_s, table->errors.speedMmPerS},
                                                 {u"position_pulses"_s, table->errors.positionPulses}}}};
    if (call.format() == u"json")
        object[u"rows"_s] = rows;
    return call.deliver(formatted(object, call.format()));
}

} // namespace campanel::cli
