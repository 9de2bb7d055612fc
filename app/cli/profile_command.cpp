// SPDX-License-Identifier: Apache-2.0
// campanelctl profile: the numbers, peaks and curves of a recipe.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/program/solved_program.h"
#include "profile/cutter/ratios.h"
#include "profile/moves/position_move.h"

#include <QJsonArray>

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

QJsonArray listOf(const std::vector<double>& values)
{
    QJsonArray list;
    for (const double value : values)
        list.append(value);
    return list;
}

QJsonObject cycleObject(const profile::RotaryCutter& cutter)
{
    const profile::CycleNumbers& cycle = cutter.cycle;
    return {{u"bag_length_mm"_s, cycle.bagLengthMm},
            {u"rate_bags_per_min"_s, cycle.rateBagsPerMin},
            {u"base_speed_mm_per_s"_s, cycle.baseSpeedMmPerS},
            {u"film_speed_mm_per_s"_s, cycle.filmSpeedMmPerS},
            {u"cycle_time_s"_s, cycle.cycleTimeS},
            {u"stroke_mm"_s, cycle.strokeMm},
            {u"weight_s"_s, cycle.weightS},
            {u"speed_ratio"_s, cycle.speedRatio}, // k0
            {u"base_circle_rad_per_s"_s, cycle.baseSpeedMmPerS / cutter.machine.knifeRadiusMm},
            {u"ta_s"_s, cycle.taS},
            {u"tb_s"_s, cycle.tbS},
            {u"tc_s"_s, cycle.tcS},
            {u"td_s"_s, cycle.tdS}};
}

QJsonObject peakObject(const program::SolvedProgram& solved)
{
    const profile::Peaks& peaks = solved.peaks;
    QJsonObject object{{u"speed_mm_per_s"_s, peaks.speedMmPerS},
                       {u"speed_at_s"_s, peaks.speedTimeS},
                       {u"motor_rpm"_s, peaks.motorRpm},
                       {u"pulse_frequency_hz"_s, peaks.pulseFrequencyHz},
                       {u"acceleration_mm_per_s2"_s, peaks.accelerationMmPerS2},
                       {u"acceleration_at_s"_s, peaks.accelerationTimeS},
                       {u"torque_nm"_s, peaks.torqueNm}, // unknown without an inertia, and for a press: null
                       {u"rms_torque_nm"_s, peaks.rmsTorqueNm},
                       {u"jerk_mm_per_s3"_s, peaks.jerkMmPerS3}}; // JSON has no infinity: null
    if (solved.cutter)
        object[u"rms_acceleration_mm_per_s2"_s] =
            profile::rmsAcceleration(solved.cutter->cycle, solved.cutter->program);
    return object;
}

QJsonObject ratioObject(const profile::RotaryCutterProgram& program)
{
    const auto options =
        program::choiceInfo(profile::ProgramKind::RotaryCutter, program::Choice::Ratios).options;
    const auto mode = std::ranges::find(options, static_cast<std::uint16_t>(program.ratioMode),
                                        &program::ChoiceOption::code);
    return {{u"mode"_s, mode == options.end() ? QJsonValue() : QJsonValue(fromView(mode->key))},
            {u"k1"_s, program.k[0]},
            {u"k2"_s, program.k[1]},
            {u"k3"_s, program.k[2]},
            {u"k4"_s, program.k[3]},
            {u"window"_s, 1 / program.k[2] - 1 / program.k[1]}};
}

// The coefficients of s = C0 + C1 t + ..., s in mm and t in ms; empty for a motion that is not one
// polynomial.
QJsonObject coefficientObject(const program::Recipe& recipe, double timeS)
{
    QJsonObject object;
    const auto* move = std::get_if<profile::PositionMoveProgram>(&recipe.program);
    const auto found =
        move ? profile::polynomialCoefficients(move->law, move->distanceMm, timeS) : std::nullopt;
    for (std::size_t i = 0; found && i < found->size(); ++i)
        object[u"C%1"_s.arg(i)] = (*found)[i];
    return object;
}

