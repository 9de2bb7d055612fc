// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link; see stage.h.
#include "tests/looks/stage.h"

#include "app/panel/settings/network_info.h"

#include <QTimeZone>

namespace campanel::looks {

namespace {

const QString longLanguage = QStringLiteral("long");

std::unique_ptr<LongTexts> longTextsFor(const Look& look)
{
    return look.isLong() ? std::make_unique<LongTexts>() : nullptr;
}

} // namespace

bool Look::isLong() const
{
    return language == longLanguage;
}

QString Look::name() const
{
    const QString plain =
        QStringLiteral("%1-%2-%3x%4").arg(theme, language).arg(size.width()).arg(size.height());
    return gloves ? plain + QStringLiteral("-gloves") : plain;
}

Stage::Stage(const Look& look)
    : Finger(m_panel)
    , m_longTexts(longTextsFor(look))
    , m_panel(m_link, {m_folder.filePath(QStringLiteral("settings.ini")), m_folder.path()})
{
    panel::NetworkInfo::fix({QDateTime(QDate(2026, 1, 15), QTime(14, 7), QTimeZone::utc()),
                             {QStringLiteral("eth0: 192.168.1.20, fe80::2e0:4cff:fe68:1")}});
    m_panel.settings().overrideLanguage(look.isLong() ? QStringLiteral("en") : look.language);
    m_panel.settings().overrideTheme(look.theme);
    m_panel.settings().overrideGloves(look.gloves);
    const auto wallClock = [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 6, 58)); };
    m_panel.machine().setWallClock(wallClock);
    m_panel.recipes().setWallClock(wallClock);
    m_panel.trends().setWallClock(
        [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7)).toMSecsSinceEpoch(); });
    m_panel.backup().setWallClock(wallClock);
    m_panel.commissioning().setWallClock(wallClock);
    m_panel.alarms().setWallClock(wallClock);
    m_panel.alarms().setPaceMs(0);
    lookAtClock();
    m_isReady = m_panel.load(look.size);
    if (!m_isReady)
        return;
    theme()->setProperty("animated", false);
    frame()->setProperty("clockRuns", false);
    frame()->setProperty("now", QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
    m_panel.window().show();
    settle(); // the first frame comes before the first data, as on a machine
    m_panel.machine().open();
    m_panel.records().open();
    waitUntil(m_panel.recipes(), &panel::Recipes::listChanged,
              [](const panel::Recipes& recipes) { return recipes.ready(); });
}

void Stage::tap(const QString& name)
{
    const QStringList groups{QStringLiteral("serviceLine"), QStringLiteral("serviceMachine"),
                             QStringLiteral("servicePanel")};
    if (groups.contains(name) && !find(name)) {
        Finger::tap(QStringLiteral("serviceGroup"));
        Finger::tap(QStringLiteral("choice_%1").arg(groups.indexOf(name)));
        return;
    }
    const QString navigation = QStringLiteral("nav_");
    if (!name.startsWith(navigation) || find(name)) {
        Finger::tap(name);
        return;
    }
    Finger::tap(QStringLiteral("nav_more"));
    Finger::tap(QStringLiteral("choice_") + name.mid(navigation.size()));
}

void Stage::lookAtClock()
{
    m_panel.machine().setClock([this] { return m_link.now(); });
    m_panel.service().frames()->setTimeOfDay(m_link.now(), QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
}

template <typename Files> void Stage::waitUntilIdle(Files& files)
{
    waitUntil(files, &Files::changed, [](const Files& each) { return !each.busy(); });
}

void Stage::waitFor(panel::KnotFiles& files)
{
    waitUntilIdle(files);
}

void Stage::waitForTrends()
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

void Stage::waitFor(panel::ReportFiles& files)
{
    waitUntilIdle(files);
}

void Stage::waitFor(panel::RecipeFiles& files)
{
    waitUntilIdle(files);
}

} // namespace campanel::looks
