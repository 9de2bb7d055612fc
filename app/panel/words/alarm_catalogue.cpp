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

// lupdate reads no macros but this one, so it is spelled out each time.
constexpr std::array kinds{
    AlarmKind{"C-01", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Axis does not follow"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The axis does not keep up with its command."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Look for a jam, then reset the fault and home.")},
    AlarmKind{"C-02", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Table damaged"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The table in the controller is damaged."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Reset the fault and download the recipe again.")},
    AlarmKind{"C-03", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "No index mark"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "No index mark was found while homing."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check drive and index sensor, then reset the fault.")},
    AlarmKind{
        "C-04", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Largest force reached"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The press reached its largest force, stopped and went back."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Look for a jam or a wrong work piece, then reset the fault.")},
    AlarmKind{"C-05", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Touched too early"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The press met something on its way down."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Check the work piece and the approach position, then reset the fault.")},
    AlarmKind{"C-06", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "No work piece"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The press did not feel a work piece."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Put one in or check where it must be touched, then reset the fault.")},
    AlarmKind{"C-07", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Master too fast"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The axis cannot follow this master: too many pulses."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Lower the master speed, then reset the fault.")},
    AlarmKind{
        "C-99", fault, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Unknown fault"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The controller tells of a fault that this panel does not know."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Update the panel. Until then look at the machine before you reset the fault.")},
    AlarmKind{"W-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Panel not heard"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The controller had not heard the panel for a while."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check the cable.")},
    AlarmKind{"W-02", notice, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Not homed"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The controller does not know where the axis stands."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Nothing needs to be done: Start homes first.")},
    AlarmKind{
        "W-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Saved copy damaged"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "One of the two saved copies in the controller is damaged."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Save the program again.")},
    AlarmKind{
        "W-04", notice, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Clock not set"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The controller has no time of day since it was switched on."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Nothing needs to be done: the panel sets it when it connects.")},
    AlarmKind{"W-99", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Unknown warning"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The controller tells of a warning that this panel does not know."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Update the panel.")},
    AlarmKind{"M-01", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Marks lost"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The marks on the film were lost and the run was ended."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check film and mark sensor, then start again.")},
    AlarmKind{"M-02", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Wrong mark distance"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The marks on the film are not one bag length apart, so the run was ended."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Load the right film or teach its marks under Service.")},
    AlarmKind{
        "M-03", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Correction at its limit"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The cuts could not follow the marks within the limits, so the run was ended."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Check the film's tension and whether it slips, then start again.")},
    AlarmKind{"M-04", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Product too long"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "A product is too long for the bag, so the run was ended."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Take it out or set a longer bag, then start again.")},
    AlarmKind{"M-05", warning, stops, QT_TRANSLATE_NOOP("AlarmCatalogue", "Too many cuts left out"),
              QT_TRANSLATE_NOOP(
                  "AlarmCatalogue",
                  "Products lay across the knife's path several times in a row, so the run was ended."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Put the products in order, then start again.")},
    AlarmKind{
        "L-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Port missing"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The port to the controller is not there."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Plug the adapter in, or choose another port in the settings.")},
    AlarmKind{"L-02", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "No answer"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "No response on the port to the controller."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check cable, power, baud rate, parity and unit number.")},
    AlarmKind{
        "L-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Connection lost"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The connection to the controller was there and broke off."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Check the cable and the controller's power; the panel reconnects by itself.")},
    AlarmKind{"L-04", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Wrong device"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "What answers on the port is not a controller that this panel knows."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Choose another port or unit number, or update the older of the two.")},
    AlarmKind{"L-05", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Port cannot be used"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The port to the controller is there and cannot be used."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Close the program that uses it, or choose another port or other settings.")},
    AlarmKind{"L-06", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Simulated controller missing"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "The simulated controller was not found or has ended."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Install it, or choose a real port in the settings.")},
    AlarmKind{
        "P-01", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Memory replaced by its copy"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The panel's memory was damaged or missing. It goes on with its last good copy."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Look whether the newest recipes are there. If it comes again, replace the disk.")},
    AlarmKind{
        "P-02", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Memory lost"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The panel's memory was damaged or missing and there was no copy. A new, empty database was created."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Restore a backup if there is one. If it comes again, replace the disk.")},
    AlarmKind{
        "P-03", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Memory not opened"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "The panel cannot open its memory: nothing is kept over a restart."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Read the detail, put it right and start the panel again.")},
    AlarmKind{
        "P-04", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Disk full"),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "There is no room left on the panel's disk: nothing new is kept."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Make room on the disk. What was kept before is not lost.")},
    AlarmKind{
        "P-05", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Disk write-protected"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The panel may not write to its disk: nothing new is kept."),
        QT_TRANSLATE_NOOP("AlarmCatalogue",
                          "Remove the write protection. If the disk protects itself, replace it.")},
    AlarmKind{"P-06", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Not kept"),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Something could not be kept in the panel's memory."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Read the detail and try again. If it comes again, start the panel again.")},
    AlarmKind{
        "P-07", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Recipe file"),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "The last recipe could not be read or not be kept."),
        QT_TRANSLATE_NOOP("AlarmCatalogue", "Read the detail; check the recipe before you download it.")},
    AlarmKind{"P-08", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Settings not kept"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The settings cannot be written: they hold until the panel is switched off."),
              QT_TRANSLATE_NOOP("AlarmCatalogue", "Check whether the disk is full or write-protected.")},
    AlarmKind{"P-09", warning, runsOn, QT_TRANSLATE_NOOP("AlarmCatalogue", "Users and PINs lost"),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "The users were lost with the panel's memory: only operators can work."),
              QT_TRANSLATE_NOOP("AlarmCatalogue",
                                "Read the detail: it names the file to delete. Then restore a backup.")},
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
    using modbus::FaultBit;
    switch (bit) {
    case FaultBit::FollowingError:
        return known("C-01");
    case FaultBit::ActiveTableDamaged:
        return known("C-02");
    case FaultBit::DriveNotFollowing:
        return known("C-03");
    case FaultBit::ForceLimit:
        return known("C-04");
    case FaultBit::TouchedTooEarly:
        return known("C-05");
    case FaultBit::NeverTouched:
        return known("C-06");
    case FaultBit::MasterTooFast:
        return known("C-07");
    }
    return unknownFault();
}

const AlarmKind& AlarmCatalogue::of(modbus::WarningBit bit)
{
    using modbus::WarningBit;
    switch (bit) {
    case WarningBit::HeartbeatLost:
        return known("W-01");
    case WarningBit::NotHomed:
        return known("W-02");
    case WarningBit::FlashSlotInvalid:
        return known("W-03");
    case WarningBit::ClockNotSet:
        return known("W-04");
    case WarningBit::MarksLost:
        return known("M-01");
    case WarningBit::MarkPitchWrong:
        return known("M-02");
    case WarningBit::CorrectionAtLimit:
        return known("M-03");
    case WarningBit::ProductTooLong:
        return known("M-04");
    case WarningBit::TooManySkips:
        return known("M-05");
    }
    return unknownWarning();
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
    case Kind::InUse:
        return known("P-03");
    case Kind::PinsLost:
        return known("P-09");
    case Kind::Full:
        return known("P-04");
    case Kind::ReadOnly:
        return known("P-05");
    case Kind::Damaged:
    case Kind::TrendsAnew:
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

} // namespace campanel::panel
