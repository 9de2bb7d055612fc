// SPDX-License-Identifier: Apache-2.0
// `Stops.shift` in QML: the displayed shift with its bar, reasons, stops and effectiveness. It is read while
// it is watched; the present shift is followed.
#pragma once

#include "app/panel/kit/watched.h"
#include "app/panel/records/csv_export.h"
#include "app/panel/stops/reason_keys.h"
#include "app/panel/stops/stop_rows.h"

#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class DatabaseService;
class Settings;
class Stops;

class ShiftView : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The shift belongs to Stops")
    // "Thu 15 Jan, 06:00 – 14:00", before it the order whose time it is, and what is special about it.
    Q_PROPERTY(QString title READ title NOTIFY changed FINAL)
    Q_PROPERTY(QString note READ note NOTIFY changed FINAL)
    Q_PROPERTY(bool isPresent READ isPresent NOTIFY changed FINAL)
    Q_PROPERTY(Content content READ content NOTIFY changed FINAL)
    // Shares, 0..1; NaN while unknown.
    Q_PROPERTY(double availability READ availability NOTIFY changed FINAL)
    Q_PROPERTY(double performance READ performance NOTIFY changed FINAL)
    Q_PROPERTY(double quality READ quality NOTIFY changed FINAL)
    Q_PROPERTY(double oee READ oee NOTIFY changed FINAL)
    // "Run 6 h 10 min · stops 50 min · planned 30 min".
    Q_PROPERTY(QString timesText READ timesText NOTIFY changed FINAL)
    // The number of stops long enough for a question that have no reason.
    Q_PROPERTY(int openStops READ openStops NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* bar READ bar CONSTANT FINAL)
    // The hours at the bar, {at: share, text}.
    Q_PROPERTY(QVariantList hours READ hours NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* reasons READ reasons CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* stops READ stops CONSTANT FINAL)
    // The keys with the reason of the selected stop, and its time.
    Q_PROPERTY(campanel::panel::ReasonKeys* keys READ keys CONSTANT FINAL)
    Q_PROPERTY(QString selectedText READ selectedText NOTIFY changed FINAL)
    // The stops and the states as CSV files.
    Q_PROPERTY(campanel::panel::CsvExport* csv READ csv CONSTANT FINAL)

public:
    // The content. Unread: not requested yet. Nothing: nothing is known of this shift.
    enum Content { Unread, Nothing, Shown };
    Q_ENUM(Content)

    ShiftView(Stops& owner, Settings& settings, DatabaseService& records);

    [[nodiscard]] QString title() const;
    [[nodiscard]] QString note() const;
    [[nodiscard]] bool isPresent() const { return m_isPresent; }
    [[nodiscard]] Content content() const { return m_content; }
    [[nodiscard]] double availability() const { return m_oee.availability; }
    [[nodiscard]] double performance() const { return m_oee.performance; }
    [[nodiscard]] double quality() const { return m_oee.quality; }
    [[nodiscard]] double oee() const { return m_oee.oee; }
    [[nodiscard]] QString timesText() const;
    [[nodiscard]] int openStops() const;
    [[nodiscard]] BarRows* bar() { return &m_bar; }
    [[nodiscard]] QVariantList hours() const;
    [[nodiscard]] ReasonRows* reasons() { return &m_reasons; }
    [[nodiscard]] StopRows* stops() { return &m_stops; }
    [[nodiscard]] ReasonKeys* keys() { return &m_keys; }
    [[nodiscard]] QString selectedText() const;
    [[nodiscard]] CsvExport* csv() { return &m_csv; }
    [[nodiscard]] const ShiftSummary& summary() const { return m_summary; }
    [[nodiscard]] const Oee& figures() const { return m_oee; }

    Q_INVOKABLE void showPrevious();
    Q_INVOKABLE void showNext();
    Q_INVOKABLE void showPresent();
    // Shows the time of an order instead of a shift, ms since 1970 UTC; an end of 0 is now.
    Q_INVOKABLE void showOrder(const QString& title, double beginMs, double endMs);
    // Selects a row of `stops`, for the keys.
    Q_INVOKABLE void select(int row);
    // Reads the shift again.
    void refresh();

signals:
    void changed();
    void answered(); // the selected stop

private:
    [[nodiscard]] ShiftCalendar calendar() const;
    [[nodiscard]] qint64 shortMs() const;
    void show(const Shift& shift, const QString& order = {});
    void follow();
    void take(const store::StopLog::Span& span, const Shift& shift);
    [[nodiscard]] CsvExport::Job csvJob();

    Stops& m_owner;
    Settings& m_settings;
    DatabaseService& m_records;
    ReasonKeys m_keys;
    CsvExport m_csv;
    Shift m_shift;
    QString m_order; // whose time it is; empty: a shift
    bool m_isPresent = true;
    Content m_content = Unread;
    ShiftSummary m_summary;
    Oee m_oee;
    qint64 m_selected = 0; // stop
    BarRows m_bar{this};
    ReasonRows m_reasons{this};
    StopRows m_stops{this};
};

} // namespace campanel::panel
