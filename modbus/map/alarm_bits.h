// SPDX-License-Identifier: Apache-2.0
// The faults and warnings of the controller: each bit with its name and sentence. A bit needs an alarm in
// app/panel/words/alarm_catalogue.cpp.
#pragma once

#include "modbus/map/enum_value.h"

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
    DriveAlarm = 7
};

inline constexpr std::array faultBits{
    entry(FaultBit::FollowingError, "FollowingError",
          "The axis lags more than parameter.following_error_limit."),
    entry(FaultBit::ActiveTableDamaged, "ActiveTableDamaged", "The active table no longer has its CRC-32."),
    entry(FaultBit::DriveNotFollowing, "DriveNotFollowing",
          "No index mark of the axis found within two revolutions of homing."),
    entry(FaultBit::ForceLimit, "ForceLimit",
          "The press reached its largest force; it stopped and returned."),
    entry(FaultBit::TouchedTooEarly, "TouchedTooEarly", "The press felt the work piece during the approach."),
    entry(FaultBit::NeverTouched, "NeverTouched",
          "The press did not feel the work piece where it should be."),
    entry(FaultBit::MasterTooFast, "MasterTooFast",
          "The cam asked for more pulses in one update than the output stage gives."),
    entry(FaultBit::DriveAlarm, "DriveAlarm", "The drive reported an alarm by its output."),
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
    EmergencyStop = 9
};

inline constexpr std::array warningBits{
    entry(WarningBit::HeartbeatLost, "HeartbeatLost",
          "The panel has not been heard for parameter.heartbeat_timeout."),
    entry(WarningBit::NotHomed, "NotHomed", "Where the axis stands is not known since power-up; home first."),
    entry(WarningBit::FlashSlotInvalid, "FlashSlotInvalid",
          "A flash slot had a wrong CRC-32 at power-up; the other was used."),
    entry(WarningBit::ClockNotSet, "ClockNotSet", "The clock has not been set since power-up."),
    entry(WarningBit::MarksLost, "MarksLost",
          "The run was ended: parameter.mark_missing_limit marks in a row did not come."),
    entry(WarningBit::MarkPitchWrong, "MarkPitchWrong",
          "The run was ended: the marks are not one bag length apart."),
    entry(WarningBit::CorrectionAtLimit, "CorrectionAtLimit",
          "The run was ended: five bags in a row needed more correction than the limits allow."),
    entry(WarningBit::ProductTooLong, "ProductTooLong",
          "The run was ended: a product with its clearance is longer than the bag."),
    entry(WarningBit::TooManySkips, "TooManySkips",
          "The run was ended: parameter.skip_limit cuts in a row were skipped for a product across."),
    entry(WarningBit::EmergencyStop, "EmergencyStop",
          "The emergency stop is pressed, or was within the last two seconds. It has ended any motion; no "
          "safety depends on that."),
};

} // namespace campanel::modbus
