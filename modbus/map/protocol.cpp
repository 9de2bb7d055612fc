// SPDX-License-Identifier: Apache-2.0
// The text of every enumeration value; generated documents and the C header are printed from here.
#include "modbus/map/protocol.h"

#include <algorithm>

namespace campanel::modbus {
namespace {

constexpr std::array states{
    entry(State::Idle, "Idle", "No active program."),
    entry(State::Ready, "Ready", "An active program, standing still."),
    entry(State::Running, "Running", "Executing the active table."),
    entry(State::Stopping, "Stopping", "Ramping down, to the end of the cycle or at once."),
    entry(State::Jogging, "Jogging", "Moving while a jog bit is held."),
    entry(State::Homing, "Homing",
          "Looking for the index mark of the axis: of the knife shaft, or of the motor where there is no "
          "knife."),
    entry(State::Fault, "Fault", "Stopped by a fault; see status.fault, then reset."),
};

constexpr std::array programKinds{
    entry(ProgramKind::None, "None", "Nothing."),
    entry(ProgramKind::RotaryCutter, "RotaryCutter", "Rotary cutter cam."),
    entry(ProgramKind::PositionMove, "PositionMove", "Move over a distance, from rest to rest."),
    entry(ProgramKind::SpeedMove, "SpeedMove", "Move from one speed to another, which is then held."),
    entry(ProgramKind::PointCam, "PointCam", "Cam through given points, following a virtual master."),
    entry(ProgramKind::Press, "Press", "Press stroke in five stages."),
    entry(ProgramKind::SegmentCam, "SegmentCam", "Cam of segments, following a virtual master."),
};
static_assert(programKinds.back().value == static_cast<std::uint16_t>(lastProgramKind));

constexpr std::array tableLayouts{
    entry(TableLayout::None, "None", "Nothing."),
    entry(TableLayout::StepTable, "StepTable",
          "Rows of three registers: pulses (u16), ticks (u32). Pulse j = 1 .. pulses comes floor(j * ticks / "
          "pulses) "
          "ticks after the row's start, the last one at its end; a row without pulses is a pause."),
    entry(
        TableLayout::CamPoints, "CamPoints",
        "Rows of four registers, one for each end of the equal intervals of the master: position (i32, "
        "1/256 pulse "
        "from the first row) and slope (i32, 1/256 pulse per interval); in between a cubic with these "
        "slopes. After "
        "the rows of a point cam cam.knot_count knots of four registers: master (u32, 0.0001 degrees), slave "
        "(i32, 0.001 mm). After those of a segment cam cam.segment_count segments of 17 registers: end (u32, "
        "0.0001 degrees), slave at the end (i32, 0.001 mm), motion (u16: 0 dwell, 101 constant speed, 103 "
        "and 105 polynomials of the third and fifth degree, else the code of a law), speed and acceleration "
        "at the start, then at the end (i32, 0.000001 mm/degree and 0.0000001 mm/degree^2), two parameters "
        "of the law (u32, 0.000001)."),
    entry(TableLayout::Intervals, "Intervals",
          "Rows of eight registers, constant acceleration each: distance (u32, pulses), first and last speed "
          "(u32, "
          "pulses/s), acceleration (u32, pulses/s^2), as the accumulators of the engine take them: at 2^23 "
          "iterations per second, in units of 2^-interval.fraction_bits."),
    entry(
        TableLayout::PressStages, "PressStages",
        "Five rows of eight registers: speed (u32, Hz), end position (i32, pulses), force (u32, N), time "
        "(u32, ms): "
        "approach, probe, press, hold, return. The time of a stage that moves is its ramp, that of the hold "
        "its length. "
        "The force of approach and probe is the one by which the work piece is felt, that of press the "
        "largest "
        "allowed in any stage."),
};

constexpr std::array endBehaviors{
    entry(EndBehavior::Repeat, "Repeat", "The table begins again."),
    entry(EndBehavior::Stop, "Stop", "The axis stands still; Start runs the table once more."),
    entry(EndBehavior::HoldSpeed, "HoldSpeed", "The last speed is held until a stop."),
};

constexpr std::array rampShapes{
    entry(RampShape::Trapezoid, "Trapezoid", "Constant acceleration of the master."),
    entry(RampShape::SCurve, "SCurve", "The acceleration of the master rises and falls linearly."),
};

constexpr std::array moveDurations{
    entry(MoveDuration::GivenTime, "GivenTime", "The time is given."),
    entry(MoveDuration::Fastest, "Fastest", "As fast as the limits of the machine allow."),
    entry(MoveDuration::OverDistance, "OverDistance", "The distance of a change of speed is given."),
};

// The codes are those of profile::LawId.
constexpr std::array laws{
    EnumValue{"Cubic", 1, "Cubic, 3 x^2 - 2 x^3."},
    EnumValue{"Quintic", 2, "Quintic 3-4-5."},
    EnumValue{"Polynomial4567", 3, "Polynomial 4-5-6-7."},
    EnumValue{"Harmonic", 4, "Harmonic."},
    EnumValue{"Cycloidal", 5, "Cycloidal."},
    EnumValue{"ModifiedSine", 6, "Modified sine."},
    EnumValue{"ModifiedTrapezoid", 7, "Modified trapezoid."},
    EnumValue{"Parabolic", 8, "Parabolic: constant acceleration, then constant deceleration."},
    EnumValue{"Trapezoid", 9, "Trapezoid; parameter 1: share of the time of each ramp."},
    EnumValue{"SCurve", 10,
              "Seven segments; parameter 1: share of the time of each ramp, 2: of the ramp with jerk."},
    EnumValue{"Exponential", 11, "Exponential; parameter 1: its exponent."},
    EnumValue{"HalfModifiedSine", 12, "First half of the modified sine."},
};

constexpr std::array splineEnds{
    entry(SplineEnds::Natural, "Natural", "No curvature at the ends."),
    entry(SplineEnds::Clamped, "Clamped", "No speed at the ends."),
    entry(SplineEnds::Periodic, "Periodic", "Speed and acceleration continue where the cycle closes."),
};

constexpr std::array pressStages{
    entry(PressStage::Standing, "Standing", "No stroke under way."),
    entry(PressStage::Approach, "Approach", "Fast to a position near the work piece."),
    entry(PressStage::Probe, "Probe", "Slowly until the work piece is felt."),
    entry(PressStage::Press, "Press", "The counted pulses to the stop position."),
    entry(PressStage::Hold, "Hold", "Standing at the stop position under force."),
    entry(PressStage::Return, "Return", "Back to the upper position."),
};

constexpr std::array strokeResults{
    entry(StrokeResult::None, "None", "No stroke has ended since power-up."),
    entry(StrokeResult::Ok, "Ok", "Stop position and force within their windows."),
    entry(StrokeResult::PositionOutside, "PositionOutside",
          "Stopped farther from the position than the tolerance."),
    entry(StrokeResult::ForceTooLow, "ForceTooLow", "Less force at the stop than the window allows."),
    entry(StrokeResult::ForceTooHigh, "ForceTooHigh", "More force at the stop than the window allows."),
    entry(StrokeResult::TouchedTooEarly, "TouchedTooEarly", "The work piece was felt during the approach."),
    entry(StrokeResult::NeverTouched, "NeverTouched",
          "The work piece was not felt where it should have been."),
    entry(StrokeResult::ForceLimit, "ForceLimit", "The largest force was reached: stopped and returned."),
    entry(StrokeResult::Stopped, "Stopped", "Ended by a stop."),
};

constexpr std::array stagedStates{
    entry(StagedState::Empty, "Empty", "The shadow bank holds nothing."),
    entry(StagedState::Receiving, "Receiving", "A transfer is under way or was interrupted."),
    entry(StagedState::Sealed, "Sealed", "Complete and checked; may be applied."),
    entry(StagedState::Armed, "Armed", "Becomes active at the next cycle boundary."),
};

constexpr std::array commands{
    entry(Command::None, "None", "No command yet."),
    entry(Command::Start, "Start", "Run the active table, ramping up from standstill."),
    entry(Command::StopAtCycleEnd, "StopAtCycleEnd",
          "Ramp down so that the motion ends at a cycle boundary."),
    entry(Command::StopNow, "StopNow", "Ramp down at once; the cam phase is kept."),
    entry(Command::Home, "Home",
          "Turn slowly to the index mark of the axis and call it zero; a press: call the place where it "
          "stands its upper position."),
    entry(Command::ResetFault, "ResetFault", "Leave Fault when its cause is gone."),
    entry(Command::ApplyStaged, "ApplyStaged",
          "argument0 = ApplyMode, argument1 = transfer session, argument2 = CRC-32 of the staged bytes."),
    entry(Command::CancelApply, "CancelApply",
          "Disarm: the staged bank stays sealed, the active one active."),
    entry(Command::DiscardStaged, "DiscardStaged", "Empty the shadow bank."),
    entry(Command::SaveToFlash, "SaveToFlash",
          "Write active bank and parameters to the older flash slot; argument2 = active CRC-32."),
    entry(Command::SetClock, "SetClock", "argument2 = seconds since 1970-01-01 UTC."),
    entry(Command::TeachMarks, "TeachMarks",
          "argument0 = marks, 2..100: measure the distances between the next marks whatever they are; see "
          "packer.teach_marks."),
};

constexpr std::array applyModes{
    entry(ApplyMode::WhenStopped, "WhenStopped", "Swap at once; refused unless standing still."),
    entry(ApplyMode::NextCycle, "NextCycle", "Swap at the next cycle boundary, at once when standing still."),
};

constexpr std::array commandStatuses{
    entry(CommandStatus::None, "None", "No command received since power-up."),
    entry(CommandStatus::Done, "Done", "Accepted and carried out, or started where it takes time."),
    entry(CommandStatus::Refused, "Refused", "Not carried out; result.reason says why."),
    entry(CommandStatus::Busy, "Busy",
          "Being carried out in pieces; read the result again until it is another one."),
};

constexpr std::array refusals{
    entry(Refusal::None, "None", "Not refused."),
    entry(Refusal::UnknownCommand, "UnknownCommand", "The controller does not know this command."),
    entry(Refusal::NoActiveProgram, "NoActiveProgram", "No program is active; download one first."),
    entry(Refusal::AlreadyRunning, "AlreadyRunning", "The machine is already moving."),
    entry(Refusal::NotRunning, "NotRunning", "The machine is not running."),
    entry(Refusal::InFault, "InFault", "The controller is in fault; reset the fault first."),
    entry(Refusal::NotStandstill, "NotStandstill", "Only allowed at standstill; stop the machine first."),
    entry(Refusal::NothingSealed, "NothingSealed", "No sealed program is staged."),
    entry(Refusal::WrongSession, "WrongSession", "The staged program belongs to another transfer session."),
    entry(Refusal::WrongChecksum, "WrongChecksum", "The CRC-32 named is not that of the bytes held."),
    entry(Refusal::MachineDataDiffers, "MachineDataDiffers",
          "Kind, knife radius, number of knives, gear, feed or pulses per revolution differ; they change "
          "only at standstill."),
    entry(Refusal::NotArmed, "NotArmed", "No change is armed."),
    entry(Refusal::FlashFailed, "FlashFailed",
          "The flash could not be written; the saved program is unchanged."),
    entry(Refusal::NoFault, "NoFault", "There is no fault to reset."),
    entry(Refusal::BadArgument, "BadArgument", "An argument is outside its range."),
    entry(Refusal::FaultPersists, "FaultPersists", "The cause of the fault is still there."),
    entry(Refusal::HeartbeatLost, "HeartbeatLost", "No panel heartbeat; reconnect first."),
    entry(Refusal::SensorTooFar, "SensorTooFar",
          "More bags between mark sensor and knife than the controller remembers; a longer bag or a nearer "
          "sensor."),
    entry(Refusal::MarkWindowTooWide, "MarkWindowTooWide",
          "parameter.mark_window reaches a quarter of the bag length; marks could be confused."),
    entry(Refusal::NoRoomToCorrect, "NoRoomToCorrect",
          "Knife and film move together for more than nine tenths of the cycle, or the cut is outside that."),
    entry(Refusal::EyeTooNear, "EyeTooNear",
          "The product eye must be far enough before the film to decide in time, some two products, and at "
          "most eight."),
    entry(Refusal::FeedTooFast, "FeedTooFast",
          "Film or infeed would need more pulses a second, corrections included, than the output stage "
          "gives."),
    entry(Refusal::CommandIncomplete, "CommandIncomplete",
          "Counter and code of a command come in one frame. Write them together."),
    entry(Refusal::StepTooLarge, "StepTooLarge",
          "Even at the smallest share of full speed an axis would change its speed by more than its largest "
          "step; the program is changed at standstill."),
    entry(Refusal::Switch1LeadTooLong, "Switch1LeadTooLong",
          "The lead of cam switch 1 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch2LeadTooLong, "Switch2LeadTooLong",
          "The lead of cam switch 2 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch3LeadTooLong, "Switch3LeadTooLong",
          "The lead of cam switch 3 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch4LeadTooLong, "Switch4LeadTooLong",
          "The lead of cam switch 4 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch5LeadTooLong, "Switch5LeadTooLong",
          "The lead of cam switch 5 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch6LeadTooLong, "Switch6LeadTooLong",
          "The lead of cam switch 6 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch7LeadTooLong, "Switch7LeadTooLong",
          "The lead of cam switch 7 is longer than a cycle at the program's full speed."),
    entry(Refusal::Switch8LeadTooLong, "Switch8LeadTooLong",
          "The lead of cam switch 8 is longer than a cycle at the program's full speed."),
    entry(Refusal::EmergencyStop, "EmergencyStop",
          "The emergency stop is pressed, or was within the last two seconds."),
    entry(Refusal::DriveAlarm, "DriveAlarm",
          "The fault is an alarm of the drive; remove its cause, then reset the fault."),
    entry(Refusal::NotWarm, "NotWarm", "exchange.permit lacks Warm."),
    entry(Refusal::WrongFilm, "WrongFilm", "exchange.permit lacks Film."),
    entry(Refusal::WrongRecipe, "WrongRecipe", "exchange.permit lacks Recipe."),
    entry(Refusal::NotClean, "NotClean", "exchange.permit lacks Clean."),
    entry(Refusal::PanelDisagrees, "PanelDisagrees", "exchange.permit lacks PanelAgrees."),
};
static_assert(refusals.back().value == static_cast<std::uint16_t>(Refusal::NotWarm) +
                                           static_cast<std::uint16_t>(PermitBit::PanelAgrees));

constexpr std::array transferOperations{
    entry(TransferOperation::None, "None", "No transfer since power-up."),
    entry(TransferOperation::Begin, "Begin", "data = ProgramKind, registers in all, map major version."),
    entry(TransferOperation::Block, "Block",
          "transfer.length registers of data at block * identity.block_registers."),
    entry(TransferOperation::Seal, "Seal", "Check every row, compute the CRC-32."),
};

constexpr std::array transferResults{
    entry(TransferResult::None, "None", "No transfer since power-up."),
    entry(TransferResult::Accepted, "Accepted", "Done."),
    entry(TransferResult::WrongSession, "WrongSession", "The transfer under way has another session id."),
    entry(TransferResult::NotReceiving, "NotReceiving", "No transfer has begun."),
    entry(TransferResult::BadBlock, "BadBlock", "Block number outside the announced length."),
    entry(TransferResult::BadLength, "BadLength", "Length is zero, too long, or not that of the block."),
    entry(TransferResult::WrongMapVersion, "WrongMapVersion",
          "The panel was built for another register map."),
    entry(TransferResult::KindNotSupported, "KindNotSupported", "This program kind cannot be executed here."),
    entry(TransferResult::BlocksMissing, "BlocksMissing",
          "Sealing needs every block; see transfer_result.next_missing."),
    entry(TransferResult::BadHeader, "BadHeader", "A header field is outside its range."),
    entry(TransferResult::BadRow, "BadRow",
          "Row transfer_result.detail is outside what the controller can execute."),
    entry(TransferResult::BadSum, "BadSum", "The rows do not add up to the header's pulses or ticks."),
    entry(TransferResult::StateRefuses, "StateRefuses", "An armed change must be cancelled first."),
    entry(TransferResult::Busy, "Busy",
          "Being checked in pieces, or the bank is being saved; send the same again."),
};

constexpr std::array jogBits{
    entry(JogBit::Forward, "Forward", "Jog forward while set and the heartbeat advances."),
    entry(JogBit::Reverse, "Reverse", "Jog backward while set and the heartbeat advances."),
};

constexpr std::array permitBits{
    entry(PermitBit::Warm, "Warm", "The machine is warm. A panel sets it while it does not judge the heat."),
    entry(PermitBit::Film, "Film", "No wrong or unknown film reel was scanned."),
    entry(PermitBit::Recipe, "Recipe", "The active program is one that the panel would start."),
    entry(PermitBit::Clean, "Clean",
          "Nobody cleans the machine; homing and jogging need it as well. A panel sets it while it does not "
          "judge that."),
    entry(PermitBit::PanelAgrees, "PanelAgrees", "The panel has no reason against a start."),
};
static_assert(permitBits.size() == permitCount);

constexpr std::array heartbeatLostActions{
    entry(HeartbeatLostAction::RunOn, "RunOn", "Warn and run on."),
    entry(HeartbeatLostAction::StopAtCycleEnd, "StopAtCycleEnd", "Warn and stop at the end of the cycle."),
};

constexpr std::array switchModes{
    entry(SwitchMode::Off, "Off", "Never on."),
    entry(SwitchMode::Cycles, "Cycles", "On from the on angle to the off angle of every n-th cycle."),
    entry(SwitchMode::RejectedBags, "RejectedBags",
          "The same, once for each bag to reject: on when the bag cut last is one. The on angle, less the "
          "lead, must be behind the cut."),
};

constexpr std::array driveEnables{
    entry(DriveEnable::Off, "Off", "The drives are never enabled."),
    entry(DriveEnable::On, "On", "Always."),
    entry(DriveEnable::WhileRunning, "WhileRunning",
          "While an axis moves by the controller, and half a second longer."),
};

constexpr std::array ioBits{
    entry(IoBit::Inputs, "Inputs", "io.inputs."),
    entry(IoBit::Outputs, "Outputs", "io.outputs."),
    entry(IoBit::Infeed, "Infeed", "Position and following error of the infeed."),
    entry(IoBit::Torque, "Torque", "io.torque."),
};

constexpr std::array inputBits{
    entry(InputBit::DriveAlarm, "DriveAlarm", "The drive reports an alarm: a fault at once."),
    entry(InputBit::EmergencyStop, "EmergencyStop",
          "The emergency stop is pressed: ends a motion and refuses others. No safety depends on it."),
    entry(InputBit::LimitForward, "LimitForward", "Forward limit switch reached. Only reported."),
    entry(InputBit::LimitReverse, "LimitReverse", "Reverse limit switch reached. Only reported."),
    entry(InputBit::IndexMark, "IndexMark", "The axis stands on its index mark."),
    entry(InputBit::MarkSensor, "MarkSensor", "A printed mark is under its sensor."),
    entry(InputBit::ProductEye, "ProductEye", "A product covers the eye."),
};

constexpr std::array outputBits{
    entry(OutputBit::Switch1, "Switch1", "Cam switch 1."),
    entry(OutputBit::Switch2, "Switch2", "Cam switch 2."),
    entry(OutputBit::Switch3, "Switch3", "Cam switch 3."),
    entry(OutputBit::Switch4, "Switch4", "Cam switch 4."),
    entry(OutputBit::Switch5, "Switch5", "Cam switch 5."),
    entry(OutputBit::Switch6, "Switch6", "Cam switch 6."),
    entry(OutputBit::Switch7, "Switch7", "Cam switch 7."),
    entry(OutputBit::Switch8, "Switch8", "Cam switch 8."),
    entry(OutputBit::DriveEnable, "DriveEnable", "Enables the drives; see parameter.drive_enable."),
};

constexpr std::array markStates{
    entry(MarkState::Off, "Off", "The marks are not followed, or nothing runs yet."),
    entry(MarkState::Searching, "Searching", "Waiting for two marks one bag length apart."),
    entry(MarkState::Aligning, "Aligning",
          "The film is being shifted until the cuts meet the marks; these bags are off."),
    entry(MarkState::Tracking, "Tracking", "The cuts follow the marks."),
};

constexpr std::array gateStates{
    entry(GateState::Running, "Running", "It follows."),
    entry(GateState::Slowing, "Slowing", "It comes to stand at the boundary of its cycle."),
    entry(GateState::Standing, "Standing", "It waits for whole cycles; a knife is open then."),
    entry(GateState::Gaining, "Gaining", "It sets off to be back in phase at bank.sync_start."),
};

constexpr std::array skipCauses{
    entry(SkipCause::None, "None", "Nothing was left out."),
    entry(SkipCause::ProductAcross, "ProductAcross", "A product lay across the knife's path."),
    entry(SkipCause::ProductTooLong, "ProductTooLong", "A product longer than the bag lay across it."),
    entry(SkipCause::NoProduct, "NoProduct", "No product came: no film was used."),
};

constexpr std::array bagBits{
    entry(BagBit::Tracked, "Tracked", "Its cut followed a mark."),
    entry(BagBit::MarkMissed, "MarkMissed", "That mark was not seen but reckoned."),
    entry(BagBit::ProductAcross, "ProductAcross", "Longer by the cuts skipped for a product across."),
    entry(BagBit::Empty, "Empty", "Cut without a product."),
    entry(BagBit::ChangeOver, "ChangeOver",
          "The program was changed in it; its set length lies between theirs."),
    entry(
        BagBit::StartUp, "StartUp",
        "Start-up scrap: one of its cuts was made before the film was in register, after power-up, a jog or "
        "for another length."),
};

constexpr std::array<EnumInfo, 31> infos{{
    {"State", states},
    {"ProgramKind", programKinds},
    {"StagedState", stagedStates},
    {"Command", commands},
    {"ApplyMode", applyModes},
    {"CommandStatus", commandStatuses},
    {"Refusal", refusals},
    {"TransferOperation", transferOperations},
    {"TransferResult", transferResults},
    {"FaultBit", faultBits},
    {"WarningBit", warningBits},
    {"JogBit", jogBits},
    {"PermitBit", permitBits},
    {"HeartbeatLostAction", heartbeatLostActions},
    {"TableLayout", tableLayouts},
    {"EndBehavior", endBehaviors},
    {"RampShape", rampShapes},
    {"MoveDuration", moveDurations},
    {"Law", laws},
    {"SplineEnds", splineEnds},
    {"PressStage", pressStages},
    {"StrokeResult", strokeResults},
    {"MarkState", markStates},
    {"GateState", gateStates},
    {"SkipCause", skipCauses},
    {"BagBit", bagBits},
    {"SwitchMode", switchModes},
    {"OutputBit", outputBits},
    {"DriveEnable", driveEnables},
    {"IoBit", ioBits},
    {"InputBit", inputBits},
}};

} // namespace

std::span<const EnumInfo> enumerations()
{
    return infos;
}

std::string_view enumText(std::string_view enumName, std::uint16_t value)
{
    for (const EnumInfo& info : enumerations()) {
        if (info.name != enumName)
            continue;
        const auto found = std::ranges::find(info.values, value, &EnumValue::value);
        return found == info.values.end() ? std::string_view{} : found->text;
    }
    return {};
}

} // namespace campanel::modbus
