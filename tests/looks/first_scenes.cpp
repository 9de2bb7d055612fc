// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/scene_lists.h"

#include "tests/looks/stage.h"

namespace campanel::looks {

namespace {

// Advances by this number of steps, then taps.
Scene step(const char* name, int steps, const QStringList& tapped = {})
{
    return {QString::fromLatin1(name), [steps, tapped](Stage& stage) {
                stage.link().show(DemoLink::Situation::Empty);
                stage.lookAtClock();
                stage.panel().settings().beginFirstStart();
                stage.settle();
                for (int i = 0; i < steps; ++i)
                    stage.tap(QStringLiteral("firstNext"));
                for (const QString& each : tapped)
                    stage.tap(each);
            }};
}

} // namespace

QList<Scene> firstScenes()
{
    return {step("first-language", 0),
            step("first-controller", 1),
            {QStringLiteral("first-controller-searching"),
             [](Stage& stage) {
                 step("", 1, {QStringLiteral("firstSearch")}).enter(stage);
                 stage.settle();
             }},
            step("first-pin", 2),
            step("first-pin-user", 2, {QStringLiteral("firstSetPin")}),
            step("first-machine", 3),
            step("first-machine-keypad", 3, {QStringLiteral("first_knifeRadius")}),
            step("first-recipe", 4),
            step("first-start-refused", 4, {QStringLiteral("startKey")})};
}

} // namespace campanel::looks
