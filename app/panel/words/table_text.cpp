// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/table_text.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "app/panel/words/controller_sentences.h"
#include "app/program/interval_speeds.h"
#include "profile/cutter/paper_table.h"

#include <cmath>

namespace campanel::panel {

namespace {

double duration(const profile::StepRow& row, const profile::Machine& machine)
{
    return static_cast<double>(row.ticks) / machine.timerClockHz;
}

} // namespace

QString TableText::name() const
{
    switch (m_image.table.index()) {
    case 0:
        return tr("Step table");
    case 1:
        return tr("Cam points");
    case 2:
        return tr("Intervals");
    default:
        return tr("Press stages");
    }
}

QStringList TableText::columns() const
{
    switch (m_image.table.index()) {
    case 0:
        return {tr("Row"), tr("Section"), tr("Time s"), tr("Frequency Hz"), tr("Pulses"), tr("Timer ticks")};
    case 1:
        return {tr("Point"),  tr("Master"),
                tr("Time s"), tr("Position %1").arg(Units::of(QStringLiteral("mm")).unit),
                tr("Pulses"), tr("Slope pulses")};
    case 2:
        return {tr("Row"),      tr("Motion"), tr("Time s"), tr("Pulses"),
                tr("Start Hz"), tr("End Hz"), tr("Hz/s")};
    default:
        return {tr("Row"), tr("Stage"), tr("Speed Hz"), tr("End pulses"), tr("Force N"), tr("Time ms")};
    }
}

std::vector<double> TableText::startsS() const
{
    std::vector<double> starts;
    double time = 0;
    if (const auto* steps = std::get_if<profile::StepTable>(&m_image.table)) {
        for (const profile::StepRow& row : steps->rows) {
            starts.push_back(time);
            time += duration(row, m_image.solved.machine);
        }
    } else if (const auto* cam = std::get_if<profile::CamTable>(&m_image.table)) {
        const double step = m_image.solved.cycleS() / static_cast<double>(cam->rows.size() - 1);
        for (std::size_t i = 0; i < cam->rows.size(); ++i)
            starts.push_back(step * static_cast<double>(i));
    } else if (const auto* intervals = std::get_if<profile::IntervalTable>(&m_image.table)) {
        for (const profile::IntervalRow& row : intervals->rows) {
            starts.push_back(time);
            time += program::speedsOf(row, intervals->fractionBits).timeS;
        }
    } else {
        starts.assign(std::get<profile::PressTable>(m_image.table).rows.size(), 0);
    }
    return starts;
}

QStringList TableText::cells(std::size_t row, double startS) const
{
    const Format format;
    const QString number = QString::number(row + 1);
    if (const auto* steps = std::get_if<profile::StepTable>(&m_image.table)) {
        const profile::StepRow& step = steps->rows[row];
        const QString frequency = step.ticks == 0
                                      ? Format::unknownText()
                                      : format.number(profile::frequencyHz(step, m_image.solved.machine), 1);
        return {number,    stretchName(startS),           format.number(startS, 4),
                frequency, format.number(step.pulses, 0), format.number(step.ticks, 0)};
    }
    if (const auto* cam = std::get_if<profile::CamTable>(&m_image.table)) {
        const profile::CamRow& point = cam->rows[row];
        const double pulses = point.position256 / profile::camUnitsPerPulse;
        return {number,
                tr("%1°").arg(format.number(
                    360 * static_cast<double>(row) / static_cast<double>(cam->rows.size() - 1), 2)),
                format.number(startS, 4),
                format.amount(pulses / m_image.solved.pulsesPerMm, 3, QStringLiteral("mm")),
                format.number(pulses, 2),
                format.number(point.slope256 / profile::camUnitsPerPulse, 2)};
    }
    if (const auto* intervals = std::get_if<profile::IntervalTable>(&m_image.table)) {
        const profile::IntervalRow& each = intervals->rows[row];
        const program::IntervalSpeeds speeds = program::speedsOf(each, intervals->fractionBits);
        return {number,
                each.lastSpeed > each.firstSpeed   ? tr("accel.")
                : each.lastSpeed < each.firstSpeed ? tr("decel.")
                                                   : tr("constant"),
                format.number(startS, 4),
                format.number(each.pulses, 0),
                format.number(speeds.firstHz, 1),
                format.number(speeds.lastHz, 1),
                format.number(speeds.accelerationHzPerS, 0)};
    }
    const profile::PressRow& stage = std::get<profile::PressTable>(m_image.table).rows[row];
    return {number,
            ControllerSentences::text(static_cast<modbus::PressStage>(row + 1)),
            format.number(stage.speedHz, 0),
            format.number(stage.endPulses, 0),
            format.number(stage.forceN, 0),
            format.number(stage.timeMs, 0)};
}

QString TableText::stretchName(double timeS) const
{
    const profile::CycleNumbers& cycle = m_image.cutter().cycle;
    // Rows start at timer ticks, segments anywhere.
    const double tolerance = 1.0 / m_image.solved.machine.timerClockHz;
    if (timeS < cycle.taS - tolerance || timeS >= cycle.tdS - tolerance)
        return tr("base");
    if (timeS < cycle.tbS - tolerance || timeS >= cycle.tcS - tolerance)
        return tr("ramp");
    return tr("sync");
}

QStringList TableText::summary() const
{
    return std::visit([this](const auto& table) { return summaryOf(table); }, m_image.table);
}

QStringList TableText::summaryOf(const profile::StepTable& table) const
{
    const profile::TableErrors& errors = table.errors;
    const Format format;
    QStringList lines;
    lines << tr("%1 rows, %2 pulses per cycle, %3 s")
                 .arg(QString::number(table.rows.size()), format.compact(table.pulses.asDouble(), 0, 4),
                      format.compact(
                          static_cast<double>(table.cycleTicks) / m_image.solved.machine.timerClockHz, 3, 6));
    lines << tr("Max. speed error: %1 (%2 %) at %3 s")
                 .arg(format.measure(errors.speedMmPerS, 2, QStringLiteral("mm/s")),
                      format.number(errors.speedPercent, 2), format.number(errors.speedTimeS, 3));
    lines << tr("Max. frequency step: %1 Hz at %2 s")
                 .arg(format.number(errors.frequencyStepHz, 0), format.number(errors.frequencyStepTimeS, 3));
    lines << tr("Max. position error: %1 pulses between rows, %2 inside")
                 .arg(format.number(errors.boundaryPulses, 2), format.number(errors.insidePulses, 2));
    lines << tr("Drift: none; the pulse remainder is carried over to the next cycle");
    const profile::PaperTable paper =
        profile::paperTable(m_image.cutter(), m_image.recipe.cutter().slicesPerRamp);
    lines << tr("Error of the paper's rounding rule: %1 pulses (%2) per bag")
                 .arg(format.number(std::abs(paper.errorPulses), 0),
                      format.measure(std::abs(paper.errorMm), 2, QStringLiteral("mm")));
    return lines;
}

QStringList TableText::summaryOf(const profile::CamTable& table) const
{
    const Format format;
    const program::CamSource source = program::camSource(m_image.recipe, m_image.solved);
    const profile::CamErrors errors =
        profile::camErrors(table, source.motion, m_image.solved.machine, source.use);
    QStringList lines;
    lines << tr("%1 points, %2 pulses per cycle, %3 s")
                 .arg(QString::number(table.rows.size()), format.compact(table.advance.asDouble(), 0, 4),
                      format.compact(
                          static_cast<double>(table.cycleTicks) / m_image.solved.machine.timerClockHz, 3, 6));
    lines << tr("Max. position error between points: %1 pulses (%2) at %3 s")
                 .arg(format.compact(errors.positionPulses, 2, 5),
                      format.compactMeasure(errors.positionMm, 2, 6, QStringLiteral("mm")),
                      format.number(errors.positionTimeS, 3));
    lines << tr("Max. speed error: %1 at %2 s")
                 .arg(format.compactMeasure(errors.speedMmPerS, 2, 5, QStringLiteral("mm/s")),
                      format.number(errors.speedTimeS, 3));
    return lines;
}

QStringList TableText::summaryOf(const profile::IntervalTable& table) const
{
    const Format format;
    QStringList lines;
    lines << tr("%1 intervals, %2 pulses, %3 s instead of %4 s")
                 .arg(QString::number(table.rows.size()), QString::number(table.advance),
                      format.number(table.timeS, 6), format.number(table.profileTimeS, 6));
    lines << tr("Max. speed error: %1 at %2 s, position: %3 pulses")
                 .arg(format.compactMeasure(table.errors.speedMmPerS, 2, 4, QStringLiteral("mm/s")),
                      format.number(table.errors.speedTimeS, 3),
                      format.compact(table.errors.positionPulses, 2, 3));
    return lines;
}

QStringList TableText::summaryOf(const profile::PressTable& table) const
{
    return {tr("%1 stages; the pulse generator counts the last section, %2 per pulse")
                .arg(table.rows.size())
                .arg(Format().compactMeasure(1 / m_image.solved.pulsesPerMm, 2, 5, QStringLiteral("mm")))};
}

} // namespace campanel::panel
