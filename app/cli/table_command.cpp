// SPDX-License-Identifier: Apache-2.0
// campanelctl table: the table of any kind of program, its sums and its own error figures.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/cli/report.h"
#include "app/program/table/table_columns.h"

#include <QJsonArray>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using TableColumns = std::vector<program::TableColumn>;

QJsonArray rowsJson(const TableColumns& columns)
{
    QJsonArray rows;
    for (std::size_t i = 0; i < columns[0].values.size(); ++i) {
        QJsonObject row;
        for (const program::TableColumn& column : columns)
            row[QString::fromLatin1(column.name)] = column.values[i];
        rows.append(row);
    }
    return rows;
}

QByteArray rowsText(const TableColumns& columns)
{
    constexpr int width = 15;
    QString text = u"\n"_s;
    for (const program::TableColumn& column : columns)
        text += QString::fromLatin1(column.name).rightJustified(width) + u' ';
    text += u'\n';
    for (std::size_t i = 0; i < columns[0].values.size(); ++i) {
        for (const program::TableColumn& column : columns)
            text += u"%1 "_s.arg(column.values[i], width, 'f', column.decimals);
        text += u'\n';
    }
    return text.toUtf8();
}

QJsonObject pulsesObject(const profile::PulsesPerCycle& pulses)
{
    return {{u"whole"_s, static_cast<qint64>(pulses.whole)},
            {u"remainder"_s, static_cast<qint64>(pulses.remainder)},
            {u"divisor"_s, static_cast<qint64>(pulses.divisor)}};
}

void addFigures(QJsonObject& object, const profile::StepTable& table, const program::ProgramImage& image)
{
    const profile::TableErrors& errors = table.errors;
    QJsonObject pulses = pulsesObject(table.pulses);
    pulses[u"carry_row"_s] = static_cast<qint64>(table.carryRow);
    object[u"row_capacity"_s] = image.recipe.machine.rowCapacity;
    object[u"pulses_per_cycle"_s] = pulses;
    object[u"errors"_s] = QJsonObject{{u"speed_mm_per_s"_s, errors.speedMmPerS},
                                      {u"speed_percent"_s, errors.speedPercent},
                                      {u"speed_at_s"_s, errors.speedTimeS},
                                      {u"frequency_step_hz"_s, errors.frequencyStepHz},
                                      {u"frequency_step_at_s"_s, errors.frequencyStepTimeS},
                                      {u"position_at_boundaries_pulses"_s, errors.boundaryPulses},
                                      {u"position_pulses"_s, errors.insidePulses},
                                      {u"position_at_s"_s, errors.insideTimeS},
                                      {u"position_rms_pulses"_s, errors.rmsPulses}};
}

void addFigures(QJsonObject& object, const profile::CamTable& table, const program::ProgramImage& image)
{
    const program::CamSource source = program::camSource(image.recipe, image.solved);
    const profile::CamErrors errors =
        profile::camErrors(table, source.motion, image.solved.machine, source.use);
    object[u"pulses_per_cycle"_s] = pulsesObject(table.advance);
    object[u"errors"_s] = QJsonObject{{u"position_pulses"_s, errors.positionPulses},
                                      {u"position_mm"_s, errors.positionMm},
                                      {u"position_at_s"_s, errors.positionTimeS},
                                      {u"speed_mm_per_s"_s, errors.speedMmPerS},
                                      {u"speed_at_s"_s, errors.speedTimeS}};
}

void addFigures(QJsonObject& object, const profile::IntervalTable& table, const program::ProgramImage&)
{
    object[u"fraction_bits"_s] = table.fractionBits;
    object[u"pulses"_s] = static_cast<qint64>(table.advance);
    object[u"time_s"_s] = table.timeS;
    object[u"profile_time_s"_s] = table.profileTimeS;
    object[u"errors"_s] = QJsonObject{{u"speed_mm_per_s"_s, table.errors.speedMmPerS},
                                      {u"speed_at_s"_s, table.errors.speedTimeS},
                                      {u"position_pulses"_s, table.errors.positionPulses},
                                      {u"position_at_s"_s, table.errors.positionTimeS}};
}

void addFigures(QJsonObject& object, const profile::PressTable& table, const program::ProgramImage&)
{
    object[u"errors"_s] =
        QJsonObject{{u"position_mm"_s, table.positionErrorMm}, {u"speed_mm_per_s"_s, table.speedErrorMmPerS}};
}

QJsonObject figures(const program::ProgramImage& image, std::size_t rows)
{
    const auto ticks =
        std::visit([](const auto& table) { return static_cast<qint64>(table.cycleTicks); }, image.table);
    QJsonObject object{{u"name"_s, QString::fromStdString(image.recipe.name)},
                       {u"kind"_s, fromView(program::kindInfo(image.recipe.kind()).key)},
                       {u"crc32"_s, crcText(image.crc)},
                       {u"rows_used"_s, static_cast<qint64>(rows)},
                       {u"timer_clock_hz"_s, static_cast<qint64>(image.recipe.machine.timerClockHz)},
                       {u"cycle_ticks"_s, ticks},
                       {u"cycle_time_s"_s, static_cast<double>(ticks) / image.recipe.machine.timerClockHz}};
    std::visit([&](const auto& table) { addFigures(object, table, image); }, image.table);
    addAdvance(object, image.recipe.program);
    return object;
}

} // namespace

Outcome runTable(const Invocation& call)
{
    const auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    const auto image = program::buildProgram(*recipe);
    if (!image)
        return fail(image.error());
    const TableColumns columns = program::tableColumns(*image);
    if (call.format() == u"csv")
        return call.deliver(QByteArray::fromStdString(program::tableCsv(columns)));
    QJsonObject object = figures(*image, columns[0].values.size());
    if (call.format() == u"json") {
        object[u"rows"_s] = rowsJson(columns);
        return call.deliver(formatted(object, call.format()));
    }
    return call.deliver(formatted(object, call.format()) + rowsText(columns));
}

} // namespace campanel::cli
