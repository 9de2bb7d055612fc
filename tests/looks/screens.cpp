// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel; see screens.h.
#include "tests/looks/screens.h"

#include "app/panel/settings/languages.h"
#include "tests/looks/screen_lists.h"
#include "tests/support/fake_package.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::looks {
namespace {

using Situation = DemoLink::Situation;
using Kind = DemoLink::Kind;

// Taps each name in turn; the navigation is "nav_run" (Run), "nav_motion" (Motion), "nav_settings"
// (Settings), "nav_maintenance" (Service), "nav_alarms" (Alarms).
Screen taps(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

// Opens the explanation of an item by a held finger.
Screen held(const char* name, const QString& page, const QString& item)
{
    return {QString::fromLatin1(name), [page, item](TestWindow& window) {
                window.tap(page);
                window.hold(item);
            }};
}

// Opens the pages behind the key More, if the screen has one; else a page as it is.
Screen morePages(const char* name)
{
    return {QString::fromLatin1(name), [](TestWindow& window) {
                window.tap(window.find(QStringLiteral("nav_more")) ? QStringLiteral("nav_more")
                                                                   : QStringLiteral("nav_run"));
            }};
}

Screen situation(const char* name, Situation situation, const QString& page)
{
    return {QString::fromLatin1(name), [situation, page](TestWindow& window) {
                window.link().show(situation);
                window.checkClock();
                window.tap(page);
            }};
}

Screen running(const char* name, Kind kind, Situation situation = Situation::Running)
{
    return {QString::fromLatin1(name), [kind, situation](TestWindow& window) {
                window.link().show(situation, kind);
                window.checkClock();
                window.tap(QStringLiteral("nav_run"));
            }};
}

// Opens Motion with a new program of this kind, also active in the controller, then taps.
Screen editing(const char* name, Kind kind, const QStringList& names = {})
{
    return {QString::fromLatin1(name), [kind, names](TestWindow& window) {
                window.link().show(Situation::Running, kind);
                window.checkClock();
                window.panel().editor().newProgram(static_cast<int>(kind));
                window.tap(QStringLiteral("nav_motion"));
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

Screen edited(const char* name, double bagLengthMm, const QStringList& names)
{
    return {QString::fromLatin1(name), [bagLengthMm, names](TestWindow& window) {
                window.panel().editor().bagLength()->set(bagLengthMm);
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

// Opens Motion as an operator does.
Screen ofOperator(const char* name, double bagLengthMm, double rateBagsPerMin)
{
    return {QString::fromLatin1(name), [=](TestWindow& window) {
                window.panel().editor().bagLength()->set(bagLengthMm);
                window.panel().editor().rate()->set(rateBagsPerMin);
                window.setLevel(panel::Level::Operator);
                window.tap(QStringLiteral("nav_motion"));
            }};
}

// Returns two files on a simulated stick with their dates, and the panel's own folder. The newer file has an
// entry before the one above it.
panel::CamFiles::Found listsOnStick(const QString&, const profile::Program& cam)
{
    panel::CamFiles::Found found;
    const QString path = QStringLiteral("/media/panel/KINGSTON");
    found.places = {{path, QStringLiteral("KINGSTON"), false},
                    {QStringLiteral("/media/panel/OLD"), QStringLiteral("OLD"), true}};
    store::ListOffer good;
    good.path = path + QStringLiteral("/pusher-slow.csv");
    good.placeName = QStringLiteral("KINGSTON");
    good.changed = QDateTime(QDate(2026, 1, 15), QTime(13, 52));
    good.program = cam;
    store::ListOffer bad = good;
    bad.path = path + QStringLiteral("/pusher-new.csv");
    bad.changed = QDateTime(QDate(2026, 1, 14), QTime(9, 5));
    if (auto* points = std::get_if<profile::PointCamProgram>(&bad.program))
        points->knots[2].masterDeg = points->knots[1].masterDeg - 5;
    else if (auto* segments = std::get_if<profile::SegmentCamProgram>(&bad.program))
        segments->segments[2].fromDeg = segments->segments[1].toDeg - 5;
    bad.refusal = program::kindInfo(profile::kindOf(cam)).list->check(bad.program);
    bad.refusedLine = 4;
    found.offers = {good, bad};
    return found;
}

// Opens the sheet of a cam's files after the search, then taps.
Screen camFiles(const char* name, Kind kind, const QStringList& names)
{
    return {QString::fromLatin1(name), [kind, names](TestWindow& window) {
                window.link().show(Situation::Running, kind);
                panel::Editor& editor = window.panel().editor();
                editor.newProgram(static_cast<int>(kind));
                editor.camFiles()->setScanner(&listsOnStick);
                window.tap(QStringLiteral("nav_motion"));
                const QString list =
                    kind == Kind::PointCam ? QStringLiteral("knot") : QStringLiteral("segment");
                window.tap(list + QStringLiteral("sButton"));
                window.tap(list + QStringLiteral("FilesButton"));
                for (const QString& tapped : names) {
                    window.waitFor(*editor.camFiles());
                    window.tap(tapped);
                }
            }};
}

// Opens a section of Service with the controller at standstill, then taps.
Screen maintenance(const char* name, const QStringList& names, Situation situation = Situation::Stopped)
{
    return {QString::fromLatin1(name), [names, situation](TestWindow& window) {
                window.link().show(situation);
                window.checkClock();
                window.tap(QStringLiteral("nav_maintenance"));
                window.tap(QStringLiteral("maintenanceLine"));
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

Screen searched(const char* name, bool isFound)
{
    return {
        QString::fromLatin1(name), [isFound](TestWindow& window) {
            window.link().show(Situation::Absent);
            for (const char* tapped : {"nav_maintenance", "maintenanceLine", "maintenance0", "doctorSearch"})
                window.tap(QString::fromLatin1(tapped));
            window.link().endScan(isFound);
        }};
}

// Opens the places for reports after the search.
Screen reportPlaces(const char* name)
{
    return {
        QString::fromLatin1(name), [](TestWindow& window) {
            panel::ReportFiles& files = *window.panel().maintenance().files();
            files.setScanner([](const QString& folder) {
                return QList<store::Place>{
                    {QStringLiteral("/media/panel/KINGSTON"), QStringLiteral("KINGSTON"), false},
                    {QStringLiteral("/media/panel/OLD"), QStringLiteral("OLD"), true},
                    {folder.section(u'/', -1), QStringLiteral("reports"), false}};
            });
            for (const char* tapped : {"nav_maintenance", "maintenanceLine", "maintenance1", "figuresExport"})
                window.tap(QString::fromLatin1(tapped));
            window.waitFor(files);
            window.tap(QStringLiteral("offer0"));
        }};
}

// A small screen has no room for all settings of the screen.
void scrollDown(TestWindow& window)
{
    QQuickItem* view = window.find(QStringLiteral("systemScroll"));
    if (view)
        view->setProperty("contentY",
                          std::max(0.0, view->property("contentHeight").toDouble() - view->height()));
    window.settle();
}

// Opens the settings of the screen at standstill, then taps.
Screen screenSetting(const char* name, const QStringList& taps)
{
    return {QString::fromLatin1(name), [taps](TestWindow& window) {
                window.link().show(Situation::Stopped);
                window.checkClock();
                for (const char* tapped : {"nav_settings", "section0", "sectionSystem"})
                    window.tap(QString::fromLatin1(tapped));
                scrollDown(window);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

// Leaves a calibration that nobody has kept yet.
void calibrate(TestWindow& window)
{
    const QByteArray matrix = "1.020000 0.000000 -0.010000 0.000000 1.010000 -0.005000";
    if (!test::writeFile(window.touchFolder() + u"/rule"_s,
                         "ENV{LIBINPUT_CALIBRATION_MATRIX}=\"" + matrix + "\"\n") ||
        !test::writeFile(window.touchFolder() + u"/trial"_s, "none\n" + matrix + '\n'))
        qWarning("the demonstration's calibration cannot be written");
}

// Opens the settings of the screen when the touchscreen's state is known, then taps.
Screen touchscreen(
    const char* name, const QStringList& taps,
    const std::function<void(TestWindow&)>& prepare = [](TestWindow&) {})
{
    return {QString::fromLatin1(name), [taps, prepare](TestWindow& window) {
                prepare(window);
                screenSetting("", {}).enter(window);
                window.waitUntil(window.panel().touchCalibration(), &panel::TouchCalibration::changed,
                                 [](const panel::TouchCalibration& touch) { return touch.isAsked(); });
                scrollDown(window);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

// Opens the sheet of the clock on a time service prepared by `prepare`, then taps.
Screen clock(const char* name, const QStringList& taps, const std::function<void(TestWindow&)>& prepare)
{
    return {QString::fromLatin1(name), [taps, prepare](TestWindow& window) {
                prepare(window);
                for (const char* tapped : {"nav_settings", "section0", "sectionSystem", "setClock"})
                    window.tap(QString::fromLatin1(tapped));
                window.waitUntil(window.panel().systemClock(), &panel::SystemClock::changed,
                                 [](const panel::SystemClock& clock) { return clock.isAsked(); });
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

// Opens the sheet of the network on a service prepared by `prepare`, then taps.
Screen network(const char* name, const QStringList& taps, const std::function<void(TestWindow&)>& prepare)
{
    return {QString::fromLatin1(name), [taps, prepare](TestWindow& window) {
                prepare(window);
                for (const char* tapped : {"nav_settings", "section0", "sectionSystem", "setNetwork"})
                    window.tap(QString::fromLatin1(tapped));
                const auto wait = [&window] {
                    window.waitUntil(
                        window.panel().systemNetwork(), &panel::SystemNetwork::changed,
                        [](const panel::SystemNetwork& each) { return each.isAsked() && !each.busy(); });
                };
                wait();
                for (const QString& tapped : taps) {
                    window.tap(tapped);
                    wait();
                }
            }};
}

// A running machine whose rate is outside the window that a technician has approved.
Screen outside(const char* name, const QStringList& taps, bool isExplained)
{
    return {QString::fromLatin1(name), [=](TestWindow& window) {
                panel::Editor& editor = window.panel().editor();
                program::Recipe recipe = editor.recipe();
                const double rate = recipe.cutter().rateBagsPerMin;
                recipe.windows[profile::Field::Rate] = {rate - 25, isExplained ? rate - 10 : rate};
                editor.open(recipe);
                if (isExplained)
                    editor.programDownload()->windowReason()->give(
                        QStringLiteral("Film PP 35, tested on Monday"));
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

} // namespace

const QList<Screen>& allScreens()
{
    const QString run = QStringLiteral("nav_run");
    const QString motion = QStringLiteral("nav_motion");
    const QString settings = QStringLiteral("nav_settings");
    const QString length = QStringLiteral("field_bag_length_mm");
    static const QList<Screen> screens{
        taps("run", {run}),
        taps("run-hand-speed", {run, QStringLiteral("speedKey"), QStringLiteral("speedSlower")}),
        taps("run-trims",
             {run, QStringLiteral("trimKey"), QStringLiteral("trimRight0"), QStringLiteral("trimRight0"),
              QStringLiteral("trimRight0"), QStringLiteral("trimRight0"), QStringLiteral("trimRight1")}),
        outside("run-outside", {run}, true),
        outside("run-outside-asked", {run, QStringLiteral("packingRate"), QStringLiteral("changeMore")},
                false),
        outside("run-outside-reasons",
                {run, QStringLiteral("packingRate"), QStringLiteral("changeMore"),
                 QStringLiteral("changeReason")},
                false),
        outside("motion-outside", {motion}, true),
        taps("run-bags-by-hand", {run, QStringLiteral("trimKey"), QStringLiteral("bagKey")}),
        taps("motion", {motion}),
        taps("keypad", {motion, length}),
        {QStringLiteral("keypad-refusal"),
         [=](TestWindow& window) {
             window.tap(motion);
             window.tap(length);
             window.type(QStringLiteral("99999"));
         }},
        {QStringLiteral("keypad-kept"),
         [=](TestWindow& window) {
             window.tap(motion);
             window.tap(length);
             window.type(QStringLiteral("190"));
             window.frame()->property("keypad").value<QQuickItem*>()->setProperty("warned", true);
         }},
        {QStringLiteral("keypad-whole"),
         [=](TestWindow& window) {
             window.tap(motion);
             window.tap(QStringLiteral("more"));
             window.tap(QStringLiteral("field_slices_per_ramp"));
             window.type(QStringLiteral("1,5"));
         }},
        {QStringLiteral("recipe-file-lost"),
         [=](TestWindow& window) {
             window.tap(motion);
             window.panel().editor().showNotice(
                 panel::Recipes::openedInsteadText(QStringLiteral("Biscuit 250"), 12));
         }},
        taps("ratios", {motion, QStringLiteral("ratios")}),
        {QStringLiteral("ratios-gentle"),
         [=](TestWindow& window) {
             window.panel().editor().rate()->set(200);
             window.panel().editor().ramps()->choose(panel::RampControl::Gentle);
             window.tap(motion);
             window.tap(QStringLiteral("ratios"));
         }},
        taps("keypad-ratios", {motion, QStringLiteral("ratios"), QStringLiteral("ratioNumbers")}),
        edited("keypad-ratios-edited", 320,
               {motion, QStringLiteral("ratios"), QStringLiteral("ratioNumbers")}),
        {QStringLiteral("laws-ranked"),
         [=](TestWindow& window) {
             window.panel().editor().ramps()->choose(panel::RampControl::Cool);
             window.tap(motion);
             window.tap(QStringLiteral("lawButton"));
         }},
        {QStringLiteral("explanation"),
         [=](TestWindow& window) {
             window.tap(motion);
             window.hold(QStringLiteral("field_base_speed_mm_per_s"));
         }},
        held("explanation-bags", run, QStringLiteral("bagNumbers")),
        held("explanation-rate", run, QStringLiteral("packingRate")),
        held("explanation-verdict", motion, QStringLiteral("verdictNumbers")),
        morePages("more-pages"),
        taps("laws", {motion, QStringLiteral("lawButton")}),
        {QStringLiteral("laws-limits"),
         [=](TestWindow& window) {
             window.panel().editor().rate()->set(390);
             window.tap(motion);
             window.tap(QStringLiteral("lawButton"));
         }},
        taps("tools", {motion, QStringLiteral("more")}),
        taps("table", {motion, QStringLiteral("more"), QStringLiteral("tableButton")}),
        edited("motion-edited", 320, {motion}),
        ofOperator("motion-operator", 240, 60),
        ofOperator("motion-operator-refused", 150, 390),
        ofOperator("motion-operator-stroke", 1500, 60),
        edited("download", 320, {motion, QStringLiteral("nextStep")}),
        edited("downloading", 320, {motion, QStringLiteral("nextStep"), QStringLiteral("downloadStart")}),
        {QStringLiteral("motion-refused"),
         [=](TestWindow& window) {
             window.panel().editor().bagLength()->set(1500);
             window.tap(motion);
         }},
        {QStringLiteral("motion-limits"),
         [=](TestWindow& window) {
             window.panel().editor().rate()->set(390);
             window.tap(motion);
         }},
        {QStringLiteral("motion-ramps"),
         [=](TestWindow& window) {
             window.panel().editor().bagLength()->set(150);
             window.panel().editor().rate()->set(320);
             window.tap(motion);
         }},
        taps("settings-display", {settings, QStringLiteral("section0")}),
        taps("settings-language", {settings, QStringLiteral("section0"), QStringLiteral("languageChoice")}),
        taps("settings-connection", {settings, QStringLiteral("section1")}),
        {QStringLiteral("settings-serial"),
         [=](TestWindow& window) {
             window.panel().settings().setSimulated(false);
             window.tap(settings);
             window.tap(QStringLiteral("section1"));
         }},
        {QStringLiteral("ports"),
         [=](TestWindow& window) {
             window.panel().settings().setSimulated(false);
             window.tap(settings);
             window.tap(QStringLiteral("section1"));
             window.tap(QStringLiteral("portButton"));
         }},
        taps("settings-machine", {settings, QStringLiteral("section2")}),
        taps("settings-machine-name", {settings, QStringLiteral("section2"), QStringLiteral("machineName")}),
        {QStringLiteral("settings-machine-named"),
         [=](TestWindow& window) {
             window.panel().settings().overrideValue(
                 "machine.name", QStringLiteral("Horizontal flow wrapper, hall 2, line 3"));
             taps("", {settings, QStringLiteral("section2")}).enter(window);
         }},
        taps("settings-permit", {settings, QStringLiteral("section2"), QStringLiteral("openPermit")}),
        taps("settings-tower", {settings, QStringLiteral("section2"), QStringLiteral("openTower")}),
        taps("settings-tower-mode",
             {settings, QStringLiteral("section2"), QStringLiteral("openTower"), QStringLiteral("tower0")}),
        taps("settings-start-key", {settings, QStringLiteral("section0"), QStringLiteral("holdToStart")}),
        taps("keypad-machine", {settings, QStringLiteral("section2"),
                                QStringLiteral("field_max_knife_acceleration_mm_per_s2")}),
        {QStringLiteral("settings-system"),
         [=](TestWindow& window) {
             const QString folder =
                 QFileInfo(window.panel().backup().ownFolder()).dir().filePath(u"backlight"_s);
             QDir().mkpath(folder + u"/screen"_s);
             for (const QString& name : {u"brightness"_s, u"max_brightness"_s}) {
                 QFile file(folder + u"/screen/"_s + name);
                 if (!file.open(QIODevice::WriteOnly) || file.write("100") < 0)
                     qWarning("the demonstration's backlight cannot be written");
             }
             window.panel().display().setBacklight(panel::Backlight::find(folder));
             window.tap(settings);
             window.tap(QStringLiteral("section0"));
             window.tap(QStringLiteral("sectionSystem"));
         }},
        {QStringLiteral("settings-system-plain"),
         [=](TestWindow& window) {
             window.panel().display().setBacklight({});
             window.tap(settings);
             window.tap(QStringLiteral("section0"));
             window.tap(QStringLiteral("sectionSystem"));
         }},
        screenSetting("settings-rotation", {QStringLiteral("setRotation")}),
        screenSetting("settings-rotation-trial",
                      {QStringLiteral("setRotation"), QStringLiteral("choice_180")}),
        touchscreen("settings-touch", {QStringLiteral("setTouch")}, &calibrate),
        touchscreen("settings-touch-cross", {QStringLiteral("setTouch"), QStringLiteral("choice_calibrate")}),
        {QStringLiteral("settings-touch-missed"),
         [](TestWindow& window) {
             touchscreen("", {QStringLiteral("setTouch"), QStringLiteral("choice_calibrate")}).enter(window);
             for (const double x : {0.1, 0.8, 0.5, 0.1})
                 window.panel().touchCalibration().touch({x, x});
             window.settle();
         }},
        {QStringLiteral("settings-touch-trial"),
         [](TestWindow& window) {
             calibrate(window);
             window.panel().touchCalibration().resume();
             window.settle();
         }},
        touchscreen("settings-touch-none", {},
                    [](TestWindow& window) {
                        window.panel().touchCalibration().setBus(
                            {[] { return QDBusConnection(QStringLiteral("nowhere")); }, {}});
                    }),
        clock("settings-clock", {}, [](TestWindow&) {}),
        clock("settings-clock-server", {}, [](TestWindow& window) { window.timeService().m_ntp = true; }),
        clock("settings-zone", {QStringLiteral("clockZone"), QStringLiteral("choice_Asia")},
              [](TestWindow&) {}),
        clock("settings-clock-none", {},
              [](TestWindow& window) {
                  window.panel().systemClock().setBus(
                      {[] { return QDBusConnection(QStringLiteral("nowhere")); }, {}});
              }),
        network("settings-network", {}, [](TestWindow&) {}),
        network("settings-network-refused",
                {QStringLiteral("networkFixed"), QStringLiteral("networkField2"),
                 QStringLiteral("pinBackspace"), QStringLiteral("pinBackspace"),
                 QStringLiteral("pinBackspace"), QStringLiteral("pin2"), QStringLiteral("pin."),
                 QStringLiteral("pin1"), QStringLiteral("pinAccept")},
                [](TestWindow&) {}),
        network("settings-network-address",
                {QStringLiteral("networkFixed"), QStringLiteral("networkField0"),
                 QStringLiteral("pinBackspace"), QStringLiteral("pinBackspace"),
                 QStringLiteral("pinBackspace")},
                [](TestWindow&) {}),
        network("settings-network-failed",
                {QStringLiteral("networkFixed"), QStringLiteral("networkField0"),
                 QStringLiteral("pinBackspace"), QStringLiteral("pinAccept"), QStringLiteral("networkApply")},
                [](TestWindow& window) {
                    window.networkService().m_usedAddress = QStringLiteral("192.168.1.2");
                    window.panel().systemNetwork().setPatienceMs(0, 0);
                }),
        network("settings-network-none", {},
                [](TestWindow& window) {
                    window.panel().systemNetwork().setBus(
                        {[] { return QDBusConnection(QStringLiteral("nowhere")); }, {}});
                }),
        taps("wipe", {settings, QStringLiteral("section0"), QStringLiteral("sectionSystem"),
                      QStringLiteral("wipeScreen")}),
        taps("settings-about", {settings, QStringLiteral("section3")}),
        situation("run-stopped", Situation::Stopped, run),
        {QStringLiteral("run-hold-to-start"),
         [run](TestWindow& window) {
             window.link().show(Situation::Stopped);
             window.panel().settings().set("access.hold_to_start", QStringLiteral("on"));
             window.tap(run);
             window.settle();
         }},
        situation("run-empty", Situation::Empty, run),
        situation("run-fault", Situation::Fault, run),
        situation("run-jammed", Situation::Jammed, run),
        situation("run-many-alarms", Situation::ManyAlarms, run),
        situation("motion-many-alarms", Situation::ManyAlarms, motion),
        situation("run-product-across", Situation::ProductAcross, run),
        situation("run-marks-lost", Situation::MarksLost, run),
        situation("run-fresh", Situation::Fresh, run),
        {QStringLiteral("run-old-controller"),
         [=](TestWindow& window) {
             window.link().setOld(true);
             window.link().show(Situation::Stopped);
             window.link().show(Situation::Running);
             window.checkClock();
             window.tap(run);
         }},
        taps("run-change", {run, QStringLiteral("bagNumbers"), QStringLiteral("changeStep2"),
                            QStringLiteral("changeMore"), QStringLiteral("changeMore")}),
        {QStringLiteral("run-change-refused"),
         [=](TestWindow& window) {
             window.tap(run);
             window.tap(QStringLiteral("packingRate"));
             window.tap(QStringLiteral("changeKeypad"));
             window.type(QStringLiteral("390"));
             window.tap(QStringLiteral("keypadAccept"));
         }},
        taps("run-knife", {run, QStringLiteral("knifeCard")}),
        taps("run-film", {run, QStringLiteral("filmCard")}),
        taps("bag-tolerance", {settings, QStringLiteral("section2"), QStringLiteral("bagTolerance")}),
        situation("run-lost", Situation::Lost, run),
        situation("motion-fault", Situation::Fault, motion),
        {QStringLiteral("start-question"),
         [=](TestWindow& window) {
             window.link().show(Situation::Stopped);
             window.checkClock();
             window.tap(run);
             window.panel().editor().bagLength()->set(240);
             window.tap(QStringLiteral("startKey"));
         }},
        {QStringLiteral("download-start-refused"),
         [=](TestWindow& window) {
             window.link().show(Situation::Empty);
             window.checkClock();
             for (const char* name : {"nav_motion", "nextStep", "startKey"})
                 window.tap(QString::fromLatin1(name));
         }},
        running("run-position", Kind::PositionMove),
        running("run-speed", Kind::SpeedMove),
        running("run-cam", Kind::PointCam),
        running("run-segments", Kind::SegmentCam),
        running("run-cam-stopped", Kind::PointCam, Situation::Stopped),
        {QStringLiteral("run-cam-lost"),
         [=](TestWindow& window) {
             window.link().show(Situation::Running, Kind::PointCam);
             window.link().show(Situation::Lost, Kind::PointCam);
             window.checkClock();
             window.tap(run);
         }},
        {QStringLiteral("run-press-lost"),
         [=](TestWindow& window) {
             window.link().show(Situation::Running, Kind::Press);
             window.link().show(Situation::Lost, Kind::Press);
             window.checkClock();
             window.tap(run);
         }},
        {QStringLiteral("run-stop-waits"),
         [=](TestWindow& window) {
             window.link().show(Situation::Lost);
             window.link().showWaitingStop();
             window.checkClock();
             window.tap(run);
         }},
        situation("motion-lost", Situation::Lost, motion),
        taps("proof",
             {motion, QStringLiteral("more"), QStringLiteral("proofButton"), QStringLiteral("proofCompare")}),
        {QStringLiteral("proof-lost"),
         [=](TestWindow& window) {
             window.link().show(Situation::Lost);
             window.checkClock();
             for (const char* name : {"nav_motion", "more", "proofButton"})
                 window.tap(QString::fromLatin1(name));
         }},
        {QStringLiteral("faults"),
         [=](TestWindow& window) {
             window.link().setSimulated(true);
             for (const char* name :
                  {"nav_maintenance", "maintenanceLine", "maintenance4", "fault0often", "fault1sometimes"})
                 window.tap(QString::fromLatin1(name));
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
        editing("knots-keypad", Kind::PointCam,
                {QStringLiteral("knotsButton"), QStringLiteral("field_knotSlave")}),
        editing("motion-segments", Kind::SegmentCam),
        editing("segments", Kind::SegmentCam, {QStringLiteral("segmentsButton")}),
        editing("segment-motions", Kind::SegmentCam,
                {QStringLiteral("segmentsButton"), QStringLiteral("segmentMotion")}),
        camFiles("knots-import", Kind::PointCam, {QStringLiteral("offer0")}),
        camFiles("knots-import-refused", Kind::PointCam, {QStringLiteral("offer1")}),
        camFiles("knots-export", Kind::PointCam, {QStringLiteral("listExport"), QStringLiteral("offer0")}),
        camFiles("segments-import", Kind::SegmentCam, {QStringLiteral("offer0")}),
        camFiles("segments-import-refused", Kind::SegmentCam, {QStringLiteral("offer1")}),
        camFiles("segments-export", Kind::SegmentCam,
                 {QStringLiteral("listExport"), QStringLiteral("offer0")}),
        editing("choice", Kind::SpeedMove, {QStringLiteral("choice0")}),
        editing("kinds", Kind::PositionMove, {QStringLiteral("more"), QStringLiteral("kindButton")}),
        editing("tools-cam", Kind::PointCam, {QStringLiteral("more")}),
        editing("table-press", Kind::Press, {QStringLiteral("more"), QStringLiteral("tableButton")}),
        {QStringLiteral("laws-move"),
         [=](TestWindow& window) {
             window.panel().editor().newProgram(static_cast<int>(Kind::PositionMove));
             window.panel().editor().compareLaw(QStringLiteral("modified_sine"));
             window.tap(motion);
             window.tap(QStringLiteral("lawButton"));
         }},
        {QStringLiteral("motion-compared"),
         [=](TestWindow& window) {
             window.panel().editor().newProgram(static_cast<int>(Kind::PositionMove));
             window.panel().editor().compareLaw(QStringLiteral("modified_sine"));
             window.tap(motion);
         }},
        maintenance("doctor", {QStringLiteral("maintenance0")}),
        maintenance("doctor-blocked", {QStringLiteral("maintenance0")}, Situation::Running),
        maintenance("doctor-searching", {QStringLiteral("maintenance0"), QStringLiteral("doctorSearch")}),
        searched("doctor-found", true),
        searched("doctor-not-found", false),
        maintenance("figures", {QStringLiteral("maintenance1")}),
        {QStringLiteral("figures-explained"),
         [=](TestWindow& window) {
             window.link().show(Situation::Stopped);
             for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance1"})
                 window.tap(QString::fromLatin1(name));
             window.hold(QStringLiteral("figuresTimes"));
         }},
        reportPlaces("figures-export"),
        maintenance("registers", {QStringLiteral("maintenance2")}, Situation::Running),
        maintenance("registers-group", {QStringLiteral("maintenance2"), QStringLiteral("registerGroup")}),
        maintenance("registers-name", {QStringLiteral("maintenance2"), QStringLiteral("registerName"),
                                       QStringLiteral("key_p"), QStringLiteral("key_a")}),
        maintenance("registers-parameter", {QStringLiteral("maintenance2"), QStringLiteral("registerGroup"),
                                            QStringLiteral("choice_parameter"), QStringLiteral("register1")}),
        maintenance("registers-write", {QStringLiteral("maintenance2"), QStringLiteral("registerGroup"),
                                        QStringLiteral("choice_parameter"), QStringLiteral("register1"),
                                        QStringLiteral("registerWrite")}),
        maintenance("frames", {QStringLiteral("maintenance3"), QStringLiteral("framesAll")},
                    Situation::Running),
        maintenance("frames-errors", {QStringLiteral("maintenance3"), QStringLiteral("framesErrors")}),
        maintenance("frames-one", {QStringLiteral("maintenance3"), QStringLiteral("framesAll"),
                                   QStringLiteral("frameList")}),
        {QStringLiteral("motion-all-curves"),
         [=](TestWindow& window) {
             for (const char* name : {"nav_motion", "more", "positionSwitch", "jerkSwitch", "sheetClose"})
                 window.tap(QString::fromLatin1(name));
         }},
    };
    static const QList<Screen> open = screens + packingScreens() + recipeScreens() + trendScreens() +
                                      stopScreens() + alarmScreens() + accessScreens() + firstScreens() +
                                      backupScreens() + maintenanceScreens() + cutterScreens() +
                                      motorScreens() + orderScreens() + scanScreens() + updateScreens();
    static const QList<Screen> all = open + lockedScreens(open);
    return all;
}

namespace {

constexpr std::array variantSizes{QSize(800, 480), QSize(1024, 600), QSize(1280, 800), QSize(1920, 1080)};

// The installed languages, and the one with longer texts.
QStringList languages()
{
    return panel::languageCodes(panel::languagesIn(panel::languageFolders())) << u"long"_s;
}

QStringList usualVariants()
{
    QStringList names;
    for (const QSize size : variantSizes) {
        // Colors change no layout except for the bold name of the theme. So dark and high contrast need only
        // one language at each size, in turn, and gloves and longer texts only one theme.
        const bool isMiddle = size.width() == 1024;
        const QString light = u"light"_s;
        const QString english = u"en"_s;
        const QString chinese = u"zh_CN"_s;
        for (const QString& language : languages())
            names += Variant{language, light, size}.name();
        for (const Variant& variant : {Variant{isMiddle ? chinese : english, u"dark"_s, size},
                                       Variant{isMiddle ? english : chinese, u"contrast"_s, size},
                                       Variant{english, light, size, true}})
            names += variant.name();
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

QList<Variant> allVariants()
{
    QList<Variant> variants;
    for (const QSize size : variantSizes) {
        for (const char* theme : {"light", "dark", "contrast"}) {
            for (const QString& language : languages()) {
                for (const bool gloves : {false, true})
                    variants.append({language, QString::fromLatin1(theme), size, gloves});
            }
        }
    }
    return variants;
}

QList<Variant> variantsNamed(const QString& patterns)
{
    QStringList each = patterns.split(u',');
    if (each.removeAll(u"usual"_s) > 0)
        each += usualVariants();
    QList<Variant> variants = allVariants();
    variants.removeIf([&each](const Variant& variant) { return !isNamed(each, variant.name()); });
    return variants;
}

QList<Screen> screensNamed(const QString& patterns)
{
    QList<Screen> screens = allScreens();
    screens.removeIf(
        [each = patterns.split(u',')](const Screen& screen) { return !isNamed(each, screen.name); });
    return screens;
}

void enterScreen(TestWindow& window, const Screen& screen)
{
    if (!window.panel().access().protectedByPins())
        window.setLevel(panel::Level::Service);
    window.panel().stops().dismissAnswer();
    window.panel().systemNetwork().discard();
    window.panel().update().dismissNotice();
    auto& editor = window.panel().editor();
    panel::Display& display = window.panel().display();
    while (display.wipeSeconds() > 0) // no taps during cleaning
        display.tick();
    window.panel().rotation().goBack();
    window.panel().touchCalibration().keep();
    window.panel().touchCalibration().cancel();
    QFile::remove(window.touchFolder() + u"/rule"_s);
    window.closeDialogs();
    window.panel().settings().endFirstStart();
    if (!screen.keepsUsers)
        forgetUsers(window);
    editor.cancelDownload();
    editor.compareLaw({});
    editor.showNotice({});
    while (editor.canUndo())
        editor.undo();
    if (editor.recipeVersion() == 0)
        editor.open(program::Recipe{}, {}); // after the first start
    if (program::Recipe recipe = editor.recipe(); !std::exchange(recipe.windows, {}).empty())
        editor.open(recipe);
    window.panel().settings().setSimulated(true);
    window.panel().settings().set("access.hold_to_start", QStringLiteral("auto"));
    window.panel().maintenance().doctor()->cancel();
    window.panel().maintenance().inspector()->setGroup({});
    window.panel().maintenance().inspector()->setNameFilter({});
    window.panel().maintenance().jog()->letGo();
    window.panel().settings().overrideValue("stops.ask_after_seconds", QStringLiteral("600"));
    window.panel().stops().setup()->reasons()->restoreStandard();
    window.link().setSimulated(false);
    window.link().setLed(false);
    if (window.link().setOld(false))
        window.link().show(Situation::Empty);
    window.link().show(Situation::Running);
    forgetOrders(window);
    window.panel().controller().dismissMessage();
    window.panel().records().dismissNotice();
    window.panel().scan().dismissNotice();
    window.panel().settings().overrideValue("scanner.prefix", {});
    window.panel().settings().overrideValue("machine.name", {});
    window.settle();
    while (window.panel().alarms().shelved()->count() > 0)
        window.panel().alarms().unshelve(0);
    window.panel().alarms().acknowledgeAll();
    window.checkClock();
    screen.enter(window);
    window.settle();
}

} // namespace campanel::looks
