// SPDX-License-Identifier: Apache-2.0
// The complete panel: settings, machine, editor, alarms, service, the QML engine and its window, in the
// language of the settings.
#pragma once

#include "app/link/link.h"
#include "app/panel/access/access.h"
#include "app/panel/alarms/alarms.h"
#include "app/panel/audit/audit.h"
#include "app/panel/audit/audit_trail.h"
#include "app/panel/controller/machine.h"
#include "app/panel/display/display.h"
#include "app/panel/editor/editor.h"
#include "app/panel/explain/explanations.h"
#include "app/panel/library/recipes.h"
#include "app/panel/maintenance/service.h"
#include "app/panel/records/records.h"
#include "app/panel/reports/backup.h"
#include "app/panel/reports/commissioning.h"
#include "app/panel/reports/service_bundle.h"
#include "app/panel/settings/settings.h"
#include "app/panel/trends/trends.h"
#include "app/shell/page_memory.h"

#include <QObject>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickWindow>
#include <QTranslator>

#include <array>
#include <memory>

namespace campanel::panel {

// The paths of the panel's persistent data. Empty: the user's standard folders.
struct Storage {
    QString settingsFile;
    QString recipeFolder;
    machine::StandardSettings standard{}; // until another value is set on the panel
};

class Panel : public QObject {
    Q_OBJECT

public:
    // The link must outlive the object. Starts to load the QML in the background.
    Panel(link::Link& link, const Storage& storage);
    ~Panel() override;

    [[nodiscard]] machine::Settings& settings() { return m_settings; }
    [[nodiscard]] machine::Machine& machine() { return m_machine; }
    [[nodiscard]] machine::Editor& editor() { return m_editor; }
    [[nodiscard]] machine::Records& records() { return m_records; }
    [[nodiscard]] machine::Alarms& alarms() { return m_alarms; }
    [[nodiscard]] machine::Recipes& recipes() { return m_recipes; }
    [[nodiscard]] machine::Service& service() { return m_service; }
    [[nodiscard]] machine::Trends& trends() { return m_trends; }
    [[nodiscard]] machine::Access& access() { return m_access; }
    [[nodiscard]] machine::AuditTrail& trail() { return m_trail; }
    [[nodiscard]] machine::Audit& audit() { return m_audit; }
    [[nodiscard]] machine::Backup& backup() { return m_backup; }
    [[nodiscard]] machine::Commissioning& commissioning() { return m_commissioning; }
    [[nodiscard]] machine::Display& display() { return m_display; }
    [[nodiscard]] machine::ServiceBundle& bundle() { return m_bundle; }
    [[nodiscard]] machine::Explanations& explanations() { return m_explanations; }
    [[nodiscard]] QQmlEngine& engine() { return m_engine; }

    // Connects to the controller and opens the databases. Call it after the first frame: line and disk can
    // wait, a person cannot.
    void open();

    // Loads the window, hidden, at its size from the first binding on, because a later resize lays out all
    // texts again. Opens the page of a run that was not ended properly. Returns false after QML errors, which
    // were logged.
    [[nodiscard]] bool load(QSize size);
    [[nodiscard]] QQuickWindow& window() { return *m_window; }

signals:
    // Emitted when its data was replaced on the disk: the panel must be rebuilt.
    void restartWanted();

private:
    void translate();

    store::FinishedRestore m_restore; // before anything is read
    machine::Settings m_settings;
    machine::Machine m_machine;
    machine::Editor m_editor;
    machine::Records m_records;
    machine::Alarms m_alarms;
    machine::Recipes m_recipes;
    machine::Service m_service;
    machine::Trends m_trends;
    machine::Access m_access;
    machine::AuditTrail m_trail;
    machine::Audit m_audit;
    machine::Backup m_backup;
    machine::Commissioning m_commissioning;
    machine::ServiceBundle m_bundle;
    machine::Display m_display;
    machine::Explanations m_explanations;
    std::array<QTranslator, 3> m_translators; // for the panel's QML, its C++, Qt itself
    QQmlEngine m_engine;
    QQmlComponent m_component{&m_engine};
    std::unique_ptr<QQuickWindow> m_window;
    PageMemory m_pageMemory; // after the window that it follows
};

} // namespace campanel::panel
