// SPDX-License-Identifier: Apache-2.0
// A panel on the demonstration link, driven as a finger would: find by name, tap, hold, type, grab. For
// captures and the self-test.
#pragma once

#include "app/main/demo_link.h"
#include "app/main/panel.h"

#include <QImage>
#include <QQuickItem>
#include <QTemporaryDir>

namespace campanel::panel {

struct Look {
    QString language;
    QString theme;
    QSize size;

    [[nodiscard]] QString name() const; // "light-en-1024x600"
};

class Stage {
public:
    explicit Stage(const Look& look);

    // False when the window could not be loaded.
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] QQuickWindow& window() { return m_panel.window(); }
    [[nodiscard]] QQuickItem& root() { return *m_panel.window().contentItem(); }
    [[nodiscard]] QObject* theme(); // the Theme singleton
    [[nodiscard]] DemoLink& link() { return m_link; }
    [[nodiscard]] Panel& panel() { return m_panel; }
    [[nodiscard]] const QStringList& complaints() const { return m_complaints; }

    // The first visible item of that objectName; null if there is none.
    [[nodiscard]] QQuickItem* find(const QString& name);
    // What cannot be found or reached becomes a complaint.
    void tap(const QString& name);
    void hold(const QString& name);
    void type(const QString& keys);
    void closeDialogs();
    // The machine looks at the age of its data now; by itself it does so every tenth of a real second.
    void lookAtClock();
    // Events handled, bindings and layout settled, one frame drawn.
    void settle();
    [[nodiscard]] QImage grab();

private:
    void press(const QString& name, int holdMs);

    QTemporaryDir m_folder;
    DemoLink m_link{nullptr};
    Panel m_panel;
    QStringList m_complaints;
    bool m_isReady = false;
};

} // namespace campanel::panel
