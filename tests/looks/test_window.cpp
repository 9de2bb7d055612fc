// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link; see stage.h.
#include "tests/looks/test_window.h"

#include "app/panel/settings/network_info.h"
#include "tests/support/fake_package.h"

#include <QTimeZone>

namespace campanel::looks {

namespace {

const QString longLanguage = QStringLiteral("long");

std::unique_ptr<LongTexts> longTextsFor(const Variant& variant)
{
    return variant.isLong() ? std::make_unique<LongTexts>() : nullptr;
}

} // namespace

bool Variant::isLong() const
{
    return language == longLanguage;
}

QString Variant::name() const
{
    const QString plain =
        QStringLiteral("%1-%2-%3x%4").arg(theme, language).arg(size.width()).arg(size.height());
    return gloves ? plain + QStringLiteral("-gloves") : plain;
}

TestWindow::TestWindow(const Variant& variant)
    : TouchDriver(m_panel)
    , m_longTexts(longTextsFor(variant))
    , m_panel(m_link,
              {m_folder.filePath(QStringLiteral("settings.ini")), test::withStoredRecipe(m_folder.path())})
{
    panel::NetworkInfo::fix({QDateTime(QDate(2026, 1, 15), QTime(14, 7), QTimeZone::utc()),
                             {QStringLiteral("eth0: 192.168.1.20, fe80::2e0:4cff:fe68:1")}});
    m_panel.settings().overrideValue("display.language",
                                     variant.isLong() ? QStringLiteral("en") : variant.language);
    m_panel.settings().overrideValue("display.theme", variant.theme);
    m_panel.settings().overrideValue("display.gloves", panel::settingText(variant.gloves));
    const auto wallClock = [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 6, 58)); };
    m_panel.controller().setWallClock(wallClock);
    m_panel.recipes().setWallClock(wallClock);
    m_panel.trends().setWallClock(
        [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7)).toMSecsSinceEpoch(); });
    m_panel.orders().setWallClock([wallClock] { return wallClock().toMSecsSinceEpoch(); });
    m_panel.stops().setWallClock(
        [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7)).toMSecsSinceEpoch(); });
    m_panel.backup().setWallClock(wallClock);
    m_panel.commissioning().setWallClock(wallClock);
    m_panel.alarms().setWallClock(wallClock);
    m_panel.audit().log()->filter()->setWallClock(wallClock);
    m_panel.alarms().setPaceMs(0);
    m_panel.systemClock().setBus(m_timeBus.bus());
    m_panel.systemNetwork().setBus(m_networkBus.bus());
    setUpUpdate();
    setUpTouch();
    checkClock();
    m_isReady = m_panel.load(variant.size);
    if (!m_isReady)
        return;
    theme()->setProperty("animated", false);
    frame()->setProperty("clockRuns", false);
    frame()->setProperty("now", QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
    m_panel.window().show();
    settle(); // the first frame comes before the first data, as on a machine
    m_panel.controller().open();
    m_panel.records().open();
    waitUntil(m_panel.recipes(), &panel::Recipes::listChanged,
              [](const panel::Recipes& recipes) { return recipes.total() > 0; });
}

// Installed is 0.1.0, on a computer whose folders are those of the test.
void TestWindow::setUpUpdate()
{
    const auto path = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
    QDir(m_folder.path()).mkpath(QStringLiteral("run"));
    if (!test::writeFile(path("package-keys/anna.json"), store::publicKeyFile(m_signer)))
        qWarning("the demonstration's key cannot be written");
    panel::SoftwareUpdate& update = m_panel.update();
    update.setPlaces({path("run"), path("update"), updateState(), path("package-keys")});
    update.setBus(m_unitBus.bus());
    update.setInstalled([] {
        return store::PackageId{QStringLiteral("campanel"), QStringLiteral("0.1.0+deb12"),
                                QStringLiteral("amd64")};
    });
    update.setScanner([folder = stick()](const QString&) {
        return QList<store::Place>{{folder, QStringLiteral("KINGSTON"), false, true}};
    });
}

// The computer has one touchscreen, which is not calibrated.
void TestWindow::setUpTouch()
{
    const QString device = touchFolder() + QStringLiteral("/devices/c13:64");
    if (!test::writeFile(device, "E:ID_INPUT=1\nE:ID_INPUT_TOUCHSCREEN=1\n"))
        qWarning("the demonstration's touchscreen cannot be written");
    panel::TouchCalibration& touch = m_panel.touchCalibration();
    touch.setPlaces({m_folder.filePath(QStringLiteral("run")), touchFolder(),
                     touchFolder() + QStringLiteral("/rule"), touchFolder() + QStringLiteral("/devices")});
    touch.setBus(m_unitBus.bus());
}

constexpr int maxInputGroups = 7;

void TestWindow::tap(const QString& name)
{
    const QStringList groups{QStringLiteral("maintenanceLine"), QStringLiteral("maintenanceMachine"),
                             QStringLiteral("maintenancePanel")};
    if (groups.contains(name) && !find(name)) {
        TouchDriver::tap(QStringLiteral("maintenanceGroup"));
        TouchDriver::tap(QStringLiteral("choice_%1").arg(groups.indexOf(name)));
        return;
    }
    // An input of another group is behind the key to the next one.
    const QString nextGroup = QStringLiteral("nextGroup");
    for (int turn = 0; turn < maxInputGroups && !find(name) && find(nextGroup); ++turn)
        TouchDriver::tap(nextGroup);
    const QString navigation = QStringLiteral("nav_");
    if (!name.startsWith(navigation) || find(name)) {
        TouchDriver::tap(name);
        return;
    }
    TouchDriver::tap(QStringLiteral("nav_more"));
    TouchDriver::tap(QStringLiteral("choice_") + name.mid(navigation.size()));
}

void TestWindow::setLevel(panel::Level level)
{
    m_panel.controller().accessCheck().setLevel(level);
    emit m_panel.access().changed();
    settle();
}

void TestWindow::checkClock()
{
    m_panel.controller().setClock([this] { return m_link.now(); });
    m_panel.maintenance().frames()->setTimeOfDay(m_link.now(), QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
}

template <typename Files> void TestWindow::waitUntilIdle(Files& files)
{
    waitUntil(files, &Files::changed, [](const Files& each) { return !each.busy(); });
}

void TestWindow::waitFor(panel::CamFiles& files)
{
    waitUntilIdle(files);
}

void TestWindow::waitForTrends()
{
    // Requests are answered in order; the second round is for requests that waited for the first answer.
    for (int round = 0; round < 2; ++round) {
        QEventLoop untilAnswered;
        m_panel.trends().store().run(
            &untilAnswered, [](store::Database&) { return true; }, [&](bool) { untilAnswered.quit(); });
        untilAnswered.exec();
    }
    settle();
}

void TestWindow::waitFor(panel::ReportFiles& files)
{
    waitUntilIdle(files);
}

void TestWindow::waitFor(panel::RecipeFiles& files)
{
    waitUntilIdle(files);
}

} // namespace campanel::looks
