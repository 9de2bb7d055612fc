// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/stroke_model.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>

namespace campanel::panel {

QString StrokeRow::resultText() const
{
    return ControllerSentences::text(status.result);
}

QString StrokeRow::stopErrorText() const
{
    return Format().amount(status.stopErrorPulses / pulsesPerMm, 2, QStringLiteral("mm"));
}

QString StrokeRow::stopForceText() const
{
    return Format().number(status.stopForceN, 0);
}

void StrokeModel::note(const modbus::StatusBlock& status, double pulsesPerMm)
{
    if (!status.press)
        return;
    noteCurve(status, pulsesPerMm);
    const bool hasEnded = m_cycleCount && status.cycleCount != *m_cycleCount;
    if (!m_cycleCount)
        m_before = status.cycleCount;
    m_cycleCount = status.cycleCount;
    if (!hasEnded || status.press->result == modbus::StrokeResult::None)
        return;
    m_rows.insert(0, {{status.cycleCount - m_before, *status.press, pulsesPerMm}});
    m_rows.remove(maxStrokes, m_rows.count() - maxStrokes);
    emit changed();
}

// Records from the start of the approach to the end of the return.
void StrokeModel::noteCurve(const modbus::StatusBlock& status, double pulsesPerMm)
{
    const bool isInStroke = status.press->stage && *status.press->stage != modbus::PressStage::Standing;
    if (isInStroke && !m_isInStroke)
        m_forceCurve.clear();
    m_isInStroke = isInStroke;
    if (!isInStroke || pulsesPerMm <= 0 || m_forceCurve.size() >= maxPoints)
        return;
    m_forceCurve.append(QPointF(status.axisPositionPulses / pulsesPerMm, status.press->forceN));
    emit curveChanged();
}

void StrokeModel::clear()
{
    m_rows.clear();
    m_forceCurve.clear();
    m_cycleCount.reset();
    m_isInStroke = false;
    emit changed();
    emit curveChanged();
}

int StrokeModel::goodCount() const
{
    return static_cast<int>(std::ranges::count(m_rows.rows(), true, &StrokeRow::good));
}

} // namespace campanel::panel
