// SPDX-License-Identifier: Apache-2.0
// The group `master_status` as a value: the encoder that leads the line. Read in one proven exchange.
#pragma once

#include "modbus/map/protocol.h"

#include <cstdint>
#include <optional>
#include <span>

namespace campanel::modbus {

inline constexpr std::uint16_t masterStatusAddress = 0x0B20;
inline constexpr std::uint16_t masterStatusRegisters = 21;
// The first version of the map with this group.
inline constexpr std::uint16_t masterMapMinor = 6;

struct MasterStatus {
    bool isAvailable = false;         // the controller has an input for an encoder
    std::optional<MasterState> state; // empty: not known to this version
    std::int32_t counts = 0;          // since power-up
    double speedMmPerS = 0.0;
    double angleDeg = 0.0;
    double errorMm = 0.0;     // last counts minus expected position
    double leadMm = 0.0;      // by which the axes are led
    double heldMm = 0.0;      // by which the master stands behind the line
    double toEngagedMm = 0.0; // until the line has engaged
    double smoothingMs = 0.0; // time constant in use
    double phaseDeg = 0.0;
    double ripplePercent = 0.0;
    int inputErrors = 0; // since power-up
    double indexErrorCounts = 0.0;
    double slipMm = 0.0;
    double lagMm = 0.0; // film beyond the last cut when the knife came to it
    double passedM = 0.0;

    bool operator==(const MasterStatus&) const = default;
};

// Decodes masterStatusRegisters registers from masterStatusAddress on.
[[nodiscard]] MasterStatus decodeMasterStatus(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
