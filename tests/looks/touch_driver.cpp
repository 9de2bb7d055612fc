// SPDX-License-Identifier: Apache-2.0
// Mouse and key events for a panel's window; see finger.h.
#include "tests/looks/touch_driver.h"

#include <QAccessible>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>

#include <algorithm>

namespace campanel::looks {
namespace {

constexpr int longPressMs = 1; // during a hold, to avoid waiting in real time
constexpr int holdTimeMs = 20; // longer than longPressMs

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

bool isInside(const QQuickItem& ancestor, const QQuickItem* item)
{
    while (item && item != &ancestor)
        item = item->parentItem();
    return item != nullptr;
}

// Returns the topmost item at a place that a finger can press.
QQuickItem* pressedAt(QQuickItem& below, const QPointF& scene)
{
    if (!below.isVisible() || !below.isEnabled())
        return nullptr;
    const QPointF at = below.mapFromScene(scene);
    if (below.clip() && !below.contains(at))
        return nullptr;
    const QList<QQuickItem*> children = below.childItems();
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
        if (QQuickItem* found = pressedAt(**child, scene))
            return found;
    }
    // A PointHandler and a TouchGate see a press; what is below may get it.
    const bool onlySees =
        std::ranges::any_of(below.children(),
                            [](const QObject* child) { return child->inherits("QQuickPointHandler"); }) ||
        below.inherits("campanel::controls::TouchGate");
    return below.acceptedMouseButtons() != Qt::NoButton && !onlySees && below.contains(at) ? &below : nullptr;
}

QString accessibleName(QQuickItem& item)
{
    const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&item);
    return interface ? interface->text(QAccessible::Name) : QString();
}

// Returns what a finger on the item's center presses: the item or a part of it or, for a text that takes no
// press itself, what it stands on. Returns null if the item is covered, scrolled out or disabled.
QQuickItem* reachedAt(QQuickItem& root, const QQuickItem& item)
{
    QQuickItem* pressed = pressedAt(root, item.mapToScene(item.boundingRect().center()));
    const bool isOnPressed = pressed && item.isEnabled() && item.acceptedMouseButtons() == Qt::NoButton &&
                             isInside(*pressed, &item);
    return isInside(item, pressed) || isOnPressed ? pressed : nullptr;
}

// Scrolls the lists around an item until its center is in sight, as a finger does first.
void scrollIntoSight(const QQuickItem& item)
{
    for (QQuickItem* parent = item.parentItem(); parent; parent = parent->parentItem()) {
        const QPointF at = parent->mapFromItem(&item, item.boundingRect().center());
        if (!parent->inherits("QQuickFlickable") || parent->contains(at))
            continue;
        const double top = parent->property("contentY").toDouble() + at.y() - parent->height() / 2;
        const double end = parent->property("contentHeight").toDouble() - parent->height();
        parent->setProperty("contentY", std::clamp(top, 0.0, std::max(0.0, end)));
    }
}

QQuickItem* namedItem(QQuickItem& root, QQuickItem& below, const QString& name)
{
    if (!below.isVisible())
        return nullptr;
    if (below.acceptedMouseButtons() != Qt::NoButton && accessibleName(below) == name &&
        reachedAt(root, below))
        return &below;
    for (QQuickItem* child : below.childItems()) {
        if (QQuickItem* found = namedItem(root, *child, name))
            return found;
    }
    return nullptr;
}

void sendMouse(QQuickWindow& window, QEvent::Type type, const QPointF& at)
{
    const Qt::MouseButtons buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    // A move with a button would count as another press.
    const Qt::MouseButton changed = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, window.mapToGlobal(at), changed, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
}

} // namespace

QObject* TouchDriver::theme()
{
    return window().property("theme").value<QObject*>();
}

QObject* TouchDriver::frame()
{
    return window().property("frame").value<QObject*>();
}

QQuickItem* TouchDriver::find(const QString& name)
{
    return visibleItem(root(), name);
}

