// SPDX-License-Identifier: Apache-2.0
// campanelctl segments: the segments of a cam as CSV, and the check of its joints.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "profile/segments/segment_edit.h"
#include "profile/segments/segments_csv.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::cli {

Outcome runSegments(const Invocation& call)
{
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto* given = std::get_if<profile::SegmentCamProgram>(&recipe->program);
    if (given == nullptr)
        return fail(ExitCode::Usage, u"Only a segment cam has segments. Use --kind segment_cam."_s);
    const profile::SegmentCamProgram cam = call.isSet(u"repair"_s) ? profile::repaired(*given) : *given;
    if (const auto wrong = profile::checkSegments(cam.segments))
        return fail(*wrong);
    if (call.format() == u"csv")
        return call.deliver(QByteArray::fromStdString(profile::writeSegmentsCsv(cam.segments)));
    QJsonObject joints; // by the number of the segment that begins there
    const auto found = profile::segmentJoints(cam);
    for (const profile::SegmentJoint& joint : found)
        joints[u"%1"_s.arg(static_cast<int>(joints.size()) + 1, 2, 10, QChar(u'0'))] =
            QJsonObject{{u"master_deg"_s, joint.masterDeg},
                        {u"smooth"_s, joint.isSmooth},
                        {u"speed_jump_mm_per_deg"_s, joint.speedMmPerDeg},
                        {u"acceleration_jump_mm_per_deg2"_s, joint.accelerationMmPerDeg2}};
    QJsonObject object{{u"segments"_s, static_cast<qint64>(cam.segments.size())},
                       {u"continuous"_s, std::ranges::all_of(found, &profile::SegmentJoint::isSmooth)},
                       {u"closing_error_mm"_s, profile::closingErrorMm(cam)},
                       {u"advance_mm"_s, profile::netAdvanceMm(cam)}};
    object[u"joints"_s] = joints;
    return call.deliver(formatted(object, call.format()));
}

} // namespace campanel::cli
