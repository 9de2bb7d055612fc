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

} // namespace

QList<Screen> cutterScreens()
{
    const QString motion = QStringLiteral("nav_motion");
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
            withJaws("run-seal-time", 250, 60, {QStringLiteral("nav_run")})};
}

} // namespace campanel::looks
