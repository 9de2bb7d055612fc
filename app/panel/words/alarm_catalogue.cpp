// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/alarm_catalogue.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>

namespace campanel::panel {

namespace {

constexpr auto notice = AlarmSeverity::Notice;
constexpr auto warning = AlarmSeverity::Warning;
constexpr auto fault = AlarmSeverity::Fault;
constexpr bool stops = true;
constexpr bool runsOn = false;

using modbus::FaultBit;
using modbus::WarningBit;

// Returns the text of the bit's row.
constexpr const char* causeOf(FaultBit bit)
{
    return modbus::faultBits[static_cast<std::size_t>(bit)].text.data();
}

constexpr const char* causeOf(WarningBit bit)
{
    return modbus::warningBits[static_cast<std::size_t>(bit)].text.data();
}

// lupdate reads no macros but this one, so it is spelled out each time.
constexpr std::array kinds{
    AlarmKind{"C-01", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Following error too large"),
              causeOf(FaultBit::FollowingError),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check for a jam, reset the fault, then start the reference run.")},
    AlarmKind{"C-02", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Table damaged"),
              causeOf(FaultBit::ActiveTableDamaged),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Reset the fault and download the recipe again.")},
    AlarmKind{"C-03", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "No index mark"),
              causeOf(FaultBit::DriveNotFollowing),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check drive and index sensor, then reset the fault.")},
    AlarmKind{
        "C-04", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Max. force reached"),
        causeOf(FaultBit::ForceLimit),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Check for a jam or a wrong workpiece, then reset the fault.")},
    AlarmKind{"C-05", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Contact too early"),
              causeOf(FaultBit::TouchedTooEarly),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the workpiece and the approach position, then reset the fault.")},
    AlarmKind{"C-06", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "No workpiece"),
              causeOf(FaultBit::NeverTouched),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Insert a workpiece or check the probe position, then reset the fault.")},
    AlarmKind{"C-07", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Master too fast"),
              causeOf(FaultBit::MasterTooFast),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Lower the master speed, then reset the fault.")},
    AlarmKind{"C-08", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Drive alarm"),
              causeOf(FaultBit::DriveAlarm),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Read the code on the drive and remove its cause, then reset the fault.")},
    AlarmKind{"C-09", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Jam at the jaws"),
              causeOf(FaultBit::Jam),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Take out what lies between the jaws, then reset the fault and start. The "
                                "machine goes on from there and rejects two bags.")},
    AlarmKind{"C-10", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Encoder signal disturbed"),
              causeOf(FaultBit::MasterSignal),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the cable and the shield of the encoder, then reset the fault.")},
    AlarmKind{"C-11", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Encoder counts lost"),
              causeOf(FaultBit::MasterCounts),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the encoder, its coupling and its cable, then reset the fault.")},
    AlarmKind{"C-12", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Wheel slips on the film"),
              causeOf(FaultBit::MasterSlip),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Clean the wheel and press it on the film, then reset the fault.")},
    AlarmKind{"C-13", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Impossible encoder speed"),
              causeOf(FaultBit::MasterSpeed),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the encoder and its counts per revolution, then reset the fault.")},
    AlarmKind{"C-14", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Master runs backward"),
              causeOf(FaultBit::MasterBackward),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Exchange wires A and B, or change the sign with Reversed counting under "
                                "Settings, Machine, Master, then reset the fault.")},
    AlarmKind{
        "C-99", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Unknown fault"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The controller reports a fault that this panel does not know."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Update the panel. Until then check the machine before you reset the fault.")},
    AlarmKind{"W-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "No panel heartbeat"),
              causeOf(WarningBit::HeartbeatLost), QT_TRANSLATE_NOOP("AlarmCatalogue", "Check the cable.")},
    AlarmKind{
        "W-02", notice, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Not referenced"),
        causeOf(WarningBit::NotHomed),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "No action required: Start begins with the reference run.")},
    AlarmKind{"W-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Saved copy damaged"),
              causeOf(WarningBit::FlashSlotInvalid),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Save the program again.")},
    AlarmKind{"W-04", notice, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Clock not set"),
              causeOf(WarningBit::ClockNotSet),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "No action required: the panel sets the clock when it connects.")},
    AlarmKind{"W-05", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Emergency stop pressed"),
              causeOf(WarningBit::EmergencyStop),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Make sure that the machine is safe, then release the emergency stop.")},
    AlarmKind{"W-06", notice, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Door open"),
              causeOf(WarningBit::DoorOpen),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Close the door, then start again.")},
    AlarmKind{"W-07", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Next machine not ready"),
              causeOf(WarningBit::NextMachine),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Clear the next machine, then start again.")},
    AlarmKind{"W-08", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Date coder not ready"),
              causeOf(WarningBit::Coder),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Clear the fault of the date coder or switch it on, then start again.")},
    AlarmKind{"W-99", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Unknown warning"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The controller reports a warning that this panel does not know."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Update the panel.")},
    AlarmKind{"M-01", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Marks lost"),
              causeOf(WarningBit::MarksLost),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check film and mark sensor, then start again.")},
    AlarmKind{
        "M-02", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Wrong mark distance"),
        causeOf(WarningBit::MarkPitchWrong),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Load the right film, or measure its marks and tell them from other prints under "
                          "Maintenance.")},
    AlarmKind{"M-03", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Correction limit reached"),
              causeOf(WarningBit::CorrectionAtLimit),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check the film for tension and slip, then start again.")},
    AlarmKind{
        "M-04", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Product too long"),
        causeOf(WarningBit::ProductTooLong),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Remove the product or set a longer bag, then start again.")},
    AlarmKind{"M-05", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Too many skipped cuts"),
              causeOf(WarningBit::TooManySkips),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Align the products, then start again.")},
    AlarmKind{"M-06", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Mark sensor has drifted"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The mark sensor's dead time is not the one entered: cuts "
                                                  "move on the print when the speed changes."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Clean and check the sensor. If the alarm stays, take over "
                                                  "the learned dead time under Maintenance, Packing.")},
    AlarmKind{"M-07", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Products joined"),
              causeOf(WarningBit::ProductsJoined),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Take the products off the infeed, then start again.")},
    AlarmKind{"M-08", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Jaws closed"),
              causeOf(WarningBit::JawsClosed),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Open them by hand. The bags on both sides are scrap.")},
    AlarmKind{"M-09", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Line too fast"),
              causeOf(WarningBit::MasterTooFast),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Slow the line down or download a faster program, then start again.")},
    AlarmKind{
        "L-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Port missing"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The port to the controller does not exist."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Plug the adapter in, or choose another port in the settings.")},
    AlarmKind{"L-02", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "No response"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "No response on the port to the controller."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check cable, power, baud rate, parity and unit number.")},
    AlarmKind{
        "L-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Connection lost"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The connection to the controller was interrupted."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Check the cable and the controller's power; the panel reconnects automatically.")},
    AlarmKind{"L-04", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Wrong device"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The device on the port is not a controller that this panel knows."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Choose another port or unit number, or update the older device.")},
    AlarmKind{
        "L-05", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Port not usable"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The port to the controller exists but cannot be used."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Close the program that uses the port, or choose another port or other settings.")},
    AlarmKind{
        "L-06", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Simulated controller missing"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The simulated controller was not found or has stopped."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Install the simulated controller, or choose a serial port in the settings.")},
    AlarmKind{"P-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Database replaced by its copy"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The panel's database was damaged or missing. The last good copy is used."),
              QT_TRANSLATE_NOOP(
                  "AlarmCatalogue",
                  "Check that the newest recipes are there. If this happens again, replace the disk.")},
    AlarmKind{
        "P-02", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Database lost"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The panel's database was damaged or missing and there was no "
                                            "copy. A new, empty database was created."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Restore a backup if there is one. If this happens again, replace the disk.")},
    AlarmKind{
        "P-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Database not opened"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The panel cannot open its database: new data are lost at a restart."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Read the detail, remove the cause and restart the panel.")},
    AlarmKind{"P-04", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Disk full"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The panel's disk is full: new data are not saved."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Free some disk space. Data saved before are not lost.")},
    AlarmKind{
        "P-05", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Disk write-protected"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The panel cannot write to its disk: new data are not saved."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Remove the write protection. If the disk protects itself, replace the disk.")},
    AlarmKind{"P-06", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Not saved"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Some data could not be saved in the panel's database."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Read the detail and try again. If this happens again, restart the panel.")},
    AlarmKind{
        "P-07", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Recipe file"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The last recipe could not be read or saved."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Read the detail; check the recipe before you download it.")},
    AlarmKind{
        "P-08", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Settings not saved"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The settings cannot be saved: they are lost when the panel is switched off."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Check for a full or write-protected disk.")},
    AlarmKind{
        "P-09", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Users and PINs lost"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The users were lost with the panel's database: only operators can work."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Delete the file named in the detail. Then restore a backup.")},
    AlarmKind{
        "P-10", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Settings file damaged"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The settings file was damaged or missing."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Read the detail; check the settings, the connection first.")},
    AlarmKind{"P-11", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Touchscreen missing"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "A touchscreen of this panel was unplugged or has failed."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the cable of the touchscreen. Stop the machine with its own switch.")},
    AlarmKind{"P-12", fault, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Data disk missing"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The disk with the panel's data cannot be used. Recipes, users and records "
                                "are missing, and new data are lost at a restart."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Replace the disk and restore a backup.")},
};

QString translated(const char* source)
{
    return QCoreApplication::translate("AlarmCatalogue", source);
}

// Returns the kind of an id from this file, which must exist.
const AlarmKind& known(std::string_view id)
{
    return *std::ranges::find(kinds, id, [](const AlarmKind& kind) { return std::string_view(kind.id); });
}

// Returns the kind whose cause is the text of the bit.
constexpr auto kindOf(const modbus::EnumValue& bit)
{
    return std::ranges::find(kinds, bit.text,
                             [](const AlarmKind& kind) { return std::string_view(kind.causeSource); });
}

constexpr bool hasKind(const modbus::EnumValue& bit)
{
    return kindOf(bit) != kinds.end();
}
static_assert(std::ranges::all_of(modbus::faultBits, hasKind));
static_assert(std::ranges::all_of(modbus::warningBits, hasKind));

} // namespace

QString AlarmKind::title() const
{
    return translated(titleSource);
}

QString AlarmKind::cause() const
{
    return translated(causeSource);
}

QString AlarmKind::action() const
{
    return translated(actionSource);
}

QString AlarmKind::sentence() const
{
    return QCoreApplication::translate("AlarmCatalogue", "%1 %2", "whole sentences: cause and what to do")
        .arg(cause(), action());
}

std::span<const AlarmKind> AlarmCatalogue::all()
{
    return kinds;
}

const AlarmKind* AlarmCatalogue::find(const QString& code)
{
    const auto* found =
        std::ranges::find_if(kinds, [&](const AlarmKind& kind) { return code == QLatin1String(kind.id); });
    return found == kinds.end() ? nullptr : found;
}

const AlarmKind& AlarmCatalogue::of(modbus::FaultBit bit)
{
    const auto index = static_cast<std::size_t>(bit);
    return index < modbus::faultBits.size() ? *kindOf(modbus::faultBits[index]) : unknownFault();
}

const AlarmKind& AlarmCatalogue::of(modbus::WarningBit bit)
{
    const auto index = static_cast<std::size_t>(bit);
    return index < modbus::warningBits.size() ? *kindOf(modbus::warningBits[index]) : unknownWarning();
}

const AlarmKind& AlarmCatalogue::unknownFault()
{
    return known("C-99");
}

const AlarmKind& AlarmCatalogue::unknownWarning()
{
    return known("W-99");
}

const AlarmKind* AlarmCatalogue::of(link::LinkState state)
{
    using link::LinkState;
    switch (state) {
    case LinkState::Connected:
        return nullptr;
    case LinkState::Searching:
        return &known("L-01");
    case LinkState::Connecting:
        return &known("L-02");
    case LinkState::Lost:
        return &known("L-03");
    case LinkState::WrongDevice:
        return &known("L-04");
    case LinkState::PortProblem:
        return &known("L-05");
    }
    return nullptr;
}

const AlarmKind& AlarmCatalogue::simulatorMissing()
{
    return known("L-06");
}

const AlarmKind& AlarmCatalogue::of(store::StoreError::Kind kind)
{
    using Kind = store::StoreError::Kind;
    switch (kind) {
    case Kind::CannotOpen:
    case Kind::NewerSchema:
    case Kind::Foreign:
    case Kind::InUse:
        return known("P-03");
    case Kind::DiskLost:
        return known("P-12");
    case Kind::PinsLost:
        return known("P-09");
    case Kind::Full:
        return known("P-04");
    case Kind::ReadOnly:
        return known("P-05");
    case Kind::Damaged:
    case Kind::TrendsAnew:
    case Kind::LastVersion:
    case Kind::Refused:
    case Kind::Failed:
        break;
    }
    return known("P-06");
}

const AlarmKind& AlarmCatalogue::memoryDamaged(bool isFromCopy)
{
    return known(isFromCopy ? "P-01" : "P-02");
}

const AlarmKind& AlarmCatalogue::recipeNotKept()
{
    return known("P-07");
}

const AlarmKind& AlarmCatalogue::settingsNotKept()
{
    return known("P-08");
}

const AlarmKind& AlarmCatalogue::settingsDamaged()
{
    return known("P-10");
}

const AlarmKind& AlarmCatalogue::touchscreenMissing()
{
    return known("P-11");
}

const AlarmKind& AlarmCatalogue::markSensorDrifted()
{
    return known("M-06");
}

} // namespace campanel::panel
