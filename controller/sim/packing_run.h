// SPDX-License-Identifier: Apache-2.0
// A run of the simulated packing machine without a line or a clock: a program bank, parameters, so many bags.
// The controller's core is the one that answers the panel; only the steps of time may be longer.
#pragma once

#include "machine.h"

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
    std::span<const std::uint16_t> bank; // header and rows, of a rotary cutter
    std::vector<ParameterValue> parameters;
    MachineOptions machine;
    std::uint32_t bags = 1000;
    std::uint64_t stepUs = 0; // 0: quickStepUs()
    bool goOn = false;        // after an alarm start again, as an operator would
    // Board of the controller.
    std::uint32_t timerClockHz = 8'000'000;
    std::uint32_t maxPulseHz = 500'000;
};

struct PackedBag {
    std::uint32_t number = 0; // from 1
    double timeS = 0.0;       // since the start
    double lengthMm = 0.0;
    std::uint32_t lengths = 1; // bag lengths in it: cuts skipped + 1
    double deviationMm = 0.0;  // from that many set lengths
    double markErrorMm = 0.0;  // of its cut, truly: positive late
    std::uint16_t flags = 0;   // bits of BagBit
    int products = 0;
    bool throughProduct = false;
    bool atSpeed = false;        // made and begun at full speed
    bool isSettled = false;      // counts for a figure of accuracy: see PackingResult
    std::uint32_t start = 1;     // of the machine, from 1; more only with goOn
    std::uint16_t skipCause = 0; // SkipCause of the last cut that was skipped in it
    // From the cuts skipped in it to the nearest product, the largest distance; 0: all through one.
    double skipGapMm = 0.0;
    bool isUnexplained = false; // that is more than the controller keeps clear
};

enum class PackingEnd : std::uint8_t {
    Done,
    BadBank,      // the controller does not take the bank: `detail` is its transfer result
    BadParameter, // nor this parameter: `detail` is its address
    Refused,      // Start was refused: `detail` is the refusal
    Alarm,        // the controller ended the run: `detail` are its warning bits
    Fault,        // `detail` are the fault bits
    NoBags        // none came for hundreds of cycles
};

inline constexpr unsigned alarmBits = 16;

struct PackingResult {
    PackingEnd end = PackingEnd::Done;
    std::uint32_t detail = 0;
    std::uint32_t bags = 0;
    double timeS = 0.0; // simulated, from the first start
    std::uint32_t starts = 0;
    std::array<std::uint32_t, alarmBits> alarms{}; // runs that ended by each bit of WarningBit
    std::array<std::uint32_t, 4> skips{};          // cuts skipped, by SkipCause
    std::uint32_t skipsUnexplained = 0;            // bags with a skipped cut that was free of products
    double largestSkipGapMm = 0.0;
    // The controller's own counts.
    std::uint32_t marks = 0;
    std::uint32_t marksMissing = 0;
    std::uint32_t marksFalse = 0;
    std::uint32_t products = 0;
    std::uint32_t cutsSkipped = 0;
    std::uint32_t emptyBags = 0;
    double filmSavedM = 0.0;
    std::uint32_t correctionsLimited = 0;
    double largestFollowingErrorPulses = 0.0;
};

// Steps of time with which no bag comes out different by more than a pulse of the film motor: a 400th of a
// cycle, within limits.
[[nodiscard]] std::uint64_t quickStepUs(double cycleS);

// Settled are the bags behind the first that follow the marks from cut to cut, or with tracking off those
// made at full speed; after each start anew.
[[nodiscard]] PackingResult runPacking(const PackingJob& job,
                                       const std::function<void(const PackedBag&)>& onBag);

} // namespace campanel::controller
