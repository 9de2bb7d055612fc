// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/segments_file.h"

#include "profile/laws/laws.h"
#include "profile/segments/segment_cam.h"
#include "profile/segments/segment_values.h"

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {
namespace {

using profile::CamSegment;

// The range is checked with the recipe, so that the refusal names the segment.
profile::FieldInfo anyNumber()
{
    profile::FieldInfo limits;
    limits.min = std::numeric_limits<double>::lowest();
    limits.max = std::numeric_limits<double>::max();
    return limits;
}

CamSegment segmentOf(ObjectReader& reader)
{
    CamSegment segment;
    segment.fromDeg = reader.number(u"from_deg"_s, false, anyNumber());
    segment.toDeg = reader.number(u"to_deg"_s, false, anyNumber());
    const QString key = reader.text(u"motion"_s);
    const profile::SegmentMotionInfo* motion = profile::findSegmentMotion(key.toStdString());
    if (motion == nullptr) {
        QStringList keys;
        for (const profile::SegmentMotionInfo& each : profile::segmentMotions())
            keys << toQString(each.key);
        reader.fail(u"motion"_s, FileError::Kind::NotAChoice, key, keys.join(u", "_s));
        return segment;
    }
    segment.motion = motion->motion;
    if (motion->law != nullptr)
        segment.lawParameters = profile::defaultParameters(*motion->law);
    for (const profile::SegmentValueInfo& value : profile::segmentEndValues) {
        const QString id = toQString(value.id);
        const bool mayBeMissing = value.id.starts_with("law_");
        if (value.isUsed(*motion) && (reader.has(id) || !mayBeMissing))
            value.number(segment) = reader.number(id, false, anyNumber());
    }
    reader.refuseUnknownKeys();
    return segment;
}

} // namespace

QJsonArray segmentsJson(std::span<const CamSegment> segments)
{
    QJsonArray array;
    for (CamSegment segment : segments) {
        const profile::SegmentMotionInfo* motion = profile::findSegmentMotion(segment.motion);
        QJsonObject object{{u"from_deg"_s, segment.fromDeg},
                           {u"to_deg"_s, segment.toDeg},
                           {u"motion"_s, motion ? toQString(motion->key) : QString()}};
        for (const profile::SegmentValueInfo& value : profile::segmentEndValues) {
            if (motion && value.isUsed(*motion))
                object[toQString(value.id)] = value.number(segment);
        }
        array.append(object);
    }
    return array;
}

void readSegmentsJson(ObjectReader& reader, profile::SegmentCamProgram& program,
                      std::optional<FileError>& failure)
{
    const QString id = u"segments"_s;
    if (!reader.has(id))
        return;
    const QJsonValue list = reader.take(id);
    if (!list.isArray())
        reader.fail(id, FileError::Kind::WrongType, {}, FileErrorText::objects());
    program.segments.clear();
    for (const QJsonValue& each : list.toArray()) {
        if (!each.isObject())
            reader.fail(id, FileError::Kind::WrongType, {}, FileErrorText::objects());
        const QString place = u"program.segments[%1]."_s.arg(program.segments.size() + 1);
        ObjectReader segment(each.toObject(), place, failure);
        program.segments.push_back(segmentOf(segment));
        if (program.segments.back().motion == profile::SegmentMotion::Dwell)
            program.segments.back().endMm = profile::jointPositionsMm(program.segments).back();
    }
}

} // namespace campanel::store
