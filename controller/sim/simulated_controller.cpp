// SPDX-License-Identifier: Apache-2.0
#include "simulated_controller.h"

#include <utility>

namespace campanel::controller {
namespace {

constexpr double sPerUs = 1e-6;

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

bool take(const std::optional<Machine::Edge>& edge, std::int64_t* at, bool* covered)
{
    if (edge) {
        *at = edge->encoder;
        *covered = edge->covered;
    }
    return edge.has_value();
}

bool takeMark(void* context, std::int64_t* filmAtEdge, bool* covered)
{
    return take(machineOf(context).takeMark(), filmAtEdge, covered);
}

bool takeEdge(void* context, std::int64_t* infeedAtEdge, bool* covered)
{
    return take(machineOf(context).takeEdge(), infeedAtEdge, covered);
}

void connectFeeds(ctl_port& port)
{
    port.feed = [](void* context, ctl_axis axis, std::int64_t from, std::int64_t to) {
        machineOf(context).commandFeed(axis, from, to);
    };
    port.film = [](void* context) { return machineOf(context).filmEncoder(); };
    port.infeed = [](void* context) { return machineOf(context).infeedEncoder(); };
    port.mark = takeMark;
    port.eye = takeEdge;
}

void connectMaster(ctl_port& port)
{
    port.master = [](void* context, std::uint16_t, ctl_master_input* input) {
        const LineShaft& shaft = machineOf(context).shaft();
        *input = {shaft.counts(), shaft.errors(), shaft.indexPasses(), shaft.indexCounts()};
    };
    port.latch_master = [](void* context, bool on) { machineOf(context).latchMaster(on); };
}

} // namespace

SimulatedController::SimulatedController(const ctl_config& config, const MachineOptions& options,
                                         FlashDevice& flash, std::uint64_t stepUs)
    : m_stepUs(stepUs)
    , m_machine(options)
    , m_core(std::make_unique<ctl_core>())
    , m_flash(flash)
{
    m_config = config;
    m_config.slice_us = static_cast<std::uint32_t>(stepUs);
    m_config.output_us = m_config.slice_us; // the pulses of a slice leave while the machine advances
    ctl_port& port = m_port;
    port.context = this;
    port.pulses = [](void* context, const ctl_train* train) {
        auto& self = *static_cast<SimulatedController*>(context);
        if (self.onPulses)
            self.onPulses(*train);
        self.machine().command(train->direction * static_cast<std::int64_t>(train->count));
    };
    port.encoder = [](void* context) { return machineOf(context).encoder(); };
    port.index = takeIndex;
    port.scale = [](void* context) { return machineOf(context).scale(); };
    port.force = [](void* context) { return machineOf(context).forceN(); };
    port.reverse = [](void* context, std::uint16_t axes) { machineOf(context).setReversed(axes); };
    port.inputs = [](void* context) { return machineOf(context).inputs(); };
    port.outputs = [](void* context, std::uint32_t levels) { machineOf(context).setOutputs(levels); };
    port.torque = [](void* context) { return machineOf(context).torqueTenthPercent(); };
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
    if (m_flash.keeps()) {
        port.keep = [](void* context, std::uint32_t record, const std::uint8_t* bytes, std::uint32_t size) {
            return static_cast<SimulatedController*>(context)->m_flash.keep(record, {bytes, size});
        };
        port.kept = [](void* context, std::uint32_t record, std::uint8_t* bytes, std::uint32_t size) {
            return static_cast<std::uint32_t>(
                static_cast<SimulatedController*>(context)->m_flash.kept(record, {bytes, size}));
        };
    }
    if (m_machine.shaft().hasEncoder())
        connectMaster(port);
    connectFeeds(port);
    restart();
}

void SimulatedController::restart()
{
    ctl_init(m_core.get(), &m_config, &m_port, m_nowUs);
    takeOverProgram();
}

void SimulatedController::takeOverProgram()
{
    if (!m_core->banks.has_active)
        return;
    m_generation = m_core->banks.generation;
    m_machine.setProgram(*ctl_active_bank(&m_core->banks));
}

void SimulatedController::step()
{
    m_nowUs += m_stepUs;
    ctl_tick(m_core.get(), m_nowUs);
    if (m_generation != m_core->banks.generation)
        takeOverProgram();
    m_machine.advance(static_cast<double>(m_stepUs) * sPerUs);
    m_cut = m_machine.takeCut();
    m_cutByHand.reset();
    if (m_core->motion.manual && !m_core->motion.in_phase) {
        m_machine.forgetLastCut();
        m_cutByHand = std::exchange(m_cut, std::nullopt);
    }
    if (m_cut)
        passCut();
    if (onStep)
        onStep();
}

void SimulatedController::passCut()
{
    ctl_on_cut(m_core.get(), m_cut->filmEncoder);
    if (m_cut->lengthUm)
        ctl_on_bag_cut(m_core.get(), *m_cut->lengthUm);
}

void SimulatedController::runTo(std::uint64_t timeUs)
{
    while (m_nowUs + m_stepUs <= timeUs)
        step();
    ctl_receive_silence(m_core.get(), timeUs);
}

} // namespace campanel::controller
