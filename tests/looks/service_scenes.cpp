// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/scene_lists.h"

#include "tests/looks/stage.h"

namespace campanel::looks {

namespace {

using Situation = DemoLink::Situation;
using Kind = DemoLink::Kind;

void openMachineSection(Stage& stage, const char* section, Situation situation,
                        Kind kind = Kind::RotaryCutter)
{
    stage.link().show(situation, kind);
    stage.lookAtClock();
    for (const char* name : {"nav_maintenance", "serviceMachine", section})
        stage.tap(QString::fromLatin1(name));
}

Scene scene(const char* name, const char* section, Situation situation, Kind kind = Kind::RotaryCutter)
{
    return {QString::fromLatin1(name), [section, situation, kind](Stage& stage) {
                openMachineSection(stage, section, situation, kind);
            }};
}

// Opens a section with values from before the line was lost.
Scene oldValues(const char* name, const char* section)
{
    return {QString::fromLatin1(name), [section](Stage& stage) {
                openMachineSection(stage, section, Situation::Running);
                stage.link().show(Situation::Lost);
                stage.lookAtClock();
            }};
}

void tell(Stage& stage, modbus::State state, std::uint16_t warningBits = 0)
{
    modbus::StatusBlock status = *stage.panel().machine().status();
    status.state = state;
    status.warningBits = warningBits;
    emit stage.link().statusReceived({{{stage.link().now(), status}}, 0});
    stage.settle();
}

// Opens the dry run of a new recipe of this kind, turned by this angle.
Scene dryRun(const char* name, Kind kind, double turnedDeg)
{
    return {QString::fromLatin1(name), [kind, turnedDeg](Stage& stage) {
                openMachineSection(stage, "serviceDryRun", Situation::Stopped);
                stage.panel().editor().newProgram(static_cast<int>(kind));
                panel::DryRun& run = *stage.panel().service().dryRun();
                run.toStart();
                run.turn(turnedDeg);
            }};
}

} // namespace

QList<Scene> serviceScenes()
{
    constexpr auto notHomed =
        static_cast<std::uint16_t>(1U << static_cast<unsigned>(modbus::WarningBit::NotHomed));
    return {scene("jog", "serviceJog", Situation::Stopped),
            {QStringLiteral("jog-held"),
             [](Stage& stage) {
                 openMachineSection(stage, "serviceJog", Situation::Stopped);
                 stage.panel().service().jog()->press(1);
                 tell(stage, modbus::State::Jogging);
             }},
            scene("jog-press", "serviceJog", Situation::Stopped, Kind::Press),
            scene("jog-blocked", "serviceJog", Situation::Running),
            scene("jog-empty", "serviceJog", Situation::Empty),
            oldValues("jog-lost", "serviceJog"),
            {QStringLiteral("jog-speed"),
             [](Stage& stage) {
                 openMachineSection(stage, "serviceJog", Situation::Stopped);
                 stage.tap(QStringLiteral("jogSpeed"));
             }},
            scene("homing", "serviceHoming", Situation::Stopped),
            {QStringLiteral("homing-needed"),
             [=](Stage& stage) {
                 openMachineSection(stage, "serviceHoming", Situation::Stopped);
                 tell(stage, modbus::State::Ready, notHomed);
             }},
            {QStringLiteral("homing-under-way"),
             [=](Stage& stage) {
                 openMachineSection(stage, "serviceHoming", Situation::Stopped);
                 tell(stage, modbus::State::Homing, notHomed);
             }},
            {QStringLiteral("homing-failed"),
             [=](Stage& stage) {
                 openMachineSection(stage, "serviceHoming", Situation::Stopped);
                 tell(stage, modbus::State::Homing, notHomed);
                 tell(stage, modbus::State::Fault, notHomed);
             }},
            scene("homing-press", "serviceHoming", Situation::Stopped, Kind::Press),
            scene("homing-move", "serviceHoming", Situation::Stopped, Kind::PositionMove),
            scene("homing-empty", "serviceHoming", Situation::Empty),
            scene("io", "serviceIo", Situation::Running),
            scene("io-fault", "serviceIo", Situation::Fault),
            scene("io-press", "serviceIo", Situation::Stopped, Kind::Press),
            oldValues("io-lost", "serviceIo"),
            scene("io-empty", "serviceIo", Situation::Absent),
            dryRun("dry-run", Kind::RotaryCutter, 200),
            dryRun("dry-run-apart", Kind::RotaryCutter, 62.5),
            dryRun("dry-run-cam", Kind::PointCam, 135),
            dryRun("dry-run-press", Kind::Press, 180),
            dryRun("dry-run-move", Kind::PositionMove, 90)};
}

} // namespace campanel::looks
