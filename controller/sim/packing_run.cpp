// SPDX-License-Identifier: Apache-2.0
#include "packing_run.h"

#include "bank/ctl_check.h"
#include "base/ctl_words.h"
#include "link/ctl_map.h"
#include "motion/ctl_start.h"
#include "simulated_controller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

namespace campanel::controller {
namespace {

constexpr double usPerS = 1e6;
constexpr double stillMmPerS = 0.015; // of the film
// The maximum times of homing and ramp before the first bag, and of a bag.
constexpr std::uint64_t longestStartUs = 120'000'000;
constexpr unsigned longestBagCycles = 400;
constexpr std::uint64_t shaftStopUs = 4'000'000; // with its ramp
// The time steps.
constexpr double stepsPerCycle = 400.0;
constexpr double shortestStepUs = 100.0;
constexpr double longestStepUs = 2500.0;
// The number of alarms without a bag after which the machine is not restarted.
constexpr std::uint32_t maxStartsPerBag = 20;
// The maximum errors of the eye, the product's slip on the film and the film's own slip.
constexpr double sensorMm = 2.5;
constexpr double aligningShare = 0.1; // share of the bag length by which a cut may be shifted while aligning

// A flash without persistent data.
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

// Returns the cycle time of the bank, which need not be valid.
double cycleS(const PackingJob& job)
{
    return job.bank.size() < CTL_BANK_HEADER_REGISTERS
               ? 0.0
               : static_cast<double>(ctl_get32(&job.bank[CTL_OFFSET_BANK_CYCLE_TICKS])) / job.timerClockHz;
}

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

// An encoder is read, and jaws press on something, in the steps of a real controller.
std::uint64_t stepUsOf(const PackingJob& job)
{
    if (job.stepUs != 0)
        return job.stepUs;
    const std::uint64_t quick = quickStepUs(cycleS(job));
    const bool isQuick = job.machine.shaft.counts == 0 && Jaws(job.machine.jaws, 0).areIdle();
    return isQuick ? quick : std::min<std::uint64_t>(quick, CTL_SLICE_US);
}

class Run {
public:
    Run(const PackingJob& job, const std::function<void(const PackedBag&)>& onBag)
        : m_job(job)
        , m_onBag(onBag)
        , m_controller(configOf(job), job.machine, m_flash, stepUsOf(job))
        , m_core(m_controller.core())
    {
    }

    PackingResult result()
    {
        m_startUs = m_controller.nowUs();
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
        m_result.correctionsLimited = packer.phase.limited;
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
        if (!write(m_job.parameters))
            return false;
        if (!download(m_job.bank))
            return false;
        ctl_motion_change_program(&m_core.motion);
        m_setMm = ctl_bank_bag_um(ctl_active_bank(&m_core.banks)) / umPerMm;
        m_longestBagUs = static_cast<std::uint64_t>(longestBagCycles * cycleS(m_job) * usPerS);
        return true;
    }

    bool write(const std::vector<ParameterValue>& parameters)
    {
        for (const ParameterValue& parameter : parameters) {
            if (ctl_map_write(&m_core, parameter.address, parameter.registers.data(),
                              static_cast<std::uint32_t>(parameter.registers.size())) != 0)
                return end(PackingEnd::BadParameter, parameter.address);
        }
        return true;
    }

    bool showMarks()
    {
        if (!m_job.onMarks || m_core.packer.edges.number == m_marksShown)
            return true;
        m_marksShown = m_core.packer.edges.number;
        std::array<std::uint16_t, CTL_GROUP_SENSOR> registers{};
        ctl_edges_registers(&m_core.packer.edges, registers.data());
        return write(m_job.onMarks(registers));
    }

    void showEye()
    {
        const ctl_eye_edges& edges = m_core.packer.eye_edges;
        if (!m_job.onEye || std::exchange(m_eyeShown, edges.number) == edges.number)
            return;
        std::array<std::uint16_t, CTL_GROUP_EYE> registers{};
        ctl_eye_edges_registers(&edges, registers.data());
        m_job.onEye(registers);
    }

