// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarms.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/store/database/clock_mark.h"

#include <algorithm>
#include <chrono>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

using store::AlarmChanges;
using store::AlarmLog;
using store::StoreError;

namespace {

const QString acknowledging = u"alarm.acknowledge"_s;
constexpr auto publishDelay = 100ms;
constexpr auto writeDelay = 300ms;
constexpr auto writeAgainDelay = 5s; // after a failure
constexpr auto alarmCheckPeriod = 10s;
constexpr qint64 msPerHour = 3'600'000;

Alarms::Severity severityOf(const AlarmKind* kind)
{
    return kind ? static_cast<Alarms::Severity>(kind->severity) : Alarms::Severity::None;
}

static_assert(static_cast<int>(Alarms::Severity::Fault) == static_cast<int>(AlarmSeverity::Fault));

} // namespace

Alarms::Alarms(Controller& controller, Editor& editor, DatabaseService& records, Settings& settings,
               QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_records(records)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
    , m_writer(*this, records, m_book,
               [this](bool isWritten) {
                   if (isWritten)
                       m_watch.noteStored();
                   if (m_book.hasChanges())
                       noteChange();
               })
    , m_watch(controller, editor, records, settings, this)
    , m_history(records, this)
    , m_publishTimer(this)
    , m_writeTimer(this)
    , m_checkTimer(this)
{
    m_publishTimer.setSingleShot(true);
    m_publishTimer.setInterval(publishDelay);
    m_writeTimer.setSingleShot(true);
    connect(&m_publishTimer, &QTimer::timeout, this, &Alarms::publish);
    connect(&m_writeTimer, &QTimer::timeout, this, &Alarms::write);
    connect(&m_checkTimer, &QTimer::timeout, this, &Alarms::check);
    m_checkTimer.start(alarmCheckPeriod);
    connect(&m_watch, &AlarmWatch::raised, this, &Alarms::raise);
    connect(&m_watch, &AlarmWatch::cleared, this, &Alarms::clear);
    connect(&controller, &Controller::commandEnded, this, [this](const link::CommandOutcome& outcome) {
        if (outcome.command == modbus::Command::ResetFault && outcome.end == link::CommandEnd::Done)
            acknowledgeFaults();
    });
    m_watch.begin();
    records.store().run(
        this, [](store::Database& database) { return AlarmLog::begin(database); },
        [this](const tl::expected<AlarmLog::Start, StoreError>& start) { begin(start); });
    LanguageNotifier::follow(this);
    LanguageNotifier::follow(&m_detail);
    LanguageNotifier::follow(&m_urgentDetail);
}

AlarmBook::Now Alarms::now() const
{
    const qint64 utcMs = m_wallClock().toMSecsSinceEpoch();
    return {m_controller.now(), utcMs, store::isTimeDoubtful(utcMs, m_newestMs, m_records.clockState())};
}

QString Alarms::person() const
{
    return m_controller.accessCheck().person();
}

void Alarms::raise(const AlarmKind& kind, const QString& detail)
{
    const AlarmBook::Now raised = now();
    if (!raised.isClockDoubtful)
        m_newestMs = std::max(m_newestMs, raised.utcMs);
    m_book.raise(kind, detail, raised);
    noteChange();
}

void Alarms::clear(const AlarmKind& kind, store::AlarmRow::End end)
{
    m_book.clear(kind, now(), end);
    noteChange();
}

void Alarms::begin(const tl::expected<AlarmLog::Start, StoreError>& start)
{
    if (!start) {
        m_records.reportError(start.error());
        return;
    }
    m_newestMs = std::max(m_newestMs, start->newestMs);
    m_book.begin(*start, m_records.clockState());
    m_book.endShelves(now().utcMs);
    noteChange();
}

void Alarms::noteChange()
{
    if (!m_publishTimer.isActive())
        m_publishTimer.start();
    if (m_book.isBegun() && !m_writer.isWriting() && !m_writeTimer.isActive())
        m_writeTimer.start(m_writer.hasFailed() ? std::chrono::milliseconds(writeAgainDelay) : writeDelay);
}

void Alarms::publish()
{
    const auto live = m_book.live();
    m_active = m_unacknowledged = 0;
    m_callingSeverity = Severity::None;
    m_urgent = nullptr;
    for (const AlarmEntry& entry : live) {
        if (entry.isShelved)
            continue;
        if (entry.isActive()) {
            ++m_active;
            if (entry.kind->severity >
                std::max(AlarmSeverity::Notice, m_urgent ? m_urgent->severity : AlarmSeverity::None))
                m_urgent = entry.kind;
        }
        if (entry.isUnacknowledged()) {
            ++m_unacknowledged;
            m_callingSeverity = std::max(m_callingSeverity, severityOf(entry.kind));
        }
    }
    m_isSeen = std::ranges::any_of(live, &AlarmEntry::isActive) && m_unacknowledged == 0;
    QList<AlarmListRow> rows;
    for (const AlarmEntry& entry : live)
        rows << AlarmListRow{entry.row, today()};
    m_live.setRows(rows);
    QList<ShelfRow> shelves;
    for (const store::AlarmShelf& shelf : m_book.shelves())
        shelves << ShelfRow{shelf, today()};
    m_shelved.setRows(shelves);
    m_history.setToday(today());
    m_detail.update(m_book, today());
    const auto urgent = std::ranges::find(rows, urgentCode(), &AlarmListRow::code);
    m_urgentDetail.show(urgent != rows.end() ? urgent->alarm : store::AlarmRow(), m_book, today());
    emit changed();
}

void Alarms::write()
{
    if (!m_writer.isWriting())
        m_history.note(m_writer.write());
}

Alarms::Severity Alarms::urgentSeverity() const
{
    return severityOf(m_urgent);
}

void Alarms::note(const QString& what, const QString& codes, const QString& after)
{
    noteChange();
    publish();
    emit noted({.what = what, .object = codes, .after = after});
}

void Alarms::acknowledge(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || row < 0 || row >= m_live.count())
        return;
    const store::AlarmRow alarm = m_live.row(row).alarm;
    m_book.acknowledge(alarm.code, alarm.id, person(), now().utcMs);
    note(acknowledging, alarm.code);
    acknowledgeSignals();
}

