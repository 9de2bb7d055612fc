// SPDX-License-Identifier: Apache-2.0
// Converts slices to rows that the timer and the row format can hold.
#include "profile/cutter/step_table.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/table_nearest.h"
#include "profile/cutter/table_slices.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace campanel::profile {
namespace {

// The capacity of a row minus one, so that any row has space for the carried pulse.
constexpr std::int64_t maxRowPulses = std::numeric_limits<std::uint16_t>::max() - 1;

class RowWriter {
public:
    RowWriter(const Machine& machine, std::vector<StepRow>& rows)
        : m_largestConstant(maxTimerConstant(machine))
        , m_rows(rows)
    {
    }

    void write(const TableSlice& slice)
    {
        const bool isSlow = slice.ticks > m_largestConstant * slice.pulses;
        if (slice.pulses == 0)
            pause(slice.ticks);
        else if (isSlow)
            writeSlow(slice);
        else
            writeEven(slice);
        if (slice.pulses == 0 || isSlow)
            m_played.push_back(slice);
    }

    // Returns the sections of constant speed in the rows; a pause and a single pulse form one section.
    [[nodiscard]] std::span<const TableSlice> played() const { return m_played; }

private:
    void pause(std::int64_t ticks)
    {
        if (!m_rows.empty() && m_rows.back().pulses == 0)
            m_rows.back().ticks += static_cast<std::uint32_t>(ticks);
        else
            m_rows.push_back({0, static_cast<std::uint32_t>(ticks)});
    }

    void writeEven(const TableSlice& slice)
    {
        const std::int64_t chunks = (slice.pulses + maxRowPulses - 1) / maxRowPulses;
        std::int64_t pulse = 0;
        std::int64_t tick = 0;
        for (std::int64_t chunk = 1; chunk <= chunks; ++chunk) {
            const std::int64_t nextPulse = slice.pulses * chunk / chunks;
            const std::int64_t nextTick = nextPulse * slice.ticks / slice.pulses;
            m_rows.push_back(
                {static_cast<std::uint16_t>(nextPulse - pulse), static_cast<std::uint32_t>(nextTick - tick)});
            m_played.push_back({slice.startTick + tick, nextTick - tick, nextPulse - pulse, chunk == chunks});
            pulse = nextPulse;
            tick = nextTick;
        }
    }

    // Writes a slice below the timer's minimum frequency: before each pulse a pause, then the longest
    // interval of the timer.
    void writeSlow(const TableSlice& slice)
    {
        std::int64_t tick = 0;
        for (std::int64_t pulse = 1; pulse <= slice.pulses; ++pulse) {
            const std::int64_t next = pulse * slice.ticks / slice.pulses;
            const std::int64_t interval = minOf(next - tick, m_largestConstant);
            if (next - tick > interval)
                pause(next - tick - interval);
            m_rows.push_back({1, static_cast<std::uint32_t>(interval)});
            tick = next;
        }
    }

    std::int64_t m_largestConstant;
    std::vector<StepRow>& m_rows;
    std::vector<TableSlice> m_played;
};

Refusal tooFast(const RotaryCutter& cutter, double actualHz)
{
    Refusal refusal;
    refusal.limit = Limit::PulseFrequency;
    refusal.field = Field::MaxPulseFrequency;
    refusal.actual = actualHz;
    refusal.allowed = pulseFrequencyLimitHz(cutter.machine);
    refusal.unit = info(refusal.field).unit;
    refusal.timeS = peaks(cutter).speedTimeS;
    refusal.angleDeg = cutter.angleDegAt(*refusal.timeS);
    return refusal;
}

// Returns the longest row of [from, to) that has space for one more pulse.
std::optional<std::size_t> rowWithRoom(const std::vector<StepRow>& rows, std::size_t from, std::size_t to,
                                       std::int64_t minConstant)
{
    std::optional<std::size_t> best;
    for (std::size_t i = from; i < to; ++i) {
        const bool hasRoom = rows[i].pulses > 0 && (rows[i].pulses + 1) * minConstant <= rows[i].ticks;
        if (hasRoom && (!best || rows[i].ticks > rows[*best].ticks))
            best = i;
    }
    return best;
}

} // namespace

namespace detail {

tl::expected<StepTable, Refusal> buildTable(const RotaryCutter& cutter)
{
    const Machine& machine = cutter.machine;
    const Peaks peak = peaks(cutter);
    constexpr double frequencyTolerance = 1e-9; // relative; for a frequency that meets the limit exactly
    if (peak.pulseFrequencyHz > pulseFrequencyLimitHz(machine) * (1 + frequencyTolerance))
        return tl::unexpected(tooFast(cutter, peak.pulseFrequencyHz));

    StepTable table;
    table.pulses = pulsesPerCycle(machine);
    if (table.pulses.whole < 1) {
        Refusal refusal;
        refusal.limit = Limit::TooFewPulses;
        refusal.field = Field::PulsesPerMotorRev;
        refusal.actual = table.pulses.asDouble();
        refusal.allowed = 1;
        return tl::unexpected(std::move(refusal));
    }
    table.cycleTicks =
        static_cast<std::uint32_t>(std::llround(cutter.cycle.cycleTimeS * machine.timerClockHz));
    const auto longestS = maxOf(cutter.cycle.taS, cutter.cycle.tcS - cutter.cycle.tbS,
                                cutter.cycle.cycleTimeS - cutter.cycle.tdS);
    const double onePulseMoreHz = peak.pulseFrequencyHz + 1 / longestS;
    const std::optional<SlicedCycle> cycle = cutSlices(cutter, table.cycleTicks);
    if (!cycle)
        return tl::unexpected(tooFast(cutter, onePulseMoreHz));

    table.rows.reserve(cycle->slices.size());
    RowWriter writer(machine, table.rows);
    std::size_t carryBegin = 0;
    std::size_t carryEnd = 0;
    for (std::size_t i = 0; i < cycle->slices.size(); ++i) {
        const std::size_t firstRow = table.rows.size();
        writer.write(cycle->slices[i]);
        if (i == cycle->carrySlice) {
            carryBegin = firstRow;
            carryEnd = table.rows.size();
        }
    }
    if (table.rows.size() > static_cast<std::size_t>(machine.rowCapacity)) {
        Refusal refusal;
        refusal.limit = Limit::RowCapacity;
        refusal.field = Field::RowCapacity;
        refusal.actual = static_cast<double>(table.rows.size());
        refusal.allowed = machine.rowCapacity;
        return tl::unexpected(std::move(refusal));
    }
    std::optional<std::size_t> row = rowWithRoom(table.rows, carryBegin, carryEnd, minTimerConstant(machine));
    if (!row)
        row = rowWithRoom(table.rows, 0, table.rows.size(), minTimerConstant(machine));
    if (!row && table.pulses.remainder != 0)
        return tl::unexpected(tooFast(cutter, onePulseMoreHz));
    table.carryRow = row.value_or(0);
    table.errors = tableErrors(cutter, writer.played());
    return table;
}

} // namespace detail

tl::expected<StepTable, Refusal> buildStepTable(const RotaryCutter& cutter)
{
    tl::expected<StepTable, Refusal> table = detail::buildTable(cutter);
    if (!table)
        table.error().nearest = detail::nearestForTable(cutter, table.error());
    return table;
}

} // namespace campanel::profile
