// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/controller_sentences.h"

#include "app/panel/words/alarm_catalogue.h"

namespace campanel::panel {

using modbus::FaultBit;
using modbus::Refusal;
using modbus::State;
using modbus::TransferResult;
using modbus::WarningBit;

QString ControllerSentences::state(State state)
{
    switch (state) {
    case State::Idle:
        return tr("No program");
    case State::Ready:
        return tr("Ready");
    case State::Running:
        return tr("Running");
    case State::Stopping:
        return tr("Stopping");
    case State::Jogging:
        return tr("Jogging");
    case State::Homing:
        return tr("Homing");
    case State::Fault:
        return tr("Fault");
    }
    return {};
}

QStringList ControllerSentences::alarms(const modbus::StatusBlock& status)
{
    QStringList texts;
    for (const FaultBit bit :
         {FaultBit::FollowingError, FaultBit::ActiveTableDamaged, FaultBit::DriveNotFollowing,
          FaultBit::ForceLimit, FaultBit::TouchedTooEarly, FaultBit::NeverTouched, FaultBit::MasterTooFast}) {
        if (status.has(bit))
            texts << AlarmCatalogue::of(bit).sentence();
    }
    // NotHomed and ClockNotSet are normal after power-up.
    for (const WarningBit bit :
         {WarningBit::HeartbeatLost, WarningBit::FlashSlotInvalid, WarningBit::MarksLost,
          WarningBit::MarkPitchWrong, WarningBit::CorrectionAtLimit, WarningBit::ProductTooLong,
          WarningBit::TooManySkips}) {
        if (status.has(bit))
            texts << AlarmCatalogue::of(bit).sentence();
    }
    return texts;
}

QString ControllerSentences::refusal(Refusal reason)
{
    switch (reason) {
    case Refusal::None:
        return {};
    case Refusal::UnknownCommand:
        return tr("The controller does not know this command. Update its firmware.");
    case Refusal::NoActiveProgram:
        return tr("The controller has no program. Download a recipe first.");
    case Refusal::AlreadyRunning:
        return tr("The machine is already moving.");
    case Refusal::NotRunning:
        return tr("The machine is not running.");
    case Refusal::InFault:
        return tr("The controller is in fault. Reset the fault first.");
    case Refusal::NotStandstill:
        return tr("This is only possible at standstill. Stop the machine first.");
    case Refusal::NothingSealed:
        return tr("The controller holds no checked table. Download again.");
    case Refusal::WrongSession:
        return tr("Another download came in between. Download again.");
    case Refusal::WrongChecksum:
        return tr("The controller holds other bytes. Download again.");
    case Refusal::MachineDataDiffers:
        return tr("The data of the machine change only at standstill. Stop the machine first.");
    case Refusal::NotArmed:
        return tr("No change is waiting.");
    case Refusal::FlashFailed:
        return tr("The controller's flash could not be written; what was saved before is unchanged.");
    case Refusal::NoFault:
        return tr("There is no fault to reset.");
    case Refusal::BadArgument:
        return tr("The controller does not accept this value. Update the older of panel and controller.");
    case Refusal::FaultPersists:
        return tr("The cause of the fault is still there. Remove it first.");
    case Refusal::HeartbeatLost:
        return tr("The controller does not hear the panel. Check the cable.");
    case Refusal::SensorTooFar:
        return tr(
            "Too many bags lie between mark sensor and knife. Set a longer bag, move the sensor nearer, or "
            "switch mark tracking off under Service.");
    case Refusal::MarkWindowTooWide:
        return tr("The window for the marks is wider than half a bag. Make it narrower under Service.");
    case Refusal::NoRoomToCorrect:
        return tr(
            "Knife and film move together for so long that no time is left to correct the film. Change k1 "
            "to k4.");
    case Refusal::EyeTooNear:
        return tr(
            "The product eye is too near or too far to decide in time. Check its distance under Service.");
    case Refusal::FeedTooFast:
        return tr(
            "The film or the infeed would have to run faster than the controller can drive it. Lower the "
            "rate.");
    case Refusal::CommandIncomplete:
        return tr("Another device on the line writes commands in parts. Check what is connected.");
    }
    return tr("The controller gives a reason that this panel does not know (%1).")
        .arg(static_cast<int>(reason));
}

QString ControllerSentences::pressStage(modbus::PressStage stage)
{
    using modbus::PressStage;
    switch (stage) {
    case PressStage::Standing:
        return tr("Standing");
    case PressStage::Approach:
        return tr("Approach");
    case PressStage::Probe:
        return tr("Probe");
    case PressStage::Press:
        return tr("Press");
    case PressStage::Hold:
        return tr("Hold");
    case PressStage::Return:
        return tr("Return");
    }
    return {};
}

QString ControllerSentences::strokeResult(modbus::StrokeResult result)
{
    using modbus::StrokeResult;
    switch (result) {
    case StrokeResult::None:
        return {};
    case StrokeResult::Ok:
        return tr("OK");
    case StrokeResult::PositionOutside:
        return tr("Stopped outside the tolerance");
    case StrokeResult::ForceTooLow:
        return tr("Force too low");
    case StrokeResult::ForceTooHigh:
        return tr("Force too high");
    case StrokeResult::TouchedTooEarly:
        return tr("Touched too early");
    case StrokeResult::NeverTouched:
        return tr("Never touched");
    case StrokeResult::ForceLimit:
        return tr("Largest force reached");
    case StrokeResult::Stopped:
        return tr("Stopped");
    }
    return {};
}

QString ControllerSentences::markState(modbus::MarkState state)
{
    using modbus::MarkState;
    switch (state) {
    case MarkState::Off:
        return tr("Marks not followed");
    case MarkState::Searching:
        return tr("Looking for marks");
    case MarkState::Aligning:
        return tr("Moving the cuts onto the marks");
    case MarkState::Tracking:
        return tr("Following the marks");
    }
    return {};
}

QString ControllerSentences::skipCause(modbus::SkipCause cause)
{
    using modbus::SkipCause;
    switch (cause) {
    case SkipCause::None:
        return {};
    case SkipCause::ProductAcross:
        return tr("A product lay across the knife's path");
    case SkipCause::ProductTooLong:
        return tr("A product was longer than the bag");
    case SkipCause::NoProduct:
        return tr("A product was missing");
    }
    return {};
}

QString ControllerSentences::transferResult(const modbus::TransferAnswer& answer)
{
    switch (answer.result) {
    case TransferResult::None:
    case TransferResult::Accepted:
        return {};
    case TransferResult::WrongSession:
    case TransferResult::NotReceiving:
        return tr("Another download came in between. Download again.");
    case TransferResult::BadBlock:
    case TransferResult::BadLength:
    case TransferResult::BlocksMissing:
        return tr("Parts of the table did not arrive. Download again.");
    case TransferResult::WrongMapVersion:
    case TransferResult::KindNotSupported:
        return tr("Panel and controller do not match. Update the older of the two.");
    case TransferResult::BadHeader:
        return tr("Value %1 of the table's header is outside the controller's limits.").arg(answer.detail);
    case TransferResult::BadRow:
        return tr("Row %1 of the table is outside the range of the controller's timer. Lower the rate.")
            .arg(answer.detail);
    case TransferResult::BadSum:
        return tr("The rows do not add up to the announced pulses and time. Download again.");
    case TransferResult::StateRefuses:
        return tr("An earlier change is still waiting for the end of the cycle. Cancel it first.");
    }
    return {};
}

} // namespace campanel::panel
