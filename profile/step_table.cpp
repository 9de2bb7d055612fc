// SPDX-License-Identifier: Apache-2.0
// From curve to rows: slice boundaries in whole ticks, pulses as differences of the rounded travel (so that
// no error adds up), then each slice as rows that the timer and the row format can hold.
#include "profile/step_table.h"

#include "profile/limits.h"
#include "profile/table_nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace campanel::profile {
namespace {

// One less than a row can hold, so that any row has room for the carried pulse.
constexpr std::int64_t largestRowPulses = std::numeric_limits<std::uint16_t>::max() - 1;

std::vector<TableSlice> cutSlices(const RotaryCutter& cutter, std::int64_t cycleTicks)
{
    const double clock = cutter.machine.timerClockHz;
    const auto segments = cutter.motion.segments();
    std::vector<TableSlice> slices;
    slices.reserve(2 * static_cast<std::size_t>(cutter.program.slicesPerRamp) + segments.size());
    std::int64_t start = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Segment& segment = segments[i];
        const int parts = segment.law == nullptr ? 1 : cutter.program.slicesPerRamp;
        for (int part = 1; part <= parts; ++part) {
            const bool isLast = i + 1 == segments.size() && part == parts;
            const double endS = segment.startS + segment.durationS * part / parts;
            const std::int64_t end = isLast ? cycleTicks : std::llround(endS * clock);
            if (end > start)
                slices.push_back({start, end - start, 0, i});
            start = end;
        }
    }
    return slices;
}

// The slice whose rows may carry the extra pulse: the longest of constant speed, if it has room; else the
// longest.
std::size_t carrySlice(const RotaryCutter& cutter, const std::vector<TableSlice>& slices)
{
    const double clock = cutter.machine.timerClockHz;
    const auto room = [&](const TableSlice& slice) {
        const double limit = pulseFrequencyLimitHz(cutter.machine);
        const double middleS =
            (static_cast<double>(slice.startTick) + static_cast<double>(slice.ticks) / 2) / clock;
        const double speed = cutter.motion.at(middleS).velocityMmPerS;
        return (limit - speed * pulsesPerMm(cutter.machine)) * static_cast<double>(slice.ticks) / clock;
    };
    constexpr double neededRoomPulses = 3; // the carried one, and the roundings at both ends
    const auto score = [&](const TableSlice& slice) {
        const bool isConstant = cutter.motion.segments()[slice.segment].law == nullptr;
        const bool moves = isConstant && cutter.motion.segments()[slice.segment].startVelocityMmPerS > 0;
        return std::pair{(moves ? 1 : 0) + (room(slice) >= neededRoomPulses ? 2 : 0), slice.ticks};
    };
    const auto best =
        std::max_element(slices.begin(), slices.end(),
                         [&](const TableSlice& a, const TableSlice& b) { return score(a) < score(b); });
    return static_cast<std::size_t>(best - slices.begin());
}

// Gives every slice its pulses: N_i = round(F(t_i)) - round(F(t_i-1)), the cycle's fraction left out after
// the carry slice, no slice faster than the timer. False when the whole pulses do not fit.
bool distributePulses(const RotaryCutter& cutter, std::vector<TableSlice>& slices, std::size_t carry)
{
    const PulsesPerCycle pulses = pulsesPerCycle(cutter.machine);
    const double fraction = static_cast<double>(pulses.remainder) / static_cast<double>(pulses.divisor);
    const double perMm = pulses.asDouble() / cutter.cycle.strokeMm;
    const double clock = cutter.machine.timerClockHz;
    const std::int64_t constant = smallestTimerConstant(cutter.machine);

    std::vector<std::int64_t> after(slices.size()); // pulses from the cycle's beginning to the slice's end
    std::int64_t before = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const double endS = static_cast<double>(slices[i].startTick + slices[i].ticks) / clock;
        const double travel = cutter.motion.at(endS).positionMm * perMm - (i >= carry ? fraction : 0);
        const std::int64_t exact = i + 1 == slices.size() ? pulses.whole : std::llround(travel);
        after[i] = std::min(std::clamp(exact, before, before + slices[i].ticks / constant), pulses.whole);
        before = after[i];
    }
    // What the timer could not give at the end has to come earlier.
    after.back() = pulses.whole;
    for (std::size_t i = slices.size() - 1; i > 0; --i)
        after[i - 1] = std::max(after[i - 1], after[i] - slices[i].ticks / constant);
    before = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        slices[i].pulses = after[i] - before;
        if (slices[i].pulses * constant > slices[i].ticks)
            return false;
        before = after[i];
    }
    return true;
}

