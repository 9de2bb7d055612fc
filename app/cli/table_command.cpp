// SPDX-License-Identifier: Apache-2.0
// campanelctl table: the step table, its sums and its own error figures.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"

#include <QJsonArray>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

struct RowColumns {
    std::vector<double> row;
    std::vector<double> timeS;
    std::vector<double> frequencyHz;
    std::vector<double> pulses;
    std::vector<double> ticks;
};

RowColumns columnsOf(const program::ProgramImage& image)
{
    const double clockHz = image.recipe.machine.timerClockHz;
    RowColumns columns;
    double startTicks = 0;
    for (std::size_t i = 0; i < image.table.rows.size(); ++i) {
        const profile::StepRow& row = image.table.rows[i];
        columns.row.push_back(static_cast<double>(i));
        columns.timeS.push_back(startTicks / clockHz);
        columns.frequencyHz.push_back(row.pulses * clockHz / row.ticks);
        columns.pulses.push_back(row.pulses);
        columns.ticks.push_back(row.ticks);
        startTicks += row.ticks;
    }
    return columns;
}

QByteArray rowsCsv(const RowColumns& columns)
{
    return csvTable({{"row", &columns.row},
                     {"time_s", &columns.timeS},
                     {"frequency_hz", &columns.frequencyHz},
                     {"pulses", &columns.pulses},
                     {"ticks", &columns.ticks}});
}

QJsonArray rowsJson(const RowColumns& columns)
{
    QJsonArray rows;
    for (std::size_t i = 0; i < columns.row.size(); ++i)
        rows.append(QJsonObject{{u"row"_s, columns.row[i]},
                                {u"time_s"_s, columns.timeS[i]},
                                {u"frequency_hz"_s, columns.frequencyHz[i]},
                                {u"pulses"_s, columns.pulses[i]},
                                {u"ticks"_s, columns.ticks[i]}});
    return rows;
}

QByteArray rowsText(const RowColumns& columns)
{
    QString text = u"\n%1 %2 %3 %4 %5\n"_s.arg(u"row"_s, 5)
                       .arg(u"time s"_s, 11)
                       .arg(u"frequency Hz"_s, 13)
                       .arg(u"pulses"_s, 7)
                       .arg(u"ticks"_s, 11);
    for (std::size_t i = 0; i < columns.row.size(); ++i)
        text += u"%1 %2 %3 %4 %5\n"_s.arg(columns.row[i], 5, 'f', 0)
                    .arg(columns.timeS[i], 11, 'f', 7)
                    .arg(columns.frequencyHz[i], 13, 'f', 3)
                    .arg(columns.pulses[i], 7, 'f', 0)
                    .arg(columns.ticks[i], 11, 'f', 0);
    return text.toUtf8();
}

QJsonObject figures(const program::ProgramImage& image)
{
    const profile::StepTable& table = image.table;
    const profile::TableErrors& errors = table.errors;
    return {{u"name"_s, QString::fromStdString(image.recipe.name)},
            {u"crc32"_s, QString::number(image.crc, 16).toUpper().rightJustified(8, u'0')},
            {u"rows_used"_s, static_cast<qint64>(table.rows.size())},
            {u"row_capacity"_s, image.recipe.machine.rowCapacity},
            {u"timer_clock_hz"_s, static_cast<qint64>(image.recipe.machine.timerClockHz)},
            {u"cycle_ticks"_s, static_cast<qint64>(table.cycleTicks)},
            {u"cycle_time_s"_s, static_cast<double>(table.cycleTicks) / image.recipe.machine.timerClockHz},
            {u"pulses_per_cycle"_s, QJsonObject{{u"whole"_s, static_cast<qint64>(table.pulses.whole)},
                                                {u"remainder"_s, static_cast<qint64>(table.pulses.remainder)},
                                                {u"divisor"_s, static_cast<qint64>(table.pulses.divisor)},
                                                {u"carry_row"_s, static_cast<qint64>(table.carryRow)}}},
            {u"errors"_s, QJsonObject{{u"speed_mm_per_s"_s, errors.speedMmPerS},
                                      {u"speed_percent"_s, errors.speedPercent},
                                      {u"speed_at_s"_s, errors.speedTimeS},
                                      {u"frequency_step_hz"_s, errors.frequencyStepHz},
                                      {u"frequency_step_at_s"_s, errors.frequencyStepTimeS},
                                      {u"position_at_boundaries_pulses"_s, errors.boundaryPulses},
                                      {u"position_pulses"_s, errors.insidePulses},
                                      {u"position_at_s"_s, errors.insideTimeS},
                                      {u"position_rms_pulses"_s, errors.rmsPulses}}}};
}

} // namespace

Outcome runTable(const Invocation& call)
{
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto image = program::buildProgram(*recipe);
    if (!image)
        return fail(ExitCode::Refused, program::describe(image.error()));
    const RowColumns columns = columnsOf(*image);
    if (call.format() == u"csv")
        return call.deliver(rowsCsv(columns));
    QJsonObject object = figures(*image);
    if (call.format() == u"json") {
        object[u"rows"_s] = rowsJson(columns);
        return call.deliver(formatted(object, call.format()));
    }
    return call.deliver(formatted(object, call.format()) + rowsText(columns));
}

} // namespace campanel::cli
