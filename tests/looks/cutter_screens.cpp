// SPDX-License-Identifier: Apache-2.0
// A cutter with sealing jaws: the regime map, refusals of window and seal time, the seal time on Run.
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

namespace campanel::looks {

namespace {

using profile::Field;

constexpr double jawDeg = 20;
constexpr double sealMs = 40;

// Sets jaws, film, bag length and rate, then taps.
Screen withJaws(const char* name, double lengthMm, double rate, const QStringList& tapped)
{
    return {QString::fromLatin1(name), [=](TestWindow& window) {
                panel::Editor& editor = window.panel().editor();
                editor.item(Field::ContactAngle)->set(jawDeg);
                editor.minSealTime()->set(sealMs);
                editor.bagLength()->set(lengthMm);
                editor.rate()->set(rate);
                for (const QString& each : tapped)
                    window.tap(each);
            }};
}

// Lets an encoder of the line lead the machine, then taps.
Screen led(const char* name, const QStringList& tapped, DemoLink::Kind kind = DemoLink::Kind::RotaryCutter)
{
    return {QString::fromLatin1(name), [=](TestWindow& window) {
                window.link().setLed(true);
                window.link().show(DemoLink::Situation::Running, kind);
                window.checkClock();
                for (const QString& each : tapped)
                    window.tap(each);
            }};
}

Screen lineFaults()
{
    return {QStringLiteral("faults-line"), [](TestWindow& window) {
                window.link().setLed(true);
                window.link().setSimulated(true);
                for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance4"})
                    window.tap(QString::fromLatin1(name));
                panel::SimulatedFaults& faults = *window.panel().maintenance().simulatedFaults();
                const int last = faults.rows()->count() - 1;
                faults.setLevel(last - 4, panel::SimulatedFaults::Often); // the line
                faults.setLevel(last, panel::SimulatedFaults::Often);
                QMetaObject::invokeMethod(window.find(QStringLiteral("faultList")), "positionViewAtEnd");
            }};
}

} // namespace

QList<Screen> cutterScreens()
{
    const QString motion = QStringLiteral("nav_motion");
    const QString run = QStringLiteral("nav_run");
    const QStringList map{motion, QStringLiteral("more"), QStringLiteral("mapButton")};
    return {withJaws("map", 250, 60, map),
            withJaws("map-refused", 300, 250, map),
            withJaws("map-window", 100, 120, map),
            withJaws("motion-window", 100, 60, {motion}),
            withJaws("motion-seal-time", 250, 200, {motion}),
            {QStringLiteral("motion-no-jaws"),
             [=](TestWindow& window) {
                 window.panel().editor().minSealTime()->set(sealMs);
                 window.tap(motion);
             }},
            withJaws("run-seal-time", 250, 60, {run}),
            led("run-line", {run, QStringLiteral("packingRate")}),
            led("run-cam-line", {run}, DemoLink::Kind::PointCam),
            led("run-segments-line", {run, QStringLiteral("masterSpeed")}, DemoLink::Kind::SegmentCam),
            led("motion-line", {motion}),
            led("keypad-line", {motion, QStringLiteral("field_rate_bags_per_min")}),
            led("tools-line", {motion, QStringLiteral("more")}),
            led("map-line", map),
            {QStringLiteral("download-line"),
             [=](TestWindow& window) {
                 window.link().setLed(true);
                 window.tap(motion);
                 window.panel().editor().setChoice(0, 1);
             }},
            lineFaults()};
}

} // namespace campanel::looks
