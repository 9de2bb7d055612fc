// SPDX-License-Identifier: Apache-2.0
// The constants of the contract between panel and controller: states, commands, refusals, fault bits. The
// controller's C header and the register document are generated from the tables at the end of this file.
#pragma once

#include "modbus/map/alarm_bits.h"
#include "modbus/map/io_rows.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace campanel::modbus {

// The value of identity.device_type of a CamPanel controller ("CA" for cam, 0x3D).
inline constexpr std::uint16_t deviceType = 0xCA3D;
// The major version of the register map. A panel refuses a controller with another one; a higher minor
// version only adds registers.
inline constexpr std::uint16_t mapMajor = 1;
extern const std::uint16_t mapMinor; // beside the registers, in register_map.cpp

enum class State : std::uint16_t { Idle = 0, Ready, Running, Stopping, Jogging, Homing, Fault };

enum class ProgramKind : std::uint16_t {
    None = 0,
    RotaryCutter = 1,
    PositionMove = 2,
    SpeedMove = 3,
    PointCam = 4,
    Press = 5,
    SegmentCam = 6,
};
inline constexpr ProgramKind lastProgramKind = ProgramKind::SegmentCam;

// The type of the rows of a bank, as named in its header.
enum class TableLayout : std::uint16_t {
    None = 0,
    StepTable = 1,
    CamPoints = 2,
    Intervals = 3,
    PressStages = 4
};

// The behavior at the end of a table.
enum class EndBehavior : std::uint16_t { Repeat = 0, Stop = 1, HoldSpeed = 2 };

enum class RampShape : std::uint16_t { Trapezoid = 0, SCurve = 1 };

// The given input of a move.
enum class MoveDuration : std::uint16_t { GivenTime = 0, Fastest = 1, OverDistance = 2 };

enum class SplineEnds : std::uint16_t { Natural = 0, Clamped = 1, Periodic = 2 };

enum class PressStage : std::uint16_t { Standing = 0, Approach, Probe, Press, Hold, Return };

enum class StrokeResult : std::uint16_t {
    None = 0,
    Ok,
    PositionOutside,
    ForceTooLow,
    ForceTooHigh,
    TouchedTooEarly,
    NeverTouched,
    ForceLimit,
    Stopped,
};

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
    TeachMarks,
    TryOutput,
    OrderStart,
    OrderEnd,
    Acknowledge,
    JogBag,
    SingleCut,
    TakeBag,
    Measure,
};

inline constexpr Command lastCommand = Command::Measure;
// The first minor version of the map with Command::TryOutput.
inline constexpr std::uint16_t tryOutputMapMinor = 5;
// The first one with Command::JogBag, SingleCut and TakeBag.
inline constexpr std::uint16_t bagsByHandMapMinor = 6;

enum class ApplyMode : std::uint16_t { WhenStopped = 0, NextCycle = 1 };

enum class CommandStatus : std::uint16_t { None = 0, Done, Refused, Busy };

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
    SensorTooFar,
    MarkWindowTooWide,
    NoRoomToCorrect,
    EyeTooNear,
    FeedTooFast,
    CommandIncomplete,
    StepTooLarge,
    // The lead of a cam switch; the number of the switch is part of the reason.
    Switch1LeadTooLong,
    Switch2LeadTooLong,
    Switch3LeadTooLong,
    Switch4LeadTooLong,
    Switch5LeadTooLong,
    Switch6LeadTooLong,
    Switch7LeadTooLong,
    Switch8LeadTooLong,
    EmergencyStop,
    DriveAlarm,
    // The missing bits of exchange.permit, in the order of PermitBit.
    NotWarm,
    WrongFilm,
    WrongRecipe,
    NotClean,
    PanelDisagrees,
    MarkMaskingTooLong,
    NoMarkWidthAllowed,
    NoMasterInput,
    MasterTooFast,
    CannotFollowMaster,
    JawsExcludeCut,
    OrderUnderWay,
    NoOrder,
    NoBags,
    // The inputs that refuse a start, in the order of InputBit.
    StopButton,
    DoorOpen,
    NextMachine,
    Coder,
    NotInPhase,
    FilmNotOurs,
    FilmMoves,
    ProductAtKnife,
    NoRejectGate,
    CoderTooFar,
    NoIndex,
    NoIndexMark,
    JawsClosed,
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
    Busy,
};

enum class MarkState : std::uint16_t { Off = 0, Searching, Aligning, Tracking };

// The use that was made of an edge of the mark sensor.
enum class MarkVerdict : std::uint16_t {
    NotUsed = 0,
    Searched,
    Taken,
    OutsideWindow,
    TooNarrow,
    TooWide,
    Masked,
};

// The monitoring of the knife's torque.
enum class JamState : std::uint16_t { Off = 0, NotReported, TooSlow, Learning, Armed };

// A sign that shows a jam.
enum class JamSource : std::uint16_t { None = 0, Torque, TorqueLimit };

enum class GateState : std::uint16_t { Running = 0, Slowing, Standing, CatchingUp };

enum class SkipCause : std::uint16_t { None = 0, ProductAcross, ProductTooLong, NoProduct };

