// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/command_rules.h"

namespace campanel::panel {

namespace {

using modbus::Refusal;
using modbus::State;

// Returns the refusal, in the order of the core's checks.
Refusal refusalToMove(const modbus::StatusBlock& status, Refusal whenMoving)
{
    if (status.state == State::Fault)
        return status.has(modbus::FaultBit::DriveAlarm) ? Refusal::DriveAlarm : Refusal::InFault;
    if (!status.activeCrc)
        return Refusal::NoActiveProgram;
    if (status.state != State::Ready)
        return whenMoving;
    return status.has(modbus::WarningBit::EmergencyStop) ? Refusal::EmergencyStop : Refusal::None;
}

} // namespace

Refusal expectedRefusal(const modbus::StatusBlock& status, modbus::Command command)
{
    switch (command) {
    case modbus::Command::Start:
        return refusalToMove(status, Refusal::AlreadyRunning);
    case modbus::Command::Home:
        return refusalToMove(status, Refusal::NotStandstill);
    case modbus::Command::ResetFault:
        return status.state == State::Fault ? Refusal::None : Refusal::NoFault;
    default:
        return Refusal::None;
    }
}

} // namespace campanel::panel
