// SPDX-License-Identifier: Apache-2.0
// The group `packer` as a value: marks, products, cuts and bags of a packing machine. Read in one proven
// exchange.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace campanel::modbus {

inline constexpr std::uint16_t packerAddress = 0x0140;
// Returns the size of the group in a controller of this minor version of the map.
[[nodiscard]] std::uint16_t packerRegisters(std::uint16_t minor = mapMinor);

struct BagRecord {
    std::uint32_t number = 0; // counted since power-up
    double deviationMm = 0.0; // length minus `lengths` set lengths, saturating at 32.767
    double markErrorMm = 0.0;
    double pitchDeviationMm = 0.0; // distance between its mark and the previous one, minus that many bag
                                   // lengths
    int lengths = 1;               // bag lengths in it: skipped cuts + 1
    bool isTracked = false;        // its cut followed a mark
    bool isMarkMissed = false;     // the mark was not detected but calculated
    bool isProductAcross = false;  // longer because of a product at the cut
    bool isEmpty = false;
    bool isChangeOver = false; // begun under one program, cut under another
    bool isStartUp = false;    // start-up scrap: made before the film was in register
    bool isBurned = false;     // the jaws stood closed at one of its ends
    bool isJammed = false;     // the jaws were stopped by a jam at one of its ends
    bool isTaken = false;      // a person wanted it

    // Rejected by the machine.
    [[nodiscard]] bool isScrap() const
    {
        return isStartUp || isChangeOver || isBurned || isJammed || isTaken;
    }

    bool operator==(const BagRecord&) const = default;
};

// An object on the film by its distance to the knife, mm; negative: past it.
struct FilmMark {
    double distanceMm = 0.0;
    bool isReckoned = false; // not detected by the sensor
};

struct FilmCut {
    double distanceMm = 0.0;
    bool isSkipped = false; // skipped because of a product
};

struct FilmProduct {
    double leadMm = 0.0;
    double trailMm = 0.0;
};

struct PackerStatus {
    std::optional<MarkState> markState; // empty: not supported by this version
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
    bool isThreading = false;         // the film is threaded up, the knife is open
    std::optional<int> knife;         // that cut the newest one, from 1; empty before map 1.6
    std::uint32_t filmPositionUm = 0; // lower 32 bits
    std::vector<FilmCut> cuts;        // starting at the knife
    std::vector<FilmMark> seenMarks;
    std::vector<FilmProduct> seenProducts;
};

// Decodes the group from packerAddress on, as long as the controller has it.
[[nodiscard]] PackerStatus decodePacker(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
