// SPDX-License-Identifier: Apache-2.0
// The words of the contract between panel and controller: states, commands, refusals, fault bits.
// The controller's C header and the register document are generated from the tables at the end of this file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace campanel::modbus {

// Value of identity.device_type by which a CamPanel controller is recognised ("CA" for cam, 0x3D).
inline constexpr std::uint16_t deviceType = 0xCA3D;
// A panel refuses a controller whose major version differs; a higher minor version only adds registers.
inline constexpr std::uint16_t mapMajor = 1;
inline constexpr std::uint16_t mapMinor = 0;
inline constexpr std::uint16_t bankLayout = 1;

enum class State : std::uint16_t { Idle = 0, Ready, Running, Stopping, Jogging, Homing, Fault };

enum class ProgramKind : std::uint16_t { None = 0, RotaryCutter = 1 };

enum class StagedState : std::uint16_t { Empty = 0, Receiving, Sealed, Armed };

enum class Command : std::uint16_t {
    None = 0,
    Start,
    StopAtCycleEnd,
    StopNow,
    Home,
    ResetFault,
    ApplyStaged,
    CancelApply,
    DiscardStaged,
    SaveToFlash,
    SetClock,
};

enum class ApplyMode : std::uint16_t { WhenStopped = 0, NextCycle = 1 };

enum class CommandStatus : std::uint16_t { None = 0, Done, Refused };

enum class Refusal : std::uint16_t {
    None = 0,
    UnknownCommand,
    NoActiveProgram,
    AlreadyRunning,
    NotRunning,
    InFault,
    NotStandstill,
    NothingSealed,
    WrongSession,
    WrongChecksum,
    MachineDataDiffers,
    NotArmed,
    FlashFailed,
    NoFault,
    BadArgument,
    FaultPersists,
    HeartbeatLost,
};

enum class TransferOperation : std::uint16_t { None = 0, Begin, Block, Seal };

enum class TransferResult : std::uint16_t {
    None = 0,
    Accepted,
    WrongSession,
    NotReceiving,
    BadBlock,
    BadLength,
    WrongMapVersion,
    KindNotSupported,
    BlocksMissing,
    BadHeader,
    BadRow,
    BadSum,
    StateRefuses,
};

// Bits of status.fault.
enum class FaultBit : std::uint16_t { FollowingError = 0, ActiveTableDamaged = 1, DriveNotFollowing = 2 };

// Bits of status.warning.
enum class WarningBit : std::uint16_t {
    HeartbeatLost = 0,
    NotHomed = 1,
    FlashSlotInvalid = 2,
    ClockNotSet = 3
};

// Bits of exchange.jog; both set means neither.
enum class JogBit : std::uint16_t { Forward = 0, Reverse = 1 };

enum class HeartbeatLostAction : std::uint16_t { RunOn = 0, StopAtCycleEnd = 1 };

struct EnumValue {
    std::string_view name; // as in the enum class
    std::uint16_t value = 0;
    std::string_view text; // one sentence for the register document
};

struct EnumInfo {
    std::string_view name;
    std::span<const EnumValue> values;
};

// Every enumeration above, for the generated C header, document and JSON.
[[nodiscard]] std::span<const EnumInfo> enumerations();

// Text of one value ("Refused while in fault ..."), empty when the value is unknown.
[[nodiscard]] std::string_view enumText(std::string_view enumName, std::uint16_t value);

} // namespace campanel::modbus
