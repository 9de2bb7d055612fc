// SPDX-License-Identifier: Apache-2.0
#include "app/program/table/table_columns.h"

#include "app/program/interval_speeds.h"
#include "profile/cam/csv_writer.h"

#include <array>
#include <variant>

namespace campanel::program {
namespace {

using TableColumns = std::vector<TableColumn>;

TableColumns columnsOf(const profile::StepTable& table, const ProgramImage& image)
{
    TableColumns columns{
        {"row", 0, {}}, {"time_s", 7, {}}, {"frequency_hz", 3, {}}, {"pulses", 0, {}}, {"ticks", 0, {}}};
    const double clockHz = image.recipe.machine.timerClockHz;
    double startTicks = 0;
    for (const profile::StepRow& row : table.rows) {
        const std::array<double, 5> values{static_cast<double>(columns[0].values.size()),
                                           startTicks / clockHz, row.pulses * clockHz / row.ticks,
                                           static_cast<double>(row.pulses), static_cast<double>(row.ticks)};
        for (std::size_t i = 0; i < values.size(); ++i)
            columns[i].values.push_back(values[i]);
        startTicks += row.ticks;
    }
    return columns;
}

TableColumns columnsOf(const profile::CamTable& table, const ProgramImage& image)
{
    TableColumns columns{{"row", 0, {}},
                         {"time_s", 7, {}},
                         {"position_mm", 6, {}},
                         {"position_pulses", 4, {}},
                         {"slope_pulses", 4, {}}};
    const double stepS = image.solved.cycleS() / static_cast<double>(table.rows.size() - 1);
    for (const profile::CamRow& row : table.rows) {
        const auto at = static_cast<double>(columns[0].values.size());
        const double pulses = row.position256 / profile::camUnitsPerPulse;
        const std::array<double, 5> values{at, at * stepS, pulses / image.solved.pulsesPerMm, pulses,
                                           row.slope256 / profile::camUnitsPerPulse};
        for (std::size_t i = 0; i < values.size(); ++i)
            columns[i].values.push_back(values[i]);
    }
    return columns;
}

TableColumns columnsOf(const profile::IntervalTable& table, const ProgramImage&)
{
    TableColumns columns{{"row", 0, {}},
                         {"pulses", 0, {}},
                         {"first_hz", 4, {}},
                         {"last_hz", 4, {}},
                         {"acceleration_hz_per_s", 3, {}}};
    for (const profile::IntervalRow& row : table.rows) {
        const IntervalSpeeds speeds = speedsOf(row, table.fractionBits);
        const std::array<double, 5> values{static_cast<double>(columns[0].values.size()),
                                           static_cast<double>(row.pulses), speeds.firstHz, speeds.lastHz,
                                           speeds.accelerationHzPerS};
        for (std::size_t i = 0; i < values.size(); ++i)
            columns[i].values.push_back(values[i]);
    }
    return columns;
}

TableColumns columnsOf(const profile::PressTable& table, const ProgramImage&)
{
    TableColumns columns{
        {"row", 0, {}}, {"speed_hz", 0, {}}, {"end_pulses", 0, {}}, {"force_n", 0, {}}, {"time_ms", 0, {}}};
    for (const profile::PressRow& row : table.rows) {
        const std::array<double, 5> values{static_cast<double>(columns[0].values.size()),
                                           static_cast<double>(row.speedHz),
                                           static_cast<double>(row.endPulses),
                                           static_cast<double>(row.forceN), static_cast<double>(row.timeMs)};
        for (std::size_t i = 0; i < values.size(); ++i)
            columns[i].values.push_back(values[i]);
    }
    return columns;
}

} // namespace

std::vector<TableColumn> tableColumns(const ProgramImage& image)
{
    return std::visit([&](const auto& table) { return columnsOf(table, image); }, image.table);
}

std::string tableCsv(const std::vector<TableColumn>& columns)
{
    constexpr int digits = 10;
    profile::CsvWriter csv;
    for (const TableColumn& column : columns)
        csv.add(column.name);
    csv.endLine();
    for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
        for (const TableColumn& column : columns)
            csv.addSignificant(column.values[row], digits);
        csv.endLine();
    }
    return csv.text();
}

} // namespace campanel::program
