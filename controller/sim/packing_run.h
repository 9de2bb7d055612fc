// SPDX-License-Identifier: Apache-2.0
// A run of the simulated packing machine without a line or a clock: a program bank, parameters, a number of
// bags. The core is that of the controller on the line; only the time steps may be longer.
#pragma once

#include "jam_figures.h"
#include "machine.h"
#include "master_lag.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace campanel::controller {

struct ParameterValue {
    std::uint32_t address = 0;
    std::vector<std::uint16_t> registers;
};

struct PackingJob {
    std::span<const std::uint16_t> bank; // header and rows of a rotary cutter
    // A second program of the same bags, downloaded while the machine runs: after so many bags the other one
    // takes over. 0: never.
    std::span<const std::uint16_t> otherBank;
    std::uint32_t changeEvery = 0;
    std::vector<ParameterValue> parameters;
    MachineOptions machine;
    std::uint32_t bags = 1000;
    std::uint64_t stepUs = 0; // 0: quickStepUs()
    bool goOn = false;        // restart after an alarm, like an operator
    double powerCutShare =
        0.0; // of the bags in which the power is cut; in half of them axes and film are moved by hand
    std::uint32_t shaftStopEvery = 0; // bags: the shaft of the line stops in the middle of one; 0: never
    double stopShare = 0.0; // of the bags in which an operator stops the machine at once, to start it later
    // Called with the group `sensor` when it has new marks; the parameters that it returns are written.
    std::function<std::vector<ParameterValue>(std::span<const std::uint16_t> registers)> onMarks;
    // Called with the group `eye` when it has new edges.
    std::function<void(std::span<const std::uint16_t> registers)> onEye;
    // The board of the controller.
    std::uint32_t timerClockHz = 8'000'000;
    std::uint32_t maxPulseHz = 500'000;
};

struct PackedBag {
    std::uint32_t number = 0; // from 1
    double timeS = 0.0;       // since the start
    double lengthMm = 0.0;
    std::uint32_t lengths = 1; // bag lengths in it: cuts skipped + 1
    double deviationMm = 0.0;  // from `lengths` set lengths
    double markErrorMm = 0.0;  // true error of its cut; positive: late
    std::uint16_t flags = 0;   // bits of BagBit
    int products = 0;
    bool throughProduct = false;
    bool atSpeed = false;        // begun and completed at full speed
    bool isSettled = false;      // counts for a figure of accuracy: see PackingResult
    std::uint32_t start = 1;     // start of the machine, from 1; more only with goOn
    std::uint16_t skipCause = 0; // SkipCause of its last skipped cut
    // The largest distance from its skipped cuts to the nearest product; 0: all through a product.
    double skipGapMm = 0.0;
    bool isUnexplained = false; // larger than the controller's clearance
};

enum class PackingEnd : std::uint8_t {
    Done,
    BadBank,      // the controller refuses the bank: `detail` is its transfer result
    BadParameter, // the controller refuses this parameter: `detail` is its address
    Refused,      // Start or a change of program was refused: `detail` is the refusal
    Alarm,        // the controller ended the run: `detail` are its warning bits
    Fault,        // `detail` are the fault bits
    NoBags        // none for hundreds of cycles
};

inline constexpr unsigned alarmBits = 16;

struct PackingResult {
    PackingEnd end = PackingEnd::Done;
    std::uint32_t detail = 0;
    std::uint32_t bags = 0;
    double timeS = 0.0; // simulated, from the first start
    std::uint32_t starts = 0;
    std::array<std::uint32_t, alarmBits> alarms{}; // runs ended by each bit of WarningBit
    std::array<std::uint32_t, 4> skips{};          // skipped cuts, by SkipCause
    std::uint32_t skipsUnexplained = 0;            // bags with a skipped cut that was free of products
    double maxSkipGapMm = 0.0;
    // The controller's own counters.
    std::uint32_t marks = 0;
    std::uint32_t marksMissing = 0;
    std::uint32_t marksFalse = 0;
    std::uint32_t products = 0;
    std::uint32_t cutsSkipped = 0;
    std::uint32_t emptyBags = 0;
    double filmSavedM = 0.0;
    std::uint32_t correctionsLimited = 0;
    double maxFollowingErrorPulses = 0.0;
    std::uint32_t stops = 0;
    // Stops that left the jaws closed on standing film for more than burnS, with the drives enabled.
    std::uint32_t burns = 0;
    double longestClosedS = 0.0;
    JamFigures jams;
    std::uint32_t powerCuts = 0;
    std::uint32_t offUnmarked =
        0; // bags of one length, in length or from the print by more than offMm, not marked
    std::uint32_t startUpBags = 0;
    MasterLag lag;
    std::uint32_t shaftStops = 0;
    // The film from a power-up to the end of the first bag whose cut follows a mark and is nearer.
    double meanFilmToGoodMm = 0.0;
    double longestFilmToGoodMm = 0.0;
};

inline constexpr double offMm = 0.5;

inline constexpr double burnS = 1.0;

// Returns the time step with which no bag differs by more than a pulse of the film motor: a 400th of a cycle,
// within limits.
[[nodiscard]] std::uint64_t quickStepUs(double cycleS);

// Runs the job and calls `onBag` for each bag. Settled bags follow the first one that follows the marks from
// cut to cut, or without tracking those at full speed; each start begins again.
[[nodiscard]] PackingResult runPacking(const PackingJob& job,
                                       const std::function<void(const PackedBag&)>& onBag);

} // namespace campanel::controller