    // Fills the shadow bank and seals it.
    bool download(std::span<const std::uint16_t> registers)
    {
        ctl_bank& bank = *ctl_staged_bank(&m_core.banks);
        if (registers.size() > std::size(bank.registers))
            return end(PackingEnd::BadBank, CTL_TRANSFER_RESULT_BAD_LENGTH);
        std::ranges::copy(registers, bank.registers);
        const ctl_verdict verdict =
            ctl_bank_check(&bank, &m_core.board.config, static_cast<std::uint32_t>(registers.size()));
        if (verdict.result != CTL_TRANSFER_RESULT_ACCEPTED)
            return end(PackingEnd::BadBank, verdict.result);
        m_core.transfer.session = 1;
        m_core.transfer.staged_crc = ctl_bank_crc(&bank);
        m_core.transfer.state = CTL_STAGED_STATE_SEALED;
        return true;
    }

    // Downloads the program that does not run, and applies it at the next cycle, as the panel does. A
    // stopping machine keeps the one that it has.
    bool changeProgram()
    {
        if (m_job.changeEvery == 0 || m_result.bags % m_job.changeEvery != 0 ||
            m_core.motion.state != CTL_STATE_RUNNING)
            return true;
        if (m_core.transfer.state == CTL_STAGED_STATE_ARMED) // not taken over yet
            return true;
        m_runsOther = !m_runsOther;
        if (!download(m_runsOther ? m_job.otherBank : m_job.bank))
            return false;
        const std::uint32_t crc = m_core.transfer.staged_crc;
        const std::array<std::uint16_t, 6> command{static_cast<std::uint16_t>(++m_commands),
                                                   CTL_COMMAND_APPLY_STAGED,
                                                   CTL_APPLY_MODE_NEXT_CYCLE,
                                                   m_core.transfer.session,
                                                   static_cast<std::uint16_t>(crc >> 16u),
                                                   static_cast<std::uint16_t>(crc & 0xFFFFu)};
        ctl_map_write(&m_core, CTL_REG_COMMAND_COUNTER, command.data(),
                      static_cast<std::uint32_t>(command.size()));
        const std::uint16_t* result = m_core.command_result;
        return result[2] == CTL_COMMAND_STATUS_DONE || end(PackingEnd::Refused, result[3]);
    }

    bool start()
    {
        const std::uint16_t refusal = ctl_start(&m_core.motion, &m_core.io);
        if (refusal != CTL_REFUSAL_NONE)
            return end(PackingEnd::Refused, refusal);
        m_untilUs = m_controller.nowUs() + longestStartUs + m_longestBagUs;
        m_isSettled = false;
        m_beforeFits = false;
        m_fullSpeed = false;
        m_result.starts += 1;
        return true;
    }

    void pack()
    {
        while (m_result.bags < m_job.bags) {
            m_controller.step();
            m_result.lag.take(m_core, m_controller.machine(), m_job.machine);
            stopShaft();
            if (!operate() || !cutPower())
                return;
            m_result.jams.take(m_core, m_controller.machine(), m_controller.stepUs());
            m_fullSpeed = m_fullSpeed && isAtSpeed();
            noticeSkip();
            if (m_controller.cut()) {
                const std::uint32_t bagsBefore = m_result.bags;
                takeCut(*m_controller.cut());
                m_untilUs = m_controller.nowUs() + m_longestBagUs;
                if (m_result.bags != bagsBefore && !changeProgram())
                    return;
            }
            showEye();
            if (!showMarks() || !goesOn())
                return;
        }
    }

    bool isAtSpeed() const
    {
        const ctl_motion& motion = m_core.motion;
        const bool isEngaged = motion.master->clutch.state == CTL_CLUTCH_ON && m_shaftRuns;
        return motion.master->leads ? isEngaged : motion.ramp.speed == motion.ramp.full;
    }

