// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/shift_view.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/stops/stops.h"
#include "app/panel/words/alarm_words.h"
#include "app/store/logs/stop_export.h"

#include <QLocale>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

using store::StateInterval;
using store::StopLog;
using store::StoreError;

namespace {

constexpr auto shiftReadPeriod = 5s;
constexpr qint64 msPerSecond = 1000;
constexpr qint64 msPerHour = 3'600'000;

QString clockText(qint64 utcMs)
{
    return Format::local(QDateTime::fromMSecsSinceEpoch(utcMs), u"HH:mm"_s);
}

} // namespace

BarRow::Kind BarRow::kindOf(StateInterval::State state)
{
    switch (state) {
    case StateInterval::State::Running:
    case StateInterval::State::Stopping:
        return Producing;
    case StateInterval::State::Suspended:
        return Waiting;
    case StateInterval::State::Jogging:
    case StateInterval::State::Homing:
        return Manual;
    case StateInterval::State::Fault:
        return Faulted;
    case StateInterval::State::Idle:
    case StateInterval::State::Ready:
        break;
    }
    return Standing;
}

QString ReasonRow::text() const
{
    return value.isShort ? StopWords::tr("Short stops (up to %1)").arg(StopWords::duration(shortMs))
                         : StopWords::reason(value.reason);
}

QString ReasonRow::durationText() const
{
    return StopWords::tr("%1 · %2×", "duration, number of stops")
        .arg(StopWords::duration(value.durationMs), QString::number(value.count));
}

ShiftView::ShiftView(Stops& owner, Settings& settings, DatabaseService& records)
    : m_owner(owner)
    , m_settings(settings)
    , m_records(records)
    , m_keys(settings, this)
    , m_csv(
          records.store(), [this] { return csvJob(); },
          [&records](const StoreError& error) { records.reportError(error); }, this)
{
    updateEvery(shiftReadPeriod, [this] { follow(); });
    connect(&settings, &Settings::changed, this, &ShiftView::follow);
    connect(&owner, &Stops::answerChanged, this, &ShiftView::refresh); // an answer may have been undone
    connect(&m_keys, &ReasonKeys::chosen, this, [this](const StopReason& reason) {
        if (m_selected == 0 || !m_owner.answer(m_selected, reason))
            return;
        m_selected = 0;
        refresh();
        emit answered();
    });
    LanguageNotifier::follow(this);
}

ShiftCalendar ShiftView::calendar() const
{
    return {shiftStartsIn(m_settings.values().text("stops.shift_starts")),
            workingDaysIn(m_settings.values().text("stops.working_days")), QTimeZone::systemTimeZone()};
}

qint64 ShiftView::shortMs() const
{
    return m_settings.values().whole("stops.ask_after_seconds") * msPerSecond;
}

// The present shift becomes the next one, and a change of the calendar another one.
void ShiftView::follow()
{
    if (!watched())
        return;
    if (m_order.isEmpty())
        show(calendar().at(m_isPresent ? m_owner.nowMs() : m_shift.beginMs));
    else
        refresh();
}

void ShiftView::show(const Shift& shift, const QString& order)
{
    const bool isOther = shift != m_shift || order != m_order;
    m_shift = shift;
    m_order = order;
    const qint64 now = m_owner.nowMs();
    m_isPresent = order.isEmpty() && shift.beginMs <= now && now < shift.endMs;
    if (isOther) {
        m_content = Unread;
        m_selected = 0;
        emit changed();
    }
    refresh();
}

void ShiftView::showPrevious()
{
    show(calendar().before(m_shift));
}

void ShiftView::showNext()
{
    if (!m_isPresent)
        show(calendar().after(m_shift));
}

// Orders sees begin and end when it reads the controller, up to a second before or after the interval does.
void ShiftView::showOrder(const QString& title, double beginMs, double endMs)
{
    constexpr qint64 besideMs = 1500;
    const qint64 end = endMs > 0 ? static_cast<qint64>(endMs) - besideMs : m_owner.nowMs();
    show({.beginMs = static_cast<qint64>(beginMs) - besideMs, .endMs = end}, title);
}

void ShiftView::showPresent()
{
    show(calendar().at(m_owner.nowMs()));
}

void ShiftView::refresh()
{
    if (!watched())
        return;
    m_owner.write();
    m_records.store().run(
        this,
        [shift = m_shift](store::Database& database) {
            return StopLog::between(database, shift.beginMs, shift.endMs);
        },
        [this, shift = m_shift](const tl::expected<StopLog::Span, StoreError>& span) {
            if (!span)
                m_records.reportError(span.error());
            else if (shift == m_shift)
                take(*span, shift);
        });
}

