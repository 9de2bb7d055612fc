// SPDX-License-Identifier: Apache-2.0
// The register blocks of the contract as values: identity, status, command and transfer results. Values
// unknown to the controller are empty optionals, never zero.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace campanel::modbus {

inline constexpr std::uint16_t identityAddress = 0x0000;
inline constexpr std::uint16_t identityRegisters = 19;
inline constexpr std::uint16_t statusAddress = 0x0100;
inline constexpr std::uint16_t commandResultRegisters = 4;
inline constexpr std::uint16_t transferResultRegisters = 8;

struct Identity {
    std::uint16_t deviceType = 0;
    std::uint16_t mapMajor = 0;
    std::uint16_t mapMinor = 0;
    std::uint16_t firmwareMajor = 0;
    std::uint16_t firmwareMinor = 0;
    std::uint16_t firmwarePatch = 0;
    std::uint64_t uniqueId = 0;
    std::uint16_t programKinds = 0; // bit n: program kind n
    std::uint16_t rowCapacity = 0;
    std::uint16_t bankRegisters = 0;
    std::uint16_t blockRegisters = 0;
    std::uint32_t timerClockHz = 0;
    std::uint16_t timerBits = 0;
    std::uint32_t maxPulseFrequencyHz = 0;
    // Bit n: table layout n; read apart, because no controller before map 1.4 has it. 0: all.
    std::uint16_t tableLayouts = 0;

    [[nodiscard]] std::string firmwareVersion() const;
    [[nodiscard]] bool supports(ProgramKind kind) const;
    [[nodiscard]] bool supports(TableLayout layout) const;
    // Returns true when the controller's map has the register with this name of the table.
    [[nodiscard]] bool hasRegister(std::string_view name) const;

    bool operator==(const Identity&) const = default;
};

// The first register of the identity with an impossible value, such as a clock of 0 Hz. Empty when all are
// possible.
struct ImpossibleValue {
    std::string_view name;
    std::uint32_t value = 0;
};
[[nodiscard]] std::optional<ImpossibleValue> impossibleValue(const Identity& identity);

// The stroke figures of a press; the last one remains until the next has ended.
struct PressStatus {
    std::optional<PressStage> stage; // empty: not supported by this version
    std::uint16_t forceN = 0;        // present force, saturating
    std::int16_t stopErrorPulses = 0;
    std::uint16_t stopForceN = 0;
    StrokeResult result = StrokeResult::None;
    std::uint16_t peakForceN = 0;

    bool operator==(const PressStatus&) const = default;
};

struct StatusBlock {
    std::uint16_t tag = 0;
    std::uint16_t heartbeat = 0;
    std::optional<State> state; // empty: not supported by this version
    std::uint16_t faultBits = 0;
    std::uint16_t warningBits = 0;
    ProgramKind programKind = ProgramKind::None;
    std::optional<StagedState> stagedState;
    std::uint32_t generation = 0;
    std::optional<std::uint32_t> activeCrc; // empty: no active program
    std::optional<std::uint32_t> savedCrc;  // empty: nothing saved
    std::uint32_t cycleCount = 0;
    std::optional<double> masterAngleDeg; // empty: no active program
    double masterSpeedPercent = 0.0;
    std::int32_t commandedFrequencyHz = 0;
    std::int32_t actualFrequencyHz = 0;
    std::int32_t commandedPositionPulses = 0;
    std::int32_t axisPositionPulses = 0;
    std::int16_t followingErrorPulses = 0;
    // The figures of a rotary cutter.
    std::optional<double> knifeAngleDeg;  // empty: not homed
    std::optional<double> bagLengthMm;    // empty: no bag measured yet
    std::optional<double> bagDeviationMm; // empty: no bag measured yet
    std::uint32_t bagCount = 0;
    std::optional<PressStatus> press; // only for a press
    std::uint32_t uptimeS = 0;
    std::uint16_t commandCounter = 0;
    std::uint16_t linkCrcErrors = 0;
    std::uint16_t linkFrameErrors = 0;
    std::uint16_t linkExceptions = 0;
    std::uint16_t linkRequests = 0;
    std::uint16_t sampleTimeMs = 0; // wrapping

    [[nodiscard]] bool has(FaultBit bit) const;
    [[nodiscard]] bool has(WarningBit bit) const;
};

struct CommandResult {
    std::uint16_t counter = 0;
    Command code = Command::None;
    CommandStatus status = CommandStatus::None;
    Refusal reason = Refusal::None;

    [[nodiscard]] bool done() const { return status == CommandStatus::Done; }
};

struct TransferAnswer {
    std::uint16_t session = 0;
    TransferOperation operation = TransferOperation::None;
    std::uint16_t block = 0;
    TransferResult result = TransferResult::None;
    std::uint16_t detail = 0;
    std::uint16_t nextMissing = 0;
    std::uint32_t stagedCrc = 0;

    [[nodiscard]] bool accepted() const { return result == TransferResult::Accepted; }
};

// Decode exactly the registers of a block, from its first address; of the identity all but the table layouts.
[[nodiscard]] Identity decodeIdentity(std::span<const std::uint16_t> registers);
[[nodiscard]] StatusBlock decodeStatus(std::span<const std::uint16_t> registers);
[[nodiscard]] CommandResult decodeCommandResult(std::span<const std::uint16_t> registers);
[[nodiscard]] TransferAnswer decodeTransferAnswer(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