class RowWriter {
public:
    RowWriter(const Machine& machine, std::vector<StepRow>& rows)
        : m_largestConstant(largestTimerConstant(machine))
        , m_rows(rows)
    {
    }

    void write(const TableSlice& slice)
    {
        if (slice.pulses == 0)
            pause(slice.ticks);
        else if (slice.ticks > m_largestConstant * slice.pulses)
            writeSlow(slice);
        else
            writeEven(slice);
    }

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
        const std::int64_t chunks = (slice.pulses + largestRowPulses - 1) / largestRowPulses;
        std::int64_t pulse = 0;
        std::int64_t tick = 0;
        for (std::int64_t chunk = 1; chunk <= chunks; ++chunk) {
            const std::int64_t nextPulse = slice.pulses * chunk / chunks;
            const std::int64_t nextTick = nextPulse * slice.ticks / slice.pulses;
            m_rows.push_back(
                {static_cast<std::uint16_t>(nextPulse - pulse), static_cast<std::uint32_t>(nextTick - tick)});
            pulse = nextPulse;
            tick = nextTick;
        }
    }

    // Slower than the timer's largest constant: before each pulse a pause, then the longest interval the
    // timer has.
    void writeSlow(const TableSlice& slice)
    {
        std::int64_t tick = 0;
        for (std::int64_t pulse = 1; pulse <= slice.pulses; ++pulse) {
            const std::int64_t next = pulse * slice.ticks / slice.pulses;
            const std::int64_t interval = std::min(next - tick, m_largestConstant);
            if (next - tick > interval)
                pause(next - tick - interval);
            m_rows.push_back({1, static_cast<std::uint32_t>(interval)});
            tick = next;
        }
    }

    std::int64_t m_largestConstant;
    std::vector<StepRow>& m_rows;
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

// The row of [from, to) that has room for one more pulse, the longest one.
std::optional<std::size_t> rowWithRoom(const std::vector<StepRow>& rows, std::size_t from, std::size_t to,
                                       std::int64_t smallestConstant)
{
    std::optional<std::size_t> best;
    for (std::size_t i = from; i < to; ++i) {
        const bool hasRoom = rows[i].pulses > 0 && (rows[i].pulses + 1) * smallestConstant <= rows[i].ticks;
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
    constexpr double frequencyTolerance = 1e-9; // relative; of a frequency that meets the limit exactly
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
    std::vector<TableSlice> slices = cutSlices(cutter, table.cycleTicks);
    const std::size_t carry = carrySlice(cutter, slices);
    // A whole pulse more in the longest slice is what the timer cannot give here.
    const double onePulseMoreHz =
        static_cast<double>(machine.timerClockHz) / static_cast<double>(slices[carry].ticks);
    if (!distributePulses(cutter, slices, carry))
        return tl::unexpected(tooFast(cutter, peak.pulseFrequencyHz + onePulseMoreHz));

    table.rows.reserve(slices.size());
    RowWriter writer(machine, table.rows);
    std::size_t carryBegin = 0;
    std::size_t carryEnd = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        if (i == carry)
            carryBegin = table.rows.size();
        writer.write(slices[i]);
        if (i == carry)
            carryEnd = table.rows.size();
    }
    if (table.rows.size() > static_cast<std::size_t>(machine.rowCapacity)) {
        Refusal refusal;
        refusal.limit = Limit::RowCapacity;
        refusal.field = Field::RowCapacity;
        refusal.actual = static_cast<double>(table.rows.size());
        refusal.allowed = machine.rowCapacity;
        return tl::unexpected(std::move(refusal));
    }
    std::optional<std::size_t> row =
        rowWithRoom(table.rows, carryBegin, carryEnd, smallestTimerConstant(machine));
    if (!row)
        row = rowWithRoom(table.rows, 0, table.rows.size(), smallestTimerConstant(machine));
    if (!row && table.pulses.remainder != 0)
        return tl::unexpected(tooFast(cutter, peak.pulseFrequencyHz + onePulseMoreHz));
    table.carryRow = row.value_or(0);
    table.errors = tableErrors(cutter, slices);
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
