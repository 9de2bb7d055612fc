// SPDX-License-Identifier: Apache-2.0
// Drives a panel's window as a finger would: find by name, tap, hold, type, grab. The panel may have any
// link.
#pragma once

#include "app/shell/panel.h"

#include <QImage>
#include <QQuickItem>
#include <QStringList>

namespace campanel::looks {

class Finger {
public:
    // The panel must outlive it and be loaded before anything is called here.
    explicit Finger(panel::Panel& panel)
        : m_panel(panel)
    {
    }

    [[nodiscard]] QQuickWindow& window() { return m_panel.window(); }
    [[nodiscard]] QQuickItem& root() { return *m_panel.window().contentItem(); }
    [[nodiscard]] QObject* theme(); // the Theme singleton
    [[nodiscard]] QObject* frame(); // what every page stands in
    [[nodiscard]] const QStringList& complaints() const { return m_complaints; }

    // The first visible item of that objectName; null if there is none.
    [[nodiscard]] QQuickItem* find(const QString& name);
    // What cannot be found or reached becomes a complaint.
    void tap(const QString& name);
    void tap(QQuickItem& item);
    void hold(const QString& name);
    // Goes down on an item's middle and stays there; then wherever it is, up again.
    void touch(const QString& name);
    void slide(const QPointF& to); // in the window, px
    void lift();
    void type(const QString& keys);
    void closeDialogs();
    // Events handled, bindings and layout settled, one frame drawn.
    void settle();
    [[nodiscard]] QImage grab();

protected:
    void complain(const QString& complaint) { m_complaints += complaint; }

private:
    void press(const QString& name, int holdMs);
    void press(QQuickItem& item, int holdMs);

    panel::Panel& m_panel;
    QPointF m_place; // of a finger that is down
    QStringList m_complaints;
};

} // namespace campanel::looks