QQuickItem* TouchDriver::findNamed(const QString& accessibleName)
{
    return namedItem(root(), root(), accessibleName);
}

void TouchDriver::tapNamed(const QString& accessibleName)
{
    if (QQuickItem* item = findNamed(accessibleName))
        press(*item, 0);
    else
        m_complaints += QStringLiteral("nothing named \"%1\" can be touched").arg(accessibleName);
}

void TouchDriver::press(const QString& name, int holdMs)
{
    QQuickItem* item = find(name);
    if (!item) {
        m_complaints += QStringLiteral("%1 is not on the screen").arg(name);
        return;
    }
    press(*item, holdMs);
}

void TouchDriver::press(QQuickItem& item, int holdMs)
{
    scrollIntoSight(item);
    QQuickItem* pressed = reachedAt(root(), item);
    if (!pressed) {
        m_complaints += QStringLiteral("%1 is covered or disabled").arg(item.objectName());
        return;
    }
    if (accessibleName(item).isEmpty() && accessibleName(*pressed).isEmpty()) {
        m_complaints += QStringLiteral("%1 has no accessible name").arg(item.objectName());
        return;
    }
    const QPointF at = item.mapToScene(item.boundingRect().center());
    sendMouse(window(), QEvent::MouseButtonPress, at);
    QElapsedTimer held;
    held.start();
    while (held.elapsed() < holdMs)
        QCoreApplication::processEvents(QEventLoop::AllEvents, holdMs);
    if (holdMs > 0)
        QCoreApplication::processEvents(); // a timer that has expired
    sendMouse(window(), QEvent::MouseButtonRelease, at);
    settle();
}

void TouchDriver::tap(const QString& name)
{
    press(name, 0);
}

void TouchDriver::tap(QQuickItem& item)
{
    press(item, 0);
}

void TouchDriver::hold(const QString& name)
{
    QStyleHints& hints = *QGuiApplication::styleHints(); // for keys; other items use the theme's
    const int usualMs = hints.mousePressAndHoldInterval();
    const QVariant usualTime = theme()->property("longPressTime");
    hints.setMousePressAndHoldInterval(longPressMs);
    theme()->setProperty("longPressTime", longPressMs);
    press(name, holdTimeMs);
    hints.setMousePressAndHoldInterval(usualMs);
    theme()->setProperty("longPressTime", usualTime);
}

void TouchDriver::touch(const QString& name)
{
    if (QQuickItem* item = find(name))
        touch(*item);
    else
        m_complaints += QStringLiteral("%1 is not on the screen").arg(name);
}

void TouchDriver::touch(QQuickItem& item)
{
    scrollIntoSight(item);
    m_place = item.mapToScene(item.boundingRect().center());
    sendMouse(window(), QEvent::MouseButtonPress, m_place);
}

void TouchDriver::slide(const QPointF& to)
{
    m_place = to;
    sendMouse(window(), QEvent::MouseMove, m_place);
}

void TouchDriver::lift()
{
    sendMouse(window(), QEvent::MouseButtonRelease, m_place);
}

void TouchDriver::type(const QString& keys)
{
    for (const QChar key : keys) {
        QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, QString(key));
        QCoreApplication::sendEvent(&window(), &event);
    }
    settle();
}

void TouchDriver::closeDialogs()
{
    QMetaObject::invokeMethod(frame(), "closeAll");
    settle();
}

void TouchDriver::settle()
{
    constexpr int rounds = 4; // loaders, then their bindings, then layout
    for (int i = 0; i < rounds; ++i) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr,
                                           QEvent::DeferredDelete); // deletes closed dialogs; no event loop
                                                                    // runs here
    }
    QEvent frame(QEvent::UpdateRequest); // draws at once, without a copy as in grab()
    QCoreApplication::sendEvent(&window(), &frame);
}

QImage TouchDriver::grab()
{
    return window().grabWindow();
}

} // namespace campanel::looks
