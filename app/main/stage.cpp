// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link; see stage.h.
#include "app/main/stage.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>

#include <functional>

namespace campanel::panel {
namespace {

constexpr int holdTimeMs = 1000; // longer than a long press

QQuickItem* visibleItem(QQuickItem& below, const QString& name)
{
    if (!below.isVisible())
        return nullptr;
    if (below.objectName() == name)
        return &below;
    for (QQuickItem* child : below.childItems()) {
        if (QQuickItem* found = visibleItem(*child, name))
            return found;
    }
    return nullptr;
}

void sendMouse(QQuickWindow& window, QEvent::Type type, const QPointF& at)
{
    const Qt::MouseButtons buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, window.mapToGlobal(at), Qt::LeftButton, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
}

} // namespace

QString Look::name() const
{
    return QStringLiteral("%1-%2-%3x%4").arg(theme, language).arg(size.width()).arg(size.height());
}

Stage::Stage(const Look& look)
    : m_panel(m_link, {m_folder.filePath(QStringLiteral("settings.ini")), m_folder.path()})
{
    m_panel.settings().overrideLanguage(look.language);
    m_panel.settings().overrideTheme(look.theme);
    lookAtClock();
    m_isReady = m_panel.load(look.size);
    if (!m_isReady)
        return;
    auto* frame = m_panel.window().property("frame").value<QObject*>();
    theme()->setProperty("animated", false);
    frame->setProperty("clockRuns", false);
    frame->setProperty("now", QDateTime(QDate(2026, 1, 15), QTime(14, 7)));
    m_panel.window().show();
    settle(); // the first frame comes before the first data, as on a machine
    m_panel.machine().open();
    settle();
}

void Stage::lookAtClock()
{
    m_panel.machine().setClock([this] { return m_link.now(); });
}

QObject* Stage::theme()
{
    return window().property("theme").value<QObject*>();
}

QQuickItem* Stage::find(const QString& name)
{
    return visibleItem(root(), name);
}

void Stage::press(const QString& name, int holdMs)
{
    QQuickItem* item = find(name);
    if (!item) {
        m_complaints += QStringLiteral("%1 is not on the screen").arg(name);
        return;
    }
    const QPointF at = item->mapToScene(item->boundingRect().center());
    sendMouse(window(), QEvent::MouseButtonPress, at);
    QElapsedTimer held;
    held.start();
    while (held.elapsed() < holdMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, holdMs);
    sendMouse(window(), QEvent::MouseButtonRelease, at);
    settle();
}

void Stage::tap(const QString& name)
{
    press(name, 0);
}

void Stage::hold(const QString& name)
{
    press(name, holdTimeMs);
}

void Stage::type(const QString& keys)
{
    for (const QChar key : keys) {
        QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, QString(key));
        QCoreApplication::sendEvent(&window(), &event);
    }
    settle();
}

void Stage::closeDialogs()
{
    QMetaObject::invokeMethod(window().property("frame").value<QObject*>(), "closeAll");
    settle();
}

void Stage::settle()
{
    constexpr int rounds = 4; // loaders, then their bindings, then polish
    for (int i = 0; i < rounds; ++i) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr,
                                           QEvent::DeferredDelete); // closed dialogs; no event loop runs here
    }
    (void)grab();
}

QImage Stage::grab()
{
    return window().grabWindow();
}

} // namespace campanel::panel
