// SPDX-License-Identifier: Apache-2.0
// Motor and shaft of a machine: on Run, on Motion, in the law picker, explained. And an axis that a cam moves
// on in every cycle.
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

namespace campanel::looks {

namespace {

using Situation = DemoLink::Situation;
using Kind = DemoLink::Kind;

// Enters a motor and a shaft.
void enterMotor(TestWindow& window)
{
    using profile::Field;
    panel::Editor& editor = window.panel().editor();
    editor.item(Field::Inertia)->set(20);
    editor.item(Field::Friction)->set(0.25);
    editor.item(Field::MaxTorque)->set(7.2);
    editor.item(Field::RatedTorque)->set(2.4);
    editor.item(Field::NaturalFrequency)->set(25);
}

Screen withMotor(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                enterMotor(window);
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

// Shows Run of a machine whose torque is predicted, at the angle of the demonstration's status.
Screen runWithTorque(const char* name, Kind kind)
{
    return {QString::fromLatin1(name), [kind](TestWindow& window) {
                window.link().show(Situation::Running, kind);
                window.checkClock();
                if (kind != Kind::RotaryCutter)
                    window.panel().editor().newProgram(static_cast<int>(kind));
                enterMotor(window);
                window.tap(QStringLiteral("nav_run"));
            }};
}

// Ends the edited cam beside its beginning, with the same cam closed in the controller, then taps.
Screen withAdvance(const char* name, double advanceMm, const QStringList& names)
{
    return {QString::fromLatin1(name), [advanceMm, names](TestWindow& window) {
                window.link().show(Situation::Running, Kind::PointCam);
                window.checkClock();
                panel::Editor& editor = window.panel().editor();
                editor.newProgram(static_cast<int>(Kind::PointCam));
                panel::KnotModel& knots = *editor.knots();
                knots.select(knots.count() - 1);
                editor.setChoice(0, 0); // natural ends: each knot for itself
                knots.slave()->set(advanceMm);
                editor.setChoice(0, 2);
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

// Shows Run of a progressive cam.
Screen runWithAdvance(const char* name)
{
    return {QString::fromLatin1(name), [](TestWindow& window) {
                window.link().show(Situation::Running, Kind::PointCam);
                program::Recipe recipe = program::defaultRecipe(Kind::PointCam);
                std::get<profile::PointCamProgram>(recipe.program).knots.back().slaveMm = -25.125;
                window.link().activate(*program::buildProgram(recipe), window.link().now());
                window.checkClock();
                window.tap(QStringLiteral("nav_run"));
            }};
}

} // namespace

QList<Screen> motorScreens()
{
    const auto motion = QStringLiteral("nav_motion");
    return {
        runWithTorque("run-torque", Kind::RotaryCutter),
        runWithTorque("run-torque-cam", Kind::PointCam),
        runWithAdvance("run-advance"),
        withAdvance("motion-advance", 25.125, {motion}),
        withAdvance("knots-advance", 25.125, {motion, QStringLiteral("knotsButton")}),
        withAdvance("download-advance", 25.125, {motion, QStringLiteral("nextStep")}),
        withAdvance("download-advance-confirmed", 25.125,
                    {motion, QStringLiteral("nextStep"), QStringLiteral("confirmAdvance")}),
        withAdvance("motion-closing-error", 0.4, {motion}),
        withMotor("laws-motor", {motion, QStringLiteral("lawButton")}),
        withMotor("motion-torque", {motion, QStringLiteral("more"), QStringLiteral("torqueSwitch"),
                                    QStringLiteral("sheetClose")}),
        {QStringLiteral("explanation-motor"),
         [=](TestWindow& window) {
             enterMotor(window);
             window.tap(motion);
             window.hold(QStringLiteral("verdictNumbers"));
         }},
        {QStringLiteral("motion-overheated"),
         [=](TestWindow& window) {
             enterMotor(window);
             window.panel().editor().item(profile::Field::RatedTorque)->set(0.2);
             window.tap(motion);
         }},
        {QStringLiteral("motion-resonance"),
         [=](TestWindow& window) {
             window.panel().editor().item(profile::Field::NaturalFrequency)->set(0.8);
             window.tap(motion);
         }},
    };
}

} // namespace campanel::looks
