// SPDX-License-Identifier: Apache-2.0
// The panel put together: settings, machine, editor, service, the QML engine and its window, in the language
// of the settings.
#pragma once

#include "app/link/link.h"
#include "app/machine/editor.h"
#include "app/machine/machine.h"
#include "app/machine/records.h"
#include "app/machine/service.h"
#include "app/machine/settings.h"

#include <QObject>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickWindow>
#include <QTranslator>

#include <array>
#include <memory>

namespace campanel::panel {

// Where a panel keeps what outlives it. Empty: the user's usual places.
struct Storage {
    QString settingsFile;
    QString recipeFolder;
};

class Panel : public QObject {
    Q_OBJECT

public:
    // The link must outlive it. Begins to load the QML in the background.
    Panel(link::Link& link, const Storage& storage);
    ~Panel() override;

    [[nodiscard]] machine::Settings& settings() { return m_settings; }
    [[nodiscard]] machine::Machine& machine() { return m_machine; }
    [[nodiscard]] machine::Editor& editor() { return m_editor; }
    [[nodiscard]] machine::Records& records() { return m_records; }
    [[nodiscard]] machine::Service& service() { return m_service; }
    [[nodiscard]] QQmlEngine& engine() { return m_engine; }

    // Loads the window, hidden, at its size from the first binding on: a later resize lays all texts out
    // again. False after QML errors, which went to the log.
    [[nodiscard]] bool load(QSize size);
    [[nodiscard]] QQuickWindow& window() { return *m_window; }

private:
    void translate();

    machine::Settings m_settings;
    machine::Machine m_machine;
    machine::Editor m_editor;
    machine::Records m_records;
    machine::Service m_service;
    std::array<QTranslator, 3> m_translators; // the panel's QML, its C++, Qt itself
    QQmlEngine m_engine;
    QQmlComponent m_component{&m_engine};
    std::unique_ptr<QQuickWindow> m_window;
};

} // namespace campanel::panel
