// SPDX-License-Identifier: Apache-2.0
// The complete panel: settings, machine, editor, alarms, maintenance, the QML engine and its window, in the
// language of the settings.
#pragma once

#include "app/link/link.h"
#include "app/panel/access/access.h"
#include "app/panel/alarms/alarms.h"
#include "app/panel/audit/audit.h"
#include "app/panel/audit/audit_trail.h"
#include "app/panel/controller/controller.h"
#include "app/panel/display/display.h"
#include "app/panel/display/screen_rotation.h"
#include "app/panel/display/touch_calibration.h"
#include "app/panel/editor/editor.h"
#include "app/panel/explain/explanations.h"
#include "app/panel/hand/hand_bags.h"
#include "app/panel/hand/hand_speed.h"
#include "app/panel/hand/hand_trims.h"
#include "app/panel/library/builder_files.h"
#include "app/panel/library/recipes.h"
#include "app/panel/maintenance/maintenance.h"
#include "app/panel/orders/orders.h"
#include "app/panel/plant/plant_feed.h"
#include "app/panel/records/database_service.h"
#include "app/panel/reports/backup.h"
#include "app/panel/reports/commissioning.h"
#include "app/panel/reports/service_bundle.h"
#include "app/panel/reports/shift_report.h"
#include "app/panel/scan/scan.h"
#include "app/panel/settings/settings.h"
#include "app/panel/settings/system_clock.h"
#include "app/panel/settings/system_network.h"
#include "app/panel/stops/stops.h"
#include "app/panel/trends/trends.h"
#include "app/panel/update/software_update.h"
#include "app/panel/update/versions.h"
#include "app/shell/page_memory.h"

#include <QImage>
#include <QObject>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickWindow>
#include <QTranslator>

#include <memory>

namespace campanel::shell {

// The paths of the panel's persistent data. Empty: the user's standard folders.
struct Storage {
    QString settingsFile;
    QString recipeFolder;
    panel::SettingValues standard{}; // until another value is set on the panel
    QString keyFolder{};             // public keys of those who sign recipes; empty: none
    QString diskLost{};              // why the disk for the data is missing; empty: it is there
    QString builderFolder{};         // what the boot has taken from the machine builder's card
    QStringList complaints{};        // about the machine builder's configuration, a sentence each
};

class Panel : public QObject {
    Q_OBJECT

public:
    // The link must outlive the object. Starts to load the QML in the background.
    Panel(link::Link& link, const Storage& storage);
    ~Panel() override;

    [[nodiscard]] panel::Settings& settings() { return m_settings; }
    [[nodiscard]] panel::Controller& controller() { return m_controller; }
    [[nodiscard]] panel::Editor& editor() { return m_editor; }
    [[nodiscard]] panel::DatabaseService& records() { return m_records; }
    [[nodiscard]] panel::Alarms& alarms() { return m_alarms; }
    [[nodiscard]] panel::SystemClock& systemClock() { return m_systemClock; }
    [[nodiscard]] panel::SystemNetwork& systemNetwork() { return m_systemNetwork; }
    [[nodiscard]] panel::Recipes& recipes() { return m_recipes; }
    [[nodiscard]] panel::BuilderFiles& builderFiles() { return m_builderFiles; }
    [[nodiscard]] panel::Scan& scan() { return m_scan; }
    [[nodiscard]] panel::Maintenance& maintenance() { return m_maintenance; }
    [[nodiscard]] panel::Trends& trends() { return m_trends; }
    [[nodiscard]] panel::Stops& stops() { return m_stops; }
    [[nodiscard]] panel::Orders& orders() { return m_orders; }
    [[nodiscard]] panel::HandTrims& handTrims() { return m_handTrims; }
    [[nodiscard]] panel::Access& access() { return m_access; }
    [[nodiscard]] panel::AuditTrail& trail() { return m_trail; }
    [[nodiscard]] panel::Audit& audit() { return m_audit; }
    [[nodiscard]] panel::SoftwareUpdate& update() { return m_update; }
    [[nodiscard]] panel::Versions& versions() { return m_versions; }
    [[nodiscard]] panel::Backup& backup() { return m_backup; }
    [[nodiscard]] panel::Commissioning& commissioning() { return m_commissioning; }
    [[nodiscard]] panel::ShiftReport& shiftReport() { return m_shiftReport; }
    [[nodiscard]] panel::Display& display() { return m_display; }
    [[nodiscard]] panel::ScreenRotation& rotation() { return m_rotation; }
    [[nodiscard]] panel::TouchCalibration& touchCalibration() { return m_touchCalibration; }
    [[nodiscard]] panel::ServiceBundle& bundle() { return m_bundle; }
    [[nodiscard]] panel::Explanations& explanations() { return m_explanations; }
    [[nodiscard]] QQmlEngine& engine() { return m_qml->engine; }

    // Returns true when this panel's folder has data of an earlier run.
    [[nodiscard]] bool wasSetUp() const { return m_wasSetUp; }
    // Connects to the controller and opens the databases, in their threads. Call it before the window is
    // shown: a Stop needs the line as soon as it can be touched.
    void open();

    // Loads the window, hidden, at its size from the first binding on, because a later resize lays out all
    // texts again. Opens the page of a run that was not ended properly. Returns false after QML errors, which
    // were logged.
    [[nodiscard]] bool load(QSize size);
    [[nodiscard]] QQuickWindow& window() { return *m_window; }
    // Returns the present picture, upright also on a rotated screen.
    [[nodiscard]] QImage picture();

signals:
    // Emitted when its data was replaced on the disk: the panel must be rebuilt.
    void restartWanted();

private:
    void translate();

    // The engine with the component of the window, which loads while the other parts are created.
    struct Qml {
        Qml();
        QQmlEngine engine;
        QQmlComponent component{&engine};
    };
    std::unique_ptr<Qml> m_qml = std::make_unique<Qml>(); // deleted first, in the destructor
    Storage m_storage;
    store::FinishedRestore m_restore; // before anything is read
    bool m_wasSetUp = false;
    panel::Settings m_settings;
    panel::Controller m_controller;
    panel::Editor m_editor;
    panel::DatabaseService m_records;
    panel::Alarms m_alarms;
    panel::Recipes m_recipes;
    panel::BuilderFiles m_builderFiles;
    panel::Scan m_scan; // its filter sees a key after those of the members below
    panel::Maintenance m_maintenance;
    panel::Trends m_trends;
    panel::Stops m_stops;
    panel::HandSpeed m_handSpeed;
    panel::HandTrims m_handTrims;
    panel::HandBags m_handBags;
    panel::Orders m_orders;
    panel::Access m_access;
    panel::SystemClock m_systemClock;
    panel::SystemNetwork m_systemNetwork;
    panel::AuditTrail m_trail;
    panel::Audit m_audit;
    panel::Backup m_backup;
    panel::SoftwareUpdate m_update;
    panel::Versions m_versions;
    panel::Commissioning m_commissioning;
    panel::ShiftReport m_shiftReport;
    panel::ServiceBundle m_bundle;
    panel::Display m_display;
    panel::ScreenRotation m_rotation;
    panel::TouchCalibration m_touchCalibration;
    panel::Explanations m_explanations;
    panel::PlantFeed m_plant;
    bool m_hasBroker = false; // the configuration names one
    QTranslator m_texts;
    QTranslator m_textsOfQt;
    std::unique_ptr<QQuickWindow> m_window;
    PageMemory m_pageMemory; // after the window that it follows
};

} // namespace campanel::shell
