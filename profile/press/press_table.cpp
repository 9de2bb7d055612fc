// SPDX-License-Identifier: Apache-2.0
// Converts the press program to the controller's units: whole pulses, Hz, N and ms.
#include "profile/model/bounds.h"
#include "profile/press/press.h"
#include "profile/press/press_ramp.h"

#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

class PressRounding {
public:
    PressRounding(const Machine& machine, PressTable& table)
        : m_machine(machine)
        , m_pulsesPerMm(axisPulsesPerMm(machine))
        , m_table(table)
    {
    }

    PressRow row(double speedMmPerS, double endMm, double forceN)
    {
        PressRow row;
        const double hz = maxOf(1.0, std::round(speedMmPerS * m_pulsesPerMm));
        const double pulses = std::round(endMm * m_pulsesPerMm);
        row.speedHz = static_cast<std::uint32_t>(hz);
        row.endPulses = static_cast<std::int32_t>(pulses);
        row.forceN = static_cast<std::uint32_t>(std::llround(forceN));
        row.timeMs = static_cast<std::uint32_t>(detail::pressRampMs(speedMmPerS, m_machine));
        m_table.positionErrorMm = maxOf(m_table.positionErrorMm, std::abs(pulses / m_pulsesPerMm - endMm));
        m_table.speedErrorMmPerS =
            maxOf(m_table.speedErrorMmPerS, std::abs(hz / m_pulsesPerMm - speedMmPerS));
        return row;
    }

private:
    const Machine& m_machine;
    double m_pulsesPerMm;
    PressTable& m_table;
};

} // namespace

tl::expected<PressTable, Refusal> buildPressTable(const PressProgram& program, const Machine& machine)
{
    const auto stroke = solveStroke(program, machine);
    if (!stroke)
        return tl::unexpected(stroke.error());
    if (!stroke->motion.broken.empty())
        return tl::unexpected(stroke->motion.broken.front());
    PressTable table;
    PressRounding rounding(machine, table);
    auto& rows = table.rows;
    rows[0] = rounding.row(program.approachSpeedMmPerS, program.approachPositionMm, program.probeForceN);
    rows[1] = rounding.row(program.probeSpeedMmPerS, program.probeEndMm, program.probeForceN);
    rows[2] = rounding.row(program.pressSpeedMmPerS, program.pressPositionMm, program.maxForceN);
    rows[3] = {0, rows[2].endPulses, rows[2].forceN,
               static_cast<std::uint32_t>(std::llround(program.holdTimeS * 1000))};
    rows[4] = rounding.row(program.returnSpeedMmPerS, 0, program.maxForceN);
    const double ticks = std::round(stroke->motion.motion.durationS() * machine.timerClockHz);
    table.cycleTicks = static_cast<std::uint32_t>(
        minOf(ticks, static_cast<double>(std::numeric_limits<std::uint32_t>::max())));
    return table;
}

} // namespace campanel::profile
