// SPDX-License-Identifier: Apache-2.0
// campanelctl compare: the same motion with every suitable law, peaks side by side. The laws of a rotary
// cutter are ranked, each with its own best ratios.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"
#include "profile/model/vibration.h"
#include "profile/moves/compare_laws.h"

#include <QJsonArray>
#include <QtNumeric>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

template <typename P>
std::vector<profile::LawComparison> compared(const P& program, const profile::Machine& machine)
{
    return profile::compareLaws(program, machine, profile::suitableLaws(program));
}

QJsonObject comparisonRow(const profile::LawComparison& each, const profile::ShaftMode& mode)
{
    QJsonObject row{{u"law"_s, fromView(profile::findLaw(each.choice.law)->key)}};
    if (!each.result) {
        row[u"refusal"_s] = panel::RefusalSentences::withSuggestions(each.result.error());
        return row;
    }
    const profile::Peaks& peaks = each.result->peaks;
    row[u"time_s"_s] = each.result->motion.durationS();
    row[u"speed_mm_per_s"_s] = peaks.speedMmPerS;
    row[u"motor_rpm"_s] = peaks.motorRpm;
    row[u"acceleration_mm_per_s2"_s] = peaks.accelerationMmPerS2;
    row[u"jerk_mm_per_s3"_s] = peaks.jerkMmPerS3; // JSON has no infinity: null
    row[u"torque_nm"_s] = peaks.torqueNm;         // null while the inertia is unknown
    row[u"rms_torque_nm"_s] = peaks.rmsTorqueNm;
    row[u"residual_mm"_s] = profile::residualAmplitudeMm(each.result->motion, mode);
    row[u"feasible"_s] = each.result->broken.empty();
    return row;
}

QJsonObject rankedRow(const profile::RankedLaw& each, const profile::Machine& machine)
{
    const profile::RotaryCutterProgram& program = each.program;
    QJsonObject row{{u"law"_s, fromView(profile::findLaw(program.speedLaw)->key)},
                    {u"k"_s, QJsonArray{program.k[0], program.k[1], program.k[2], program.k[3]}},
                    {u"motor_rpm"_s, each.peaks.motorRpm},
                    {u"acceleration_mm_per_s2"_s, each.peaks.accelerationMmPerS2},
                    {u"rms_acceleration_mm_per_s2"_s, each.rmsAccelerationMmPerS2},
                    {u"jerk_mm_per_s3"_s, each.peaks.jerkMmPerS3}, // JSON has no infinity: null
                    {u"feasible"_s, each.isFeasible}};
    if (!each.cycle)
        return row;
    if (const auto fastest = profile::fastestRate({program, machine, *each.cycle, {}}))
        row[u"fastest_bags_per_min"_s] = fastest->rateBagsPerMin;
    return row;
}

QString cell(const QJsonValue& value, int width, int decimals, const QString& otherwise)
{
    const double number = value.toDouble(qQNaN());
    return (std::isfinite(number) ? QString::number(number, 'f', decimals) : otherwise).rightJustified(width);
}

constexpr int lawWidth = 20;

QString verdict(const QJsonObject& row)
{
    return (row[u"feasible"_s].toBool() ? u"yes"_s : u"no"_s).rightJustified(13);
}

// The laws of a rotary cutter, the gentlest first, each with the ratios that suit it.
QByteArray rankedText(const QJsonArray& rows)
{
    const QString unknown = u"--"_s;
    QString text =
        u"law                         k1      k4    r/min     mm/s^2  rms mm/s^2       mm/s^3  bags/min within limits\n"_s;
    for (const QJsonValue& each : rows) {
        const QJsonObject row = each.toObject();
        text += u"%1 %2 %3 %4 %5 %6 %7 %8 %9\n"_s.arg(
            row[u"law"_s].toString().leftJustified(lawWidth), cell(row[u"k"_s][0], 9, 4, unknown),
            cell(row[u"k"_s][3], 7, 4, unknown), cell(row[u"motor_rpm"_s], 8, 1, unknown),
            cell(row[u"acceleration_mm_per_s2"_s], 10, 1, unknown),
            cell(row[u"rms_acceleration_mm_per_s2"_s], 11, 1, unknown),
            cell(row[u"jerk_mm_per_s3"_s], 12, 0, u"steps"_s),
            cell(row[u"fastest_bags_per_min"_s], 9, 1, unknown), verdict(row));
    }
    return text.toUtf8();
}

QByteArray comparisonText(const QJsonArray& rows)
{
    QString text =
        u"law                     time s     r/min      mm/s^2        mm/s^3        Nm within limits\n"_s;
    for (const QJsonValue& each : rows) {
        const QJsonObject row = each.toObject();
        if (row.contains(u"refusal"_s)) {
            text += u"%1 %2\n"_s.arg(row[u"law"_s].toString().leftJustified(lawWidth),
                                     cellText(row[u"refusal"_s].toString()));
            continue;
        }
        text += u"%1 %2 %3 %4 %5 %6 %7\n"_s.arg(
            row[u"law"_s].toString().leftJustified(lawWidth), cell(row[u"time_s"_s], 9, 3, {}),
            cell(row[u"motor_rpm"_s], 9, 1, {}), cell(row[u"acceleration_mm_per_s2"_s], 11, 1, {}),
            cell(row[u"jerk_mm_per_s3"_s], 13, 0, u"steps"_s), cell(row[u"torque_nm"_s], 9, 4, u"--"_s),
            verdict(row));
    }
    return text.toUtf8();
}

} // namespace

Outcome runCompare(const Invocation& call)
{
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    QJsonArray rows;
    if (recipe->isCutter()) {
        const program::Recipe rounded = program::quantised(*recipe);
        for (const profile::RankedLaw& each : profile::rankLaws(rounded.cutter(), rounded.machine))
            rows.append(rankedRow(each, rounded.machine));
        return call.deliver(call.format() == u"json" ? formatted({{u"laws"_s, rows}}, call.format())
                                                     : rankedText(rows));
    }
    std::vector<profile::LawComparison> laws;
    if (const auto* move = std::get_if<profile::PositionMoveProgram>(&recipe->program))
        laws = compared(*move, recipe->machine);
    else if (const auto* change = std::get_if<profile::SpeedMoveProgram>(&recipe->program))
        laws = compared(*change, recipe->machine);
    else
        return fail(ExitCode::Usage,
                    u"Laws are compared for --kind position_move, speed_move and rotary_cutter."_s);
    for (const profile::LawComparison& each : laws)
        rows.append(comparisonRow(each, profile::shaftMode(recipe->machine)));
    if (call.format() == u"json")
        return call.deliver(formatted(QJsonObject{{u"laws"_s, rows}}, call.format()));
    return call.deliver(comparisonText(rows));
}

} // namespace campanel::cli
