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

// One bag, or one cut, begins where the knife is in its place.
Refusal refusalByHand(const modbus::StatusBlock& status)
{
    const Refusal refusal = refusalToMove(status, Refusal::AlreadyRunning);
    return refusal == Refusal::None && status.has(modbus::WarningBit::NotHomed) ? Refusal::NotInPhase
                                                                                : refusal;
}

} // namespace

Refusal expectedRefusal(const modbus::StatusBlock& status, modbus::Command command)
{
    switch (command) {
    case modbus::Command::Start:
        return refusalToMove(status, Refusal::AlreadyRunning);
    case modbus::Command::JogBag:
    case modbus::Command::SingleCut:
        return refusalByHand(status);
    case modbus::Command::TakeBag:
        if (!status.activeCrc)
            return Refusal::NoBags;
        return status.state == State::Running || status.state == State::Stopping ? Refusal::None
                                                                                 : Refusal::NotRunning;
    case modbus::Command::Home:
    case modbus::Command::Measure:
        return refusalToMove(status, Refusal::NotStandstill);
    case modbus::Command::ResetFault:
        return status.state == State::Fault ? Refusal::None : Refusal::NoFault;
    default:
        return Refusal::None;
    }
}

} // namespace campanel::panel
