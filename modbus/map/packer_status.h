// SPDX-License-Identifier: Apache-2.0
// The group `packer` as a value: marks, products, cuts and bags of a packing machine. One proven reading.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace campanel::modbus {

inline constexpr std::uint16_t packerAddress = 0x0140;
inline constexpr std::uint16_t packerRegisters = 104;

struct BagRecord {
    std::uint32_t number = 0;      // counted since power-up
    double deviationMm = 0.0;      // of its length from `lengths` set lengths, saturating at 32.767
    double markErrorMm = 0.0;      // of its cut
    double pitchDeviationMm = 0.0; // from its mark to the one before, minus as many bag lengths
    int lengths = 1;               // bag lengths in it: cuts skipped + 1
    bool isTracked = false;        // its cut followed a mark
    bool isMarkMissed = false;     // which was not seen but reckoned
    bool isProductAcross = false;  // longer because a product lay across
    bool isEmpty = false;

    bool operator==(const BagRecord&) const = default;
};

// Something on the film by its distance to the knife, mm; negative: past it.
struct FilmMark {
    double distanceMm = 0.0;
    bool isReckoned = false; // the sensor did not see it
};

struct FilmCut {
    double distanceMm = 0.0;
    bool isLeftOut = false; // a product lies there
};

struct FilmProduct {
    double leadMm = 0.0;
    double trailMm = 0.0;
};

struct PackerStatus {
    std::optional<MarkState> markState; // empty: one that this version does not know
    double markErrorMm = 0.0;
    double markPitchMm = 0.0;
    double phaseCorrectionMm = 0.0;
    double lengthCorrectionMm = 0.0;
    double lastMarkMm = 0.0;
    double filmFollowingErrorMm = 0.0;
    std::uint32_t marks = 0;
    std::uint32_t marksMissing = 0;
    std::uint32_t marksFalse = 0;
    std::uint32_t products = 0;
    std::uint32_t cutsSkipped = 0;
    std::uint32_t emptyBags = 0;
    double filmSavedM = 0.0;
    SkipCause lastSkip = SkipCause::None;
    std::uint16_t skipsInARow = 0;
    std::uint32_t correctionsLimited = 0;
    double filmAngleDeg = 0.0;
    GateState knifeGate = GateState::Running;
    GateState filmGate = GateState::Running;
    int teachMarks = 0;
    std::optional<double> teachPitchMm;   // empty below two marks
    std::optional<double> teachScatterMm; // empty below three
    int marksWaiting = 0;
    std::uint32_t bagNumber = 0;
    std::vector<BagRecord> bags;      // the newest, oldest first; at most bagRecords
    std::uint32_t filmPositionUm = 0; // lower 32 bits
    std::vector<FilmCut> cuts;        // from the knife on
    std::vector<FilmMark> seenMarks;
    std::vector<FilmProduct> seenProducts;
};

// Takes packerRegisters registers from packerAddress on.
[[nodiscard]] PackerStatus decodePacker(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
