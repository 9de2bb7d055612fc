// SPDX-License-Identifier: Apache-2.0
// `Alarms` in QML: the active, earlier and shelved alarms, and who acknowledged them. It watches controller,
// link and panel and stores its log in the database; nothing here waits for the disk.
#pragma once

#include "app/panel/alarms/alarm_detail.h"
#include "app/panel/alarms/alarm_history.h"
#include "app/panel/alarms/alarm_lists.h"
#include "app/panel/alarms/alarm_watch.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/records/buffered_writer.h"

#include "app/store/logs/audit_log.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

class Alarms : public QObject, public Singleton<Alarms> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::RowModelBase* live READ live CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::PagedLogBase* history READ history CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* shelved READ shelved CONSTANT FINAL)
    // The selected alarm.
    Q_PROPERTY(campanel::panel::AlarmDetail* detail READ detail CONSTANT FINAL)
    // The most urgent active alarm in detail, and what broke its limit; its code is empty without one.
    Q_PROPERTY(campanel::panel::AlarmDetail* urgent READ urgent CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::FaultMeasure urgentMeasure READ urgentMeasure NOTIFY changed FINAL)
    Q_PROPERTY(int unacknowledged READ unacknowledged NOTIFY changed FINAL)
    // The highest severity that needs to be acknowledged; None when there is none.
    Q_PROPERTY(Severity callingSeverity READ callingSeverity NOTIFY changed FINAL)
    // The most urgent active alarm, without notices; empty: none.
    Q_PROPERTY(QString urgentCode READ urgentCode NOTIFY changed FINAL)
    Q_PROPERTY(QString urgentTitle READ urgentTitle NOTIFY changed FINAL)
    Q_PROPERTY(Severity urgentSeverity READ urgentSeverity NOTIFY changed FINAL)
    // True when an alarm is active and all are acknowledged.
    Q_PROPERTY(bool seen READ seen NOTIFY changed FINAL)

public:
    enum class Severity { None, Notice, Warning, Fault }; // as AlarmSeverity
    Q_ENUM(Severity)

    using WallClock = std::function<QDateTime()>;

    // All arguments must outlive the object. The log begins when the records are opened.
    Alarms(Controller& controller, Editor& editor, DatabaseService& records, Settings& settings,
           QObject* parent);

    void setWallClock(const WallClock& clock)
    {
        m_wallClock = clock;
        m_history.filter()->setWallClock(clock);
    }
    // Sets how long changes are collected before they are published; 100 ms by default.
    void setPaceMs(int paceMs) { m_publishTimer.setInterval(paceMs); }
    [[nodiscard]] AlarmWatch& watch() { return m_watch; }

    [[nodiscard]] AlarmList* live() { return &m_live; }
    [[nodiscard]] AlarmHistory* history() { return &m_history; }
    [[nodiscard]] ShelvedAlarms* shelved() { return &m_shelved; }
    [[nodiscard]] AlarmDetail* detail() { return &m_detail; }
    [[nodiscard]] AlarmDetail* urgent() { return &m_urgentDetail; }
    [[nodiscard]] FaultMeasure urgentMeasure() const;
    [[nodiscard]] int active() const { return m_active; }
    [[nodiscard]] int unacknowledged() const { return m_unacknowledged; }
    [[nodiscard]] Severity callingSeverity() const { return m_callingSeverity; }
    [[nodiscard]] QString urgentCode() const { return m_urgent ? m_urgent->code() : QString(); }
    [[nodiscard]] QString urgentTitle() const { return m_urgent ? m_urgent->title() : QString(); }
    [[nodiscard]] Severity urgentSeverity() const;
    [[nodiscard]] bool seen() const { return m_isSeen; }

    // Acknowledges a row of `live` and all earlier occurrences of the same alarm.
    Q_INVOKABLE void acknowledge(int row);
    Q_INVOKABLE void acknowledgeAll();
    // Selects a row of `live` or `history` for `detail`.
    Q_INVOKABLE void showLive(int row);
    Q_INVOKABLE void showHistory(int row);
    // Selects the most urgent active alarm.
    Q_INVOKABLE void showUrgent();
    Q_INVOKABLE void acknowledgeShown();
    // Shelves the selected alarm: it is logged but does not call. Does nothing for an alarm that stops the
    // machine.
    Q_INVOKABLE void shelveShown(int hours);
    Q_INVOKABLE void unshelveShown();
    Q_INVOKABLE void unshelve(int row);
    // Ends expired shelves; runs every ten seconds.
    void check();

signals:
    void changed();
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    void raise(const AlarmKind& kind, const QString& detail);
    void clear(const AlarmKind& kind, store::AlarmRow::End end);
    void begin(const tl::expected<store::AlarmLog::Start, store::StoreError>& start);
    // Publishes and writes the changes soon, at most a few times a second.
    void noteChange();
    // Publishes what a person did, and reports it to the audit trail.
    void note(const QString& what, const QString& codes, const QString& after = {});
    // Acknowledges the controller's faults: the person who resets them has seen them.
    void acknowledgeFaults();
    // Ends the blinking and the horn of the machine.
    void acknowledgeSignals();
    void publish();
    void write();
    void acknowledgeEach(const std::function<bool(const AlarmEntry& entry)>& isMeant);
    [[nodiscard]] AlarmBook::Now now() const;
    [[nodiscard]] QString person() const;
    [[nodiscard]] QDate today() const { return m_wallClock().date(); }

    Controller& m_controller;
    DatabaseService& m_records;
    WallClock m_wallClock;
    qint64 m_newestMs = 0; // the latest record with a clock that was set
    AlarmBook m_book;
    BufferedWriter<AlarmBook, store::AlarmLog> m_writer;
    AlarmWatch m_watch;
    AlarmList m_live{this};
    AlarmHistory m_history;
    ShelvedAlarms m_shelved{this};
    AlarmDetail m_detail{this};
    AlarmDetail m_urgentDetail{this};
    QTimer m_publishTimer;
    QTimer m_writeTimer;
    QTimer m_checkTimer;
    int m_active = 0;
    int m_unacknowledged = 0;
    Severity m_callingSeverity = Severity::None;
    const AlarmKind* m_urgent = nullptr;
    bool m_isSeen = false;
};

} // namespace campanel::panel
