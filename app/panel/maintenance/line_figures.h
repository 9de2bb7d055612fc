// SPDX-License-Identifier: Apache-2.0
// The statistics of the line: exchanges, errors by class, times, the controller's own counters, and the last
// 24 hours minute by minute. Updated once a second while it is watched.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/figure_model.h"
#include "app/panel/kit/report_files.h"
#include "app/panel/kit/watched.h"

#include <QDateTime>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <optional>

namespace campanel::panel {

class LineFigures : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The figures belong to Maintenance")
    Q_PROPERTY(campanel::panel::RowModelBase* exchanges READ exchanges CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* errors READ errors CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* times READ times CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* controller READ controller CONSTANT FINAL)
    // One number for each minute, oldest first; the last one is the minute `stripEnd`. NaN: no exchange.
    Q_PROPERTY(QList<double> stripAnswers READ stripAnswers NOTIFY stripChanged FINAL)
    Q_PROPERTY(QList<double> stripErrors READ stripErrors NOTIFY stripChanged FINAL)
    Q_PROPERTY(QList<double> stripP99Ms READ stripP99Ms NOTIFY stripChanged FINAL)
    Q_PROPERTY(QDateTime stripEnd READ stripEnd NOTIFY stripChanged FINAL)

public:
    // Both arguments must outlive the object.
    LineFigures(link::Link& link, AccessCheck& access, ReportFiles& files, QObject* parent);

    [[nodiscard]] FigureModel* exchanges() { return &m_exchanges; }
    [[nodiscard]] FigureModel* errors() { return &m_errors; }
    [[nodiscard]] FigureModel* times() { return &m_times; }
    [[nodiscard]] FigureModel* controller() { return &m_controller; }
    [[nodiscard]] QList<double> stripAnswers() const { return m_stripAnswers; }
    [[nodiscard]] QList<double> stripErrors() const { return m_stripErrors; }
    [[nodiscard]] QList<double> stripP99Ms() const { return m_stripP99Ms; }
    [[nodiscard]] QDateTime stripEnd() const { return m_stripEnd; }
    // Returns the last report; empty before the first.
    [[nodiscard]] const std::optional<link::FiguresReport>& report() const { return m_report; }

    // Calls `take` with the next report, within a second, also when the figures are not watched. The call
    // ends with `context`.
    void readOnce(QObject* context, const std::function<void(const link::FiguresReport&)>& take);

    // Resets all counters.
    Q_INVOKABLE void reset();
    // Offers figures and strip as two CSV files.
    Q_INVOKABLE void exportCsv();

signals:
    void stripChanged();
    void wasReset(); // by a person

private:
    void takeFigures(const link::FiguresReport& report);
    void showRows();
    void showErrors();
    void showTimes();
    void showController();
    void showStrip();

    link::Link& m_link;
    AccessCheck& m_access;
    ReportFiles& m_files;
    std::optional<link::FiguresReport> m_report; // the last one
    FigureModel m_exchanges{this};
    FigureModel m_errors{this};
    FigureModel m_times{this};
    FigureModel m_controller{this};
    QList<double> m_stripAnswers;
    QList<double> m_stripErrors;
    QList<double> m_stripP99Ms;
    QDateTime m_stripEnd;
    int m_readers = 0; // pending readOnce() calls
};

} // namespace campanel::panel
