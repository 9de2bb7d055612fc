// SPDX-License-Identifier: Apache-2.0
// `Trends` in QML: stores every bag and the course of the measured values, and displays a window of it.
// Reading and writing run in the thread of their own database. Requests made during a read wait for its
// answer.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/kit/watched.h"
#include "app/panel/records/csv_export.h"
#include "app/panel/trends/trend_recorder.h"
#include "app/store/logs/trend_window.h"
#include "app/store/store_thread.h"

#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class DatabaseService;

class Trends : public campanel::panel::Watched, public Singleton<Trends> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // The quantities from top to bottom, at least one, at most `maxChosen`.
    Q_PROPERTY(QList<int> chosen READ chosen NOTIFY chosenChanged FINAL)
    // The window in ms since 1970 UTC. It moves with the time while `live`.
    Q_PROPERTY(double fromMs READ fromMs NOTIFY windowChanged FINAL)
    Q_PROPERTY(double toMs READ toMs NOTIFY windowChanged FINAL)
    Q_PROPERTY(double spanMs READ spanMs NOTIFY windowChanged FINAL)
    Q_PROPERTY(bool live READ live NOTIFY windowChanged FINAL)
    // The curves for the plot: std::shared_ptr<const QList<QList<QPointF>>>. Each chosen quantity has the
    // means, the lowest and the highest values over the time in ms, with half a window more on both sides. A
    // point with a NaN as y is a gap.
    Q_PROPERTY(QVariant curves READ curves NOTIFY shownChanged FINAL)
    // The statistics of each chosen quantity, {count, mean, scatter, low, high, within}. NaN: none; within:
    // share, 0..1.
    Q_PROPERTY(QVariantList statistics READ statistics NOTIFY shownChanged FINAL)
    Q_PROPERTY(Content content READ content NOTIFY shownChanged FINAL)
    // True when a bag of the window was recorded while the clock was not set.
    Q_PROPERTY(bool clockDoubtful READ clockDoubtful NOTIFY shownChanged FINAL)
    // The window as CSV files: each bag unless there are too many, and the columns of the chosen quantities.
    Q_PROPERTY(campanel::panel::CsvExport* csv READ csv CONSTANT FINAL)

public:
    enum Quantity { BagLength, Deviation, MarkError, FollowingError, Rate, Latency, JamResidue };
    Q_ENUM(Quantity)
    // The content. Unread: not requested yet. NothingYet: nothing recorded at all. NothingHere: nothing in
    // this window.
    enum Content { Unread, NothingYet, NothingHere, Shown };
    Q_ENUM(Content)

    static constexpr int maxChosen = 3;
    static constexpr qint64 shortestSpanMs = 60'000;
    static constexpr qint64 longestSpanMs = 30LL * 24 * 3'600'000;
    static constexpr int writePeriodMs = 5000;

    // All arguments must outlive the object. `folder` contains the database.
    Trends(Controller& controller, Settings& settings, DatabaseService& records, const QString& folder,
           QObject* parent);
    // Stores the remaining data.
    ~Trends() override;

    // Opens the database; earlier requests wait for it.
    void open() { m_store.open(); }

    // Records a mean torque of the knife at the cut, see modbus::JamStatus::residuePercent.
    void recordResidue(double percent) { m_recorder.addResidue(percent); }
    // Writes the measured data to the database before the next request of store().
    void flush();

    // Replaces the computer's time of day, for tests and captures.
    void setWallClock(const TrendRecorder::WallClock& clock);
    [[nodiscard]] store::StoreThread& store() { return m_store; }

    [[nodiscard]] QList<int> chosen() const { return m_chosen; }
    [[nodiscard]] double fromMs() const { return static_cast<double>(m_toMs - m_spanMs); }
    [[nodiscard]] double toMs() const { return static_cast<double>(m_toMs); }
    [[nodiscard]] double spanMs() const { return static_cast<double>(m_spanMs); }
    [[nodiscard]] bool live() const { return m_isLive; }
    [[nodiscard]] QVariant curves() const { return m_curves; }
    [[nodiscard]] QVariantList statistics() const { return m_statistics; }
    [[nodiscard]] Content content() const { return m_content; }
    [[nodiscard]] bool clockDoubtful() const { return m_isClockDoubtful; }
    [[nodiscard]] qint64 columnMs() const { return m_columnMs; } // per column; 0 before the first answer
    [[nodiscard]] CsvExport* csv() { return &m_csv; }

    // Adds or removes the quantity. The last one stays; a fourth one replaces the lowest.
    Q_INVOKABLE void toggle(int quantity);
    // Displays a span around the middle of the window; while live, up to now.
    Q_INVOKABLE void showSpan(double spanMs);
    // Changes the span; a factor below 1 shortens it.
    Q_INVOKABLE void zoom(double factor) { showSpan(spanMs() * factor); }
    // Displays this window without its future part. A window up to now is live again.
    Q_INVOKABLE void showWindow(double fromMs, double toMs);
    Q_INVOKABLE void showNow();
    // Reads the window again, with the new data.
    void refresh();

signals:
    void chosenChanged();
    void windowChanged();
    void shownChanged();

private:
    struct Answer {
        tl::expected<void, store::StoreError> kept;
        tl::expected<store::TrendWindow, store::StoreError> window;
    };

    void write();
    void follow();
    void setWindow(qint64 toMs, qint64 spanMs, bool isLive);
    [[nodiscard]] store::TrendQuestion question() const;
    void takeAnswer(const Answer& answer);
    void takeOpening(const store::StoreThread::Report& report);
    void takeKept(const tl::expected<void, store::StoreError>& kept);
    void reportError(const store::StoreError& error);
    void show(const store::TrendWindow& window);
    [[nodiscard]] CsvExport::Job csvJob();

    DatabaseService& m_records;
    TrendRecorder m_recorder;
    TrendRecorder::WallClock m_clock;
    store::StoreThread m_store;
    CsvExport m_csv;
    QTimer m_writeTimer;
    QTimer m_followTimer;
    QList<int> m_chosen{Deviation, MarkError};
    qint64 m_toMs = 0;
    qint64 m_spanMs = 600'000;
    qint64 m_columnMs = 0;
    bool m_isLive = true;
    bool m_isAsked = false;  // an answer is pending
    bool m_isWanted = false; // another read is needed after it
    bool m_isWriting = false;
    bool m_hasComplained = false; // until the next successful write
    QVariant m_curves;
    QVariantList m_statistics;
    Content m_content = Unread;
    bool m_isClockDoubtful = false;
};

} // namespace campanel::panel
