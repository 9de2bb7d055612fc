// SPDX-License-Identifier: Apache-2.0
#include "press_bench.h"

#include "bank/ctl_check.h"

#include <algorithm>
#include <stdexcept>

namespace campanel::test {
namespace {

constexpr std::uint64_t machineStepUs = 50;
constexpr std::uint64_t minuteUs = 60'000'000;

PressBench& benchOf(void* context)
{
    return *static_cast<PressBench*>(context);
}

} // namespace

PressBench::PressBench(const PressImage& image, const controller::MachineOptions& options,
                       const Disturbance& disturbance)
    : m_machine(options)
    , m_core(std::make_unique<ctl_core>())
    , m_disturbance(disturbance)
    , m_random(disturbance.seed)
{
    ctl_port port{};
    port.context = this;
    port.pulses = [](void* context, const ctl_train* train) {
        benchOf(context).onPulses(train->direction * static_cast<std::int32_t>(train->count));
    };
    port.encoder = [](void* context) { return benchOf(context).m_machine.encoder(); };
    port.index = [](void*, std::int64_t*) { return false; };
    port.scale = [](void* context) { return benchOf(context).m_machine.scale(); };
    port.force = [](void* context) { return benchOf(context).m_machine.forceN(); };
    port.flash_read = [](void*, std::uint32_t, std::uint32_t, std::uint8_t*, std::uint32_t) { return false; };
    port.flash_erase = [](void*, std::uint32_t) { return false; };
    port.flash_write = [](void*, std::uint32_t, std::uint32_t, const std::uint8_t*, std::uint32_t) {
        return false;
    };
    const ctl_config config = benchConfig();
    ctl_init(m_core.get(), &config, &port, 0);
    const Registers registers = image.registers();
    std::ranges::copy(registers, ctl_staged_bank(&m_core->banks)->registers);
    const ctl_verdict verdict = ctl_bank_check(ctl_staged_bank(&m_core->banks), &config,
                                               static_cast<std::uint32_t>(registers.size()));
    if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED)
        throw std::runtime_error("the bank was refused");
    m_core->transfer.staged_crc = crc32(registers);
    ctl_motion_change_program(&m_core->motion);
    m_machine.setProgram(*ctl_active_bank(&m_core->banks));
}

void PressBench::onPulses(std::int32_t count)
{
    if (count < 0 && m_core->motion.press.stage != CTL_PRESS_STAGE_RETURN)
        ++backwards;
    m_machine.command(count);
}

void PressBench::tick()
{
    const std::uint64_t steps = m_disturbance.longestTickUs / machineStepUs;
    const std::uint64_t passed = std::uniform_int_distribution<std::uint64_t>(1, steps)(m_random);
    for (std::uint64_t i = 0; i < passed; ++i)
        m_machine.advance(static_cast<double>(machineStepUs) * 1e-6);
    m_nowUs += passed * machineStepUs;
    ctl_tick(m_core.get(), m_nowUs);
    if (m_core->motion.press.stage == CTL_PRESS_STAGE_HOLD)
        heldMm = m_machine.ram().positionMm();
    if (!m_disturbance.traffic)
        return;
    Bytes answer(CTL_FRAME_BYTES);
    answers += ctl_take_answer(m_core.get(), answer.data()) > 0 ? 1u : 0u;
    if (std::uniform_int_distribution<int>(0, 9)(m_random) == 0) {
        const Bytes request = frame({1, 3, CTL_REG_STATUS_TAG >> 8, CTL_REG_STATUS_TAG & 0xFF, 0, 40});
        ctl_receive(m_core.get(), request.data(), request.size(), m_nowUs);
    }
}

void PressBench::runToStandstill()
{
    const std::uint64_t endUs = m_nowUs + minuteUs;
    while (!ctl_motion_standstill(&m_core->motion) && m_nowUs < endUs)
        tick();
}

bool PressBench::stroke()
{
    heldMm = 0.0;
    backwards = 0;
    if (ctl_start(&m_core->motion, &m_core->io) != CTL_REFUSAL_NONE)
        return false;
    runToStandstill();
    return true;
}

} // namespace campanel::test
