// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/segment_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/recipe_words.h"

namespace campanel::panel {

using profile::Limit;

QString SegmentSentences::motionName(profile::SegmentMotion motion)
{
    const profile::SegmentMotionInfo* info = profile::findSegmentMotion(motion);
    return info ? RecipeWords::inWords(info->name) : QString();
}

QString SegmentSentences::outOfRange(const profile::Refusal& refusal, const QString& actual,
                                     const QString& allowed)
{
    const int number = refusal.index + 1;
    if (refusal.lawParameter == "from")
        return tr("Segment %1 begins at %2, which is out of range; the nearest possible value is %3.")
            .arg(number)
            .arg(actual, allowed);
    if (refusal.lawParameter == "speed")
        return tr("Segment %1 has a boundary speed of %2; the nearest possible value is %3.")
            .arg(number)
            .arg(actual, allowed);
    if (refusal.lawParameter == "acceleration")
        return tr("Segment %1 has a boundary acceleration of %2; the nearest possible value is %3.")
            .arg(number)
            .arg(actual, allowed);
    return tr("Segment %1 ends at %2, which is out of range; the nearest possible value is %3.")
        .arg(number)
        .arg(actual, allowed);
}

QString SegmentSentences::refusal(const profile::Refusal& refusal)
{
    const Format format;
    const int number = refusal.index + 1;
    const QString unit = RecipeWords::unit(refusal.unit);
    const int decimals = Format::decimalsToTell(refusal.actual, refusal.allowed, 4);
    const QString actual = format.compactMeasure(refusal.actual, 0, 4, unit, refusal.allowed);
    const QString allowed = format.compactMeasure(refusal.allowed, 0, 4, unit, refusal.actual);
    switch (refusal.limit) {
    case Limit::SegmentCount:
        return tr("The cam has %1 segments; the nearest possible number is %2.")
            .arg(format.number(refusal.actual, 0), format.number(refusal.allowed, 0));
    case Limit::SegmentRange:
        return outOfRange(refusal, actual, allowed);
    case Limit::SegmentWidth:
        return tr("Segment %1 is only %2 wide; the minimum is %3.").arg(number).arg(actual, allowed);
    case Limit::SegmentOverlap:
        return tr("Segment %1 begins at %2 and overlaps the segment before it, which ends at %3. Begin it at "
                  "%3.")
            .arg(number)
            .arg(actual, allowed);
    case Limit::SegmentGap:
        return tr("Segment %1 begins at %2 and leaves a gap: the segment before it ends at %3. Begin it at "
                  "%3.")
            .arg(number)
            .arg(actual, allowed);
    case Limit::SegmentEnds:
        return refusal.allowed == 0
                   ? tr("The first segment begins at %1; the cycle begins at %2.").arg(actual, allowed)
                   : tr("The last segment ends at %1; the cycle ends at %2.").arg(actual, allowed);
    case Limit::SegmentMotion:
        return tr("The motion of segment %1 is unknown. Choose another motion.").arg(number);
    case Limit::LawParameter:
        return tr("Segment %1: %2 is %3; the nearest possible value is %4.")
            .arg(number)
            .arg(RecipeWords::lawParameterName(refusal.lawParameter),
                 format.compact(refusal.actual, 0, decimals), format.compact(refusal.allowed, 0, decimals));
    case Limit::JointJump:
        return refusal.index == 0 ? tr("Speed jumps by %1 at the end of the cycle; the axis can follow %2. "
                                       "Make the segments "
                                       "continuous.")
                                        .arg(actual, allowed)
                                  : tr("Speed jumps by %1 where segment %2 begins; the axis can follow %3. "
                                       "Make the segments "
                                       "continuous.")
                                        .arg(actual, QString::number(number), allowed);
    default:
        return {};
    }
}

QString SegmentSentences::continuity(const profile::SegmentCamProgram& program)
{
    const Format format;
    const std::vector<profile::SegmentJoint> joints = profile::segmentJoints(program);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const profile::SegmentJoint& joint = joints[i];
        if (joint.isSmooth)
            continue;
        const QString speed = format.compactMeasure(joint.speedMmPerDeg, 0, 4, QStringLiteral("mm/°"));
        const QString acceleration =
            format.compactMeasure(joint.accelerationMmPerDeg2, 0, 5, QStringLiteral("mm/°²"));
        if (i > 0)
            return tr("Where segment %1 begins: speed jumps by %2, acceleration by %3.")
                .arg(i + 1)
                .arg(speed, acceleration);
        return tr("At the end of the cycle: speed jumps by %1, acceleration by %2.").arg(speed, acceleration);
    }
    return tr("The segments are continuous.");
}

} // namespace campanel::panel
