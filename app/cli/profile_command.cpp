// SPDX-License-Identifier: Apache-2.0
// campanelctl profile: the numbers, peaks and curves of a recipe.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "profile/limits.h"
#include "profile/sampling.h"

#include <QJsonArray>

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

QJsonObject cycleObject(const profile::CycleNumbers& cycle)
{
    return {{u"bag_length_mm"_s, cycle.bagLengthMm},
            {u"rate_bags_per_min"_s, cycle.rateBagsPerMin},
            {u"base_speed_mm_per_s"_s, cycle.baseSpeedMmPerS},
            {u"film_speed_mm_per_s"_s, cycle.filmSpeedMmPerS},
            {u"cycle_time_s"_s, cycle.cycleTimeS},
            {u"stroke_mm"_s, cycle.strokeMm},
            {u"weight_s"_s, cycle.weightS},
            {u"speed_ratio"_s, cycle.speedRatio},
            {u"ta_s"_s, cycle.taS},
            {u"tb_s"_s, cycle.tbS},
            {u"tc_s"_s, cycle.tcS},
            {u"td_s"_s, cycle.tdS}};
}

QJsonObject peakObject(const profile::Peaks& peaks)
{
    return {{u"speed_mm_per_s"_s, peaks.speedMmPerS},
            {u"speed_at_s"_s, peaks.speedTimeS},
            {u"motor_rpm"_s, peaks.motorRpm},
            {u"pulse_frequency_hz"_s, peaks.pulseFrequencyHz},
            {u"acceleration_mm_per_s2"_s, peaks.accelerationMmPerS2},
            {u"acceleration_at_s"_s, peaks.accelerationTimeS},
            {u"jerk_mm_per_s3"_s, peaks.jerkMmPerS3}}; // JSON has no infinity: null
}

QJsonObject curveObject(const profile::Curves& curves)
{
    return {{u"time_s"_s, listOf(curves.timeS)},
            {u"position_mm"_s, listOf(curves.positionMm)},
            {u"velocity_mm_per_s"_s, listOf(curves.velocityMmPerS)},
            {u"acceleration_mm_per_s2"_s, listOf(curves.accelerationMmPerS2)},
            {u"jerk_mm_per_s3"_s, listOf(curves.jerkMmPerS3)},
            {u"frequency_hz"_s, listOf(curves.frequencyHz)}};
}

QByteArray curvesCsv(const profile::Curves& curves)
{
    return csvTable({{"time_s", &curves.timeS},
                     {"position_mm", &curves.positionMm},
                     {"velocity_mm_per_s", &curves.velocityMmPerS},
                     {"acceleration_mm_per_s2", &curves.accelerationMmPerS2},
                     {"jerk_mm_per_s3", &curves.jerkMmPerS3},
                     {"frequency_hz", &curves.frequencyHz}});
}

} // namespace

Outcome runProfile(const Invocation& call)
{
    bool ok = false;
    const int points = call.value(u"points"_s).toInt(&ok);
    constexpr int mostPoints = 100'000;
    if (!ok || points < 2 || points > mostPoints)
        return fail(ExitCode::Usage, u"--points takes a whole number from 2 to %1."_s.arg(mostPoints));
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto cutter = profile::solve(recipe->program, recipe->machine);
    if (!cutter)
        return fail(ExitCode::Refused, profile::describe(cutter.error()));
    const program::ProgramRefusal broken{profile::checkLimits(*cutter), std::nullopt};

    QByteArray text;
    if (call.format() == u"csv") {
        text = curvesCsv(profile::sampleCurves(*cutter, static_cast<std::size_t>(points)));
    } else {
        QJsonArray limits;
        for (const profile::Refusal& limit : broken.limits)
            limits.append(QString::fromStdString(profile::describe(limit)));
        QJsonObject object{{u"name"_s, QString::fromStdString(recipe->name)},
                           {u"cycle"_s, cycleObject(cutter->cycle)},
                           {u"peaks"_s, peakObject(profile::peaks(*cutter))},
                           {u"feasible"_s, broken.limits.empty()},
                           {u"broken_limits"_s, limits}};
        if (const auto fastest = profile::fastestRate(*cutter))
            object[u"fastest"_s] =
                QJsonObject{{u"rate_bags_per_min"_s, fastest->rateBagsPerMin},
                            {u"limited_by"_s, fromView(profile::limitId(fastest->limitedBy))}};
        if (call.format() == u"json")
            object[u"curves"_s] =
                curveObject(profile::sampleCurves(*cutter, static_cast<std::size_t>(points)));
        text = formatted(object, call.format());
    }
    if (const Outcome delivered = call.deliver(text); !delivered)
        return delivered;
    if (!broken.limits.empty())
        return fail(ExitCode::Refused, program::describe(broken));
    return {};
}

} // namespace campanel::cli
