// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/stroke_model.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>

namespace campanel::panel {

void StrokeModel::note(const modbus::StatusBlock& status, double pulsesPerMm)
{
    if (!status.press)
        return;
    noteCurve(status, pulsesPerMm);
    const bool hasEnded = m_cycleCount && status.cycleCount != *m_cycleCount;
    m_cycleCount = status.cycleCount;
    if (!hasEnded || status.press->result == modbus::StrokeResult::None)
        return;
    beginInsertRows({}, 0, 0);
    m_strokes.prepend({status.cycleCount, *status.press, pulsesPerMm});
    endInsertRows();
    if (m_strokes.size() > mostStrokes) {
        const int last = count() - 1;
        beginRemoveRows({}, last, last);
        m_strokes.removeLast();
        endRemoveRows();
    }
    emit changed();
}

// Records from the start of the approach to the end of the return.
void StrokeModel::noteCurve(const modbus::StatusBlock& status, double pulsesPerMm)
{
    const bool isInStroke = status.press->stage && *status.press->stage != modbus::PressStage::Standing;
    if (isInStroke && !m_isInStroke)
        m_forceCurve.clear();
    m_isInStroke = isInStroke;
    if (!isInStroke || pulsesPerMm <= 0 || m_forceCurve.size() >= mostPoints)
        return;
    m_forceCurve.append(QPointF(status.axisPositionPulses / pulsesPerMm, status.press->forceN));
    emit curveChanged();
}

void StrokeModel::clear()
{
    beginResetModel();
    m_strokes.clear();
    m_forceCurve.clear();
    m_cycleCount.reset();
    m_isInStroke = false;
    endResetModel();
    emit changed();
    emit curveChanged();
}

void StrokeModel::retranslate()
{
    if (!m_strokes.isEmpty())
        emit dataChanged(index(0), index(count() - 1));
}

int StrokeModel::goodCount() const
{
    return static_cast<int>(std::ranges::count(m_strokes, modbus::StrokeResult::Ok,
                                               [](const Stroke& stroke) { return stroke.status.result; }));
}

int StrokeModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant StrokeModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Stroke& stroke = m_strokes[index.row()];
    const Format format;
    switch (role) {
    case NumberRole:
        return stroke.number;
    case ResultTextRole:
        return ControllerSentences::strokeResult(stroke.status.result);
    case GoodRole:
        return stroke.status.result == modbus::StrokeResult::Ok;
    case StopErrorTextRole:
        return format.number(stroke.status.stopErrorPulses / stroke.pulsesPerMm, 2);
    case StopForceTextRole:
        return format.number(stroke.status.stopForceN, 0);
    case PeakForceTextRole:
        return format.number(stroke.status.peakForceN, 0);
    default:
        return {};
    }
}

QHash<int, QByteArray> StrokeModel::roleNames() const
{
    return {{NumberRole, "number"},
            {ResultTextRole, "resultText"},
            {GoodRole, "good"},
            {StopErrorTextRole, "stopErrorText"},
            {StopForceTextRole, "stopForceText"},
            {PeakForceTextRole, "peakForceText"}};
}

} // namespace campanel::panel
