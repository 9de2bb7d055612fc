// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/controller_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/alarm_catalogue.h"

#include <algorithm>
#include <cmath>

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
    for (const FaultBit bit : {FaultBit::FollowingError, FaultBit::ActiveTableDamaged,
                               FaultBit::DriveNotFollowing, FaultBit::ForceLimit, FaultBit::TouchedTooEarly,
                               FaultBit::NeverTouched, FaultBit::MasterTooFast, FaultBit::DriveAlarm}) {
        if (status.has(bit))
            texts << AlarmCatalogue::of(bit).sentence();
    }
    // NotHomed and ClockNotSet are normal after power-up.
    for (const WarningBit bit :
         {WarningBit::HeartbeatLost, WarningBit::FlashSlotInvalid, WarningBit::MarksLost,
          WarningBit::MarkPitchWrong, WarningBit::CorrectionAtLimit, WarningBit::ProductTooLong,
          WarningBit::TooManySkips, WarningBit::EmergencyStop}) {
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
        return tr("The controller does not support this command. Update its firmware.");
    case Refusal::NoActiveProgram:
        return tr("The controller has no program. Download a recipe first.");
    case Refusal::AlreadyRunning:
        return tr("The machine is already moving. Stop it first.");
    case Refusal::NotRunning:
        return tr("The machine is not running.");
    case Refusal::InFault:
        return tr("The controller is in fault. Reset the fault first.");
    case Refusal::NotStandstill:
        return tr("This is only possible at standstill. Stop the machine first.");
    case Refusal::NothingSealed:
        return tr("The controller has no checked table. Download again.");
    case Refusal::WrongSession:
        return tr("Another download interfered. Download again.");
    case Refusal::WrongChecksum:
        return tr("The controller received different data. Download again.");
    case Refusal::MachineDataDiffers:
        return tr("Machine data can only be changed at standstill. Stop the machine first.");
    case Refusal::NotArmed:
        return tr("No change is pending.");
    case Refusal::FlashFailed:
        return tr("Writing to the controller's flash failed; the saved program is unchanged. Save again.");
    case Refusal::NoFault:
        return tr("There is no fault to reset.");
    case Refusal::BadArgument:
        return tr("The controller does not accept this value. Update the older of panel and controller.");
    case Refusal::FaultPersists:
        return tr("The cause of the fault still exists. Remove it first.");
    case Refusal::HeartbeatLost:
        return tr("The controller receives no heartbeat from the panel. Check the cable.");
    case Refusal::SensorTooFar:
        return tr("There are too many bags between mark sensor and knife. Set a longer bag, move the sensor "
                  "closer, or switch off mark tracking under Maintenance.");
    case Refusal::MarkWindowTooWide:
        return tr("The mark window is wider than half a bag. Reduce it under Maintenance.");
    case Refusal::NoRoomToCorrect:
        return tr("The sync window is too long to correct the film. Change k1 to k4.");
    case Refusal::EyeTooNear:
        return tr("The product eye is too close or too far to decide in time. Check its distance under "
                  "Maintenance.");
    case Refusal::FeedTooFast:
        return tr("Film or infeed would exceed the controller's speed limit. Lower the rate.");
    case Refusal::CommandIncomplete:
        return tr("Another device on the line writes parts of commands. Check the connected devices.");
    case Refusal::StepTooLarge:
        return tr("The speed of an axis would change too abruptly. Stop the machine, then download; or raise "
                  "the largest speed steps under Maintenance.");
    case Refusal::Switch1LeadTooLong:
    case Refusal::Switch2LeadTooLong:
    case Refusal::Switch3LeadTooLong:
    case Refusal::Switch4LeadTooLong:
    case Refusal::Switch5LeadTooLong:
    case Refusal::Switch6LeadTooLong:
    case Refusal::Switch7LeadTooLong:
    case Refusal::Switch8LeadTooLong:
        return tr("The lead of cam switch %1 is longer than a cycle. Shorten it under Maintenance, or lower "
                  "the rate.")
            .arg(1 + static_cast<int>(reason) - static_cast<int>(Refusal::Switch1LeadTooLong));
    case Refusal::EmergencyStop:
        return tr("The emergency stop is pressed. Release it, then wait two seconds.");
    case Refusal::DriveAlarm:
        return tr("The drive reported an alarm. Remove its cause, then reset the fault.");
    case Refusal::NotWarm:
        return tr("The panel does not permit the start: the machine is not warm. Wait until it is warm.");
    case Refusal::WrongFilm:
        return tr("The panel does not permit the start with this film reel. Load and scan the right reel.");
    case Refusal::WrongRecipe:
        return tr("The panel does not permit the start with this program. Download the recipe again.");
    case Refusal::NotClean:
        return tr("The panel does not permit motion while the machine is cleaned. End the cleaning first.");
    case Refusal::PanelDisagrees:
        return tr("The panel does not permit the start. Read the reason at its Start button.");
    }
    return tr("The controller reports reason %1, which this panel does not know. Update the panel.")
        .arg(static_cast<int>(reason));
}

