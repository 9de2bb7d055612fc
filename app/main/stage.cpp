// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link; see stage.h.
#include "app/main/stage.h"

#include <QEventLoop>

namespace campanel::panel {

QString Look::name() const
{
    return QStringLiteral("%1-%2-%3x%4").arg(theme, language).arg(size.width()).arg(size.height());
}

Stage::Stage(const Look& look)
    : Finger(m_panel)
    , m_panel(m_link, {m_folder.filePath(QStringLiteral("settings.ini")), m_folder.path()})
{
    m_panel.settings().overrideLanguage(look.language);
    m_panel.settings().overrideTheme(look.theme);
    m_panel.machine().setWallClock([] { return QDateTime(QDate(2026, 1, 15), QTime(14, 6, 58)); });
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
    settle();
}

void Stage::lookAtClock()
{
    m_panel.machine().setClock([this] { return m_link.now(); });
    m_panel.service().frames()->setTimeOfDay(m_link.now(), QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
}

template <typename Files> void Stage::waitUntilIdle(Files& files)
{
    QEventLoop untilFound;
    QObject::connect(&files, &Files::changed, &untilFound, [&] {
        if (!files.busy())
            untilFound.quit();
    });
    if (files.busy())
        untilFound.exec();
    settle();
}

void Stage::waitFor(machine::KnotFiles& files)
{
    waitUntilIdle(files);
}

void Stage::waitFor(machine::ReportFiles& files)
{
    waitUntilIdle(files);
}

} // namespace campanel::panel
