// SPDX-License-Identifier: Apache-2.0
// A run of the simulated packing machine without a line or a clock: a program bank, parameters, so many bags.
// The controller's core is the one that answers the panel; only the steps of time may be longer.
#pragma once

#include "machine.h"

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
    std::uint64_t stepUs = 1000;
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
    bool atSpeed = false; // made and begun at full speed
};

enum class PackingEnd : std::uint8_t {
    Done,
    BadBank,      // the controller does not take the bank: `detail` is its transfer result
    BadParameter, // nor this parameter: `detail` is its address
    Refused,      // Start was refused: `detail` is the refusal
    Alarm,        // the controller ended the run: `detail` are its warning bits
    Fault         // `detail` are the fault bits
};

struct PackingResult {
    PackingEnd end = PackingEnd::Done;
    std::uint32_t detail = 0;
    std::uint32_t bags = 0;
    double timeS = 0.0; // simulated, from the start
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

[[nodiscard]] PackingResult runPacking(const PackingJob& job,
                                       const std::function<void(const PackedBag&)>& onBag);

} // namespace campanel::controller
