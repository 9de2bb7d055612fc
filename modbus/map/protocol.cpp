// SPDX-License-Identifier: Apache-2.0
// The text of every enumeration value; generated documents and the C header are printed from here.
#include "modbus/map/protocol.h"

#include "text/marked.h"

#include <algorithm>
#include <cctype>

namespace campanel::modbus {
namespace {

constexpr std::array states{
    entry(State::Idle, "Idle", CAMPANEL_TEXT("Protocol", "No program")),
    entry(State::Ready, "Ready", CAMPANEL_TEXT("Protocol", "Ready"),
          "A program is active, the axes stand still."),
    entry(State::Running, "Running", CAMPANEL_TEXT("Protocol", "Running"), "Executes the active table."),
    entry(State::Stopping, "Stopping", CAMPANEL_TEXT("Protocol", "Stopping"),
          "Ramps down, to the end of the cycle or at once."),
    entry(State::Jogging, "Jogging", CAMPANEL_TEXT("Protocol", "Jogging"), "Moves while a jog bit is set."),
    entry(State::Homing, "Homing", CAMPANEL_TEXT("Protocol", "Reference run"),
          "Searches for the index mark of the knife shaft, or of the motor on a machine without a knife."),
    entry(State::Fault, "Fault", CAMPANEL_TEXT("Protocol", "Fault"),
          "Stopped by a fault; see status.fault, then reset."),
};

constexpr std::array programKinds{
    entry(ProgramKind::None, "None", "No program."),
    entry(ProgramKind::RotaryCutter, "RotaryCutter", "Rotary cutter cam."),
    entry(ProgramKind::PositionMove, "PositionMove", "Move over a distance, from rest to rest."),
    entry(ProgramKind::SpeedMove, "SpeedMove", "Move from one speed to another, which is then held."),
    entry(ProgramKind::PointCam, "PointCam", "Cam through given points, following a virtual master."),
    entry(ProgramKind::Press, "Press", "Press stroke in five stages."),
    entry(ProgramKind::SegmentCam, "SegmentCam", "Cam of segments, following a virtual master."),
};
static_assert(programKinds.back().value == static_cast<std::uint16_t>(lastProgramKind));

constexpr std::array tableLayouts{
    entry(TableLayout::None, "None", "No table."),
    entry(TableLayout::StepTable, "StepTable",
          "Rows of three registers: pulses (u16), ticks (u32). Pulse j = 1 .. pulses follows floor(j * ticks "
          "/ pulses) ticks after the start of the row, the last pulse at its end; a row without pulses is a "
          "pause."),
    entry(
        TableLayout::CamPoints, "CamPoints",
        "Rows of four registers, one for each end of the equal intervals of the master: position (i32, 1/256 "
        "pulse from the first row) and slope (i32, 1/256 pulse per interval); between them a cubic with "
        "these slopes. After the rows of a point cam there are cam.knot_count knots of four registers: "
        "master (u32, 0.0001 degrees), slave (i32, 0.001 mm). After the rows of a segment cam there are "
        "cam.segment_count segments of 17 registers: end (u32, 0.0001 degrees), slave at the end (i32, 0.001 "
        "mm), motion (u16: 0 dwell, 101 constant speed, 103 and 105 polynomials of the third and fifth "
        "degree, otherwise the code of a law), speed and acceleration at the start, then at the end (i32, "
        "0.000001 mm/degree and 0.0000001 mm/degree^2), two parameters of the law (u32, 0.000001)."),
    entry(TableLayout::Intervals, "Intervals",
          "Rows of eight registers with constant acceleration: distance (u32, pulses), first and last speed "
          "(u32, pulses/s), acceleration (u32, pulses/s^2), in the units of the engine's accumulators: 2^23 "
          "iterations per second, scaled by 2^-interval.fraction_bits."),
    entry(TableLayout::PressStages, "PressStages",
          "Five rows of eight registers: speed (u32, Hz), end position (i32, pulses), force (u32, N), time "
          "(u32, ms): approach, probe, press, hold, return. The time of a moving stage is its ramp, the time "
          "of the hold stage its duration. The force of approach and probe is the threshold for contact with "
          "the work piece, the force of press the maximum of all stages."),
};

constexpr std::array endBehaviors{
    entry(EndBehavior::Repeat, "Repeat", "The table repeats."),
    entry(EndBehavior::Stop, "Stop", "The axis stands still; Start runs the table once more."),
    entry(EndBehavior::HoldSpeed, "HoldSpeed", "The axis keeps its last speed until a stop."),
};

constexpr std::array rampShapes{
    entry(RampShape::Trapezoid, "Trapezoid", "Constant acceleration of the master."),
    entry(RampShape::SCurve, "SCurve", "The acceleration of the master rises and falls linearly."),
};

constexpr std::array moveDurations{
    entry(MoveDuration::GivenTime, "GivenTime", "Given time."),
    entry(MoveDuration::Fastest, "Fastest", "As fast as the limits of the machine allow."),
    entry(MoveDuration::OverDistance, "OverDistance", "Given distance of a change of speed."),
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
    entry(SplineEnds::Periodic, "Periodic", "Speed and acceleration are continuous where the cycle closes."),
};

constexpr std::array pressStages{
    entry(PressStage::Standing, "Standing", CAMPANEL_TEXT("Protocol", "At standstill"),
          "No stroke in progress."),
    entry(PressStage::Approach, "Approach", CAMPANEL_TEXT("Protocol", "Approach"),
          "Fast to a position near the work piece."),
    entry(PressStage::Probe, "Probe", CAMPANEL_TEXT("Protocol", "Probe"),
          "Slowly until contact with the work piece."),
    entry(PressStage::Press, "Press", CAMPANEL_TEXT("Protocol", "Press"),
          "Counted pulses to the stop position."),
    entry(PressStage::Hold, "Hold", CAMPANEL_TEXT("Protocol", "Hold"),
          "Stands at the stop position under force."),
    entry(PressStage::Return, "Return", CAMPANEL_TEXT("Protocol", "Return"), "Back to the upper position."),
};

constexpr std::array strokeResults{
    entry(StrokeResult::None, "None", {}, "No stroke has ended since power-up."),
    entry(StrokeResult::Ok, "Ok", CAMPANEL_TEXT("Protocol", "OK"),
          "Stop position and force are within their windows."),
    entry(StrokeResult::PositionOutside, "PositionOutside",
          CAMPANEL_TEXT("Protocol", "Stop position outside tolerance")),
    entry(StrokeResult::ForceTooLow, "ForceTooLow", CAMPANEL_TEXT("Protocol", "Force too low"),
          "The force at the stop is below the window."),
    entry(StrokeResult::ForceTooHigh, "ForceTooHigh", CAMPANEL_TEXT("Protocol", "Force too high"),
          "The force at the stop is above the window."),
    entry(StrokeResult::TouchedTooEarly, "TouchedTooEarly", CAMPANEL_TEXT("Protocol", "Contact too early"),
          "The press touched the work piece during the approach."),
    entry(StrokeResult::NeverTouched, "NeverTouched", CAMPANEL_TEXT("Protocol", "No contact"),
          "The press did not touch the work piece before the end of the probe stage."),
    entry(StrokeResult::ForceLimit, "ForceLimit", CAMPANEL_TEXT("Protocol", "Max. force reached"),
          "The press stopped and returned."),
    entry(StrokeResult::Stopped, "Stopped", CAMPANEL_TEXT("Protocol", "Stopped"), "Ended by a stop."),
};

constexpr std::array stagedStates{
    entry(StagedState::Empty, "Empty", "The shadow bank is empty."),
    entry(StagedState::Receiving, "Receiving", "A transfer is in progress or was interrupted."),
    entry(StagedState::Sealed, "Sealed", "Complete and checked; can be applied."),
    entry(StagedState::Armed, "Armed", "Becomes active at the next cycle boundary."),
};

constexpr std::array commands{
    entry(Command::None, "None", {}, "No command yet."),
    entry(Command::Start, "Start", CAMPANEL_TEXT("Protocol", "Start"),
          "Runs the active table, ramping up from standstill."),
    entry(Command::StopAtCycleEnd, "StopAtCycleEnd", CAMPANEL_TEXT("Protocol", "Stop"),
          "Ramps down so that the motion ends at a cycle boundary."),
    entry(Command::StopNow, "StopNow", CAMPANEL_TEXT("Protocol", "Stop"),
          "Ramps down at once; the cam phase is kept."),
    entry(Command::Home, "Home", CAMPANEL_TEXT("Protocol", "Reference run"),
          "Turns slowly to the index mark of the axis and sets this position to zero; a press takes its "
          "present position as the upper position."),
    entry(Command::ResetFault, "ResetFault", CAMPANEL_TEXT("Protocol", "Reset fault"),
          "Leaves Fault when its cause is gone."),
    entry(Command::ApplyStaged, "ApplyStaged", {},
          "argument0 = ApplyMode, argument1 = transfer session, argument2 = CRC-32 of the staged bytes."),
    entry(Command::CancelApply, "CancelApply", {},
          "Disarms: the staged bank stays sealed, the active bank stays active."),
    entry(Command::DiscardStaged, "DiscardStaged", {}, "Empties the shadow bank."),
    entry(Command::SaveToFlash, "SaveToFlash", CAMPANEL_TEXT("Protocol", "Save"),
          "Writes active bank and parameters to the older flash slot; argument2 = active CRC-32."),
    entry(Command::SetClock, "SetClock", {}, "argument2 = seconds since 1970-01-01 UTC."),
    entry(Command::TeachMarks, "TeachMarks", CAMPANEL_TEXT("Protocol", "Measure marks"),
          "argument0 = number of marks, 2 to 100: measures the distances between the next marks of any "
          "length; see packer.teach_marks."),
    entry(
        Command::TryOutput, "TryOutput", CAMPANEL_TEXT("Protocol", "Try output"),
        "argument0 = OutputBit, argument1 = 1: switches this output on at standstill, for 500 ms unless the "
        "command is repeated; 0: switches it off. Any other command, a motion, a fault and the emergency "
        "stop switch it off too. Since map 1.5."),
    entry(
        Command::OrderStart, "OrderStart", CAMPANEL_TEXT("Protocol", "Start of an order"),
        "argument0 = number of the order, not 0, argument1 = OrderAction, argument2 = good bags to make, 1 "
        "to "
        "1 000 000: counts from the next bag on; see order_status. Repeated for the order under way, or for "
        "one that was completed or ended before, nothing is counted anew. Since map 1.6."),
    entry(Command::OrderEnd, "OrderEnd", CAMPANEL_TEXT("Protocol", "End of an order"),
          "argument0 = number of the order under way: no further bag is counted. Since map 1.6."),
    entry(Command::Acknowledge, "Acknowledge", CAMPANEL_TEXT("Protocol", "Acknowledgement"),
          "What the light tower and the horn show now is acknowledged: see SignalMode. Since map 1.6."),
    entry(
        Command::JogBag, "JogBag", CAMPANEL_TEXT("Protocol", "One bag"),
        "A packing machine makes one bag at a fifth of its program's rate, by the clock, and stands in phase "
        "at the end of its cycle. The bag is start-up scrap. Start's rules apply. Since map 1.6."),
    entry(Command::SingleCut, "SingleCut", CAMPANEL_TEXT("Protocol", "Single cut"),
          "The knife alone makes one cut at parameter.home_frequency while the film stands, and is where it "
          "was. The bags on both sides are start-up scrap; where the film has not moved since the last cut, "
          "there is no bag. Start's rules apply. Since map 1.6."),
    entry(Command::TakeBag, "TakeBag", CAMPANEL_TEXT("Protocol", "Next bag to me"),
          "While running: the next bag that is cut is rejected, and its record has the bit Taken. Since map "
          "1.6."),
    entry(Command::Measure, "Measure", CAMPANEL_TEXT("Protocol", "Measurement of an axis"),
          "argument0 = MeasuredAxis, argument1 = turns of its index mark, 1 to 20: turns the axis forward at "
          "parameter.home_frequency and counts; 0: a quarter of a turn. Ends without the heartbeat, by any "
          "stop and by the door; see measure.state. Since map 1.7."),
};

constexpr std::array applyModes{
    entry(ApplyMode::WhenStopped, "WhenStopped", "Swaps at once; refused unless the axes stand still."),
    entry(ApplyMode::NextCycle, "NextCycle", "Swaps at the next cycle boundary, at once at standstill."),
};

constexpr std::array commandStatuses{
    entry(CommandStatus::None, "None", "No command received since power-up."),
    entry(CommandStatus::Done, "Done", "Executed, or started if it takes time."),
    entry(CommandStatus::Refused, "Refused", "Not executed; result.reason says why."),
    entry(CommandStatus::Busy, "Busy", "In progress; read the result again until it changes."),
};

// The wire has one number for each switch.
constexpr std::string_view switchLeadTooLong = CAMPANEL_TEXT(
    "Protocol",
    "The lead of cam switch %1 is longer than a cycle. Shorten it under Maintenance, or lower the rate.");

constexpr std::array refusals{
    entry(Refusal::None, "None", {}, "Not refused."),
    entry(Refusal::UnknownCommand, "UnknownCommand",
          CAMPANEL_TEXT("Protocol", "The controller does not support this command. Update its firmware.")),
    entry(Refusal::NoActiveProgram, "NoActiveProgram",
          CAMPANEL_TEXT("Protocol", "The controller has no program. Download a recipe first.")),
    entry(Refusal::AlreadyRunning, "AlreadyRunning",
          CAMPANEL_TEXT("Protocol", "The machine is already moving. Stop it first.")),
    entry(Refusal::NotRunning, "NotRunning", CAMPANEL_TEXT("Protocol", "The machine is not running.")),
    entry(Refusal::InFault, "InFault",
          CAMPANEL_TEXT("Protocol", "The controller is in fault. Reset the fault first.")),
    entry(Refusal::NotStandstill, "NotStandstill",
          CAMPANEL_TEXT("Protocol", "This is only possible at standstill. Stop the machine first.")),
    entry(Refusal::NothingSealed, "NothingSealed",
          CAMPANEL_TEXT("Protocol", "The controller has no checked table. Download again."),
          "No sealed program is staged."),
    entry(Refusal::WrongSession, "WrongSession",
          CAMPANEL_TEXT("Protocol", "Another download interfered. Download again."),
          "The staged program belongs to another transfer session."),
    entry(Refusal::WrongChecksum, "WrongChecksum",
          CAMPANEL_TEXT("Protocol", "The controller received different data. Download again."),
          "argument2 is not the CRC-32 of the stored bytes."),
    entry(
        Refusal::MachineDataDiffers, "MachineDataDiffers",
        CAMPANEL_TEXT("Protocol", "Machine data can only be changed at standstill. Stop the machine first."),
        "These are kind, knife radius, number of knives, gear, feed and pulses per revolution."),
    entry(Refusal::NotArmed, "NotArmed", CAMPANEL_TEXT("Protocol", "No change is pending.")),
    entry(Refusal::FlashFailed, "FlashFailed",
          CAMPANEL_TEXT(
              "Protocol",
              "Writing to the controller's flash failed; the saved program is unchanged. Save again.")),
    entry(Refusal::NoFault, "NoFault", CAMPANEL_TEXT("Protocol", "There is no fault to reset.")),
    entry(
        Refusal::BadArgument, "BadArgument",
        CAMPANEL_TEXT("Protocol",
                      "The controller does not accept this value. Update the older of panel and controller."),
        "An argument is outside its range."),
    entry(Refusal::FaultPersists, "FaultPersists",
          CAMPANEL_TEXT("Protocol", "The cause of the fault still exists. Remove it first.")),
    entry(Refusal::HeartbeatLost, "HeartbeatLost",
          CAMPANEL_TEXT("Protocol", "The controller receives no heartbeat from the panel. Check the cable.")),
    entry(Refusal::SensorTooFar, "SensorTooFar",
          CAMPANEL_TEXT("Protocol",
                        "There are too many bags between mark sensor and knife. Set a longer bag, "
                        "move the sensor closer, or switch off mark tracking under Maintenance.")),
    entry(Refusal::MarkWindowTooWide, "MarkWindowTooWide",
          CAMPANEL_TEXT("Protocol", "The mark window is wider than half a bag. Reduce it under Maintenance."),
          "parameter.mark_window must be less than a quarter of the bag length."),
    entry(Refusal::NoRoomToCorrect, "NoRoomToCorrect",
          CAMPANEL_TEXT("Protocol", "The sync window is too long to correct the film. Change k1 to k4."),
          "Knife and film move together for more than nine tenths of the cycle, or the cut is outside this "
          "part."),
    entry(Refusal::EyeTooNear, "EyeTooNear",
          CAMPANEL_TEXT("Protocol", "The product eye is too close or too far to decide in time. Check its "
                                    "distance under Maintenance."),
          "The minimum is about two products, the maximum eight."),
    entry(Refusal::FeedTooFast, "FeedTooFast",
          CAMPANEL_TEXT("Protocol",
                        "Film or infeed would exceed the controller's speed limit. Lower the rate."),
          "With corrections they would need more pulses per second than the output stage generates."),
    entry(Refusal::CommandIncomplete, "CommandIncomplete",
          CAMPANEL_TEXT("Protocol",
                        "Another device on the line writes parts of commands. Check the connected devices."),
          "Write counter and code of a command in one frame."),
    entry(Refusal::StepTooLarge, "StepTooLarge",
          CAMPANEL_TEXT("Protocol", "The speed of an axis would change too abruptly. Stop the machine, then "
                                    "download; or raise the largest speed steps under Maintenance."),
          "The speed step is above its maximum even at the lowest share of full speed."),
    entry(Refusal::Switch1LeadTooLong, "Switch1LeadTooLong", switchLeadTooLong, {}, "1"),
    entry(Refusal::Switch2LeadTooLong, "Switch2LeadTooLong", switchLeadTooLong, {}, "2"),
    entry(Refusal::Switch3LeadTooLong, "Switch3LeadTooLong", switchLeadTooLong, {}, "3"),
    entry(Refusal::Switch4LeadTooLong, "Switch4LeadTooLong", switchLeadTooLong, {}, "4"),
    entry(Refusal::Switch5LeadTooLong, "Switch5LeadTooLong", switchLeadTooLong, {}, "5"),
    entry(Refusal::Switch6LeadTooLong, "Switch6LeadTooLong", switchLeadTooLong, {}, "6"),
    entry(Refusal::Switch7LeadTooLong, "Switch7LeadTooLong", switchLeadTooLong, {}, "7"),
    entry(Refusal::Switch8LeadTooLong, "Switch8LeadTooLong", switchLeadTooLong, {}, "8"),
    entry(Refusal::EmergencyStop, "EmergencyStop",
          CAMPANEL_TEXT("Protocol", "The emergency stop is pressed. Release it, then wait two seconds.")),
    entry(Refusal::DriveAlarm, "DriveAlarm",
          CAMPANEL_TEXT("Protocol", "The drive reported an alarm. Remove its cause, then reset the fault.")),
    entry(
        Refusal::NotWarm, "NotWarm",
        CAMPANEL_TEXT("Protocol",
                      "The panel does not permit the start: the machine is not warm. Wait until it is warm."),
        "exchange.permit lacks Warm."),
    entry(Refusal::WrongFilm, "WrongFilm",
          CAMPANEL_TEXT(
              "Protocol",
              "The panel does not permit the start with this film reel. Load and scan the right reel."),
          "exchange.permit lacks Film."),
    entry(Refusal::WrongRecipe, "WrongRecipe",
          CAMPANEL_TEXT("Protocol",
                        "The panel does not permit the start with this program. Download the recipe again."),
          "exchange.permit lacks Recipe."),
    entry(Refusal::NotClean, "NotClean",
          CAMPANEL_TEXT(
              "Protocol",
              "The panel does not permit motion while the machine is cleaned. End the cleaning first."),
          "exchange.permit lacks Clean."),
    entry(Refusal::PanelDisagrees, "PanelDisagrees",
          CAMPANEL_TEXT("Protocol",
                        "The panel does not permit the start. Read the reason at its Start button."),
          "exchange.permit lacks PanelAgrees."),
    entry(Refusal::MarkMaskingTooLong, "MarkMaskingTooLong",
          CAMPANEL_TEXT("Protocol", "The distance in which prints behind a mark are ignored reaches the next "
                                    "mark. Reduce it under Maintenance."),
          "parameter.mark_masking and parameter.mark_window must be less than the bag length."),
    entry(Refusal::NoMarkWidthAllowed, "NoMarkWidthAllowed",
          CAMPANEL_TEXT("Protocol",
                        "The minimum mark width is above the maximum. Correct it under Maintenance."),
          "parameter.mark_width_min must not be above parameter.mark_width_max."),
    entry(Refusal::NoMasterInput, "NoMasterInput",
          CAMPANEL_TEXT("Protocol",
                        "The controller has no input for an encoder as the master. Set the clock as "
                        "the master, or use another controller."),
          "master.source is Encoder."),
    entry(
        Refusal::MasterTooFast, "MasterTooFast",
        CAMPANEL_TEXT("Protocol",
                      "The line runs faster than this program. Slow it down, or download a faster program."),
        "It is above master.speed_max."),
    entry(
        Refusal::CannotFollowMaster, "CannotFollowMaster",
        CAMPANEL_TEXT("Protocol",
                      "This program cannot follow an encoder. Set the clock as the master to run it."),
        "master.source is Encoder; programs that repeat follow it, but none whose master turns in reverse."),
    entry(Refusal::JawsExcludeCut, "JawsExcludeCut",
          CAMPANEL_TEXT("Protocol",
                        "The angles at which the jaws touch the film leave out the cut. Enter both "
                        "under Maintenance, or 0 for both."),
          "One of parameter.jaws_before and parameter.jaws_behind is 0 and the other is not."),
    entry(Refusal::OrderUnderWay, "OrderUnderWay",
          CAMPANEL_TEXT("Protocol", "Another order is under way. End it first."), "It is Active."),
    entry(Refusal::NoOrder, "NoOrder", CAMPANEL_TEXT("Protocol", "This order is not under way."),
          "None with this number is Active."),
    entry(Refusal::NoBags, "NoBags",
          CAMPANEL_TEXT("Protocol", "The active program makes no bags. Download a "
                                    "cutter's program to a packing machine first."),
          "They need film and infeed, and a cutter's program."),
    entry(Refusal::StopButton, "StopButton",
          CAMPANEL_TEXT("Protocol", "The Stop button of the machine is pressed. Release it.")),
    entry(Refusal::DoorOpen, "DoorOpen", CAMPANEL_TEXT("Protocol", "The door is open. Close it.")),
    entry(Refusal::NextMachine, "NextMachine",
          CAMPANEL_TEXT("Protocol", "The next machine is not ready. Clear it first.")),
    entry(Refusal::Coder, "Coder",
          CAMPANEL_TEXT("Protocol", "The date coder is not ready. Clear its fault first.")),
    entry(Refusal::NotInPhase, "NotInPhase",
          CAMPANEL_TEXT("Protocol", "The knife is not in its place. Make a reference run first."),
          "Not homed since power-up, a jog, a fault or another program."),
    entry(Refusal::FilmNotOurs, "FilmNotOurs",
          CAMPANEL_TEXT("Protocol", "The line in front drives the film, so no single bag can be made."),
          "master.place is Wheel."),
    entry(Refusal::FilmMoves, "FilmMoves", CAMPANEL_TEXT("Protocol", "The film moves. Stop the line first."),
          "master.place is Wheel, and its counts change."),
    entry(Refusal::ProductAtKnife, "ProductAtKnife",
          CAMPANEL_TEXT("Protocol", "A product is under the knife. Run the machine empty first."),
          "It is nearer than parameter.cut_clearance."),
    entry(Refusal::NoRejectGate, "NoRejectGate",
          CAMPANEL_TEXT("Protocol", "No cam switch rejects bags. Set one under Maintenance."),
          "No parameter.switch1_mode to switch8_mode is RejectedBags."),
    entry(Refusal::CoderTooFar, "CoderTooFar",
          CAMPANEL_TEXT("Protocol",
                        "The date coder prints before the products are on the film. Check the place of "
                        "its pulse under Maintenance > Inputs and outputs.")),
    entry(Refusal::NoIndex, "NoIndex",
          CAMPANEL_TEXT("Protocol", "This axis has no index sensor. Connect one under Maintenance > Inputs "
                                    "and outputs, or enter the pulses by hand."),
          "signal.film_index_contact or signal.infeed_index_contact is NotConnected, or this is a press."),
    entry(Refusal::NoIndexMark, "NoIndexMark",
          CAMPANEL_TEXT("Protocol", "No index mark came within four turns. Check the index sensor."),
          "Only in measure.reason."),
    entry(Refusal::JawsClosed, "JawsClosed",
          CAMPANEL_TEXT("Protocol", "The jaws hold the film. Jog the knife open first.")),
};
static_assert(static_cast<std::uint16_t>(Refusal::PanelDisagrees) ==
              static_cast<std::uint16_t>(Refusal::NotWarm) +
                  static_cast<std::uint16_t>(PermitBit::PanelAgrees));

constexpr std::array transferOperations{
    entry(TransferOperation::None, "None", "No transfer since power-up."),
    entry(TransferOperation::Begin, "Begin",
          "data = ProgramKind, total number of registers, map major version."),
    entry(TransferOperation::Block, "Block",
          "transfer.length registers of data at block * identity.block_registers."),
    entry(TransferOperation::Seal, "Seal", "Checks every row and computes the CRC-32."),
};

constexpr std::array transferResults{
    entry(TransferResult::None, "None", {}, "No transfer since power-up."),
    entry(TransferResult::Accepted, "Accepted", {}, "Done."),
    entry(TransferResult::WrongSession, "WrongSession",
          CAMPANEL_TEXT("Protocol", "Another download interfered. Download again."),
          "The current transfer has another session id."),
    entry(TransferResult::NotReceiving, "NotReceiving",
          CAMPANEL_TEXT("Protocol", "Another download interfered. Download again."),
          "No transfer has begun."),
    entry(TransferResult::BadBlock, "BadBlock",
          CAMPANEL_TEXT("Protocol", "Parts of the table are missing. Download again."),
          "The block number is outside the announced length."),
    entry(TransferResult::BadLength, "BadLength",
          CAMPANEL_TEXT("Protocol", "Parts of the table are missing. Download again."),
          "The length is zero, too long, or not that of the block."),
    entry(TransferResult::WrongMapVersion, "WrongMapVersion",
          CAMPANEL_TEXT("Protocol", "Panel and controller do not match. Update the older device."),
          "The panel was built for another register map."),
    entry(TransferResult::KindNotSupported, "KindNotSupported",
          CAMPANEL_TEXT("Protocol", "Panel and controller do not match. Update the older device."),
          "The controller cannot execute this kind of program."),
    entry(TransferResult::BlocksMissing, "BlocksMissing",
          CAMPANEL_TEXT("Protocol", "Parts of the table are missing. Download again."),
          "Sealing needs every block; see transfer_result.next_missing."),
    entry(
        TransferResult::BadHeader, "BadHeader",
        CAMPANEL_TEXT("Protocol",
                      "Value %1 in the table header is outside the controller's limits. Correct the recipe."),
        {}, "transfer_result.detail"),
    entry(
        TransferResult::BadRow, "BadRow",
        CAMPANEL_TEXT("Protocol",
                      "Row %1 of the table is outside the range of the controller's timer. Lower the rate."),
        {}, "transfer_result.detail"),
    entry(TransferResult::BadSum, "BadSum",
          CAMPANEL_TEXT("Protocol",
                        "The table's rows do not match its total pulses and time. Download again.")),
    entry(
        TransferResult::StateRefuses, "StateRefuses",
        CAMPANEL_TEXT("Protocol", "An earlier change is waiting for the end of the cycle. Cancel it first.")),
    entry(TransferResult::Busy, "Busy",
          CAMPANEL_TEXT("Protocol",
                        "The controller has not finished checking or saving a table. Download again."),
          "Send the same request again."),
};

constexpr std::array jogBits{
    entry(JogBit::Forward, "Forward", "Jogs forward while set and the heartbeat advances."),
    entry(JogBit::Reverse, "Reverse", "Jogs in reverse while set and the heartbeat advances."),
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
    entry(HeartbeatLostAction::RunOn, "RunOn", "Warns and keeps running."),
    entry(HeartbeatLostAction::StopAtCycleEnd, "StopAtCycleEnd", "Warns and stops at the end of the cycle."),
};

constexpr std::array switchModes{
    entry(SwitchMode::Off, "Off", CAMPANEL_TEXT("Protocol", "Off"), "Never on."),
    entry(SwitchMode::Cycles, "Cycles", CAMPANEL_TEXT("Protocol", "By angle"),
          "On from the on angle to the off angle of every n-th cycle."),
    entry(SwitchMode::RejectedBags, "RejectedBags", CAMPANEL_TEXT("Protocol", "Rejected bags"),
          "As by angle, once for each rejected bag: on if the last cut bag is rejected. The on angle minus "
          "the lead must be after the cut."),
};

constexpr std::array driveEnables{
    entry(DriveEnable::Off, "Off", CAMPANEL_TEXT("Protocol", "Off"), "The drives are never enabled."),
    entry(DriveEnable::On, "On", CAMPANEL_TEXT("Protocol", "Always on")),
    entry(DriveEnable::WhileRunning, "WhileRunning", CAMPANEL_TEXT("Protocol", "While running"),
          "Enabled while the controller moves an axis, and for half a second after."),
};

constexpr std::array masterSources{
    entry(MasterSource::Clock, "Clock", CAMPANEL_TEXT("Protocol", "Clock")),
    entry(MasterSource::Encoder, "Encoder", CAMPANEL_TEXT("Protocol", "Encoder")),
};

constexpr std::array masterPlaces{
    entry(MasterPlace::Shaft, "Shaft", CAMPANEL_TEXT("Protocol", "Shaft"),
          "It replaces the clock; the controller drives infeed, film and knife."),
    entry(MasterPlace::Wheel, "Wheel", CAMPANEL_TEXT("Protocol", "Wheel"),
          "Somebody else drives infeed and film; the controller drives the knife alone."),
};

constexpr std::array masterSignals{
    entry(MasterSignal::Quadrature, "Quadrature", CAMPANEL_TEXT("Protocol", "A/B"),
          "A and B, four counts per line."),
    entry(MasterSignal::PulseAndDirection, "PulseAndDirection", CAMPANEL_TEXT("Protocol", "Pulse"),
          "And a line for the direction, one count per pulse."),
};

constexpr std::array masterStates{
    entry(MasterState::Off, "Off", CAMPANEL_TEXT("Protocol", "Not engaged"), "No run follows the encoder."),
    entry(MasterState::Engaging, "Engaging", CAMPANEL_TEXT("Protocol", "Engaging")),
    entry(MasterState::Engaged, "Engaged", CAMPANEL_TEXT("Protocol", "Engaged")),
    entry(MasterState::Disengaging, "Disengaging", CAMPANEL_TEXT("Protocol", "Disengaging"),
          "It stands at the end of its cycle then."),
};

constexpr std::array measuredAxes{
    entry(MeasuredAxis::Knife, "Knife",
          "The axis with the index mark of homing; of other programs the motor of the axis."),
    entry(MeasuredAxis::Film, "Film", "The film motor."),
    entry(MeasuredAxis::Infeed, "Infeed", "A turn is the way from product to product."),
};

constexpr std::array measureStates{
    entry(MeasureState::None, "None", "Nothing was measured since power-up."),
    entry(MeasureState::Moving, "Moving", "The axis turns."),
    entry(MeasureState::Done, "Done", "The axis has made its turns, and comes to rest."),
    entry(MeasureState::Ended, "Ended", "It was ended before; see measure.reason."),
};

constexpr std::array orderStates{
    entry(OrderState::None, "None", CAMPANEL_TEXT("Protocol", "No order")),
    entry(OrderState::Active, "Active", CAMPANEL_TEXT("Protocol", "Under way")),
    entry(OrderState::Complete, "Complete", CAMPANEL_TEXT("Protocol", "Complete"),
          "The quantity is good and no bag is on the way."),
    entry(OrderState::Ended, "Ended", CAMPANEL_TEXT("Protocol", "Ended early"), "By OrderEnd."),
};

constexpr std::array orderActions{
    entry(OrderAction::None, "None", CAMPANEL_TEXT("Protocol", "Run on"), "The run goes on, uncounted."),
    entry(OrderAction::Message, "Message", CAMPANEL_TEXT("Protocol", "Message"),
          "As None; the panel gives a message."),
    entry(OrderAction::Stop, "Stop", CAMPANEL_TEXT("Protocol", "Stop"),
          "The run ends with the bag that completes the order, if all on the way are good."),
};

constexpr std::array signalModes{
    entry(SignalMode::Off, "Off", CAMPANEL_TEXT("Protocol", "Off")),
    entry(SignalMode::On, "On", CAMPANEL_TEXT("Protocol", "On")),
    entry(SignalMode::Blink, "Blink", CAMPANEL_TEXT("Protocol", "Blinks"), "Half a second on, half off."),
    entry(SignalMode::BlinkThenOn, "BlinkThenOn", CAMPANEL_TEXT("Protocol", "Blinks, then on"),
          "Blinks until it is acknowledged."),
    entry(SignalMode::OnThenOff, "OnThenOff", CAMPANEL_TEXT("Protocol", "On, then off"),
          "On until it is acknowledged."),
};

constexpr std::array signalBits{
    entry(SignalBit::Fault, "Fault", CAMPANEL_TEXT("Protocol", "Fault")),
    entry(SignalBit::Warning, "Warning", CAMPANEL_TEXT("Protocol", "Warning"),
          "Any but NotHomed, FlashSlotInvalid and ClockNotSet, or an input refuses a start."),
    entry(SignalBit::Waiting, "Waiting", CAMPANEL_TEXT("Protocol", "Waiting"),
          "In a run: the film waits for a product, or the line for its encoder."),
    entry(SignalBit::Running, "Running", CAMPANEL_TEXT("Protocol", "Running"), "And nothing waits."),
    entry(SignalBit::Ready, "Ready", CAMPANEL_TEXT("Protocol", "Ready"),
          "There is a program; nothing moves and nothing is wrong."),
    entry(SignalBit::Order, "Order", CAMPANEL_TEXT("Protocol", "Order complete"),
          "Until the next start of an order or of a run."),
};

constexpr std::array ioBits{
    entry(IoBit::Inputs, "Inputs", "io.inputs."),
    entry(IoBit::Outputs, "Outputs", "io.outputs."),
    entry(IoBit::Infeed, "Infeed", "Position and following error of the infeed."),
    entry(IoBit::Torque, "Torque", "io.torque."),
    entry(
        IoBit::AxisKept, "AxisKept",
        "The position of the axis survives a power cut: the axis homes without a search for its index mark."),
    entry(
        IoBit::FilmKept, "FilmKept",
        "The position of the film motor survives. The film is believed only at its next mark all the same."),
    entry(IoBit::InfeedKept, "InfeedKept", "The position of the infeed motor survives."),
    entry(IoBit::Reversal, "Reversal",
          "The board can turn an axis the other way: signal.knife_reversed and those behind it."),
};

constexpr std::array inputBits = [] {
    std::array<EnumValue, inputRows.size()> values;
    std::ranges::transform(inputRows, values.begin(), &InputRow::value);
    return values;
}();

constexpr std::array markStates{
    entry(MarkState::Off, "Off", CAMPANEL_TEXT("Protocol", "Mark tracking off"),
          "Also before the first run."),
    entry(MarkState::Searching, "Searching", CAMPANEL_TEXT("Protocol", "Searching for marks"),
          "Waits for two marks one bag length apart."),
    entry(MarkState::Aligning, "Aligning", CAMPANEL_TEXT("Protocol", "Aligning cuts with marks"),
          "Shifts the film; these bags are off."),
    entry(MarkState::Tracking, "Tracking", CAMPANEL_TEXT("Protocol", "Tracking marks")),
};

constexpr std::array markVerdicts{
    entry(MarkVerdict::NotUsed, "NotUsed", "Mark tracking was off."),
    entry(MarkVerdict::Searched, "Searched", "One of the marks by which the search finds the print."),
    entry(MarkVerdict::Taken, "Taken", "It sets the place of a cut."),
    entry(MarkVerdict::OutsideWindow, "OutsideWindow",
          "Farther than parameter.mark_window from the expected position."),
    entry(MarkVerdict::TooNarrow, "TooNarrow", "Less wide than parameter.mark_width_min."),
    entry(MarkVerdict::TooWide, "TooWide", "Wider than parameter.mark_width_max."),
    entry(MarkVerdict::Masked, "Masked", "Nearer to the mark before than parameter.mark_masking."),
};

constexpr std::array jamStates{
    entry(JamState::Off, "Off", CAMPANEL_TEXT("Protocol", "Off"), "Also without a program of a cutter."),
    entry(JamState::NotReported, "NotReported", CAMPANEL_TEXT("Protocol", "The drive reports no torque"),
          "None, or always the same. The torque-limit input is monitored."),
    entry(JamState::TooSlow, "TooSlow", CAMPANEL_TEXT("Protocol", "The drive reports its torque too seldom"),
          "See jam.interval. The torque-limit input is monitored."),
    entry(JamState::Learning, "Learning", CAMPANEL_TEXT("Protocol", "Learning"),
          "Armed after jam.cycles_left more cycles at full speed. The torque-limit input is monitored."),
    entry(JamState::Armed, "Armed", CAMPANEL_TEXT("Protocol", "Monitored")),
};

constexpr std::array jamSources{
    entry(JamSource::None, "None", "No jam since power-up."),
    entry(JamSource::Torque, "Torque", "The torque left its band."),
    entry(JamSource::TorqueLimit, "TorqueLimit", "The torque-limit input was on."),
};

constexpr std::array gateStates{
    entry(GateState::Running, "Running", CAMPANEL_TEXT("Protocol", "following"),
          "The axis follows its master."),
    entry(GateState::Slowing, "Slowing", CAMPANEL_TEXT("Protocol", "decelerating"),
          "The axis stops at the end of the cycle."),
    entry(GateState::Standing, "Standing", CAMPANEL_TEXT("Protocol", "at standstill"),
          "The axis waits for whole cycles; a knife is open."),
    entry(GateState::CatchingUp, "CatchingUp", CAMPANEL_TEXT("Protocol", "accelerating"),
          "The axis is in phase again at bank.sync_start."),
};

constexpr std::array skipCauses{
    entry(SkipCause::None, "None", {}, "No cut was skipped."),
    entry(SkipCause::ProductAcross, "ProductAcross",
          CAMPANEL_TEXT("Protocol", "Product in the knife's path")),
    entry(SkipCause::ProductTooLong, "ProductTooLong",
          CAMPANEL_TEXT("Protocol", "Product longer than the bag"), "It is in the knife's path."),
    entry(SkipCause::NoProduct, "NoProduct", CAMPANEL_TEXT("Protocol", "Product missing"),
          "No film was used."),
};

constexpr std::array bagBits{
    entry(BagBit::Tracked, "Tracked", "The cut followed a mark."),
    entry(BagBit::MarkMissed, "MarkMissed", "Mark position estimated."),
    entry(BagBit::ProductAcross, "ProductAcross",
          "Longer by the cuts skipped for a product in the knife's path."),
    entry(BagBit::Empty, "Empty", "Cut without a product."),
    entry(BagBit::ChangeOver, "ChangeOver",
          "The program changed in this bag; its set length is between the lengths of both programs."),
    entry(BagBit::StartUp, "StartUp",
          "Start-up scrap: one of its cuts was made before the film was in register, after power-up, a jog "
          "or a change of length."),
    entry(BagBit::Burned, "Burned",
          "The jaws stood closed at one of its ends: for longer than parameter.jaws_closed_max, or at an "
          "emergency stop."),
    entry(BagBit::Jammed, "Jammed", "The jaws were stopped by a jam at one of its ends."),
    entry(BagBit::Taken, "Taken", "A person wanted it. Since map 1.6."),
};

constexpr std::array<EnumInfo, 46> infos{{
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
    {"MarkVerdict", markVerdicts},
    {"JamState", jamStates},
    {"JamSource", jamSources},
    {"GateState", gateStates},
    {"SkipCause", skipCauses},
    {"BagBit", bagBits},
    {"SwitchMode", switchModes},
    {"OutputBit", outputRows},
    {"DriveEnable", driveEnables},
    {"MasterPlace", masterPlaces},
    {"MasterSource", masterSources},
    {"MasterSignal", masterSignals},
    {"MasterState", masterStates},
    {"MeasuredAxis", measuredAxes},
    {"MeasureState", measureStates},
    {"OrderState", orderStates},
    {"OrderAction", orderActions},
    {"SignalMode", signalModes},
    {"SignalBit", signalBits},
    {"IoBit", ioBits},
    {"InputBit", inputBits},
    {"Contact", contacts},
    {"IndexContact", indexContacts},
}};

} // namespace

std::span<const EnumInfo> enumerations()
{
    return infos;
}

std::span<const EnumValue> valuesOf(std::string_view enumName)
{
    const auto info = std::ranges::find(infos, enumName, &EnumInfo::name);
    return info == infos.end() ? std::span<const EnumValue>() : info->values;
}

const EnumValue* findValue(std::string_view enumName, std::int64_t value)
{
    const auto values = valuesOf(enumName);
    const auto row = std::ranges::find(values, value, &EnumValue::value);
    return row == values.end() ? nullptr : &*row;
}

std::string enumName(std::string_view enumName, std::int64_t value)
{
    const EnumValue* row = findValue(enumName, value);
    return row ? std::string(row->name) : std::to_string(value);
}

std::string meaning(const EnumValue& value)
{
    std::string text(value.text);
    if (const std::size_t place = text.find("%1"); place != std::string::npos)
        text.replace(place, 2, value.number);
    if (!text.empty() && !text.ends_with('.')) { // a label
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        text += '.';
    }
    if (!text.empty() && !value.detail.empty())
        text += ' ';
    return text.append(value.detail);
}

std::string enumText(std::string_view enumName, std::int64_t value)
{
    const EnumValue* row = findValue(enumName, value);
    return row ? meaning(*row) : std::string();
}

} // namespace campanel::modbus
