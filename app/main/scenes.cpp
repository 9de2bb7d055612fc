// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel; see scenes.h.
#include "app/main/scenes.h"

namespace campanel::panel {
namespace {

using Situation = DemoLink::Situation;

// A tap on each name in turn; the navigation is "nav0" (Run), "nav1" (Motion), "nav2" (Settings).
Scene taps(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](Stage& stage) {
                for (const QString& tapped : names)
                    stage.tap(tapped);
            }};
}

Scene situation(const char* name, Situation situation, const QString& page)
{
    return {QString::fromLatin1(name), [situation, page](Stage& stage) {
                stage.link().show(situation);
                stage.lookAtClock();
                stage.tap(page);
            }};
}

Scene edited(const char* name, double bagLengthMm, const QStringList& names)
{
    return {QString::fromLatin1(name), [bagLengthMm, names](Stage& stage) {
                stage.panel().editor().bagLength()->set(bagLengthMm);
                for (const QString& tapped : names)
                    stage.tap(tapped);
            }};
}

} // namespace

const QList<Scene>& allScenes()
{
    const QString run = QStringLiteral("nav0");
    const QString motion = QStringLiteral("nav1");
    const QString settings = QStringLiteral("nav2");
    const QString length = QStringLiteral("field_bagLength");
    static const QList<Scene> scenes{
        taps("run", {run}),
        taps("motion", {motion}),
        taps("keypad", {motion, length}),
        {QStringLiteral("keypad-refusal"),
         [=](Stage& stage) {
             stage.tap(motion);
             stage.tap(length);
             stage.type(QStringLiteral("99999"));
         }},
        taps("keypad-ratios", {motion, QStringLiteral("ratios")}),
        {QStringLiteral("explanation"),
         [=](Stage& stage) {
             stage.tap(motion);
             stage.hold(QStringLiteral("field_baseSpeed"));
         }},
        taps("laws", {motion, QStringLiteral("lawButton")}),
        taps("tools", {motion, QStringLiteral("more")}),
        taps("table", {motion, QStringLiteral("more"), QStringLiteral("tableButton")}),
        edited("motion-edited", 320, {motion}),
        edited("download", 320, {motion, QStringLiteral("nextStep")}),
        edited("downloading", 320, {motion, QStringLiteral("nextStep"), QStringLiteral("downloadStart")}),
        {QStringLiteral("motion-refused"),
         [=](Stage& stage) {
             stage.panel().editor().bagLength()->set(1500);
             stage.tap(motion);
         }},
        {QStringLiteral("motion-limits"),
         [=](Stage& stage) {
             stage.panel().editor().rate()->set(390);
             stage.tap(motion);
         }},
        taps("settings-display", {settings, QStringLiteral("section0")}),
        taps("settings-connection", {settings, QStringLiteral("section1")}),
        {QStringLiteral("settings-serial"),
         [=](Stage& stage) {
             stage.panel().settings().setSimulated(false);
             stage.tap(settings);
             stage.tap(QStringLiteral("section1"));
         }},
        {QStringLiteral("ports"),
         [=](Stage& stage) {
             stage.panel().settings().setSimulated(false);
             stage.tap(settings);
             stage.tap(QStringLiteral("section1"));
             stage.tap(QStringLiteral("portButton"));
         }},
        taps("settings-machine", {settings, QStringLiteral("section2")}),
        taps("keypad-machine",
             {settings, QStringLiteral("section2"), QStringLiteral("field_maxAcceleration")}),
        taps("settings-about", {settings, QStringLiteral("section3")}),
        situation("run-stopped", Situation::Stopped, run),
        situation("run-empty", Situation::Empty, run),
        situation("run-fault", Situation::Fault, run),
        situation("run-lost", Situation::Lost, run),
        situation("motion-fault", Situation::Fault, motion),
        {QStringLiteral("motion-all-curves"),
         [=](Stage& stage) {
             for (const char* name : {"nav1", "more", "positionSwitch", "jerkSwitch", "sheetClose"})
                 stage.tap(QString::fromLatin1(name));
         }},
    };
    return scenes;
}

QList<Look> allLooks()
{
    QList<Look> looks;
    for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
        for (const char* theme : {"light", "dark"}) {
            for (const char* language : {"en", "zh_CN"})
                looks.append({QString::fromLatin1(language), QString::fromLatin1(theme), size});
        }
    }
    return looks;
}

void enterScene(Stage& stage, const Scene& scene)
{
    auto& editor = stage.panel().editor();
    stage.closeDialogs();
    editor.cancelDownload();
    while (editor.canUndo())
        editor.undo();
    stage.panel().settings().setSimulated(true);
    stage.link().show(Situation::Running);
    stage.lookAtClock();
    scene.enter(stage);
    stage.settle();
}

} // namespace campanel::panel