// The bits of a record of packer.bags; between the last two is the number of bag lengths in it.
enum class BagBit : std::uint16_t {
    Tracked = 0,
    MarkMissed = 1,
    ProductAcross = 2,
    Empty = 3,
    ChangeOver = 4,
    StartUp = 5,
    Burned = 6,
    Jammed = 7,
    Taken = 15
};
// The bag lengths in such a record, from the bit `bagLengthsFrom` on.
inline constexpr unsigned bagLengthsFrom = 8;
inline constexpr unsigned maxBagLengths = 127;

// The bits of exchange.jog; both set means neither.
enum class JogBit : std::uint16_t { Forward = 0, Reverse = 1 };

// The bits of exchange.permit.
enum class PermitBit : std::uint16_t { Warm = 0, Film, Recipe, Clean, PanelAgrees };
inline constexpr int permitCount = 5;
inline constexpr std::uint16_t allPermits = (1u << permitCount) - 1u;

enum class HeartbeatLostAction : std::uint16_t { RunOn = 0, StopAtCycleEnd = 1 };

// The mode of a cam switch.
enum class SwitchMode : std::uint16_t { Off = 0, Cycles = 1, RejectedBags = 2 };
inline constexpr int switchCount = 8;

enum class MasterSource : std::uint16_t { Clock = 0, Encoder = 1 };
enum class MasterPlace : std::uint16_t { Shaft = 0, Wheel = 1 };
enum class MasterSignal : std::uint16_t { Quadrature = 0, PulseAndDirection = 1 };
enum class MasterState : std::uint16_t { Off = 0, Engaging, Engaged, Disengaging };

// An axis of which command Measure counts the pulses, and what became of it.
enum class MeasuredAxis : std::uint16_t { Knife = 0, Film, Infeed };
enum class MeasureState : std::uint16_t { None = 0, Moving, Done, Ended };

// The order that the controller counts.
enum class OrderState : std::uint16_t { None = 0, Active, Complete, Ended };

// Its lot is a text of so many registers, two bytes each.
inline constexpr int orderLotRegisters = 20;

// The run does this at an order's quantity.
enum class OrderAction : std::uint16_t { None = 0, Message, Stop };

// The conduct of a light of the tower, or of the horn, while its condition lasts. Until it is acknowledged,
// BlinkThenOn blinks and OnThenOff is on.
enum class SignalMode : std::uint16_t { Off = 0, On, Blink, BlinkThenOn, OnThenOff };

// The conditions that the light tower shows, in the order of their registers in the group `signal`.
enum class SignalBit : std::uint16_t { Fault = 0, Warning, Waiting, Running, Ready, Order };

enum class DriveEnable : std::uint16_t { Off = 0, On = 1, WhileRunning = 2 };

// The bits of io.available.
enum class IoBit : std::uint16_t {
    Inputs = 0,
    Outputs = 1,
    Infeed = 2,
    Torque = 3,
    AxisKept = 4,
    FilmKept = 5,
    InfeedKept = 6,
    Reversal = 7,
};

struct EnumInfo {
    std::string_view name;
    std::span<const EnumValue> values;
};

// Returns all enumerations above, for the generated C header, document and JSON.
[[nodiscard]] std::span<const EnumInfo> enumerations();

// The names of the enumerations whose texts the panel shows.
constexpr std::string_view nameOf(State)
{
    return "State";
}
constexpr std::string_view nameOf(PressStage)
{
    return "PressStage";
}
constexpr std::string_view nameOf(StrokeResult)
{
    return "StrokeResult";
}
constexpr std::string_view nameOf(Command)
{
    return "Command";
}
constexpr std::string_view nameOf(Refusal)
{
    return "Refusal";
}
constexpr std::string_view nameOf(TransferResult)
{
    return "TransferResult";
}
constexpr std::string_view nameOf(MarkState)
{
    return "MarkState";
}
constexpr std::string_view nameOf(MarkVerdict)
{
    return "MarkVerdict";
}
constexpr std::string_view nameOf(JamState)
{
    return "JamState";
}
constexpr std::string_view nameOf(OrderState)
{
    return "OrderState";
}
constexpr std::string_view nameOf(OrderAction)
{
    return "OrderAction";
}
constexpr std::string_view nameOf(GateState)
{
    return "GateState";
}
constexpr std::string_view nameOf(InputBit)
{
    return "InputBit";
}
constexpr std::string_view nameOf(OutputBit)
{
    return "OutputBit";
}
constexpr std::string_view nameOf(SkipCause)
{
    return "SkipCause";
}
constexpr std::string_view nameOf(MasterState)
{
    return "MasterState";
}

// Returns the row of a value, or null.
[[nodiscard]] const EnumValue* findValue(std::string_view enumName, std::int64_t value);
template <typename E> [[nodiscard]] const EnumValue* findValue(E value)
{
    return findValue(nameOf(value), static_cast<std::int64_t>(value));
}

// Returns the rows of an enumeration; none for an unknown one.
[[nodiscard]] std::span<const EnumValue> valuesOf(std::string_view enumName);

// Returns the name of a value, or its number where it is unknown.
[[nodiscard]] std::string enumName(std::string_view enumName, std::int64_t value);

template <typename E> [[nodiscard]] std::string enumName(E value)
{
    return enumName(nameOf(value), static_cast<std::int64_t>(value));
}

// Returns what the register document says of a value: text and detail.
[[nodiscard]] std::string meaning(const EnumValue& value);
// Returns the same by the number of the value, empty where it is unknown.
[[nodiscard]] std::string enumText(std::string_view enumName, std::int64_t value);

} // namespace campanel::modbus
