// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/line_figures.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/maintenance/figures_csv.h"

#include <numeric>

namespace campanel::panel {

namespace {

QString count(std::uint64_t number)
{
    return Format().grouped(static_cast<double>(number), 0);
}

} // namespace

LineFigures::LineFigures(link::Link& link, AccessCheck& access, ReportFiles& files, QObject* parent)
    : Watched(parent)
    , m_link(link)
    , m_access(access)
    , m_files(files)
{
    connect(&link, &link::Link::figuresReported, this, &LineFigures::takeFigures);
    connect(this, &Watched::watchedChanged, this, [this] {
        if (m_readers == 0)
            m_link.watchFigures(watched());
    });
    showRows();
    LanguageNotifier::follow(this, &LineFigures::showRows);
}

void LineFigures::readOnce(QObject* context, const std::function<void(const link::FiguresReport&)>& take)
{
    ++m_readers;
    connect(
        &m_link, &link::Link::figuresReported, context,
        [this, take](const link::FiguresReport& report) {
            if (--m_readers == 0 && !watched())
                m_link.watchFigures(false);
            take(report);
        },
        Qt::SingleShotConnection);
    m_link.watchFigures(true);
}

void LineFigures::reset()
{
    if (!m_access.require(Level::Operator))
        return;
    m_link.resetFigures();
    emit wasReset();
}

void LineFigures::takeFigures(const link::FiguresReport& report)
{
    m_report = report;
    showRows();
    showStrip();
}

void LineFigures::showRows()
{
    const modbus::LinkFigures figures = m_report ? m_report->figures : modbus::LinkFigures();
    const auto share = figures.wireShare();
    const Format format;
    m_exchanges.setRows(
        {{tr("Requests"), count(figures.requests()), false},
         {tr("Responses"), count(figures.answers()), false},
         {tr("Retries"), count(figures.retries()), figures.retries() > 0},
         {tr("Bytes dropped"), count(figures.droppedBytes()), figures.droppedBytes() > 0},
         {tr("Stray bytes"), count(figures.strayBytes()), figures.strayBytes() > 0},
         {tr("Line utilization"),
          share ? tr("%1 %").arg(format.number(100 * *share, 1)) : Format::unknownText(), false}});
    showErrors();
    showTimes();
    showController();
}

void LineFigures::showErrors()
{
    const auto row = [this](const QString& label, modbus::LinkErrorKind kind) {
        const std::uint32_t number = m_report ? m_report->figures.errors(kind) : 0;
        return FigureRow{label, count(number), number > 0};
    };
    using modbus::LinkErrorKind;
    m_errors.setRows({row(tr("No response"), LinkErrorKind::NoAnswer),
                      row(tr("Wrong checksum"), LinkErrorKind::BadChecksum),
                      row(tr("Damaged frame"), LinkErrorKind::BadFrame),
                      row(tr("Foreign response"), LinkErrorKind::ForeignAnswer),
                      row(tr("Refused by the controller"), LinkErrorKind::Exception),
                      row(tr("Port removed"), LinkErrorKind::PortGone)});
}

void LineFigures::showTimes()
{
    const Format format;
    const bool isKnown = m_report && m_report->figures.latency().count() > 0;
    const auto ms = [&](std::chrono::microseconds time) {
        return isKnown ? tr("%1 ms").arg(format.number(static_cast<double>(time.count()) / 1000, 1))
                       : Format::unknownText();
    };
    const modbus::LatencyHistogram latency =
        m_report ? m_report->figures.latency() : modbus::LatencyHistogram();
    const auto allowance = m_report ? m_report->answerAllowance : std::chrono::milliseconds(0);
    m_times.setRows(
        {{tr("50 % within"), ms(latency.percentile(0.5)), false},
         {tr("95 % within"), ms(latency.percentile(0.95)), false},
         {tr("99 % within"), ms(latency.percentile(0.99)), false},
         {tr("Maximum"), ms(latency.maximum()), false},
         {tr("Response timeout"),
          allowance.count() > 0 ? tr("%1 ms").arg(allowance.count()) : Format::unknownText(), false}});
}

void LineFigures::showController()
{
    const bool isKnown = m_report && m_report->figures.controller();
    const modbus::ControllerCounts counts =
        isKnown ? *m_report->figures.controller() : modbus::ControllerCounts();
    const auto row = [isKnown](const QString& label, std::uint32_t number, bool isError) {
        return FigureRow{label, isKnown ? count(number) : Format::unknownText(), isError && number > 0};
    };
    m_controller.setRows({row(tr("Requests answered"), counts.requests, false),
                          row(tr("Wrong checksum"), counts.crcErrors, true),
                          row(tr("Damaged frame"), counts.frameErrors, true),
                          row(tr("Refused"), counts.exceptions, true)});
}

void LineFigures::showStrip()
{
    constexpr qint64 secondsOfMinute = 60;
    const std::vector<modbus::MinuteFigures> strip = m_report->figures.strip();
    m_stripAnswers.clear();
    m_stripErrors.clear();
    m_stripP99Ms.clear();
    for (const modbus::MinuteFigures& minute : strip) {
        const auto errors = std::accumulate(minute.errors.begin(), minute.errors.end(), 0.0);
        const bool isKnown = minute.answers > 0 || errors > 0; // otherwise there was no connection, or no
                                                               // panel
        m_stripAnswers << (isKnown ? minute.answers : unknown);
        m_stripErrors << (isKnown ? errors : unknown);
        m_stripP99Ms << (minute.answers > 0 ? minute.latencyP99Us / 1000.0 : unknown);
    }
    m_stripEnd =
        strip.empty() ? QDateTime() : QDateTime::fromSecsSinceEpoch(strip.back().minute * secondsOfMinute);
    emit stripChanged();
}

void LineFigures::exportCsv()
{
    const modbus::LinkFigures figures = m_report ? m_report->figures : modbus::LinkFigures();
    const store::CsvDialect dialect = store::spreadsheetDialect();
    m_files.offer({csvFile(tr("link statistics"), figuresCsv(figures, dialect)),
                   csvFile(tr("link 24 hours"), stripCsv(figures, dialect))});
}

} // namespace campanel::panel
