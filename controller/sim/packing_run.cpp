// SPDX-License-Identifier: Apache-2.0
#include "packing_run.h"

#include "ctl_command.h"
#include "ctl_words.h"
#include "simulated_controller.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace campanel::controller {
namespace {

constexpr double usPerS = 1e6;
constexpr double umPerMm = 1000.0;
// Homing and the ramp, before the first bag must have come; and how long a bag may take.
constexpr std::uint64_t longestStartUs = 120'000'000;
constexpr unsigned longestBagCycles = 400;

// Nothing is kept over a power loss.
class NoFlash : public FlashDevice {
public:
    bool read(std::uint32_t, std::uint32_t, std::span<std::uint8_t> bytes) override
    {
        std::ranges::fill(bytes, std::uint8_t{0xFF});
        return true;
    }
    bool erase(std::uint32_t) override { return true; }
    bool write(std::uint32_t, std::uint32_t, std::span<const std::uint8_t>) override { return true; }
};

ctl_config configOf(const PackingJob& job)
{
    ctl_config config{};
    config.unit = 1;
    config.frame_gap_us = 1750;
    config.timer_clock_hz = job.timerClockHz;
    config.timer_bits = 16;
    config.max_pulse_hz = job.maxPulseHz;
    return config;
}

class Run {
public:
    Run(const PackingJob& job, const std::function<void(const PackedBag&)>& onBag)
        : m_job(job)
        , m_onBag(onBag)
        , m_controller(configOf(job), job.machine, m_flash, job.stepUs)
        , m_core(m_controller.core())
    {
    }

    PackingResult result()
    {
        if (setUp() && start())
            pack();
        const ctl_packer& packer = m_core.packer;
        m_result.timeS = static_cast<double>(m_controller.nowUs() - m_startUs) / usPerS;
        m_result.marks = packer.marks.followed;
        m_result.marksMissing = packer.marks.missing;
        m_result.marksFalse = packer.marks.unexpected;
        m_result.products = packer.products.total;
        m_result.cutsSkipped = packer.skipped;
        m_result.emptyBags = packer.empty;
        m_result.filmSavedM = static_cast<double>(packer.saved_um) / (umPerMm * umPerMm);
        m_result.correctionsLimited = packer.limited;
        return m_result;
    }

private:
    bool end(PackingEnd reason, std::uint32_t detail)
    {
        m_result.end = reason;
        m_result.detail = detail;
        return false;
    }

    bool setUp()
    {
        for (const ParameterValue& parameter : m_job.parameters) {
            if (ctl_map_write(&m_core, parameter.address, parameter.registers.data(),
                              static_cast<std::uint32_t>(parameter.registers.size())) != 0)
                return end(PackingEnd::BadParameter, parameter.address);
        }
        ctl_bank& bank = *ctl_staged_bank(&m_core);
        if (m_job.bank.size() > std::size(bank.registers))
            return end(PackingEnd::BadBank, CTL_TRANSFER_RESULT_BAD_LENGTH);
        std::ranges::copy(m_job.bank, bank.registers);
        const ctl_verdict verdict =
            ctl_bank_check(&bank, &m_core.config, static_cast<std::uint32_t>(m_job.bank.size()));
        if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED)
            return end(PackingEnd::BadBank, verdict.result);
        m_core.transfer.staged_crc = ctl_bank_crc(&bank);
        ctl_motion_change_program(&m_core);
        m_setUm = ctl_get32(&ctl_active_bank(&m_core)->registers[CTL_OFFSET_PROGRAM_BAG_LENGTH]);
        return true;
    }

    bool start()
    {
        m_startUs = m_controller.nowUs();
        const std::uint16_t refusal = ctl_motion_start(&m_core);
        return refusal == CTL_REFUSAL_NONE || end(PackingEnd::Refused, refusal);
    }

    void pack()
    {
        const std::uint64_t cycleUs = static_cast<std::uint64_t>(
            ctl_bank_cycle_ticks(ctl_active_bank(&m_core)) * usPerS / m_job.timerClockHz);
        std::uint64_t untilUs = m_startUs + longestStartUs + longestBagCycles * cycleUs;
        while (m_result.bags < m_job.bags) {
            m_controller.step();
            m_fullSpeed = m_fullSpeed && m_core.motion.ramp.speed == m_core.motion.ramp.full;
            if (m_controller.cut()) {
                takeCut(*m_controller.cut());
                untilUs = m_controller.nowUs() + longestBagCycles * cycleUs;
            }
            if (!goesOn(untilUs))
                return;
        }
    }

    bool goesOn(std::uint64_t untilUs)
    {
        const ctl_motion& motion = m_core.motion;
        m_result.largestFollowingErrorPulses =
            std::max(m_result.largestFollowingErrorPulses,
                     std::abs(static_cast<double>(motion.commanded - motion.actual)));
        if (motion.state == CTL_STATE_FAULT)
            return end(PackingEnd::Fault, motion.fault);
        if (m_core.packer.alarms != 0 && ctl_motion_standstill(&m_core))
            return end(PackingEnd::Alarm, m_core.packer.alarms);
        return m_controller.nowUs() < untilUs || end(PackingEnd::Alarm, m_core.packer.alarms);
    }

    void takeCut(const BagCut& cut)
    {
        const bool atSpeed = m_fullSpeed;
        m_fullSpeed = true;
        if (!cut.lengthUm)
            return;
        const ctl_packer& packer = m_core.packer;
        const std::uint16_t* record = &packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS)];
        PackedBag bag;
        bag.number = ++m_result.bags;
        bag.timeS = static_cast<double>(m_controller.nowUs() - m_startUs) / usPerS;
        bag.lengthMm = *cut.lengthUm / umPerMm;
        bag.lengths = ctl_packer_lengths_in_bag(&m_core);
        bag.deviationMm = bag.lengthMm - bag.lengths * (m_setUm / umPerMm);
        bag.markErrorMm = cut.markErrorMm;
        bag.flags = record[3];
        bag.products = cut.products;
        bag.throughProduct = cut.throughProduct;
        bag.atSpeed = atSpeed;
        m_onBag(bag);
    }

    const PackingJob& m_job;
    const std::function<void(const PackedBag&)>& m_onBag;
    NoFlash m_flash;
    SimulatedController m_controller;
    ctl_core& m_core;
    PackingResult m_result;
    std::uint64_t m_startUs = 0;
    std::uint32_t m_setUm = 0;
    bool m_fullSpeed = false;
};

} // namespace

PackingResult runPacking(const PackingJob& job, const std::function<void(const PackedBag&)>& onBag)
{
    return std::make_unique<Run>(job, onBag)->result();
}

} // namespace campanel::controller
