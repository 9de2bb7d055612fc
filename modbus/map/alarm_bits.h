// SPDX-License-Identifier: Apache-2.0
// The faults and warnings of the controller: each bit with its name and sentence, the cause of its alarm in
// app/panel/words/alarm_catalogue.cpp.
#pragma once

#include "modbus/map/enum_value.h"
#include "text/marked.h"

#include <array>

namespace campanel::modbus {

// The bits of status.fault.
enum class FaultBit : std::uint16_t {
    FollowingError = 0,
    ActiveTableDamaged = 1,
    DriveNotFollowing = 2,
    ForceLimit = 3,
    TouchedTooEarly = 4,
    NeverTouched = 5,
    MasterTooFast = 6,
    DriveAlarm = 7,
    Jam = 8,
    MasterSignal = 9,
    MasterCounts = 10,
    MasterSlip = 11,
    MasterSpeed = 12,
    MasterBackward = 13
};

inline constexpr std::array faultBits{
    entry(FaultBit::FollowingError, "FollowingError",
          CAMPANEL_TEXT("AlarmCatalogue", "The axis cannot follow its setpoint."),
          "The following error is above parameter.following_error_limit."),
    entry(FaultBit::ActiveTableDamaged, "ActiveTableDamaged",
          CAMPANEL_TEXT("AlarmCatalogue", "The table in the controller is damaged."), "Its CRC-32 is wrong."),
    entry(FaultBit::DriveNotFollowing, "DriveNotFollowing",
          CAMPANEL_TEXT("AlarmCatalogue", "No index mark was found in the reference run."),
          "The search covers two revolutions."),
    entry(FaultBit::ForceLimit, "ForceLimit",
          CAMPANEL_TEXT("AlarmCatalogue", "The press reached the maximum force, stopped and returned.")),
    entry(FaultBit::TouchedTooEarly, "TouchedTooEarly",
          CAMPANEL_TEXT("AlarmCatalogue", "The press touched an object during the approach.")),
    entry(FaultBit::NeverTouched, "NeverTouched",
          CAMPANEL_TEXT("AlarmCatalogue", "The press did not detect a workpiece."),
          "There was no contact before the end of the probe stage."),
    entry(
        FaultBit::MasterTooFast, "MasterTooFast",
        CAMPANEL_TEXT("AlarmCatalogue",
                      "The axis cannot follow the master: the pulse frequency is too high."),
        "The cam needed more pulses in one update than the output stage generates, or the encoder that leads "
        "the line was a quarter above master.speed_max."),
    entry(FaultBit::DriveAlarm, "DriveAlarm",
          CAMPANEL_TEXT("AlarmCatalogue", "The drive of the axis reports an alarm.")),
    entry(FaultBit::Jam, "Jam", CAMPANEL_TEXT("AlarmCatalogue", "Something is under the closing jaws."),
          "The knife has stopped and gone back by parameter.jam_back. The film keeps its place: a start goes "
          "on from there."),
    entry(FaultBit::MasterSignal, "MasterSignal",
          CAMPANEL_TEXT("AlarmCatalogue", "The signal of the encoder that leads the line is disturbed."),
          "A and B changed at once."),
    entry(FaultBit::MasterCounts, "MasterCounts",
          CAMPANEL_TEXT("AlarmCatalogue", "The encoder that leads the line has lost or gained counts."),
          "Its index mark was off its place by more than master.index_limit."),
    entry(FaultBit::MasterSlip, "MasterSlip",
          CAMPANEL_TEXT("AlarmCatalogue", "The wheel of the encoder slips on the film."),
          "A mark was off its place by the wheel by more than master.slip_limit."),
    entry(FaultBit::MasterSpeed, "MasterSpeed",
          CAMPANEL_TEXT("AlarmCatalogue",
                        "The encoder that leads the line reports a speed that no machine has."),
          "More than four times that of the program, or a jump of its counts."),
    entry(FaultBit::MasterBackward, "MasterBackward",
          CAMPANEL_TEXT("AlarmCatalogue", "The master runs backward by more than a cycle."),
          "A run that may not go back (a cutter, or master.backward 0) waited for the encoder so far."),
};

// The bits of status.warning.
enum class WarningBit : std::uint16_t {
    HeartbeatLost = 0,
    NotHomed = 1,
    FlashSlotInvalid = 2,
    ClockNotSet = 3,
    // The reasons for the end of a run of the packing machine; valid until the next start.
    MarksLost = 4,
    MarkPitchWrong = 5,
    CorrectionAtLimit = 6,
    ProductTooLong = 7,
    TooManySkips = 8,
    EmergencyStop = 9,
    ProductsJoined = 10, // it ends a run, too
    JawsClosed = 11,
    MasterTooFast = 12, // it ends a run, too
    // While the input is on; each ends a run, too.
    DoorOpen = 13,
    NextMachine = 14,
    Coder = 15
};

inline constexpr std::array warningBits{
    entry(
        WarningBit::HeartbeatLost, "HeartbeatLost",
        CAMPANEL_TEXT("AlarmCatalogue", "The controller received no heartbeat from the panel for some time."),
        "The time is parameter.heartbeat_timeout."),
    entry(WarningBit::NotHomed, "NotHomed",
          CAMPANEL_TEXT("AlarmCatalogue", "The controller does not know the position of the axis."),
          "Not homed since power-up."),
    entry(WarningBit::FlashSlotInvalid, "FlashSlotInvalid",
          CAMPANEL_TEXT("AlarmCatalogue", "One of the two saved copies in the controller is damaged."),
          "It had a wrong CRC-32 at power-up; the other one was used."),
    entry(WarningBit::ClockNotSet, "ClockNotSet",
          CAMPANEL_TEXT("AlarmCatalogue", "The controller has had no time of day since power-on.")),
    entry(WarningBit::MarksLost, "MarksLost",
          CAMPANEL_TEXT("AlarmCatalogue", "The controller lost the marks on the film and stopped the run."),
          "parameter.mark_missing_limit consecutive marks were missing."),
    entry(
        WarningBit::MarkPitchWrong, "MarkPitchWrong",
        CAMPANEL_TEXT("AlarmCatalogue",
                      "The mark distance on the film differs from the bag length, so the run was stopped.")),
    entry(WarningBit::CorrectionAtLimit, "CorrectionAtLimit",
          CAMPANEL_TEXT("AlarmCatalogue",
                        "The correction limits were too small to follow the marks, so the run was stopped."),
          "Five consecutive bags needed more correction than the limits allow."),
    entry(WarningBit::ProductTooLong, "ProductTooLong",
          CAMPANEL_TEXT("AlarmCatalogue", "A product is longer than the bag, so the run was stopped."),
          "The length includes its clearance."),
    entry(WarningBit::TooManySkips, "TooManySkips",
          CAMPANEL_TEXT("AlarmCatalogue",
                        "Products blocked the knife several times in a row, so the run was stopped."),
          "parameter.skip_limit consecutive cuts were skipped."),
    entry(
        WarningBit::EmergencyStop, "EmergencyStop",
        CAMPANEL_TEXT("AlarmCatalogue", "The emergency stop of the machine is pressed."),
        "The bit stays set for two seconds after the release. It has ended any motion; no safety depends on "
        "that."),
    entry(
        WarningBit::ProductsJoined, "ProductsJoined",
        CAMPANEL_TEXT("AlarmCatalogue", "Two products hang together on the infeed, so the run was stopped."),
        "One was longer than parameter.product_length_max at the eye. Its bag is marked as empty."),
    entry(WarningBit::JawsClosed, "JawsClosed",
          CAMPANEL_TEXT("AlarmCatalogue", "The jaws have been closed on standing film for too long."),
          "Longer than parameter.jaws_closed_max, and still are."),
    entry(WarningBit::MasterTooFast, "MasterTooFast",
          CAMPANEL_TEXT("AlarmCatalogue",
                        "The line became faster than the program allows, so the run was stopped."),
          "It was above master.speed_max."),
    entry(WarningBit::DoorOpen, "DoorOpen", CAMPANEL_TEXT("AlarmCatalogue", "A door of the machine is open."),
          "Input Door. It has ended a run; no safety depends on that."),
    entry(WarningBit::NextMachine, "NextMachine",
          CAMPANEL_TEXT("AlarmCatalogue", "The machine behind this one is not ready."), "Input NextMachine."),
    entry(WarningBit::Coder, "Coder", CAMPANEL_TEXT("AlarmCatalogue", "The date coder is not ready."),
          "Input Coder."),
};

} // namespace campanel::modbus