// Returns the vibration of the shaft; null while its natural frequency is unknown.
QJsonObject vibrationObject(const program::Recipe& recipe, const program::SolvedProgram& solved)
{
    const QString name = solved.cutter                        ? u"seal_error_mm"_s
                         : profile::camMaster(recipe.program) ? u"cycle_error_mm"_s
                                                              : u"residual_mm"_s;
    return {{name, program::vibrationMm(recipe, solved)}};
}

QJsonObject motionObject(const program::SolvedProgram& solved)
{
    const auto begin = solved.motion.at(0);
    const auto end = solved.motion.at(solved.cycleS());
    return {{u"time_s"_s, solved.cycleS()},
            {u"distance_mm"_s, end.positionMm - begin.positionMm},
            {u"start_speed_mm_per_s"_s, begin.velocityMmPerS},
            {u"end_speed_mm_per_s"_s, end.velocityMmPerS},
            {u"pulses_per_mm"_s, solved.pulsesPerMm}};
}

// Returns the curves by the names of their columns; the torque only where it is known.
std::vector<Column> columnsOf(const profile::Curves& curves)
{
    std::vector<Column> columns{{"time_s", &curves.timeS},
                                {"position_mm", &curves.positionMm},
                                {"velocity_mm_per_s", &curves.velocityMmPerS},
                                {"acceleration_mm_per_s2", &curves.accelerationMmPerS2},
                                {"jerk_mm_per_s3", &curves.jerkMmPerS3},
                                {"frequency_hz", &curves.frequencyHz}};
    if (!curves.torqueNm.empty())
        columns.push_back({"torque_nm", &curves.torqueNm});
    return columns;
}

QJsonObject curveObject(const profile::Curves& curves)
{
    QJsonObject object;
    for (const Column& column : columnsOf(curves))
        object[QLatin1StringView(column.name)] = listOf(*column.values);
    return object;
}

} // namespace

Outcome runProfile(const Invocation& call)
{
    bool ok = false;
    const int points = call.value(u"points"_s).toInt(&ok);
    constexpr int maxPoints = 100'000;
    if (!ok || points < 2 || points > maxPoints)
        return fail(ExitCode::Usage, u"--points takes a whole number from 2 to %1."_s.arg(maxPoints));
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto solved = program::solveProgram(program::quantised(*recipe)); // quantised like the table
    if (!solved)
        return fail(solved.error());
    const program::ProgramRefusal broken{solved->broken, std::nullopt};
    const auto curves = [&] { return program::sampleCurves(*solved, static_cast<std::size_t>(points)); };

    QByteArray text;
    if (call.format() == u"csv") {
        const profile::Curves sampled = curves();
        text = csvTable(columnsOf(sampled));
    } else {
        QJsonArray limits;
        for (const profile::Refusal& limit : broken.limits)
            limits.append(panel::RefusalSentences::withSuggestions(limit));
        QJsonObject object{
            {u"name"_s, QString::fromStdString(recipe->name)},
            {u"kind"_s, fromView(program::kindInfo(recipe->kind()).key)},
            {u"cycle"_s, solved->cutter ? cycleObject(*solved->cutter) : motionObject(*solved)},
            {u"peaks"_s, peakObject(*solved)},
            {u"vibration"_s, vibrationObject(*recipe, *solved)},
            {u"feasible"_s, broken.limits.empty()},
            {u"broken_limits"_s, limits}};
        addAdvance(object, recipe->program);
        if (const QJsonObject found = coefficientObject(*recipe, solved->cycleS()); !found.isEmpty())
            object[u"coefficients"_s] = found;
        if (solved->cutter) {
            object[u"ratios"_s] = ratioObject(solved->cutter->program);
            if (const auto fastest = profile::fastestRate(*solved->cutter))
                object[u"fastest"_s] =
                    QJsonObject{{u"rate_bags_per_min"_s, fastest->rateBagsPerMin},
                                {u"limited_by"_s, fromView(profile::limitId(fastest->limitedBy))}};
        }
        if (call.format() == u"json")
            object[u"curves"_s] = curveObject(curves());
        text = formatted(object, call.format());
    }
    if (const Outcome delivered = call.deliver(text); !delivered)
        return delivered;
    if (!broken.limits.empty())
        return fail(broken);
    return {};
}

} // namespace campanel::cli
