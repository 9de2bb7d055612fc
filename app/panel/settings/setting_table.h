// SPDX-License-Identifier: Apache-2.0
// Every setting, one row each: its place, form, default, level, label and sentence. The keys of both files,
// campanel.toml(5), the checks and the audit entries follow from the rows.
#pragma once

#include "app/panel/kit/access_check.h"

#include <QtGlobal>

#include <array>
#include <string_view>

namespace campanel::panel {

enum class SettingForm {
    Truth,    // true or false
    Word,     // one of the choices
    Language, // the code of a language; which ones are installed is known at run time
    Choice,   // a whole number, one of the choices
    Whole,    // a whole number of the range
    Decimal,  // a number of the range
    Port,     // an absolute path, or nothing
    File,     // an absolute path, or nothing
    Title,    // up to 64 printable characters, or nothing
    Name,     // up to 64 letters without those that have a meaning in MQTT topics, or nothing
    Host,     // name or address of a computer, as DNS has it, or nothing
    User,     // up to 256 printable characters, as MQTT has them, or nothing
    Prefix,   // up to 8 printable characters of ASCII but the space, or nothing
    Size,     // width and height of a window in pixels: "1024x600"
    Rules,    // rules for logging, one per line
    Times,    // times of the day: "06:00 14:00"
    Days,     // days of the week, 1: Monday: "12345"
    Reasons,  // reasons of a stop, one per line; empty: the standard ones
};

// The text of a value, and a remark below it in a list.
struct SettingWord {
    const char* text = nullptr;
    const char* note = nullptr;
};

struct SettingRow {
    std::string_view name;     // "section.key"; the key in campanel.toml
    std::string_view key = {}; // in the settings file; empty: it cannot be set on the panel
    SettingForm form = SettingForm::Truth;
    std::string_view choices = {}; // separated by spaces
    double minimum = 0;
    double maximum = 0;
    std::string_view standard = {}; // the default, as the settings file has it
    Level level = Level::Viewer;    // the lowest level that may change it
    const char* label = nullptr;    // in the audit trail; nullptr: it is not audited
    const char* help = nullptr;     // in campanel.toml and its man page; nullptr: it has no key there
    const char* title = nullptr;    // on the page; nullptr: the label
    // The texts of the choices in their order, or that of a number's 0; without: On and Off, or the value.
    std::array<SettingWord, 3> words = {};
    const char* shown = nullptr; // a number on the page, with its unit: "±%1"; one without a unit: "%1 min"
    const char* unit = nullptr;  // of a number that is entered, metric
    int decimals = 0;            // of a number
};

// In the order of campanel.toml.
inline constexpr std::array settingTable{
    SettingRow{.name = "connection.simulated",
               .key = "connection/simulated",
               .standard = "true",
               .level = Level::Technician,
               .help = "Use the simulated controller instead of a serial port. Without this key: false when "
                       "a port is named."},
    SettingRow{.name = "connection.port",
               .key = "connection/port",
               .form = SettingForm::Port,
               .level = Level::Technician,
               .help = "Serial port. /dev/campanel-serial is the USB adapter at any socket. With several "
                       "adapters use a path below /dev/serial/by-id."},
    SettingRow{.name = "connection.baud",
               .key = "connection/baud",
               .form = SettingForm::Choice,
               .choices = "9600 19200 38400 57600 115200",
               .standard = "115200",
               .level = Level::Technician,
               .help = "Baud rate.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Baud rate")},
    SettingRow{.name = "connection.parity",
               .key = "connection/parity",
               .form = SettingForm::Word,
               .choices = "N E O",
               .standard = "N",
               .level = Level::Technician,
               .help = "Parity: none, even or odd."},
    SettingRow{.name = "connection.stop_bits",
               .key = "connection/stop_bits",
               .form = SettingForm::Whole,
               .minimum = 1,
               .maximum = 2,
               .standard = "1",
               .level = Level::Technician,
               .help = "Stop bits."},
    // Modbus: 0 is broadcast, numbers above 247 are reserved.
    SettingRow{.name = "connection.unit",
               .key = "connection/unit",
               .form = SettingForm::Whole,
               .minimum = 1,
               .maximum = 247,
               .standard = "1",
               .level = Level::Technician,
               .help = "Modbus unit number of the controller.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Unit number")},
    SettingRow{.name = "display.language",
               .key = "language",
               .form = SettingForm::Language,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Language"),
               .help = "Language: en, or that of a file in a folder of languages, see campanel(1). Without "
                       "this key: the "
                       "language of the system, or English."},
    SettingRow{
        .name = "display.units",
        .key = "units",
        .form = SettingForm::Word,
        .choices = "metric inch",
        .standard = "metric",
        .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Units"),
        .help = "Units on the screen and in reports: metric (mm) or inch (in, in/s, ft). Recipes, "
                "registers, files, campanelctl and gateway stay metric.",
        .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "Metric"),
                    QT_TRANSLATE_NOOP("campanel::panel::Settings", "mm, mm/s, m/s²")},
                   {QT_TRANSLATE_NOOP("campanel::panel::Settings", "Inch"),
                    QT_TRANSLATE_NOOP("campanel::panel::Settings", "in, in/s, ft; files stay metric")}}}},
    SettingRow{.name = "display.theme",
               .key = "theme",
               .form = SettingForm::Word,
               .choices = "light dark contrast",
               .standard = "light",
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Theme"),
               .help = "Colors.",
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "Light")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "Dark")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "High contrast")}}}},
    SettingRow{.name = "display.gloves",
               .key = "gloves",
               .standard = "false",
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Glove mode"),
               .help = "Enlarge all keys by a quarter, for thick gloves."},
    SettingRow{.name = "display.size",
               .form = SettingForm::Size,
               .standard = "1024x600",
               .help = "Width and height of the window in pixels. The kiosk always fills the screen."},
    SettingRow{
        .name = "display.fullscreen", .standard = "false", .help = "Fill the screen of a desktop as well."},
    SettingRow{.name = "display.rotation",
               .key = "display/rotation",
               .form = SettingForm::Choice,
               .choices = "0 90 180 270",
               .standard = "0",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "screen rotation, degrees"),
               .help = "Rotation of the panel on its screen in degrees, clockwise. On a screen that is wider "
                       "than high 0 or 180, on another 90 or 270; a value that does not fit is replaced."},
    SettingRow{.name = "display.brightness",
               .key = "display/brightness",
               .form = SettingForm::Choice,
               .choices = "25 50 75 100",
               .standard = "100",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Brightness"),
               .shown = QT_TRANSLATE_NOOP("campanel::panel::Settings", "%1 %")},
    SettingRow{.name = "display.dark_after_minutes",
               .key = "display/dark_after_minutes",
               .form = SettingForm::Choice,
               .choices = "0 5 30",
               .standard = "0",
               .title =
                   QT_TRANSLATE_NOOP("campanel::panel::Settings", "Screen off without touch, at standstill"),
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "Never")}}},
               .shown = QT_TRANSLATE_NOOP("campanel::panel::Settings", "%1 min")},
    SettingRow{.name = "bags.tolerance_mm",
               .key = "bag_tolerance_mm",
               .form = SettingForm::Decimal,
               .minimum = 0.05,
               .maximum = 5,
               .standard = "0.5",
               .level = Level::Technician,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "bag tolerance, mm"),
               .help = "Largest deviation of a bag's length that is shown as good, in mm.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Bag tolerance"),
               .shown = QT_TRANSLATE_NOOP("campanel::panel::Settings", "±%1"),
               .unit = "mm",
               .decimals = 2},
    SettingRow{.name = "hand.trim_step_mm",
               .key = "hand/trim_step_mm",
               .form = SettingForm::Decimal,
               .minimum = 0.1,
               .maximum = 2,
               .standard = "0.5",
               .level = Level::Technician,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "step of a trim, mm"),
               .help = "By how much a touch moves cut, product or length on the Run page, in mm.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Step of a trim"),
               .unit = "mm",
               .decimals = 1},
    SettingRow{.name = "access.auto_logout_minutes",
               .key = "access/auto_logout_minutes",
               .form = SettingForm::Choice,
               .choices = "1 2 5 10 30",
               .standard = "5",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "minutes until logout"),
               .help = "Minutes without a touch until the user is logged out.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Log out after"),
               .shown = QT_TRANSLATE_NOOP("campanel::panel::Settings", "%1 min")},
    SettingRow{.name = "access.operators_log_in",
               .key = "access/operators_log_in",
               .standard = "false",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "operator login required"),
               .help = "Operators must log in. Without a login a person can only view and stop.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Without login")},
    SettingRow{.name = "access.hold_to_start",
               .key = "access/hold_to_start",
               .form = SettingForm::Word,
               .choices = "auto on off",
               .standard = "auto",
               .level = Level::Technician,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "hold to start"),
               .help = "Start acts only after its key was held for half a second. auto: with a real "
                       "controller.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Start key"),
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "Automatic"),
                           QT_TRANSLATE_NOOP("campanel::panel::Settings", "hold with a real controller")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "Hold for 0.5 s"),
                           QT_TRANSLATE_NOOP("campanel::panel::Settings",
                                             "an accidental touch does not start the machine")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "One touch")}}}},
    SettingRow{.name = "recipes.order",
               .key = "recipes/order",
               .form = SettingForm::Word,
               .choices = "date name use",
               .standard = "date",
               .help =
                   "Order of the recipes in their list: date (the one saved last first), name, or use (the "
                   "one downloaded last first).",
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "By date")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "By name")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "By last use")}}}},
    SettingRow{.name = "machine.name",
               .key = "machine/name",
               .form = SettingForm::Title,
               .level = Level::Technician,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "name of the machine"),
               .help = "Name of this machine in reports and in the names of their files. Empty: none.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Name of the machine")},
    SettingRow{.name = "scanner.prefix",
               .key = "scanner/prefix",
               .form = SettingForm::Prefix,
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "scanner prefix"),
               .help = "Characters that the code scanner sends before each code, which nobody types. Empty: "
                       "no scanner."},
    SettingRow{.name = "scanner.suffix",
               .key = "scanner/suffix",
               .form = SettingForm::Word,
               .choices = "enter tab",
               .standard = "enter",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "scanner suffix"),
               .help = "Key that the scanner sends after each code.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Suffix"),
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "Enter key")},
                          {QT_TRANSLATE_NOOP("campanel::panel::Settings", "Tab key")}}}},
    SettingRow{.name = "scanner.key_time_ms",
               .key = "scanner/key_time_ms",
               .form = SettingForm::Whole,
               .minimum = 10,
               .maximum = 1000,
               .standard = "100",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "time between scanned keys, ms"),
               .help = "Longest time between two keys of a code, in ms.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Time between keys"),
               .unit = "ms"},
    SettingRow{.name = "stops.ask_after_seconds",
               .key = "stops/ask_after_seconds",
               .form = SettingForm::Whole,
               .minimum = 1,
               .maximum = 3600,
               .standard = "60",
               .level = Level::Service,
               .label =
                   QT_TRANSLATE_NOOP("campanel::panel::Settings", "seconds of a stop until its question"),
               .help = "Seconds that the machine stands until the Run page asks for the reason.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Question after"),
               .unit = QT_TRANSLATE_NOOP("campanel::panel::Settings", "s")},
    SettingRow{.name = "stops.ideal_rate",
               .key = "stops/ideal_rate",
               .form = SettingForm::Decimal,
               .minimum = 0,
               .maximum = 2000,
               .standard = "0",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "ideal rate, pieces/min"),
               .help = "Ideal rate of the machine for its performance, in pieces per minute. 0: the fastest "
                       "rate of the recipe.",
               .title = QT_TRANSLATE_NOOP("campanel::panel::Settings", "Ideal rate"),
               .words = {{{QT_TRANSLATE_NOOP("campanel::panel::Settings", "by recipe")}}},
               .unit = QT_TRANSLATE_NOOP("campanel::panel::Settings", "pieces/min"),
               .decimals = 1},
    SettingRow{.name = "stops.shift_starts",
               .key = "stops/shift_starts",
               .form = SettingForm::Times,
               .standard = "06:00 14:00 22:00",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "start of the shifts"),
               .help = "Local times at which the shifts start."},
    SettingRow{.name = "stops.working_days",
               .key = "stops/working_days",
               .form = SettingForm::Days,
               .standard = "1234567",
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "working days"),
               .help =
                   "Days of the week whose shifts are planned, 1 is Monday. A shift belongs to the day on "
                   "which it starts."},
    SettingRow{.name = "stops.reasons",
               .key = "stops/reasons",
               .form = SettingForm::Reasons,
               .level = Level::Service,
               .label = QT_TRANSLATE_NOOP("campanel::panel::Settings", "reasons of a stop"),
               .help =
                   "Reasons of a stop: at most eight groups with at most eight reasons each. An empty list "
                   "stands for the standard reasons. The time of planned ones is not planned production "
                   "time."},
    SettingRow{.name = "log.rules",
               .form = SettingForm::Rules,
               .help = "What is logged in addition: a category and true or false each, with * for any part. "
                       "Categories: campanel.link, campanel.link.raw, campanel.motion, campanel.store, "
                       "campanel.ui."},
    SettingRow{.name = "kiosk.screen",
               .form = SettingForm::Word,
               .choices = "auto eglfs linuxfb",
               .standard = "auto",
               .help =
                   "How the kiosk draws: eglfs (graphics processor) or linuxfb (plain framebuffer). auto: "
                   "eglfs with a screen at a graphics card; linuxfb without one, or after eglfs has "
                   "ended without drawing."},
    SettingRow{.name = "gateway.host",
               .form = SettingForm::Host,
               .help = "Name or address of the MQTT broker to which campanel-gateway sends the values of the "
                       "machine. Empty: nothing is sent."},
    SettingRow{.name = "gateway.port",
               .form = SettingForm::Whole,
               .minimum = 1,
               .maximum = 65535,
               .standard = "8883",
               .help = "Port of the broker: 8883 with TLS, usually 1883 without."},
    SettingRow{.name = "gateway.ca",
               .form = SettingForm::File,
               .help = "Certificate of the authority that has signed the broker's, in PEM form. With it the "
                       "connection uses TLS; without it everybody on the network can read the values."},
    SettingRow{.name = "gateway.certificate",
               .form = SettingForm::File,
               .help = "Certificate of this machine, for a broker that asks for one; PEM."},
    SettingRow{.name = "gateway.key", .form = SettingForm::File, .help = "Key of this certificate; PEM."},
    SettingRow{.name = "gateway.group",
               .form = SettingForm::Name,
               .standard = "CamPanel",
               .help = "Sparkplug group: usually the hall or the line."},
    SettingRow{.name = "gateway.node",
               .form = SettingForm::Name,
               .help =
                   "Sparkplug node: the name of this machine, which no other one in the group has. Empty: "
                   "the name of the computer."},
    SettingRow{.name = "gateway.primary_host",
               .form = SettingForm::Name,
               .help = "Sparkplug primary host. While it is offline, values are kept instead of sent. Empty: "
                       "the broker is enough."},
    SettingRow{.name = "gateway.user",
               .form = SettingForm::User,
               .help = "User name for a broker that asks for one."},
    SettingRow{.name = "gateway.password_file",
               .form = SettingForm::File,
               .help = "File whose first line is the password of this user. Others must not be able to read "
                       "it: owner root, group campanel-gateway, mode 640."},
};

// A row of the table by its name. An unknown name does not compile.
class Setting {
public:
    consteval Setting(const char* name) // NOLINT(google-explicit-constructor): written as a text
        : m_row(find(name))
    {
    }
    constexpr Setting(const SettingRow& row) // NOLINT(google-explicit-constructor)
        : m_row(&row)
    {
    }

    constexpr const SettingRow* operator->() const { return m_row; }

private:
    static consteval const SettingRow* find(std::string_view name)
    {
        for (const SettingRow& row : settingTable) {
            if (row.name == name)
                return &row;
        }
        throw "no setting has this name";
    }

    const SettingRow* m_row;
};

} // namespace campanel::panel
