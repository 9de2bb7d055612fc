// SPDX-License-Identifier: Apache-2.0
// Looks at controller, link, recipe, settings and database and tells when an alarm comes and when it goes.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/store_thread.h"

#include <QObject>
#include <QSet>
#include <QTimer>

namespace campanel::machine {

class Editor;
class Machine;
class Records;
class Settings;

class AlarmWatch : public QObject {
    Q_OBJECT

public:
    // All must outlive it.
    AlarmWatch(Machine& machine, Editor& editor, Records& records, Settings& settings, QObject* parent);

    // What there is at the beginning. Connect to the signals before.
    void begin();
    // How long a link may take to come up; 3 s by default.
    void setPatienceMs(int patienceMs) { m_patience.setInterval(patienceMs); }
    // Something was written to the database.
    void noteStored();
    // What says nothing by itself.
    void look();

signals:
    void raised(const campanel::machine::AlarmKind& kind, const QString& detail);
    void cleared(const campanel::machine::AlarmKind& kind, campanel::store::AlarmRow::End end);

private:
    using Kinds = QSet<const AlarmKind*>;

    void noteController();
    void tellController(const Kinds& now, const QString& detail, store::AlarmRow::End end);
    void noteLink();
    void tellLink(const AlarmKind* kind);
    void noteRecipe();
    void noteOpening(const store::StoreThread::Report& report);
    void noteTrouble(const store::StoreError& error);
    // It has happened and does not last.
    void tellEvent(const AlarmKind& kind, const QString& detail);

    Machine& m_machine;
    Editor& m_editor;
    Settings& m_settings;
    QTimer m_patience;
    bool m_isPatienceOver = false;
    Kinds m_controller;
    const AlarmKind* m_link = nullptr;
    Kinds m_store; // until something can be written again
    bool m_areSettingsKept = true;
};

} // namespace campanel::machine
