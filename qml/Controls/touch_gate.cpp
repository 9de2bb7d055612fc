// SPDX-License-Identifier: Apache-2.0
#include "touch_gate.h"

#include <QAccessible>
#include <QQuickWindow>

#include <algorithm>

namespace campanel::controls {

TouchGate::TouchGate(QQuickItem* parent)
    : QQuickItem(parent)
{
    setAcceptedMouseButtons(Qt::LeftButton);
    setAcceptTouchEvents(true);
}

bool TouchGate::isIn(QQuickItem* item, QQuickItem* ancestor) const
{
    return item && ancestor && (item == ancestor || ancestor->isAncestorOf(item));
}

// Returns the topmost item that takes touches at that place, without this one.
QQuickItem* TouchGate::targetAt(QQuickItem& below, const QPointF& scene) const
{
    const QPointF at = below.mapFromScene(scene);
    if (&below == this || !below.isVisible() || !below.isEnabled() || (below.clip() && !below.contains(at)))
        return nullptr;
    QList<QQuickItem*> children = below.childItems();
    std::ranges::stable_sort(children, {}, &QQuickItem::z);
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
        if (QQuickItem* found = targetAt(**child, scene))
            return found;
    }
    return below.acceptedMouseButtons() != Qt::NoButton && below.contains(at) ? &below : nullptr;
}

bool TouchGate::stops(const QPointF& scene)
{
    m_isRefused = false;
    QQuickItem* target = targetAt(*window()->contentItem(), scene);
    const QAccessibleInterface* named = target ? QAccessible::queryAccessibleInterface(target) : nullptr;
    emit touched(target, named && !named->text(QAccessible::Name).isEmpty());
    // Another item may stand there now, because of touched(); nobody meant to touch it.
    return m_isRefused || targetAt(*window()->contentItem(), scene) != target;
}

void TouchGate::mousePressEvent(QMouseEvent* event)
{
    event->setAccepted(stops(event->scenePosition()));
}

// Its press came before.
void TouchGate::mouseDoubleClickEvent(QMouseEvent* event)
{
    event->setAccepted(m_isRefused);
}

void TouchGate::touchEvent(QTouchEvent* event)
{
    const auto pressed = std::ranges::find(event->points(), QEventPoint::Pressed, &QEventPoint::state);
    event->setAccepted(pressed == event->points().end() || stops(pressed->scenePosition()));
}

void TouchGate::itemChange(ItemChange change, const ItemChangeData& value)
{
    if (change == ItemSceneChange && value.window)
        value.window->installEventFilter(this);
    QQuickItem::itemChange(change, value);
}

bool TouchGate::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::TouchEnd)
        QMetaObject::invokeMethod(this, &TouchGate::lifted, Qt::QueuedConnection);
    return QQuickItem::eventFilter(watched, event);
}

} // namespace campanel::controls
