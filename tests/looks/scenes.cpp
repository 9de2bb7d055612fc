// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel; see scenes.h.
#include "tests/looks/scenes.h"

#include "tests/looks/scene_lists.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace campanel::looks {
namespace {

using Situation = DemoLink::Situation;
using Kind = DemoLink::Kind;

// Taps each name in turn; the navigation is "nav_run" (Run), "nav_motion" (Motion), "nav_settings"
// (Settings), "nav_maintenance" (Service), "nav_alarms" (Alarms).
Scene taps(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](Stage& stage) {
                for (const QString& tapped : names)
                    stage.tap(tapped);
            }};
}

// Opens the explanation of an item by a held finger.
Scene held(const char* name, const QString& page, const QString& item)
{
    return {QString::fromLatin1(name), [page, item](Stage& stage) {
                stage.tap(page);
                stage.hold(item);
            }};
}

// Opens the pages behind the key More, if the screen has one; else a page as it is.
Scene morePages(const char* name)
{
    return {QString::fromLatin1(name), [](Stage& stage) {
                stage.tap(stage.find(QStringLiteral("nav_more")) ? QStringLiteral("nav_more")
                                                                 : QStringLiteral("nav_run"));
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

Scene running(const char* name, Kind kind, Situation situation = Situation::Running)
{
    return {QString::fromLatin1(name), [kind, situation](Stage& stage) {
                stage.link().show(situation, kind);
                stage.lookAtClock();
                stage.tap(QStringLiteral("nav_run"));
            }};
}

// Opens Motion with a new program of this kind, also active in the controller, then taps.
Scene editing(const char* name, Kind kind, const QStringList& names = {})
{
    return {QString::fromLatin1(name), [kind, names](Stage& stage) {
                stage.link().show(Situation::Running, kind);
                stage.lookAtClock();
                stage.panel().editor().newProgram(static_cast<int>(kind));
                stage.tap(QStringLiteral("nav_motion"));
                for (const QString& tapped : names)
                    stage.tap(tapped);
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

// Returns two files on a simulated stick with their dates, and the panel's own folder.
panel::KnotFiles::Found knotsOnStick(const QString&)
{
    panel::KnotFiles::Found found;
    const QString path = QStringLiteral("/media/panel/KINGSTON");
    found.places = {{path, QStringLiteral("KINGSTON"), false},
                    {QStringLiteral("/media/panel/OLD"), QStringLiteral("OLD"), true}};
    store::KnotsOffer good;
    good.path = path + QStringLiteral("/pusher-slow.csv");
    good.placeName = QStringLiteral("KINGSTON");
    good.changed = QDateTime(QDate(2026, 1, 15), QTime(13, 52));
    const auto cam = program::defaultRecipe(Kind::PointCam);
    good.knots = std::get<profile::PointCamProgram>(cam.program).knots;
    store::KnotsOffer bad = good;
    bad.path = path + QStringLiteral("/pusher-new.csv");
    bad.changed = QDateTime(QDate(2026, 1, 14), QTime(9, 5));
    bad.knots[2].masterDeg = bad.knots[1].masterDeg - 5;
    bad.refusal = profile::checkKnots(bad.knots);
    bad.refusedLine = 4;
    found.offers = {good, bad};
    return found;
}

// Opens the sheet of knot files after the search, then taps.
Scene knotFiles(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](Stage& stage) {
                stage.link().show(Situation::Running, Kind::PointCam);
                panel::Editor& editor = stage.panel().editor();
                editor.newProgram(static_cast<int>(Kind::PointCam));
                editor.knotFiles()->setLooker(&knotsOnStick);
                for (const char* tapped : {"nav_motion", "knotsButton", "knotFilesButton"})
                    stage.tap(QString::fromLatin1(tapped));
                for (const QString& tapped : names) {
                    stage.waitFor(*editor.knotFiles());
                    stage.tap(tapped);
                }
            }};
}

// Opens a section of Service with the controller at standstill, then taps.
Scene service(const char* name, const QStringList& names, Situation situation = Situation::Stopped)
{
    return {QString::fromLatin1(name), [names, situation](Stage& stage) {
                stage.link().show(situation);
                stage.lookAtClock();
                stage.tap(QStringLiteral("nav_maintenance"));
                stage.tap(QStringLiteral("serviceLine"));
                for (const QString& tapped : names)
                    stage.tap(tapped);
            }};
}

Scene searched(const char* name, bool isFound)
{
    return {QString::fromLatin1(name), [isFound](Stage& stage) {
                stage.link().show(Situation::Absent);
                for (const char* tapped : {"nav_maintenance", "serviceLine", "service0", "doctorSearch"})
                    stage.tap(QString::fromLatin1(tapped));
                stage.link().endScan(isFound);
            }};
}

// Opens the places for reports after the search.
Scene reportPlaces(const char* name)
{
    return {QString::fromLatin1(name), [](Stage& stage) {
                panel::ReportFiles& files = *stage.panel().service().files();
                files.setLooker([](const QString& folder) {
                    return QList<store::Place>{
                        {QStringLiteral("/media/panel/KINGSTON"), QStringLiteral("KINGSTON"), false},
                        {QStringLiteral("/media/panel/OLD"), QStringLiteral("OLD"), true},
                        {folder.section(u'/', -1), QStringLiteral("reports"), false}};
                });
                for (const char* tapped : {"nav_maintenance", "serviceLine", "service1", "figuresExport"})
                    stage.tap(QString::fromLatin1(tapped));
                stage.waitFor(files);
                stage.tap(QStringLiteral("offer0"));
            }};
}

} // namespace

const QList<Scene>& allScenes()
{
    const QString run = QStringLiteral("nav_run");
    const QString motion = QStringLiteral("nav_motion");
    const QString settings = QStringLiteral("nav_settings");
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
        held("explanation-bags", run, QStringLiteral("bagNumbers")),
        held("explanation-rate", run, QStringLiteral("packingRate")),
        held("explanation-verdict", motion, QStringLiteral("verdictNumbers")),
        morePages("more-pages"),
        taps("laws", {motion, QStringLiteral("lawButton")}),
        {QStringLiteral("laws-limits"),
         [=](Stage& stage) {
             stage.panel().editor().rate()->set(390);
             stage.tap(motion);
             stage.tap(QStringLiteral("lawButton"));
         }},
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
        {QStringLiteral("settings-system"),
         [=](Stage& stage) {
             const QString folder =
                 QFileInfo(stage.panel().backup().ownFolder()).dir().filePath(u"backlight"_s);
             QDir().mkpath(folder + u"/screen"_s);
             for (const QString& name : {u"brightness"_s, u"max_brightness"_s}) {
                 QFile file(folder + u"/screen/"_s + name);
                 if (!file.open(QIODevice::WriteOnly) || file.write("100") < 0)
                     qWarning("the demonstration's backlight cannot be written");
             }
             stage.panel().display().setBacklight(panel::Backlight::find(folder));
             stage.tap(settings);
             stage.tap(QStringLiteral("section0"));
             stage.tap(QStringLiteral("sectionSystem"));
         }},
        {QStringLiteral("settings-system-plain"),
         [=](Stage& stage) {
             stage.panel().display().setBacklight({});
             stage.tap(settings);
             stage.tap(QStringLiteral("section0"));
             stage.tap(QStringLiteral("sectionSystem"));
         }},
        taps("wipe", {settings, QStringLiteral("section0"), QStringLiteral("sectionSystem"),
                      QStringLiteral("wipeScreen")}),
        taps("settings-about", {settings, QStringLiteral("section3")}),
        situation("run-stopped", Situation::Stopped, run),
        situation("run-empty", Situation::Empty, run),
        situation("run-fault", Situation::Fault, run),
        situation("run-many-alarms", Situation::ManyAlarms, run),
        situation("motion-many-alarms", Situation::ManyAlarms, motion),
        situation("run-product-across", Situation::ProductAcross, run),
        situation("run-marks-lost", Situation::MarksLost, run),
        {QStringLiteral("run-old-controller"),
         [=](Stage& stage) {
             stage.link().setOld(true);
             stage.link().show(Situation::Stopped);
             stage.link().show(Situation::Running);
             stage.lookAtClock();
             stage.tap(run);
         }},
        taps("run-film", {run, QStringLiteral("filmCard")}),
        taps("bag-tolerance", {settings, QStringLiteral("section2"), QStringLiteral("bagTolerance")}),
        situation("run-lost", Situation::Lost, run),
        situation("motion-fault", Situation::Fault, motion),
        {QStringLiteral("download-start-refused"),
         [=](Stage& stage) {
             stage.link().show(Situation::Empty);
             stage.lookAtClock();
             for (const char* name : {"nav_motion", "nextStep", "startKey"})
                 stage.tap(QString::fromLatin1(name));
         }},
        running("run-position", Kind::PositionMove),
        running("run-speed", Kind::SpeedMove),
        running("run-cam", Kind::PointCam),
        running("run-cam-stopped", Kind::PointCam, Situation::Stopped),
        {QStringLiteral("run-cam-lost"),
         [=](Stage& stage) {
             stage.link().show(Situation::Running, Kind::PointCam);
             stage.link().show(Situation::Lost, Kind::PointCam);
             stage.lookAtClock();
             stage.tap(run);
         }},
        {QStringLiteral("run-press-lost"),
         [=](Stage& stage) {
             stage.link().show(Situation::Running, Kind::Press);
             stage.link().show(Situation::Lost, Kind::Press);
             stage.lookAtClock();
             stage.tap(run);
         }},
        {QStringLiteral("run-stop-waits"),
         [=](Stage& stage) {
             stage.link().show(Situation::Lost);
             stage.link().showWaitingStop();
             stage.lookAtClock();
             stage.tap(run);
         }},
        situation("motion-lost", Situation::Lost, motion),
        taps("proof",
             {motion, QStringLiteral("more"), QStringLiteral("proofButton"), QStringLiteral("proofCompare")}),
        {QStringLiteral("proof-lost"),
         [=](Stage& stage) {
             stage.link().show(Situation::Lost);
             stage.lookAtClock();
             for (const char* name : {"nav_motion", "more", "proofButton"})
                 stage.tap(QString::fromLatin1(name));
         }},
        {QStringLiteral("faults"),
         [=](Stage& stage) {
             stage.link().setSimulated(true);
             for (const char* name :
                  {"nav_maintenance", "serviceLine", "service4", "fault0often", "fault1sometimes"})
                 stage.tap(QString::fromLatin1(name));
         }},
        running("run-press", Kind::Press),
        running("run-press-stopped", Kind::Press, Situation::Stopped),
        running("run-press-fresh", Kind::Press, Situation::Fresh),
        running("run-press-fault", Kind::Press, Situation::Fault),
        running("run-position-fresh", Kind::PositionMove, Situation::Fresh),
        editing("motion-position", Kind::PositionMove),
        editing("motion-speed", Kind::SpeedMove),
        editing("motion-cam", Kind::PointCam),
        editing("motion-press", Kind::Press),
        editing("knots", Kind::PointCam, {QStringLiteral("knotsButton")}),
        knotFiles("knots-import", {QStringLiteral("offer0")}),
        knotFiles("knots-import-refused", {QStringLiteral("offer1")}),
        knotFiles("knots-export", {QStringLiteral("knotsExport"), QStringLiteral("offer0")}),
        editing("choice", Kind::SpeedMove, {QStringLiteral("choice0")}),
        editing("kinds", Kind::PositionMove, {QStringLiteral("more"), QStringLiteral("kindButton")}),
        editing("tools-cam", Kind::PointCam, {QStringLiteral("more")}),
        editing("table-press", Kind::Press, {QStringLiteral("more"), QStringLiteral("tableButton")}),
        {QStringLiteral("laws-move"),
         [=](Stage& stage) {
             stage.panel().editor().newProgram(static_cast<int>(Kind::PositionMove));
             stage.panel().editor().compareLaw(QStringLiteral("modified_sine"));
             stage.tap(motion);
             stage.tap(QStringLiteral("lawButton"));
         }},
        {QStringLiteral("motion-compared"),
         [=](Stage& stage) {
             stage.panel().editor().newProgram(static_cast<int>(Kind::PositionMove));
             stage.panel().editor().compareLaw(QStringLiteral("modified_sine"));
             stage.tap(motion);
         }},
        service("doctor", {QStringLiteral("service0")}),
        service("doctor-blocked", {QStringLiteral("service0")}, Situation::Running),
        service("doctor-searching", {QStringLiteral("service0"), QStringLiteral("doctorSearch")}),
        searched("doctor-found", true),
        searched("doctor-not-found", false),
        service("figures", {QStringLiteral("service1")}),
        {QStringLiteral("figures-explained"),
         [=](Stage& stage) {
             stage.link().show(Situation::Stopped);
             for (const char* name : {"nav_maintenance", "serviceLine", "service1"})
                 stage.tap(QString::fromLatin1(name));
             stage.hold(QStringLiteral("figuresTimes"));
         }},
        reportPlaces("figures-export"),
        service("registers", {QStringLiteral("service2")}, Situation::Running),
        service("registers-group", {QStringLiteral("service2"), QStringLiteral("registerGroup")}),
        service("registers-name", {QStringLiteral("service2"), QStringLiteral("registerName"),
                                   QStringLiteral("key_p"), QStringLiteral("key_a")}),
        service("registers-parameter", {QStringLiteral("service2"), QStringLiteral("registerGroup"),
                                        QStringLiteral("choice_parameter"), QStringLiteral("register1")}),
        service("registers-write", {QStringLiteral("service2"), QStringLiteral("registerGroup"),
                                    QStringLiteral("choice_parameter"), QStringLiteral("register1"),
                                    QStringLiteral("registerWrite")}),
        service("frames", {QStringLiteral("service3"), QStringLiteral("framesAll")}, Situation::Running),
        service("frames-errors", {QStringLiteral("service3"), QStringLiteral("framesErrors")}),
        service("frames-one",
                {QStringLiteral("service3"), QStringLiteral("framesAll"), QStringLiteral("frameList")}),
        {QStringLiteral("motion-all-curves"),
         [=](Stage& stage) {
             for (const char* name : {"nav_motion", "more", "positionSwitch", "jerkSwitch", "sheetClose"})
                 stage.tap(QString::fromLatin1(name));
         }},
    };
    static const QList<Scene> all = scenes + packingScenes() + recipeScenes() + trendScenes() +
                                    alarmScenes() + accessScenes() + firstScenes() + backupScenes() +
                                    serviceScenes();
    return all;
}

namespace {

constexpr std::array lookSizes{QSize(800, 480), QSize(1024, 600), QSize(1280, 800)};

QStringList usualLooks()
{
    QStringList names;
    for (const QSize size : lookSizes) {
        // Colors change no layout except for the bold name of the theme. So dark and high contrast need only
        // one language at each size, in turn, and gloves and longer texts only one theme.
        const bool isMiddle = size.width() == 1024;
        const QString light = u"light"_s;
        const QString english = u"en"_s;
        const QString chinese = u"zh_CN"_s;
        for (const Look& look : {Look{english, light, size}, Look{chinese, light, size},
                                 Look{isMiddle ? chinese : english, u"dark"_s, size},
                                 Look{isMiddle ? english : chinese, u"contrast"_s, size},
                                 Look{u"long"_s, light, size}, Look{english, light, size, true}})
            names += look.name();
    }
    return names;
}

bool isNamed(const QStringList& patterns, const QString& name)
{
    return std::ranges::any_of(patterns, [&name](const QString& pattern) {
        return QRegularExpression::fromWildcard(pattern).match(name).hasMatch();
    });
}

} // namespace

QList<Look> allLooks()
{
    QList<Look> looks;
    for (const QSize size : lookSizes) {
        for (const char* theme : {"light", "dark", "contrast"}) {
            for (const char* language : {"en", "zh_CN", "long"}) {
                for (const bool gloves : {false, true})
                    looks.append({QString::fromLatin1(language), QString::fromLatin1(theme), size, gloves});
            }
        }
    }
    return looks;
}

QList<Look> looksNamed(const QString& patterns)
{
    QStringList each = patterns.split(u',');
    if (each.removeAll(u"usual"_s) > 0)
        each += usualLooks();
    QList<Look> looks = allLooks();
    looks.removeIf([&each](const Look& look) { return !isNamed(each, look.name()); });
    return looks;
}

QList<Scene> scenesNamed(const QString& patterns)
{
    QList<Scene> scenes = allScenes();
    scenes.removeIf([each = patterns.split(u',')](const Scene& scene) { return !isNamed(each, scene.name); });
    return scenes;
}

void enterScene(Stage& stage, const Scene& scene)
{
    auto& editor = stage.panel().editor();
    panel::Display& display = stage.panel().display();
    while (display.wipeSeconds() > 0) // no taps during cleaning
        display.tick();
    stage.closeDialogs();
    stage.panel().settings().endFirstStart();
    forgetUsers(stage);
    editor.cancelDownload();
    editor.compareLaw({});
    while (editor.canUndo())
        editor.undo();
    stage.panel().settings().setSimulated(true);
    stage.panel().service().doctor()->cancel();
    stage.panel().service().inspector()->setGroup({});
    stage.panel().service().inspector()->setNameFilter({});
    stage.panel().service().jog()->letGo();
    stage.link().setSimulated(false);
    if (stage.link().setOld(false))
        stage.link().show(Situation::Empty);
    stage.link().show(Situation::Running);
    stage.panel().machine().dismissMessage();
    stage.settle();
    while (stage.panel().alarms().shelved()->count() > 0)
        stage.panel().alarms().unshelve(0);
    stage.panel().alarms().acknowledgeAll();
    stage.lookAtClock();
    scene.enter(stage);
    stage.settle();
}

} // namespace campanel::looks
