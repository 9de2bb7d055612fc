// SPDX-License-Identifier: Apache-2.0
#include "app/machine/table_model.h"

#include "app/machine/format.h"

#include <cmath>

namespace campanel::machine {

void TableModel::setImage(std::shared_ptr<const program::ProgramImage> image)
{
    const int before = count();
    beginResetModel();
    m_image = std::move(image);
    m_startS.clear();
    if (m_image) {
        m_startS.reserve(m_image->table.rows.size());
        std::uint64_t tick = 0;
        for (const profile::StepRow& row : m_image->table.rows) {
            m_startS.push_back(static_cast<double>(tick) / m_image->cutter.machine.timerClockHz);
            tick += row.ticks;
        }
    }
    endResetModel();
    if (count() != before)
        emit countChanged();
}

int TableModel::count() const
{
    return static_cast<int>(m_startS.size());
}

int TableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QString TableModel::segmentName(double timeS) const
{
    const profile::CycleNumbers& cycle = m_image->cutter.cycle;
    // Rows begin at timer ticks, the stretches anywhere.
    const double tolerance = 1.0 / m_image->cutter.machine.timerClockHz;
    if (timeS < cycle.taS - tolerance || timeS >= cycle.tdS - tolerance)
        return tr("base");
    if (timeS < cycle.tbS - tolerance || timeS >= cycle.tcS - tolerance)
        return tr("ramp");
    return tr("sync");
}

QVariant TableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto at = static_cast<std::size_t>(index.row());
    const profile::StepRow& row = m_image->table.rows[at];
    const Format format;
    switch (role) {
    case RowRole:
        return index.row() + 1;
    case TimeTextRole:
        return format.number(m_startS[at], 4);
    case FrequencyTextRole:
        return row.ticks == 0 ? Format::unknownText()
                              : format.number(static_cast<double>(row.pulses) *
                                                  m_image->cutter.machine.timerClockHz / row.ticks,
                                              1);
    case PulsesTextRole:
        return format.number(row.pulses, 0);
    case TicksTextRole:
        return format.number(row.ticks, 0);
    case SegmentRole:
        return segmentName(m_startS[at]);
    default:
        return {};
    }
}

QHash<int, QByteArray> TableModel::roleNames() const
{
    return {{RowRole, "row"},
            {TimeTextRole, "timeText"},
            {FrequencyTextRole, "frequencyText"},
            {PulsesTextRole, "pulsesText"},
            {TicksTextRole, "ticksText"},
            {SegmentRole, "segment"}};
}

} // namespace campanel::machine