    // Somebody stops the line in the middle of a bag and starts it again some seconds later.
    void stopShaft()
    {
        if (m_job.shaftStopEvery == 0)
            return;
        LineShaft& shaft = m_controller.machine().shaft();
        if (m_shaftRuns && m_result.bags / m_job.shaftStopEvery > m_result.shaftStops) {
            ++m_result.shaftStops;
            std::uniform_real_distribution<double> waitS(0.0, cycleS(m_job));
            m_shaftStopAtUs = m_controller.nowUs() + static_cast<std::uint64_t>(waitS(m_random) * usPerS);
            m_shaftRuns = false;
        }
        if (m_shaftRuns || m_controller.nowUs() < m_shaftStopAtUs)
            return;
        const bool starts = m_controller.nowUs() >= m_shaftStopAtUs + shaftStopUs;
        shaft.setSpeed(starts ? m_job.machine.shaft.speedMmPerS : 0.0);
        m_shaftRuns = starts;
        m_untilUs = m_controller.nowUs() + longestStartUs + m_longestBagUs;
    }

    // The power is cut anywhere in a cycle. The program is downloaded again: this machine has no flash.
    bool cutPower()
    {
        if (m_job.powerCutShare <= 0.0 || m_core.motion.state != CTL_STATE_RUNNING)
            return true;
        if (m_powerCutAtUs == 0)
            m_powerCutAtUs = randomTime(m_job.powerCutShare);
        if (m_controller.nowUs() < m_powerCutAtUs)
            return true;
        m_powerCutAtUs = 0;
        ++m_result.powerCuts;
        std::uniform_real_distribution<double> part(0.0, 1.0);
        Machine::ByHand byHand;
        if (m_result.powerCuts % 2 == 0)
            byHand = {part(m_random), m_setMm * part(m_random), part(m_random)};
        m_controller.machine().standStill(byHand);
        m_controller.restart();
        m_commands = 0;
        m_marksShown = 0;
        m_skipped = 0;
        m_powerUpMm = m_controller.machine().drawnMm();
        m_hasGoodCut = false;
        return setUp() && start();
    }

    std::uint64_t randomTime(double share)
    {
        std::geometric_distribution<std::uint32_t> bags(share);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        return m_controller.nowUs() +
               static_cast<std::uint64_t>((bags(m_random) + part(m_random)) * cycleS(m_job) * usPerS);
    }

    void takeFirstCuts(const BagCut& cut)
    {
        if (m_job.powerCutShare <= 0.0 || m_hasGoodCut || !m_core.packer.last_cut.tracked ||
            std::abs(cut.markErrorMm) > offMm || !cut.lengthUm)
            return;
        m_hasGoodCut = true;
        const double filmMm = cut.drawnMm - m_powerUpMm;
        ++m_goodStarts;
        m_result.meanFilmToGoodMm += (filmMm - m_result.meanFilmToGoodMm) / m_goodStarts;
        m_result.longestFilmToGoodMm = std::max(m_result.longestFilmToGoodMm, filmMm);
    }

    // An operator stops the machine anywhere in a cycle and starts it again some seconds later.
    bool operate()
    {
        const std::uint64_t now = m_controller.nowUs();
        watchJaws();
        if (m_job.stopShare <= 0.0)
            return true;
        if (m_stopAtUs == 0 && m_core.motion.state == CTL_STATE_RUNNING)
            m_stopAtUs = randomTime(m_job.stopShare);
        if (m_stopAtUs != 0 && m_startAtUs == 0 && now >= m_stopAtUs) {
            std::uniform_real_distribution<double> pause(1.0, 5.0);
            ++m_result.stops;
            (void)ctl_motion_stop_now(&m_core.motion);
            m_startAtUs = now + static_cast<std::uint64_t>(pause(m_random) * usPerS);
        }
        if (m_startAtUs == 0 || now < m_startAtUs || !ctl_motion_standstill(&m_core.motion) ||
            m_core.motion.state == CTL_STATE_FAULT)
            return true;
        m_stopAtUs = 0;
        m_startAtUs = 0;
        return start();
    }

    void watchJaws()
    {
        const Machine& machine = m_controller.machine();
        const bool stands = machine.areDrivesOn() && std::abs(machine.filmMmPerS()) < stillMmPerS;
        if (!stands || !machine.areJawsClosed()) {
            m_closedUs = 0;
            return;
        }
        const double beforeS = static_cast<double>(m_closedUs) / usPerS;
        m_closedUs += m_controller.stepUs();
        const double closedS = static_cast<double>(m_closedUs) / usPerS;
        m_result.burns += beforeS <= burnS && closedS > burnS ? 1u : 0u;
        m_result.longestClosedS = std::max(m_result.longestClosedS, closedS);
    }