void Alarms::acknowledgeSignals()
{
    const auto& identity = m_controller.identity();
    if (m_controller.isConnected() && identity && identity->hasRegister("signal.fault_red"))
        m_controller.link().request(
            link::CommandRequest{m_controller.link().nextId(), modbus::Command::Acknowledge, {}});
}

void Alarms::acknowledgeAll()
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return;
    acknowledgeEach([](const AlarmEntry&) { return true; });
    acknowledgeSignals();
}

void Alarms::acknowledgeFaults()
{
    acknowledgeEach([](const AlarmEntry& entry) {
        return entry.kind->severity == AlarmSeverity::Fault && entry.row.code.startsWith(u"C-");
    });
}

void Alarms::acknowledgeEach(const std::function<bool(const AlarmEntry& entry)>& isMeant)
{
    QStringList codes;
    for (const AlarmEntry& entry : m_book.live()) {
        if (!entry.isUnacknowledged() || !isMeant(entry) || codes.contains(entry.row.code))
            continue; // or acknowledged with a later occurrence
        m_book.acknowledge(entry.row.code, entry.row.id, person(), now().utcMs);
        codes << entry.row.code;
    }
    if (!codes.isEmpty())
        note(acknowledging, codes.join(u", "_s));
}

FaultMeasure Alarms::urgentMeasure() const
{
    return m_urgent ? m_watch.measureOf(*m_urgent) : FaultMeasure();
}

void Alarms::showUrgent()
{
    const auto& rows = m_live.rows();
    const auto row = std::ranges::find(rows, urgentCode(), &AlarmListRow::code);
    if (row != rows.end())
        m_detail.show(row->alarm, m_book, today());
}

void Alarms::showLive(int row)
{
    if (row >= 0 && row < m_live.count())
        m_detail.show(m_live.row(row).alarm, m_book, today());
}

void Alarms::showHistory(int row)
{
    if (row >= 0 && row < m_history.rows()->count())
        m_detail.show(m_history.rows()->row(row).alarm, m_book, today());
}

void Alarms::acknowledgeShown()
{
    if (!m_controller.accessCheck().require(Level::Operator) || !m_detail.calls())
        return;
    const qint64 utcMs = now().utcMs;
    m_book.acknowledge(m_detail.code(), m_detail.row().id, person(), utcMs);
    m_detail.noteAcknowledged(utcMs, person());
    note(acknowledging, m_detail.code());
    acknowledgeSignals();
}

void Alarms::shelveShown(int hours)
{
    if (!m_controller.accessCheck().require(Level::Technician))
        return;
    const qint64 utcMs = now().utcMs;
    if (m_book.shelve(m_detail.code(), utcMs + hours * msPerHour, person(), utcMs))
        note(u"alarm.shelve"_s, m_detail.code(), u"%1 h"_s.arg(hours));
}

void Alarms::unshelveShown()
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return;
    m_book.unshelve(m_detail.code());
    note(u"alarm.unshelve"_s, m_detail.code());
}

void Alarms::unshelve(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || row < 0 || row >= m_shelved.count())
        return;
    const QString code = m_shelved.row(row).code();
    m_book.unshelve(code);
    note(u"alarm.unshelve"_s, code);
}

void Alarms::check()
{
    m_watch.check();
    m_history.setToday(today());
    if (m_book.endShelves(now().utcMs))
        noteChange();
}

} // namespace campanel::panel
