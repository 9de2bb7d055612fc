// SPDX-License-Identifier: Apache-2.0
// Watches controller, link, recipe, settings and database and reports when an alarm comes and goes.
#pragma once

#include "app/panel/alarms/fault_measure.h"
#include "app/panel/words/alarm_catalogue.h"
#include "app/program/dead_time_estimate.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/store_thread.h"

#include <QHash>
#include <QObject>
#include <QSet>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>

namespace campanel::panel {

class Editor;
class Controller;
class DatabaseService;
class Settings;

class AlarmWatch : public QObject {
    Q_OBJECT

public:
    // All arguments must outlive the object.
    AlarmWatch(Controller& controller, Editor& editor, DatabaseService& records, Settings& settings,
               QObject* parent);

    // Reports the initial state. Connect the signals first.
    void begin();
    // Sets how long a link may take to connect; 3 s by default.
    void setPatienceMs(int patienceMs) { m_patience.setInterval(patienceMs); }
    // Sets the function that counts the touchscreens. Fewer than at any earlier check are an alarm; without
    // the function none is raised.
    void setTouchscreenCount(std::function<int()> count) { m_countTouchscreens = std::move(count); }
    // Returns what broke the limit when this alarm was raised last; unknown for most.
    [[nodiscard]] FaultMeasure measureOf(const AlarmKind& kind) const { return m_measures.value(&kind); }
    // Ends the database alarm after a successful write.
    void noteStored();
    // Raises the alarm of a mark sensor that has drifted, or ends it.
    void noteSensorDrift(const std::optional<program::SensorDrift>& drift);
    // Checks the sources that have no signal of their own.
    void check();

signals:
    void raised(const campanel::panel::AlarmKind& kind, const QString& detail);
    void cleared(const campanel::panel::AlarmKind& kind, campanel::store::AlarmRow::End end);

private:
    using Kinds = QSet<const AlarmKind*>;

    void noteController();
    void setControllerAlarms(const Kinds& now, const QString& detail, store::AlarmRow::End end);
    [[nodiscard]] FaultMeasure measured(const AlarmKind& kind) const;
    // Returns the values that broke the limit, as far as the controller reports them.
    [[nodiscard]] QString valuesOf(const AlarmKind& kind) const;
    void noteLink();
    void setLinkAlarm(const AlarmKind* kind);
    void noteRecipe();
    void noteOpening(const store::StoreThread::Report& report);
    void noteTrouble(const store::StoreError& error);
    // Raises or clears the alarm when the state has changed.
    void setLasting(bool& state, bool now, const AlarmKind& kind);
    // Reports an event, which does not last.
    void raiseEvent(const AlarmKind& kind, const QString& detail);

    Controller& m_controller;
    Editor& m_editor;
    Settings& m_settings;
    QTimer m_patience;
    bool m_isPatienceOver = false;
    QHash<const AlarmKind*, FaultMeasure> m_measures;
    Kinds m_byController;
    const AlarmKind* m_link = nullptr;
    Kinds m_store; // until the next successful write
    bool m_areSettingsLost = false;
    std::function<int()> m_countTouchscreens;
    int m_touchscreens = 0; // the most that there were
    bool m_isTouchscreenMissing = false;
};

} // namespace campanel::panel