    // An operator takes out what lies there.
    bool takeJam()
    {
        m_controller.machine().jaws().clear();
        const bool still = ctl_motion_reset_fault(&m_core.motion) != CTL_REFUSAL_NONE;
        return still ? m_controller.nowUs() < m_untilUs || end(PackingEnd::Fault, m_core.motion.fault)
                     : start();
    }

    bool goesOn()
    {
        const ctl_motion& motion = m_core.motion;
        m_result.maxFollowingErrorPulses =
            std::max(m_result.maxFollowingErrorPulses,
                     std::abs(static_cast<double>(motion.commanded - motion.actual)));
        if (motion.fault == 1u << CTL_FAULT_BIT_JAM && m_job.goOn)
            return takeJam();
        if (motion.state == CTL_STATE_FAULT)
            return end(PackingEnd::Fault, motion.fault);
        const unsigned tooFast = m_core.master.too_fast ? 1u << CTL_WARNING_BIT_MASTER_TOO_FAST : 0u;
        const auto alarms = static_cast<std::uint16_t>(m_core.packer.alarms | tooFast);
        if (alarms != 0 && ctl_motion_standstill(&m_core.motion))
            return takeAlarm(alarms);
        return m_controller.nowUs() < m_untilUs || end(PackingEnd::NoBags, 0);
    }

    bool takeAlarm(std::uint16_t bits)
    {
        for (unsigned bit = 0; bit < alarmBits; ++bit)
            m_result.alarms[bit] += static_cast<unsigned>(bits) >> bit & 1u;
        m_startsWithoutBag = m_result.bags == m_bagsAtAlarm ? m_startsWithoutBag + 1 : 0;
        m_bagsAtAlarm = m_result.bags;
        if (!m_job.goOn || m_startsWithoutBag > maxStartsPerBag)
            return end(PackingEnd::Alarm, bits);
        return start();
    }

    void noticeSkip()
    {
        const ctl_packer& packer = m_core.packer;
        if (packer.skipped == m_skipped)
            return;
        m_result.skips[packer.last_skip] += packer.skipped - m_skipped;
        m_skipped = packer.skipped;
        m_skipCause = packer.last_skip;
        if (packer.marks.state == CTL_MARK_STATE_ALIGNING)
            m_skippedAligning = true;
    }

    void takeCut(const BagCut& cut)
    {
        takeFirstCuts(cut);
        const bool atSpeed = m_fullSpeed;
        m_fullSpeed = true;
        if (cut.lengthUm)
            takeBag(cut, atSpeed);
        m_drawnBeforeMm = cut.drawnMm;
        m_skipCause = CTL_SKIP_CAUSE_NONE;
        m_skippedAligning = false;
    }

    void takeBag(const BagCut& cut, bool atSpeed)
    {
        const ctl_packer& packer = m_core.packer;
        const std::uint16_t* record = &packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS)];
        PackedBag bag;
        bag.number = ++m_result.bags;
        bag.timeS = static_cast<double>(m_controller.nowUs() - m_startUs) / usPerS;
        bag.lengthMm = *cut.lengthUm / umPerMm;
        bag.lengths = packer.last_cut.bags;
        bag.deviationMm = bag.lengthMm - bag.lengths * m_setMm;
        bag.markErrorMm = cut.markErrorMm;
        bag.flags = record[3];
        bag.products = static_cast<int>(cut.products.size());
        bag.throughProduct = cut.throughProduct;
        bag.atSpeed = atSpeed;
        bag.start = m_result.starts;
        settle(bag);
        const bool isStartUp = (bag.flags & 1u << CTL_BAG_BIT_START_UP) != 0;
        bag.isSettled = m_isSettled && (m_job.shaftStopEvery == 0 || !isStartUp);
        explainSkips(bag, cut);
        m_result.startUpBags += isStartUp ? 1u : 0u;
        const double farthestMm = std::max(std::abs(bag.markErrorMm), std::abs(bag.deviationMm));
        if (farthestMm > offMm && !isStartUp && bag.lengths == 1)
            m_result.offUnmarked += 1;
        m_onBag(bag);
    }