QString ControllerSentences::programChange(const program::ProgramChange& change, double rateBagsPerMin)
{
    const QString text = undisturbedChange(change, rateBagsPerMin);
    if (change.productWaitS <= 0)
        return text;
    return tr("%1 A product under the first cut adds %2 s.")
        .arg(text, Format().number(change.productWaitS, 1));
}

QString ControllerSentences::undisturbedChange(const program::ProgramChange& change, double rateBagsPerMin)
{
    constexpr double noSlower = 0.995;
    const Format format;
    const QString rate = format.number(rateBagsPerMin, 1);
    const QString seconds = format.number(change.timeS, 1);
    const QString time = change.productWaitS > 0 ? tr("at least %1 s").arg(seconds) : tr("%1 s").arg(seconds);
    const bool hasBags = rateBagsPerMin > 0;
    if (change.shareBefore >= noSlower && change.shareBehind >= noSlower)
        return tr("The machine keeps running; the new recipe starts with the next cycle.");
    if (change.shareBefore >= noSlower)
        return hasBags ? tr("The film keeps its speed; %1 bags/min after %2.").arg(rate, time)
                       : tr("The master keeps its speed; full speed after %1.").arg(time);
    const QString percent = format.number(100 * change.shareBefore, change.shareBefore < 0.1 ? 1 : 0);
    const QString count = QString::number(std::max(1L, std::lround(change.cycles)));
    return hasBags
               ? tr("Slows down to %1 % (bags: %2, %3), then %4 bags/min.").arg(percent, count, time, rate)
               : tr("Slows down to %1 % (cycles: %2, %3), then full speed.").arg(percent, count, time);
}

QString ControllerSentences::pressStage(modbus::PressStage stage)
{
    using modbus::PressStage;
    switch (stage) {
    case PressStage::Standing:
        return tr("At standstill");
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
        return tr("Stop position outside tolerance");
    case StrokeResult::ForceTooLow:
        return tr("Force too low");
    case StrokeResult::ForceTooHigh:
        return tr("Force too high");
    case StrokeResult::TouchedTooEarly:
        return tr("Contact too early");
    case StrokeResult::NeverTouched:
        return tr("No contact");
    case StrokeResult::ForceLimit:
        return tr("Max. force reached");
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
        return tr("Mark tracking off");
    case MarkState::Searching:
        return tr("Searching for marks");
    case MarkState::Aligning:
        return tr("Aligning cuts with marks");
    case MarkState::Tracking:
        return tr("Tracking marks");
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
        return tr("Product in the knife's path");
    case SkipCause::ProductTooLong:
        return tr("Product longer than the bag");
    case SkipCause::NoProduct:
        return tr("Product missing");
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
        return tr("Another download interfered. Download again.");
    case TransferResult::BadBlock:
    case TransferResult::BadLength:
    case TransferResult::BlocksMissing:
        return tr("Parts of the table are missing. Download again.");
    case TransferResult::WrongMapVersion:
    case TransferResult::KindNotSupported:
        return tr("Panel and controller do not match. Update the older device.");
    case TransferResult::BadHeader:
        return tr("Value %1 in the table header is outside the controller's limits. Correct the recipe.")
            .arg(answer.detail);
    case TransferResult::BadRow:
        return tr("Row %1 of the table is outside the range of the controller's timer. Lower the rate.")
            .arg(answer.detail);
    case TransferResult::BadSum:
        return tr("The table's rows do not match its total pulses and time. Download again.");
    case TransferResult::StateRefuses:
        return tr("An earlier change is waiting for the end of the cycle. Cancel it first.");
    case TransferResult::Busy:
        return tr("The controller has not finished checking or saving a table. Download again.");
    }
    return {};
}

} // namespace campanel::panel
