// SPDX-License-Identifier: Apache-2.0
// campanelctl knots: the knots of a point cam as CSV, and the check of its wrap.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "profile/cam/knots_csv.h"
#include "profile/cam/point_cam_edit.h"

using namespace Qt::StringLiterals;

namespace campanel::cli {

Outcome runKnots(const Invocation& call)
{
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto* given = std::get_if<profile::PointCamProgram>(&recipe->program);
    if (given == nullptr)
        return fail(ExitCode::Usage, u"Only a point cam has knots. Use --kind point_cam."_s);
    if (const auto wrong = profile::checkKnots(given->knots))
        return fail(*wrong);
    const profile::PointCamProgram cam = call.isSet(u"repair"_s) ? profile::repaired(*given) : *given;
    if (call.format() == u"csv")
        return call.deliver(QByteArray::fromStdString(profile::writeKnotsCsv(cam.knots)));
    const profile::WrapCheck wrap = profile::wrapCheck(cam);
    return call.deliver(
        formatted(QJsonObject{{u"knots"_s, static_cast<qint64>(cam.knots.size())},
                              {u"smooth"_s, wrap.isSmooth},
                              {u"closing_error_mm"_s, profile::closingErrorMm(cam)},
                              {u"speed_jump_mm_per_deg"_s, wrap.speedMmPerDeg},
                              {u"acceleration_jump_mm_per_deg2"_s, wrap.accelerationMmPerDeg2},
                              {u"advance_mm"_s, wrap.advanceMm}},
                  call.format()));
}

} // namespace campanel::cli