    void settle(const PackedBag& bag)
    {
        const bool tracks = ctl_packer_tracks(&m_core.packer);
        const bool fits = bag.atSpeed && (!tracks || (bag.flags & 1u << CTL_BAG_BIT_TRACKED) != 0);
        m_isSettled = m_isSettled || (fits && m_beforeFits);
        m_beforeFits = fits;
    }

    // Explains skipped cuts, which would have divided the bag evenly.
    void explainSkips(PackedBag& bag, const BagCut& cut)
    {
        bag.skipCause = m_skipCause;
        for (std::uint32_t i = 1; i < bag.lengths; ++i) {
            const double skippedMm = m_drawnBeforeMm + (cut.drawnMm - m_drawnBeforeMm) * i / bag.lengths;
            double gapMm = m_setMm;
            for (const Infeed::Laid& product : cut.products)
                gapMm =
                    std::min(gapMm, std::max({0.0, product.leadMm - skippedMm, skippedMm - product.trailMm}));
            bag.skipGapMm = std::max(bag.skipGapMm, gapMm);
        }
        bag.isUnexplained = bag.skipGapMm > keptClearMm();
        m_result.skipsUnexplained += bag.isUnexplained ? 1u : 0u;
        m_result.maxSkipGapMm = std::max(m_result.maxSkipGapMm, bag.skipGapMm);
    }

    // Returns the clearance, plus the remaining correction and undetectable errors.
    double keptClearMm() const
    {
        const double clearance = ctl_parameter16(&m_core.board, CTL_REG_PARAMETER_CUT_CLEARANCE) / umPerMm;
        const double phase = ctl_parameter16(&m_core.board, CTL_REG_PARAMETER_PHASE_LIMIT) / umPerMm;
        const double length = m_setMm * static_cast<double>(ctl_packer_length_limit(&m_core.packer)) /
                              static_cast<double>(m_core.packer.bag);
        return clearance + sensorMm + (m_skippedAligning ? m_setMm * aligningShare : length + phase);
    }

    const PackingJob& m_job;
    const std::function<void(const PackedBag&)>& m_onBag;
    NoFlash m_flash;
    SimulatedController m_controller;
    ctl_core& m_core;
    PackingResult m_result;
    std::uint64_t m_startUs = 0;
    std::uint64_t m_untilUs = 0; // time limit of the next bag
    std::uint64_t m_longestBagUs = 0;
    double m_setMm = 0.0;
    double m_drawnBeforeMm = 0.0; // at the previous cut
    bool m_fullSpeed = false;     // since the previous cut
    bool m_isSettled = false;
    bool m_beforeFits = false;
    std::uint32_t m_skipped = 0;
    std::uint16_t m_skipCause = CTL_SKIP_CAUSE_NONE; // of the last skipped cut since then
    bool m_skippedAligning = false;
    std::uint32_t m_bagsAtAlarm = 0;
    bool m_runsOther = false;
    bool m_shaftRuns = true;
    std::uint64_t m_shaftStopAtUs = 0;
    std::mt19937_64 m_random{m_job.machine.seed};
    std::uint64_t m_powerCutAtUs = 0;
    double m_powerUpMm = 0.0; // film drawn then
    bool m_hasGoodCut = false;
    std::uint32_t m_goodStarts = 0;
    std::uint64_t m_stopAtUs = 0;
    std::uint64_t m_startAtUs = 0;
    std::uint64_t m_closedUs = 0; // the jaws on standing film
    std::uint32_t m_marksShown = 0;
    std::uint32_t m_eyeShown = 0;
    std::uint32_t m_commands = 0;
    std::uint32_t m_startsWithoutBag = 0;
};

} // namespace

std::uint64_t quickStepUs(double cycleS)
{
    return static_cast<std::uint64_t>(
        std::clamp(cycleS * usPerS / stepsPerCycle, shortestStepUs, longestStepUs));
}

PackingResult runPacking(const PackingJob& job, const std::function<void(const PackedBag&)>& onBag)
{
    return std::make_unique<Run>(job, onBag)->result();
}

} // namespace campanel::controller