void ShiftView::take(const StopLog::Span& span, const Shift& shift)
{
    m_summary = summarize(span, shift, shortMs());
    m_oee = oeeOf(m_summary.production);
    m_content = span.intervals.isEmpty() ? Nothing : Shown;
    QList<BarRow> bar;
    for (const BarStretch& stretch : m_summary.bar)
        bar << BarRow{stretch, static_cast<int>(bar.size())};
    m_bar.setRows(bar);
    QList<ReasonRow> reasons;
    for (const ReasonShare& each : m_summary.reasons) {
        const auto longest = static_cast<double>(std::max<qint64>(1, m_summary.reasons.first().durationMs));
        reasons << ReasonRow{each, static_cast<double>(each.durationMs) / longest, shortMs()};
    }
    m_reasons.setRows(reasons);
    QList<StopListRow> stops;
    for (const ShiftStop& each : m_summary.stops)
        stops.prepend({each});
    m_stops.setRows(stops);
    emit changed();
}

QString ShiftView::title() const
{
    if (m_shift.endMs == 0)
        return {};
    const QString day = QLocale().toString(QDateTime::fromMSecsSinceEpoch(m_shift.beginMs).date(),
                                           tr("ddd d MMM", "date: weekday, day, month"));
    const QString time = tr("%1, %2 – %3", "date, begin and end of a shift")
                             .arg(day, clockText(m_shift.beginMs), clockText(m_shift.endMs));
    return m_order.isEmpty() ? time : m_order + u" · "_s + time;
}

QString ShiftView::note() const
{
    QStringList notes;
    if (!m_shift.isWorking)
        notes << tr("Day off: no production planned");
    else if (m_isPresent)
        notes << tr("Present shift");
    if (m_summary.isClockDoubtful)
        notes << AlarmWords::clockNote(true);
    return notes.join(u" · "_s);
}

QString ShiftView::timesText() const
{
    if (m_content != Shown)
        return {};
    const QString run = StopWords::duration(m_summary.production.runMs);
    const QString stops = StopWords::duration(m_summary.stopMs);
    const QString planned = StopWords::duration(m_summary.plannedStopMs);
    const qint64 unknownMs = std::min(m_shift.endMs, m_owner.nowMs()) - m_shift.beginMs - m_summary.knownMs;
    constexpr qint64 worthSaying = 60'000;
    return unknownMs < worthSaying ? tr("Run %1 · stops %2 · planned stops %3").arg(run, stops, planned)
                                   : tr("Run %1 · stops %2 · planned stops %3 · not recorded %4")
                                         .arg(run, stops, planned, StopWords::duration(unknownMs));
}

int ShiftView::openStops() const
{
    const qint64 limit = shortMs();
    return static_cast<int>(std::ranges::count_if(m_summary.stops, [limit](const ShiftStop& stop) {
        return stop.answer.reason.isEmpty() && stop.durationMs > limit;
    }));
}

QVariantList ShiftView::hours() const
{
    QVariantList hours;
    const auto lengthMs = static_cast<double>(m_shift.durationMs());
    if (!(lengthMs > 0))
        return hours;
    for (qint64 at = m_shift.beginMs; at <= m_shift.endMs; at += msPerHour)
        hours << QVariantMap{{u"at"_s, static_cast<double>(at - m_shift.beginMs) / lengthMs},
                             {u"text"_s, clockText(at)}};
    return hours;
}

void ShiftView::select(int row)
{
    m_keys.close();
    m_selected = row >= 0 && row < m_stops.count() ? m_stops.row(row).id() : 0;
    emit changed();
}

QString ShiftView::selectedText() const
{
    for (const StopListRow& row : m_stops.rows()) {
        if (row.id() == m_selected)
            return tr("%1, %2: %3", "time, duration, reason of a stop")
                .arg(row.time(), row.durationText(), row.reasonText());
    }
    return {};
}

CsvExport::Job ShiftView::csvJob()
{
    m_owner.write();
    return [shift = m_shift, stops = tr("stops"), states = tr("states")](
               store::Database& database, const store::CsvDialect& dialect) -> CsvExport::Made {
        return StopLog::between(database, shift.beginMs, shift.endMs).map([&](const StopLog::Span& span) {
            return CsvExport::Files{{csvFile(stops, store::stopsCsv(span, dialect)),
                                     csvFile(states, store::statesCsv(span, dialect))}};
        });
    };
}

} // namespace campanel::panel
