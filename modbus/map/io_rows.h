// SPDX-License-Identifier: Apache-2.0
// The inputs and outputs of the controller: one row each. The controller's header, its document, the list on
// the panel, the names of the command line and of the simulated machine are made from these rows.
#pragma once

#include "modbus/map/enum_value.h"
#include "text/marked.h"

#include <algorithm>
#include <array>

namespace campanel::modbus {

// The bits of io.inputs.
enum class InputBit : std::uint16_t {
    DriveAlarm = 0,
    EmergencyStop,
    LimitForward,
    LimitReverse,
    IndexMark,
    MarkSensor,
    ProductEye,
    TorqueLimit,
    StartButton,
    StopButton,
    Door,
    NextMachine,
    Coder,
    BagButton,
    FilmIndex,
    InfeedIndex
};

// The bits of io.outputs, and from 16 on of io.more_outputs. Command TryOutput switches each of them on at
// standstill.
enum class OutputBit : std::uint16_t {
    Switch1 = 0,
    Switch2,
    Switch3,
    Switch4,
    Switch5,
    Switch6,
    Switch7,
    Switch8,
    DriveEnable,
    LineMayRun,
    TowerRed,
    TowerYellow,
    TowerGreen,
    Horn,
    Running,
    // Since io.more_outputs is there.
    Ready,
    Request,
    CoderPulse
};

// The origin of an input's level. A contact has the registers NAME_contact and NAME_filter in the group
// parameter or signal, and a person sets it on the simulated machine; the motion of the machine sets a
// sensor.
enum class InputSource { Contact, Sensor };

// The level of the pin that means on.
enum class Contact : std::uint16_t { NormallyOpen = 0, NormallyClosed = 1 };

inline constexpr std::array contacts{
    entry(Contact::NormallyOpen, "NormallyOpen", CAMPANEL_TEXT("Protocol", "NO contact"),
          "Normally open: closed means on."),
    entry(Contact::NormallyClosed, "NormallyClosed", CAMPANEL_TEXT("Protocol", "NC contact"),
          "Normally closed: open means on, as a broken wire does."),
};

// The same of the index mark of an axis that may have none.
enum class IndexContact : std::uint16_t { NormallyOpen = 0, NormallyClosed = 1, NotConnected = 2 };

inline constexpr std::array indexContacts{
    entry(IndexContact::NormallyOpen, "NormallyOpen", CAMPANEL_TEXT("Protocol", "NO contact"),
          "Normally open: closed means on."),
    entry(IndexContact::NormallyClosed, "NormallyClosed", CAMPANEL_TEXT("Protocol", "NC contact"),
          "Normally closed: open means on."),
    entry(IndexContact::NotConnected, "NotConnected", CAMPANEL_TEXT("Protocol", "None"),
          "Nothing is measured with it."),
};

struct InputRow {
    EnumValue value; // its detail is translated too
    InputSource source = InputSource::Contact;
};

inline constexpr std::array inputRows{
    InputRow{entry(InputBit::DriveAlarm, "DriveAlarm", CAMPANEL_TEXT("Protocol", "Drive alarm"),
                   CAMPANEL_TEXT("Protocol", "The drive reports an alarm. The controller goes into fault."))},
    InputRow{
        entry(InputBit::EmergencyStop, "EmergencyStop", CAMPANEL_TEXT("Protocol", "Emergency stop"),
              CAMPANEL_TEXT("Protocol", "Ends a motion and refuses others. No safety depends on this."))},
    InputRow{entry(InputBit::LimitForward, "LimitForward", CAMPANEL_TEXT("Protocol", "Limit switch, forward"),
                   CAMPANEL_TEXT("Protocol", "The axis is at its forward limit. Only displayed."))},
    InputRow{entry(InputBit::LimitReverse, "LimitReverse", CAMPANEL_TEXT("Protocol", "Limit switch, reverse"),
                   CAMPANEL_TEXT("Protocol", "The axis is at its reverse limit. Only displayed."))},
    InputRow{entry(InputBit::IndexMark, "IndexMark", CAMPANEL_TEXT("Protocol", "Index mark"),
                   CAMPANEL_TEXT("Protocol", "The axis is on its index mark.")),
             InputSource::Sensor},
    InputRow{entry(InputBit::MarkSensor, "MarkSensor", CAMPANEL_TEXT("Protocol", "Mark sensor"),
                   CAMPANEL_TEXT("Protocol", "A printed mark is under the sensor.")),
             InputSource::Sensor},
    InputRow{entry(InputBit::ProductEye, "ProductEye", CAMPANEL_TEXT("Protocol", "Product eye"),
                   CAMPANEL_TEXT("Protocol", "A product covers the eye.")),
             InputSource::Sensor},
    InputRow{entry(
        InputBit::TorqueLimit, "TorqueLimit", CAMPANEL_TEXT("Protocol", "Torque limit"),
        CAMPANEL_TEXT("Protocol", "The drive is at its torque limit. While the jaws close, this is a jam."))},
    InputRow{
        entry(InputBit::StartButton, "StartButton", CAMPANEL_TEXT("Protocol", "Start button"),
              CAMPANEL_TEXT("Protocol", "Starts a run when it is pressed, as Start on the panel does."))},
    InputRow{entry(InputBit::StopButton, "StopButton", CAMPANEL_TEXT("Protocol", "Stop button"),
                   CAMPANEL_TEXT("Protocol", "Ends a run at the end of its cycle and refuses a start."))},
    InputRow{entry(
        InputBit::Door, "Door", CAMPANEL_TEXT("Protocol", "Door open"),
        CAMPANEL_TEXT("Protocol", "Ends a run at once and refuses a start. No safety depends on this."))},
    InputRow{entry(InputBit::NextMachine, "NextMachine", CAMPANEL_TEXT("Protocol", "Next machine not ready"),
                   CAMPANEL_TEXT("Protocol", "Ends a run at the end of its cycle and refuses a start."))},
    InputRow{entry(InputBit::Coder, "Coder", CAMPANEL_TEXT("Protocol", "Date coder not ready"),
                   CAMPANEL_TEXT("Protocol", "Ends a run at the end of its cycle and refuses a start."))},
    InputRow{entry(InputBit::BagButton, "BagButton", CAMPANEL_TEXT("Protocol", "One-bag button"),
                   CAMPANEL_TEXT("Protocol", "Makes one bag when it is pressed at standstill."))},
    InputRow{entry(InputBit::FilmIndex, "FilmIndex", CAMPANEL_TEXT("Protocol", "Film index"),
                   CAMPANEL_TEXT("Protocol", "On once per turn of the film motor. For measuring it."))},
    InputRow{entry(InputBit::InfeedIndex, "InfeedIndex", CAMPANEL_TEXT("Protocol", "Infeed index"),
                   CAMPANEL_TEXT("Protocol", "On once per product of the infeed. For measuring it."))},
};

constexpr EnumValue camSwitchRow(OutputBit bit, std::string_view name, std::string_view number)
{
    return entry(bit, name, CAMPANEL_TEXT("Protocol", "Cam switch %1"),
                 CAMPANEL_TEXT("Protocol", "On by the angle of the cycle, or for a rejected bag."), number);
}

constexpr EnumValue towerRow(OutputBit bit, std::string_view name, std::string_view text)
{
    return entry(bit, name, text,
                 CAMPANEL_TEXT("Protocol", "On or blinking by the table of the light tower."));
}

inline constexpr std::array outputRows{
    camSwitchRow(OutputBit::Switch1, "Switch1", "1"),
    camSwitchRow(OutputBit::Switch2, "Switch2", "2"),
    camSwitchRow(OutputBit::Switch3, "Switch3", "3"),
    camSwitchRow(OutputBit::Switch4, "Switch4", "4"),
    camSwitchRow(OutputBit::Switch5, "Switch5", "5"),
    camSwitchRow(OutputBit::Switch6, "Switch6", "6"),
    camSwitchRow(OutputBit::Switch7, "Switch7", "7"),
    camSwitchRow(OutputBit::Switch8, "Switch8", "8"),
    entry(OutputBit::DriveEnable, "DriveEnable", CAMPANEL_TEXT("Protocol", "Drive enable"),
          CAMPANEL_TEXT("Protocol", "Enables the drives of all axes.")),
    entry(OutputBit::LineMayRun, "LineMayRun", CAMPANEL_TEXT("Protocol", "Line may run"),
          CAMPANEL_TEXT("Protocol", "On while the knife follows the encoder on the film, or waits for it.")),
    towerRow(OutputBit::TowerRed, "TowerRed", CAMPANEL_TEXT("Protocol", "Light tower, red")),
    towerRow(OutputBit::TowerYellow, "TowerYellow", CAMPANEL_TEXT("Protocol", "Light tower, yellow")),
    towerRow(OutputBit::TowerGreen, "TowerGreen", CAMPANEL_TEXT("Protocol", "Light tower, green")),
    towerRow(OutputBit::Horn, "Horn", CAMPANEL_TEXT("Protocol", "Horn")),
    entry(OutputBit::Running, "Running", CAMPANEL_TEXT("Protocol", "Machine runs"),
          CAMPANEL_TEXT("Protocol", "On from the start of a run to its standstill.")),
    entry(OutputBit::Ready, "Ready", CAMPANEL_TEXT("Protocol", "Ready to start"),
          CAMPANEL_TEXT("Protocol", "On at standstill while nothing refuses a start.")),
    entry(OutputBit::Request, "Request", CAMPANEL_TEXT("Protocol", "Product request"),
          CAMPANEL_TEXT("Protocol", "On in a run while the place at the product eye is free.")),
    entry(OutputBit::CoderPulse, "CoderPulse", CAMPANEL_TEXT("Protocol", "Date coder pulse"),
          CAMPANEL_TEXT("Protocol", "One pulse for each product, at its place before the cut.")),
};

} // namespace campanel::modbus
