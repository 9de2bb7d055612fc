// SPDX-License-Identifier: Apache-2.0
#include "machine.h"

#include "ctl_press.h"
#include "ctl_step.h"
#include "ctl_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace campanel::controller {
namespace {

constexpr double fullCircle = 36000.0; // of the bank's angles, 0.01 degrees
constexpr double restPulses = 1e-6;    // closer than that the servo stands still
constexpr double restPulsesPerS = 1e-3;
constexpr double umPerMm = 1000.0;

double wide(const ctl_bank& bank, unsigned offset)
{
    return ctl_get32(&bank.registers[offset]);
}

// Pulses of one turn of the knife shaft.
double knifeRevolution(const ctl_bank& bank)
{
    return wide(bank, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) *
           bank.registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] /
           bank.registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR];
}

// Pulses of the table from the start of the cycle to a master angle.
double pulsesAtAngle(const ctl_bank& bank, double angle)
{
    double ticks = wide(bank, CTL_OFFSET_BANK_CYCLE_TICKS) * angle / fullCircle;
    double pulses = 0.0;
    for (std::uint32_t i = 0; i < ctl_bank_row_count(&bank) && ticks > 0.0; ++i) {
        const ctl_row row = ctl_step_row(&bank, i);
        const double part = std::min(1.0, ticks / row.ticks);
        pulses += part * row.pulses;
        ticks -= row.ticks;
    }
    return pulses;
}

} // namespace

Machine::Machine(const MachineOptions& options)
    : m_options(options)
    , m_random(options.seed)
    , m_slipMm(0.0, std::max(options.filmSlipMm, 0.0))
    , m_angularBandwidth(2.0 * std::numbers::pi * options.servoBandwidthHz)
{
    m_mark = -m_revolution * options.startAngleDegrees / 360.0;
}

void Machine::setProgram(const ctl_bank& bank)
{
    const std::uint16_t kind = ctl_bank_kind(&bank);
    m_hasKnife = kind == CTL_PROGRAM_KIND_ROTARY_CUTTER;
    turnBy(m_hasKnife ? knifeRevolution(bank) : ctl_bank_revolution_pulses(&bank, 1));
    if (m_hasKnife)
        setKnife(bank);
    else
        forgetLastCut();
    if (kind == CTL_PROGRAM_KIND_PRESS)
        setPress(bank);
    else
        m_ram.reset();
}

// From now on so many pulses lie between two index marks; the shaft keeps its angle.
void Machine::turnBy(double revolution)
{
    const double revolutions = (m_position - m_mark) / m_revolution;
    if (std::abs(revolution - m_revolution) > restPulses) {
        m_revolution = revolution;
        m_mark = m_position - revolutions * revolution;
    }
}

// Another press begins with its ram up.
void Machine::setPress(const ctl_bank& bank)
{
    const double pulseMm =
        wide(bank, CTL_OFFSET_PRESS_FEED) / umPerMm / wide(bank, CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV);
    if (m_ram && pulseMm == m_pulseMm)
        return;
    m_ram.emplace(m_options.press, m_options.seed);
    m_pulseMm = pulseMm;
    m_top = m_position;
}

void Machine::setKnife(const ctl_bank& bank)
{
    m_stroke = m_revolution / bank.registers[CTL_OFFSET_PROGRAM_KNIVES];
    m_cutOffset = pulsesAtAngle(bank, bank.registers[CTL_OFFSET_BANK_CUT_ANGLE]);
}

void Machine::setDriveOn(bool on)
{
    if (on && !m_driveOn)
        m_commanded = std::llround(m_position);
    m_driveOn = on;
}

void Machine::followCommand(double stepS)
{
    const double error = m_driveOn ? static_cast<double>(m_commanded) - m_position : 0.0;
    if (std::abs(error) < restPulses && std::abs(m_speed) < restPulsesPerS) {
        m_speed = 0.0;
        return;
    }
    m_speed += stepS * m_angularBandwidth * (m_angularBandwidth * error - 2.0 * m_speed);
    m_position += stepS * m_speed;
}

void Machine::passIndex(double before)
{
    const double turns = std::floor((m_position - m_mark) / m_revolution);
    if (turns > std::floor((before - m_mark) / m_revolution))
        m_index = std::llround(m_mark + turns * m_revolution);
}

void Machine::passCut(double before, double filmMm)
{
    const double first = m_mark + m_cutOffset;
    const double strokes = std::floor((m_position - first) / m_stroke);
    if (!m_hasKnife || strokes <= std::floor((before - first) / m_stroke))
        return;
    const double passed = (first + strokes * m_stroke - before) / (m_position - before);
    const double filmAtCutMm = m_filmMm + passed * filmMm + m_slipMm(m_random);
    if (m_filmAtCutMm)
        m_cutUm = static_cast<std::uint32_t>(std::max(0.0, umPerMm * (filmAtCutMm - *m_filmAtCutMm) + 0.5));
    m_filmAtCutMm = filmAtCutMm;
}

void Machine::advance(double stepS, double filmMm)
{
    const double before = m_position;
    followCommand(stepS);
    if (m_ram)
        m_ram->follow((m_position - m_top) * m_pulseMm);
    passIndex(before);
    passCut(before, filmMm);
    m_filmMm += filmMm;
}

std::int64_t Machine::encoder() const
{
    return m_ram ? std::llround(m_top) + std::llround(m_ram->scaleMm() / m_pulseMm)
                 : std::llround(m_position);
}

std::int64_t Machine::scale() const
{
    if (!m_ram)
        return encoder() * CTL_PRESS_FINE;
    return std::llround(m_top) * CTL_PRESS_FINE + std::llround(m_ram->scaleMm() / m_pulseMm * CTL_PRESS_FINE);
}

std::optional<std::int64_t> Machine::takeIndex()
{
    return std::exchange(m_index, std::nullopt);
}

std::optional<std::uint32_t> Machine::takeCutUm()
{
    return std::exchange(m_cutUm, std::nullopt);
}

} // namespace campanel::controller
