// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/segment_model.h"

#include "app/panel/kit/format.h"
#include "app/panel/recipe/curve_shape.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/segment_sentences.h"
#include "profile/segments/segment_values.h"

#include <algorithm>
#include <array>

namespace campanel::panel {

namespace {

using profile::CamSegment;
using profile::SegmentMotionInfo;

// The end of a segment is the first field; the others are profile::segmentEndValues.
constexpr std::size_t firstValue = 1;

// How the number of a segment is entered.
struct Entry {
    const char* fieldId = "";
    const char* unit = "";
    int decimals = 0;
    double limit = 0; // of the magnitude
};

constexpr std::array<Entry, profile::segmentEndValues.size() + firstValue> entries{{
    {"segmentTo", "deg", 4, profile::camCycleDeg},
    {"segmentEnd", "mm", 3, profile::maxSlaveMm},
    {"segmentStartSpeed", "mm/deg", 6, profile::maxBoundarySpeedMmPerDeg},
    {"segmentStartAcceleration", "mm/deg^2", 7, profile::maxBoundaryAccelerationMmPerDeg2},
    {"segmentEndSpeed", "mm/deg", 6, profile::maxBoundarySpeedMmPerDeg},
    {"segmentEndAcceleration", "mm/deg^2", 7, profile::maxBoundaryAccelerationMmPerDeg2},
    {"segmentParameter1", "", 3, 0},
    {"segmentParameter2", "", 3, 0},
}};

constexpr std::size_t firstParameter = 6;

} // namespace

SegmentModel::SegmentModel(QObject* parent)
    : CamHandles(parent)
{
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto* field = new EditorField(QString::fromLatin1(entries[i].fieldId), this);
        connect(field, &EditorField::setRequested, this, [this, i](double value) {
            if (canEdit())
                enter(i, value);
        });
        m_fields.push_back(field);
    }
}

int SegmentModel::listSize(const profile::Program& program) const
{
    return static_cast<int>(std::get<profile::SegmentCamProgram>(program).segments.size());
}

bool SegmentModel::isValid(const profile::Program& program) const
{
    return !profile::checkSegments(std::get<profile::SegmentCamProgram>(program).segments);
}

double SegmentModel::masterDegOf(const profile::Program& program, int index) const
{
    return std::get<profile::SegmentCamProgram>(program).segments[static_cast<std::size_t>(index)].toDeg;
}

double SegmentModel::startDegOf(const profile::Program& program, int index) const
{
    return std::get<profile::SegmentCamProgram>(program).segments[static_cast<std::size_t>(index)].fromDeg;
}

void SegmentModel::moveBy(profile::Program& program, int index, double deg, double mm) const
{
    auto& moved = std::get<profile::SegmentCamProgram>(program);
    const CamSegment segment = moved.segments[static_cast<std::size_t>(index)];
    profile::moveSegmentEnd(moved, static_cast<std::size_t>(index), segment.toDeg + deg, segment.endMm + mm);
}

void SegmentModel::showSelection()
{
    showRows();
    showFields();
}

void SegmentModel::showRows()
{
    const Format format;
    const auto joints = canEdit() ? profile::segmentJoints(cam()) : std::vector<profile::SegmentJoint>{};
    QList<SegmentRow> rows;
    for (int i = 0; i < count(); ++i) {
        const CamSegment& segment = at(i);
        SegmentRow row;
        row.number = i + 1;
        row.rangeText =
            tr("%1 – %2°").arg(format.compact(segment.fromDeg, 0, 4), format.compact(segment.toDeg, 0, 4));
        row.motionText = SegmentSentences::motionName(segment.motion);
        row.jumps =
            static_cast<std::size_t>(i) < joints.size() && !joints[static_cast<std::size_t>(i)].isSmooth;
        row.isSelected = i == selected();
        rows << row;
    }
    m_rows.setRows(rows);
}

void SegmentModel::showFields()
{
    std::vector<std::size_t> shown;
    const SegmentMotionInfo* motion =
        count() > 0 ? profile::findSegmentMotion(at(selected()).motion) : nullptr;
    const std::array labels{tr("Ends at"),     tr("End position"),
                            tr("Start speed"), tr("Start acceleration"),
                            tr("End speed"),   tr("End acceleration")};
    const Format format;
    for (std::size_t i = 0; motion != nullptr && i < entries.size(); ++i) {
        const bool isLast = selected() + 1 == count();
        if (i < firstValue ? isLast : !profile::segmentEndValues[i - firstValue].isUsed(*motion))
            continue;
        CamSegment segment = at(selected());
        FieldView view;
        view.unit = RecipeWords::unit(entries[i].unit);
        view.decimals = entries[i].decimals;
        view.value =
            i < firstValue ? segment.toDeg : profile::segmentEndValues[i - firstValue].number(segment);
        view.defaultValue = view.value;
        view.minimum = -entries[i].limit;
        view.maximum = entries[i].limit;
        if (i < firstValue) {
            view.minimum = segment.fromDeg + profile::minMasterSpacingDeg;
            view.maximum = at(selected() + 1).toDeg - profile::minMasterSpacingDeg;
        }
        if (i >= firstParameter) {
            const profile::LawParameterInfo& parameter = motion->law->parameters[i - firstParameter];
            view.label = RecipeWords::inWords(parameter.name);
            view.minimum = parameter.min;
            view.maximum = parameter.max;
            view.defaultValue = parameter.defaultValue;
            view.decimals = parameter.decimals;
        } else {
            view.label = labels[i];
        }
        view.text = format.compactAmount(view.value, i < firstValue ? 1 : 0, view.decimals, view.unit);
        m_fields[i]->show(view);
        shown.push_back(i);
    }
    if (shown == m_shown)
        return;
    m_shown = shown;
    emit fieldsChanged();
}

