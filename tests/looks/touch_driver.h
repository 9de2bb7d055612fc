// SPDX-License-Identifier: Apache-2.0
// Operates a panel's window like a finger: find by name, tap, hold, type, grab. For captures, the self-test
// and the tests, with any link.
#pragma once

#include "app/shell/panel.h"

#include <QImage>
#include <QQuickItem>
#include <QStringList>

namespace campanel::looks {

class TouchDriver {
public:
    // The panel must outlive the object and be loaded before any call.
    explicit TouchDriver(shell::Panel& panel)
        : m_panel(panel)
    {
    }

    [[nodiscard]] QQuickWindow& window() { return m_panel.window(); }
    [[nodiscard]] QQuickItem& root() { return *m_panel.window().contentItem(); }
    [[nodiscard]] QObject* theme(); // the Theme singleton
    [[nodiscard]] QObject* frame(); // parent of every page
    [[nodiscard]] const QStringList& complaints() const { return m_complaints; }

    // Returns the first visible item with that objectName, or null.
    [[nodiscard]] QQuickItem* find(const QString& name);
    // Returns the visible item with that accessible name that a finger reaches, or null.
    [[nodiscard]] QQuickItem* findNamed(const QString& accessibleName);
    // Taps an item, scrolled into sight. An item that is not there, covered or disabled, or has no accessible
    // name, becomes a complaint and is not pressed.
    void tap(const QString& name);
    void tap(QQuickItem& item);
    void tapNamed(const QString& accessibleName);
    void hold(const QString& name);
    // Presses the center of an item and holds it; the next call releases it.
    void touch(const QString& name);
    void touch(QQuickItem& item);
    void slide(const QPointF& to); // to a place in the window, px
    void lift();
    void type(const QString& keys);
    void closeDialogs();
    // Handles events, settles bindings and layout, and draws one frame.
    void settle();
    [[nodiscard]] QImage grab();

protected:
    void reportError(const QString& complaint) { m_complaints += complaint; }

private:
    void press(const QString& name, int holdMs);
    void press(QQuickItem& item, int holdMs);

    shell::Panel& m_panel;
    QPointF m_place; // of a finger that is down
    QStringList m_complaints;
};

} // namespace campanel::looks
