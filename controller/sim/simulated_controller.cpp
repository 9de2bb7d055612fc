// SPDX-License-Identifier: Apache-2.0
#include "simulated_controller.h"

#include "ctl_words.h"

#include <algorithm>

namespace campanel::controller {
namespace {

constexpr double stepS = SimulatedController::stepUs * 1e-6;
constexpr double mmPerUm = 1e-3;

Machine& machineOf(void* context)
{
    return static_cast<SimulatedController*>(context)->machine();
}

bool takeIndex(void* context, std::int64_t* encoderAtMark)
{
    const auto mark = machineOf(context).takeIndex();
    if (mark)
        *encoderAtMark = *mark;
    return mark.has_value();
}

double phaseOf(const ctl_core& core)
{
    if (!core.banks.has_active)
        return 0.0;
    const ctl_table& table = core.motion.table;
    return static_cast<double>(ctl_table_position(&table)) / ctl_bank_cycle_ticks(table.bank);
}

// Film that a cycle feeds: none where there is no knife.
double bagLengthMm(const ctl_core& core)
{
    if (ctl_bank_kind(ctl_active_bank(&core)) != CTL_PROGRAM_KIND_ROTARY_CUTTER)
        return 0.0;
    return mmPerUm * ctl_get32(&ctl_active_bank(&core)->registers[CTL_OFFSET_PROGRAM_BAG_LENGTH]);
}

} // namespace

SimulatedController::SimulatedController(const ctl_config& config, const MachineOptions& options,
                                         FlashDevice& flash)
    : m_machine(options)
    , m_core(std::make_unique<ctl_core>())
    , m_flash(flash)
{
    ctl_port port{};
    port.context = this;
    port.pulses = [](void* context, std::int32_t count) { machineOf(context).command(count); };
    port.encoder = [](void* context) { return machineOf(context).encoder(); };
    port.index = takeIndex;
    port.scale = [](void* context) { return machineOf(context).scale(); };
    port.force = [](void* context) { return machineOf(context).forceN(); };
    port.flash_read = [](void* context, std::uint32_t slot, std::uint32_t offset, std::uint8_t* bytes,
                         std::uint32_t size) {
        return static_cast<SimulatedController*>(context)->m_flash.read(slot, offset, {bytes, size});
    };
    port.flash_erase = [](void* context, std::uint32_t slot) {
        return static_cast<SimulatedController*>(context)->m_flash.erase(slot);
    };
    port.flash_write = [](void* context, std::uint32_t slot, std::uint32_t offset, const std::uint8_t* bytes,
                          std::uint32_t size) {
        return static_cast<SimulatedController*>(context)->m_flash.write(slot, offset, {bytes, size});
    };
    ctl_init(m_core.get(), &config, &port, 0);
    takeOverProgram();
}

void SimulatedController::takeOverProgram()
{
    if (!m_core->banks.has_active)
        return;
    m_generation = m_core->banks.generation;
    m_bagLengthMm = bagLengthMm(*m_core);
    m_machine.setProgram(*ctl_active_bank(m_core.get()));
}

// The film axis moves one bag length a cycle, in proportion to the master.
double SimulatedController::filmSinceLastStepMm()
{
    const double phase = phaseOf(*m_core);
    const std::uint32_t cycles = m_core->motion.cycle_count - m_cycles;
    const double oldLengthMm = m_bagLengthMm;
    const double oldPhase = m_phase;
    m_cycles = m_core->motion.cycle_count;
    m_phase = phase;
    if (m_generation != m_core->banks.generation) {
        takeOverProgram();
        // Taken over at a boundary: the old program fed up to it, the new one from there.
        if (cycles > 0)
            return oldLengthMm * (cycles - oldPhase) + m_bagLengthMm * phase;
        return m_bagLengthMm * phase;
    }
    return std::max(0.0, m_bagLengthMm * (cycles + phase - oldPhase));
}

void SimulatedController::step()
{
    m_nowUs += stepUs;
    ctl_tick(m_core.get(), m_nowUs);
    const double filmMm = filmSinceLastStepMm();
    if (m_core->motion.manual)
        m_machine.forgetLastCut();
    m_machine.advance(stepS, filmMm);
    if (const auto lengthUm = m_machine.takeCutUm())
        ctl_on_bag_cut(m_core.get(), *lengthUm);
}

void SimulatedController::runTo(std::uint64_t timeUs)
{
    while (m_nowUs + stepUs <= timeUs)
        step();
    ctl_rtu_tick(m_core.get(), timeUs);
}

} // namespace campanel::controller