QVariantList SegmentModel::fields() const
{
    QVariantList items;
    for (const std::size_t i : m_shown)
        items << QVariant::fromValue(m_fields[i]);
    return items;
}

EditorField* SegmentModel::field(const QString& fieldId) const
{
    for (const std::size_t i : m_shown) {
        if (m_fields[i]->fieldId() == fieldId)
            return m_fields[i];
    }
    return nullptr;
}

QVariantList SegmentModel::motions() const
{
    QVariantList motions;
    for (const SegmentMotionInfo& each : profile::segmentMotions())
        motions << QVariant::fromValue(ShapedName{RecipeWords::inWords(each.name), shapeOf(each)});
    return motions;
}

int SegmentModel::motion() const
{
    const auto motions = profile::segmentMotions();
    const auto wanted = count() > 0 ? at(selected()).motion : profile::SegmentMotion::Dwell;
    return static_cast<int>(std::ranges::find(motions, wanted, &SegmentMotionInfo::motion) - motions.begin());
}

QString SegmentModel::motionName() const
{
    return RecipeWords::inWords(profile::segmentMotions()[static_cast<std::size_t>(motion())].name);
}

QString SegmentModel::jointText() const
{
    return canEdit() ? QStringLiteral("%1 %2")
                           .arg(SegmentSentences::continuity(cam()), CamSentences::ends(cam()))
                           .trimmed()
                     : QString();
}

bool SegmentModel::canRepair() const
{
    return program() && (!canEdit() || !std::ranges::all_of(profile::segmentJoints(cam()),
                                                            &profile::SegmentJoint::isSmooth));
}

bool SegmentModel::canDivide() const
{
    return canEdit() && count() < static_cast<int>(profile::maxSegments) &&
           at(selected()).toDeg - at(selected()).fromDeg >= 2 * profile::minMasterSpacingDeg;
}

bool SegmentModel::canRemove() const
{
    return canEdit() && count() > 1;
}

void SegmentModel::enter(std::size_t field, double value)
{
    if (!canEdit())
        return;
    profile::SegmentCamProgram moved = cam();
    const auto index = static_cast<std::size_t>(selected());
    CamSegment& segment = moved.segments[index];
    if (field < firstValue)
        profile::moveSegmentEnd(moved, index, value, segment.endMm);
    else if (field == firstValue)
        profile::moveSegmentEnd(moved, index, segment.toDeg, value);
    else
        profile::segmentEndValues[field - firstValue].number(segment) = value;
    moved.segments = profile::onSegmentGrid(moved.segments);
    emit edited(moved);
}

void SegmentModel::setMotion(int index)
{
    const auto motions = profile::segmentMotions();
    if (!canEdit() || index < 0 || static_cast<std::size_t>(index) >= motions.size())
        return;
    profile::SegmentCamProgram moved = cam();
    profile::setSegmentMotion(moved, static_cast<std::size_t>(selected()),
                              motions[static_cast<std::size_t>(index)].motion);
    emit edited(moved);
}

void SegmentModel::addDwell()
{
    if (!canEdit())
        return;
    profile::SegmentCamProgram moved = cam();
    if (const auto index = profile::insertDwell(moved, static_cast<std::size_t>(selected()))) {
        setSelected(static_cast<int>(*index));
        emit edited(moved);
    }
}

void SegmentModel::split()
{
    if (!canEdit())
        return;
    profile::SegmentCamProgram moved = cam();
    if (const auto index = profile::splitSegment(moved, static_cast<std::size_t>(selected()))) {
        setSelected(static_cast<int>(*index));
        emit edited(moved);
    }
}

void SegmentModel::removeSelected()
{
    if (!canEdit())
        return;
    profile::SegmentCamProgram moved = cam();
    if (profile::removeSegment(moved, static_cast<std::size_t>(selected())))
        emit edited(moved);
}

void SegmentModel::repair()
{
    if (program())
        emit edited(profile::repaired(cam()));
}

} // namespace campanel::panel
