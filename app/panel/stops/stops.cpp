// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/stops.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"

#include <QDateTime>

#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

using store::StopLog;
using store::StopRow;
using store::StoreError;

namespace {

constexpr auto stopCheckPeriod = 1s;
constexpr auto retryDelay = 5s; // after a failed write
constexpr qint64 msPerAskedSecond = 1000;

} // namespace

Stops::Stops(Controller& controller, Settings& settings, DatabaseService& records, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_records(records)
    , m_writer(*this, records, m_book)
    , m_watch(controller, settings, records, m_book)
    , m_setup(settings)
    , m_keys(settings, this)
    , m_shift(*this, settings, records)
{
    connect(&m_watch, &MachineWatch::observed, this, &Stops::updatePresent);
    connect(&m_timer, &QTimer::timeout, this, &Stops::check);
    m_timer.start(stopCheckPeriod);
    m_undoTimer.setSingleShot(true);
    m_undoTimer.setInterval(undoPeriod);
    m_undoTimer.callOnTimeout(this, &Stops::dismissAnswer);
    connect(&m_keys, &ReasonKeys::chosen, this,
            [this](const StopReason& reason) { answer(m_book.presentStop().id, reason); });
    connect(&settings, &Settings::changed, this, &Stops::updatePresent);
    LanguageNotifier::follow(this, &Stops::updatePresent);
    records.store().run(
        this, [](store::Database& database) { return StopLog::begin(database); },
        [this](const tl::expected<StopLog::Start, StoreError>& start) {
            if (!start)
                return m_records.reportError(start.error());
            m_watch.setNewestRecord(start->newestMs);
            m_book.begin(*start);
        });
}

void Stops::setWallClock(const MachineWatch::WallClock& clock)
{
    m_watch.setWallClock(clock);
    m_shift.showPresent();
}

void Stops::check()
{
    m_book.check(m_watch.now());
    updatePresent();
    const auto sinceWrite = m_controller.now() - m_writtenAt;
    const bool isDue = m_book.hasNews() ? !m_writer.hasFailed() || sinceWrite >= retryDelay
                                        : m_book.present() && sinceWrite >= writePeriod;
    if (isDue && !m_writer.isWriting())
        write();
}

void Stops::write()
{
    if (!m_writer.write().isEmpty())
        m_writtenAt = m_controller.now();
}

void Stops::postpone()
{
    m_postponed = m_book.presentStop().id;
    m_keys.close();
    updatePresent();
}

bool Stops::answer(qint64 stop, const StopReason& reason)
{
    if (!m_controller.accessCheck().require(Level::Operator) || stop == 0)
        return false;
    setReason({stop, reason.key(), reason.isPlanned, m_controller.accessCheck().person(), nowMs()}, true);
    return true;
}

void Stops::undoAnswer()
{
    if (!m_controller.accessCheck().require(Level::Operator) || m_undo.answer.id == 0)
        return;
    const StopRow before = m_undo.before;
    setReason(before, false);
    dismissAnswer();
}

void Stops::dismissAnswer()
{
    m_undoTimer.stop();
    m_undo = {};
    emit answerChanged();
}

void Stops::setReason(const StopRow& answer, bool canBeUndone)
{
    const StopRow before = m_book.presentStop();
    if (!m_book.answer(answer))
        return setEarlierReason(answer, canBeUndone);
    noteReplaced({before, answer}, canBeUndone);
    updatePresent();
    write();
}

void Stops::setEarlierReason(const StopRow& answer, bool canBeUndone)
{
    write(); // an earlier answer of this stop
    struct Outcome {
        std::optional<StopRow> before;
        tl::expected<void, StoreError> written;
    };
    m_records.store().run(
        this,
        [answer](store::Database& database) {
            const auto before = StopLog::stop(database, answer.id);
            if (!before)
                return Outcome{{}, tl::unexpected(before.error())};
            return Outcome{*before, StopLog::write(database, {{}, {answer}})};
        },
        [this, answer, canBeUndone](const Outcome& outcome) {
            if (!outcome.written)
                return m_records.reportError(outcome.written.error());
            StopRow unanswered;
            unanswered.id = answer.id;
            noteReplaced({outcome.before.value_or(unanswered), answer}, canBeUndone);
        });
}

void Stops::noteReplaced(const Replaced& replaced, bool canBeUndone)
{
    const auto& [before, answer] = replaced;
    if (before.reason == answer.reason)
        return;
    if (canBeUndone) {
        m_undo = replaced;
        m_undoTimer.start();
        emit answerChanged();
    }
    if (before.reason.isEmpty())
        return;
    emit noted({.what = u"stop.reason"_s,
                .object = QDateTime::fromMSecsSinceEpoch(before.answeredMs).toUTC().toString(Qt::ISODate),
                .before = before.reason,
                .after = answer.reason});
}

QString Stops::answerText() const
{
    return m_undo.answer.id == 0 ? QString()
                                 : tr("Stop reason: %1.").arg(StopWords::reason(m_undo.answer.reason));
}

QString Stops::reasonText() const
{
    return m_present.reason.isEmpty() ? QString() : StopWords::reason(m_present.reason);
}

QString Stops::lastTitle() const
{
    if (m_present.lastBeginMs == 0)
        return {};
    const QString begin =
        Format::local(QDateTime::fromMSecsSinceEpoch(m_present.lastBeginMs), QStringLiteral("HH:mm"));
    return m_book.presentStop().id != 0 ? tr("Stopped at %1", "time").arg(begin)
                                        : tr("Last stop %1", "time").arg(begin);
}

QString Stops::lastReason() const
{
    return m_present.lastBeginMs == 0 ? QString() : StopWords::reason(m_present.lastReason);
}

QString Stops::lastDuration() const
{
    return m_present.lastBeginMs == 0 ? QString() : StopWords::duration(m_present.lastMs);
}

void Stops::updatePresent()
{
    Present present;
    const StopRow stop = m_book.presentStop();
    present.lastBeginMs = m_present.lastBeginMs;
    present.lastMs = m_present.lastMs;
    present.lastReason = m_present.lastReason;
    if (stop.id != 0) {
        present.lastBeginMs = m_book.stopBeginMs();
        present.lastMs = m_book.stopMs();
        present.lastReason = stop.reason;
        const qint64 afterMs = m_settings.values().whole("stops.ask_after_seconds") * msPerAskedSecond;
        const bool hasProgram = !m_book.present()->program.isEmpty();
        present.reason = stop.reason;
        present.isAsking =
            stop.reason.isEmpty() && stop.id != m_postponed && hasProgram && m_book.stopMs() >= afterMs;
        present.sinceText =
            tr("Since %1, %2", "time, duration")
                .arg(Format::local(QDateTime::fromMSecsSinceEpoch(m_book.stopBeginMs()), u"HH:mm"_s),
                     StopWords::duration(m_book.stopMs()));
    }
    if (present == m_present)
        return;
    const bool hasEnded = m_present.isAsking && !present.isAsking;
    m_present = present;
    if (hasEnded)
        m_keys.close();
    emit presentChanged();
}

} // namespace campanel::panel
