// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/shift_report.h"

#include "app/panel/kit/format.h"
#include "app/panel/records/database_service.h"
#include "app/panel/stops/stops.h"
#include "app/panel/words/order_words.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString shareText(double share)
{
    const QString number = Format().number(100 * share, 1);
    return number == Format::unknownText() ? number : number + u" %"_s;
}

QString pieceText(std::int64_t count)
{
    return Format().grouped(static_cast<double>(count), 0);
}

} // namespace

ShiftReport::ShiftReport(Controller& controller, Stops& stops, DatabaseService& records, ReportFiles& files,
                         QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_stops(stops)
    , m_records(records)
    , m_files(files)
    , m_printer([](const ReportData&) { return QByteArray(); })
{
}

void ShiftReport::offer()
{
    const Shift shift = m_stops.shift()->summary().shift;
    m_records.store().run(
        this,
        [shift](store::Database& database) {
            return store::OrderLog::between(database, shift.beginMs, shift.endMs);
        },
        [this, shift](const store::Table<store::OrderRow>::Rows& found) {
            if (!found)
                m_records.reportError(found.error());
            const QByteArray pdf = m_printer(data(found.value_or(QList<store::OrderRow>())));
            const QDateTime begin = QDateTime::fromMSecsSinceEpoch(shift.beginMs);
            m_files.offer(
                {{tr("shift %1", "name of a file: date and time").arg(begin.toString(u"yyyy-MM-dd HH-mm"_s)),
                  u"pdf"_s, [pdf] { return pdf; }}});
        });
}

ReportData ShiftReport::data(const QList<store::OrderRow>& rows) const
{
    ReportData data;
    data.title = tr("Shift report");
    data.recipe = m_stops.shift()->title();
    data.footer = u"CamPanel %1"_s.arg(QCoreApplication::applicationVersion());
    data.pageText = tr("Page %1");
    data.isFeasible = true;
    data.machine = machineText(m_controller);
    data.bar = bar();
    data.sections = {work(), figures(), orders(rows), reasons(), stops()};
    data.signatures = signatureTexts();
    return data;
}

ReportBar ShiftReport::bar() const
{
    ReportBar bar;
    for (const BarStretch& each : m_stops.shift()->summary().bar)
        bar.stretches.append({each.from, each.width, BarRow::kindOf(each.state)});
    for (const QVariant& each : m_stops.shift()->hours()) {
        const QVariantMap hour = each.toMap();
        bar.hours.append({hour.value(u"at"_s).toDouble(), hour.value(u"text"_s).toString()});
    }
    bar.kinds = {tr("Running"), tr("Stopped"), tr("Waiting"), tr("Manual"), tr("Fault")};
    return bar;
}

// Returns what ran, and who was there.
ReportSection ShiftReport::work() const
{
    const ShiftSummary& summary = m_stops.shift()->summary();
    QStringList people;
    for (const ShiftStop& each : summary.stops) {
        if (!each.answer.by.isEmpty() && !people.contains(each.answer.by))
            people << each.answer.by;
    }
    ReportSection section{tr("Work"), {}, {}, true};
    section.rows = {
        {tr("Programs that ran"), summary.programs.isEmpty() ? tr("none") : summary.programs.join(u", "_s)},
        {tr("Stops answered by"), people.isEmpty() ? tr("nobody") : people.join(u", "_s)}};
    return section;
}

ReportSection ShiftReport::figures() const
{
    const ShiftView& shift = *m_stops.shift();
    const ShiftSummary& summary = shift.summary();
    const Production& made = summary.production;
    ReportSection section{tr("Effectiveness"), {}, {}};
    section.rows = {{tr("OEE"), shareText(shift.oee())},
                    {tr("Availability"), shareText(shift.availability())},
                    {tr("Performance"), shareText(shift.performance())},
                    {tr("Quality"), shareText(shift.quality())},
                    {tr("Run time"), StopWords::duration(made.runMs)},
                    {tr("Planned time"), StopWords::duration(made.plannedMs)},
                    {tr("Stops"), StopWords::duration(summary.stopMs)},
                    {tr("Planned stops"), StopWords::duration(summary.plannedStopMs)},
                    {tr("Pieces"), pieceText(made.pieces)},
                    {tr("Good pieces"), pieceText(made.pieces - made.rejects())},
                    {tr("Out of tolerance"), pieceText(made.outOfTolerance)},
                    {tr("Start-up scrap"), pieceText(made.startUpScrap)},
                    {tr("Skipped cuts"), pieceText(made.skipped)}};
    section.lines = {shift.timesText()};
    if (!shift.note().isEmpty())
        section.lines << shift.note();
    return section;
}

ReportSection ShiftReport::orders(const QList<store::OrderRow>& rows) const
{
    ReportSection section{tr("Orders"), {}, {}, true};
    for (const store::OrderRow& order : rows) {
        const QDate day = QDateTime::fromMSecsSinceEpoch(m_stops.shift()->summary().shift.beginMs).date();
        section.rows.append(
            {OrderWords::title(order),
             tr("%1, %2; rejected %3, empty %4; %5", "bags, state, counts, further facts of an order")
                 .arg(OrderWords::progress(order), OrderWords::state(order.state),
                      OrderWords::count(order.rejected), OrderWords::count(order.empty),
                      OrderWords::facts(order, day))});
    }
    if (section.rows.isEmpty())
        section.lines = {tr("No order in this shift.")};
    return section;
}

ReportSection ShiftReport::reasons() const
{
    ReportSection section{tr("Reasons by time"), {}, {}};
    for (const ReasonRow& row : m_stops.shift()->reasons()->rows())
        section.rows.append(
            {row.isPlanned() ? tr("%1 (planned)").arg(row.text()) : row.text(), row.durationText()});
    if (section.rows.isEmpty())
        section.lines = {tr("No stop in this shift.")};
    return section;
}

ReportSection ShiftReport::stops() const
{
    ReportSection section{tr("Stops"), {}, {}, true};
    const QList<StopListRow>& rows = m_stops.shift()->stops()->rows();
    for (auto row = rows.crbegin(); row != rows.crend(); ++row) {
        const QString note = row->clockNote();
        const QString time = note.isEmpty() ? row->time() : u"%1 · %2"_s.arg(row->time(), note);
        section.rows.append({tr("%1, %2", "time, duration").arg(time, row->durationText()),
                             row->by().isEmpty()
                                 ? row->reasonText()
                                 : tr("%1 (%2)", "reason, person").arg(row->reasonText(), row->by())});
    }
    return section;
}

} // namespace campanel::panel
