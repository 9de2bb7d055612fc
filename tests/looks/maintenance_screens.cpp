// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

namespace campanel::looks {

namespace {

using Situation = DemoLink::Situation;
using Kind = DemoLink::Kind;

void openMachineSection(TestWindow& window, const char* section, Situation situation,
                        Kind kind = Kind::RotaryCutter)
{
    window.link().show(situation, kind);
    window.checkClock();
    // By way of another section, so that it opens as at first.
    for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceDryRun", section})
        window.tap(QString::fromLatin1(name));
}

Screen screen(const char* name, const char* section, Situation situation, Kind kind = Kind::RotaryCutter)
{
    return {QString::fromLatin1(name), [section, situation, kind](TestWindow& window) {
                openMachineSection(window, section, situation, kind);
            }};
}

// Opens a section with values from before the line was lost.
Screen oldValues(const char* name, const char* section)
{
    return {QString::fromLatin1(name), [section](TestWindow& window) {
                openMachineSection(window, section, Situation::Running);
                window.link().show(Situation::Lost);
                window.checkClock();
            }};
}

void tell(TestWindow& window, modbus::State state, std::uint16_t warningBits = 0)
{
    modbus::StatusBlock status = *window.panel().controller().status();
    status.state = state;
    status.warningBits = warningBits;
    emit window.link().statusReceived({{{window.link().now(), status}}, 0});
    window.settle();
}

// Opens the page of the axes; all have been measured but the film, which has no index sensor.
void openAxes(TestWindow& window)
{
    DemoLink& link = window.link();
    link.setParameter("parameter.film_pulses", 10'000);
    link.setParameter("parameter.film_feed", 150);
    link.setParameter("parameter.flight_pulses", 20'000);
    link.setParameter("signal.film_index_contact", 2);
    link.setMeasure({.state = modbus::MeasureState::Done,
                     .turns = 5,
                     .pulses = 10'237.4,
                     .spread = 6.5,
                     .bagPulses = 12'000.0,
                     .bag = 1234});
    link.show(Situation::Stopped);
    window.checkClock();
    for (const char* name : {"nav_settings", "section2", "openAxes"})
        window.tap(QString::fromLatin1(name));
}

// Opens the measurement of a row and leads it so far.
Screen axis(const char* name, int row, const std::function<void(TestWindow&)>& then = {})
{
    return {QString::fromLatin1(name), [row, then](TestWindow& window) {
                openAxes(window);
                window.tap(QStringLiteral("axes%1measure").arg(row));
                if (then)
                    then(window);
                window.settle();
            }};
}

// Opens the page of an encoder that leads, at this place, with its figures or its machine data.
Screen master(const char* name, bool isSetting, double place = 0)
{
    return {QString::fromLatin1(name), [isSetting, place](TestWindow& window) {
                window.link().setLed(true);
                window.link().setParameter("master.delay", 2);
                window.link().setParameter("master.place", place);
                openMachineSection(window, "maintenanceMaster", Situation::Running);
                if (isSetting)
                    window.tap(QStringLiteral("masterSetUp"));
            }};
}

// Opens the dry run of a new recipe of this kind, turned by this angle.
Screen dryRun(const char* name, Kind kind, double turnedDeg)
{
    return {QString::fromLatin1(name), [kind, turnedDeg](TestWindow& window) {
                openMachineSection(window, "maintenanceDryRun", Situation::Stopped);
                window.panel().editor().newProgram(static_cast<int>(kind));
                panel::DryRun& run = *window.panel().maintenance().dryRun();
                run.toStart();
                run.turn(turnedDeg);
            }};
}

} // namespace

QList<Screen> maintenanceScreens()
{
    constexpr auto notHomed =
        static_cast<std::uint16_t>(1U << static_cast<unsigned>(modbus::WarningBit::NotHomed));
    return {screen("jog", "maintenanceJog", Situation::Stopped),
            {QStringLiteral("jog-held"),
             [](TestWindow& window) {
                 openMachineSection(window, "maintenanceJog", Situation::Stopped);
                 window.panel().maintenance().jog()->press(1);
                 tell(window, modbus::State::Jogging);
             }},
            screen("jog-press", "maintenanceJog", Situation::Stopped, Kind::Press),
            screen("jog-blocked", "maintenanceJog", Situation::Running),
            screen("jog-empty", "maintenanceJog", Situation::Empty),
            oldValues("jog-lost", "maintenanceJog"),
            {QStringLiteral("jog-speed"),
             [](TestWindow& window) {
                 openMachineSection(window, "maintenanceJog", Situation::Stopped);
                 window.tap(QStringLiteral("jogSpeed"));
             }},
            screen("homing", "maintenanceHoming", Situation::Stopped),
            {QStringLiteral("homing-needed"),
             [=](TestWindow& window) {
                 openMachineSection(window, "maintenanceHoming", Situation::Stopped);
                 tell(window, modbus::State::Ready, notHomed);
             }},
            {QStringLiteral("homing-under-way"),
             [=](TestWindow& window) {
                 openMachineSection(window, "maintenanceHoming", Situation::Stopped);
                 tell(window, modbus::State::Homing, notHomed);
             }},
            {QStringLiteral("homing-failed"),
             [=](TestWindow& window) {
                 openMachineSection(window, "maintenanceHoming", Situation::Stopped);
                 tell(window, modbus::State::Homing, notHomed);
                 tell(window, modbus::State::Fault, notHomed);
             }},
            screen("homing-press", "maintenanceHoming", Situation::Stopped, Kind::Press),
            screen("homing-move", "maintenanceHoming", Situation::Stopped, Kind::PositionMove),
            screen("homing-empty", "maintenanceHoming", Situation::Empty),
            screen("io", "maintenanceIo", Situation::Running),
            {QStringLiteral("io-switches"),
             [=](TestWindow& window) {
                 openMachineSection(window, "maintenanceIo", Situation::Running);
                 window.tap(QStringLiteral("ioSwitches"));
                 window.tap(QStringLiteral("ioSwitch"));
                 window.tap(QStringLiteral("choice_3"));
             }},
            {QStringLiteral("io-contact"),
             [=](TestWindow& window) {
                 openMachineSection(window, "maintenanceIo", Situation::Running);
                 window.tap(QStringLiteral("ioSwitches"));
                 window.panel().maintenance().switches()->choose(11);
                 window.settle();
             }},
            screen("io-standstill", "maintenanceIo", Situation::Stopped),
            {QStringLiteral("io-held"),
             [](TestWindow& window) {
                 openMachineSection(window, "maintenanceIo", Situation::Stopped);
                 window.find(QStringLiteral("ioList"))->setProperty("contentY", 150);
                 window.panel().maintenance().outputTry()->press(0);
             }},
            screen("io-fault", "maintenanceIo", Situation::Fault),
            screen("io-press", "maintenanceIo", Situation::Stopped, Kind::Press),
            oldValues("io-lost", "maintenanceIo"),
            screen("io-empty", "maintenanceIo", Situation::Absent),
            master("master", false),
            master("master-wheel", false, 1),
            master("settings-master", true),
            master("settings-master-wheel", true, 1),
            {QStringLiteral("settings-master-empty"),
             [](TestWindow& window) {
                 window.link().show(Situation::Running);
                 for (const char* name : {"nav_settings", "section2", "openMaster"})
                     window.tap(QString::fromLatin1(name));
             }},
            {QStringLiteral("settings-axes"), &openAxes},
            {QStringLiteral("settings-machine-measure"),
             [](TestWindow& window) {
                 window.link().show(Situation::Stopped);
                 for (const char* name : {"nav_settings", "section2", "measureMainMotor", "axisLeave"})
                     window.tap(QString::fromLatin1(name));
             }},
            axis("axis-turns", 3),
            axis("axis-moving", 3,
                 [](TestWindow& window) {
                     window.link().setMeasure(
                         {.state = modbus::MeasureState::Moving, .turns = 3, .bagPulses = {}});
                     window.panel().maintenance().measurement()->start();
                 }),
            axis("axis-result", 3,
                 [](TestWindow& window) { window.panel().maintenance().measurement()->start(); }),
            axis("axis-direction", 1,
                 [](TestWindow& window) { window.panel().maintenance().measurement()->start(); }),
            axis("axis-film", 4),
            axis("axis-ended", 5,
                 [](TestWindow& window) {
                     window.link().setMeasure({.state = modbus::MeasureState::Ended,
                                               .reason = modbus::Refusal::DoorOpen,
                                               .bagPulses = {}});
                     window.panel().maintenance().measurement()->start();
                 }),
            screen("master-empty", "maintenanceMaster", Situation::Absent),
            dryRun("dry-run", Kind::RotaryCutter, 200),
            dryRun("dry-run-apart", Kind::RotaryCutter, 62.5),
            dryRun("dry-run-cam", Kind::PointCam, 135),
            dryRun("dry-run-press", Kind::Press, 180),
            dryRun("dry-run-move", Kind::PositionMove, 90)};
}

} // namespace campanel::looks
