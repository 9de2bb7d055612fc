// SPDX-License-Identifier: Apache-2.0
// `Stops` in QML: records the machine's states, asks for the reason of a stop, and shows shifts. The log is
// in the main database; nothing here waits for the disk.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/records/buffered_writer.h"
#include "app/panel/stops/machine_watch.h"
#include "app/panel/stops/shift_view.h"
#include "app/panel/stops/stop_setup.h"
#include "app/store/logs/audit_log.h"

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Stops : public QObject, public Singleton<Stops> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True while the present stop has taken the set time and has no reason.
    Q_PROPERTY(bool asking READ asking NOTIFY presentChanged FINAL)
    // "Since 14:05, 3 min".
    Q_PROPERTY(QString sinceText READ sinceText NOTIFY presentChanged FINAL)
    // The reason of the present stop as it is stored, and in words; empty while the machine produces or
    // nobody has given one.
    Q_PROPERTY(QString reason READ reason NOTIFY presentChanged FINAL)
    Q_PROPERTY(QString reasonText READ reasonText NOTIFY presentChanged FINAL)
    // The present stop, or while the machine produces the one before: "Last stop 13:52", its reason, "12 s".
    // Empty without one.
    Q_PROPERTY(QString lastTitle READ lastTitle NOTIFY presentChanged FINAL)
    Q_PROPERTY(QString lastReason READ lastReason NOTIFY presentChanged FINAL)
    Q_PROPERTY(QString lastDuration READ lastDuration NOTIFY presentChanged FINAL)
    // The last answer for some seconds, "Stop reason: Film change."; empty: nothing can be undone.
    Q_PROPERTY(QString answerText READ answerText NOTIFY answerChanged FINAL)
    // The keys that answer the question.
    Q_PROPERTY(campanel::panel::ReasonKeys* keys READ keys CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::ShiftView* shift READ shift CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::StopSetup* setup READ setup CONSTANT FINAL)

public:
    // The open interval is written again after this time: a power cut loses no more of it.
    static constexpr std::chrono::seconds writePeriod{60};

    // The time to undo an answer.
    static constexpr std::chrono::seconds undoPeriod{5};

    // All arguments must outlive the object. The log begins when the records are opened.
    Stops(Controller& controller, Settings& settings, DatabaseService& records, QObject* parent);

    void setWallClock(const MachineWatch::WallClock& clock);
    [[nodiscard]] qint64 nowMs() const { return m_watch.now().utcMs; }

    [[nodiscard]] bool asking() const { return m_present.isAsking; }
    [[nodiscard]] QString sinceText() const { return m_present.sinceText; }
    [[nodiscard]] QString reason() const { return m_present.reason; }
    [[nodiscard]] QString reasonText() const;
    [[nodiscard]] QString lastTitle() const;
    [[nodiscard]] QString lastReason() const;
    [[nodiscard]] QString lastDuration() const;
    [[nodiscard]] QString answerText() const;
    [[nodiscard]] ReasonKeys* keys() { return &m_keys; }
    [[nodiscard]] ShiftView* shift() { return &m_shift; }
    [[nodiscard]] StopSetup* setup() { return &m_setup; }
    [[nodiscard]] const StateBook& book() const { return m_book; }

    // Closes the question of the present stop; it stays without a reason, and can be answered later.
    Q_INVOKABLE void postpone();
    // Brings back the reason before the last answer, or none, for operators.
    Q_INVOKABLE void undoAnswer();
    Q_INVOKABLE void dismissAnswer();
    // Sets the reason of a stop, for operators. Returns false when the access check refuses.
    bool answer(qint64 stop, const StopReason& reason);
    // Begins a new interval now: an order begins or ends, and its intervals belong to it alone.
    void divide() { m_book.divide(m_watch.now()); }
    // Writes the changes and the present interval.
    void write();
    // Writes what is due, and asks; runs every second.
    void check();

signals:
    void presentChanged();
    void answerChanged();
    // Emitted for the audit trail: a reason was replaced.
    void noted(const campanel::store::AuditEntry& entry);

private:
    struct Present {
        bool isAsking = false;
        QString sinceText;
        QString reason;
        // The present stop, or the one before.
        qint64 lastBeginMs = 0; // 0: none
        qint64 lastMs = 0;
        QString lastReason;

        bool operator==(const Present&) const = default;
    };

    // An answer, and what it replaces; the id of both is 0: none.
    struct Replaced {
        store::StopRow before;
        store::StopRow answer;
    };

    void setReason(const store::StopRow& answer, bool canBeUndone);
    void setEarlierReason(const store::StopRow& answer, bool canBeUndone);
    void noteReplaced(const Replaced& replaced, bool canBeUndone);
    void updatePresent();

    Controller& m_controller;
    Settings& m_settings;
    DatabaseService& m_records;
    StateBook m_book;
    BufferedWriter<StateBook, store::StopLog> m_writer;
    MachineWatch m_watch;
    StopSetup m_setup;
    ReasonKeys m_keys;
    ShiftView m_shift;
    QTimer m_timer;
    Present m_present;
    Replaced m_undo;
    QTimer m_undoTimer;
    qint64 m_postponed = 0; // stop
    link::SteadyTime m_writtenAt{};
};

} // namespace campanel::panel
