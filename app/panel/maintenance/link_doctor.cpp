// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/link_doctor.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/doctor_sentences.h"

namespace campanel::panel {

using Depth = modbus::ScanPlan::Depth;

LinkDoctor::LinkDoctor(Controller& controller, Settings& settings, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
{
    connect(&controller.link(), &link::Link::reported, this, &LinkDoctor::takeLinkReport);
    connect(&controller.link(), &link::Link::downloadReported, this, &LinkDoctor::takeDownload);
    connect(&controller.link(), &link::Link::scanReported, this, &LinkDoctor::takeScan);
    connect(&controller, &Controller::stateChanged, this, &LinkDoctor::changed);
    connect(&settings, &Settings::connectionChanged, this, &LinkDoctor::changed);
    LanguageNotifier::follow(this, &LinkDoctor::showFindings);
}

QString LinkDoctor::blockedReason() const
{
    if (const QString reason = m_controller.blockedReason(Action::Diagnose); !reason.isEmpty())
        return reason;
    if (m_isStopWaiting)
        return tr("A stop command is waiting for the connection and has priority.");
    if (m_isDownloading)
        return tr("A download is in progress. Wait for its end, or cancel the download.");
    return {};
}

QString LinkDoctor::triedText() const
{
    if (!running())
        return {};
    const modbus::ScanProgress& tried = m_report->progress;
    return tr("Trying %1: %2", "port, settings")
        .arg(QString::fromStdString(tried.port), DoctorSentences::settings(tried.line, tried.unit));
}

QString LinkDoctor::progressText() const
{
    return running() ? DoctorSentences::progress(m_report->progress) : QString();
}

double LinkDoctor::progress() const
{
    return running() && m_report->progress.total > 0
               ? static_cast<double>(m_report->progress.done) / m_report->progress.total
               : 0;
}

QString LinkDoctor::foundText() const
{
    if (!m_report || !m_report->found)
        return {};
    const link::ConnectionSettings& found = *m_report->found;
    return found.simulated ? tr("simulated controller")
                           : tr("%1, %2", "port, settings")
                                 .arg(found.port, DoctorSentences::settings(found.line, found.unit));
}

bool LinkDoctor::offersSearch() const
{
    return m_report && !m_report->isRunning && !m_report->isCanceled && !m_report->found &&
           m_report->depth == Depth::Usual && !m_report->findings.isEmpty();
}

bool LinkDoctor::canTake() const
{
    return m_report && !m_report->isRunning && m_report->found && !m_settings.isInUse(*m_report->found);
}

QString LinkDoctor::resultText() const
{
    if (!m_report)
        return tr("Diagnose tests the port in use. Search tries all ports, baud rates, parities and unit "
                  "numbers, which may take long; both only read and interrupt the connection.");
    if (m_report->isRunning)
        return m_report->depth != Depth::Diagnosis
                   ? tr("Searching. The panel reconnects afterwards.")
                   : tr("Testing the port in use. The panel reconnects afterwards.");
    if (canTake())
        return tr("A controller responds: %1.").arg(foundText());
    if (m_report->found)
        return tr("The connection in use works: %1.").arg(foundText());
    if (m_report->isCanceled)
        return tr("Canceled. The panel reconnects automatically.");
    if (m_report->findings.isEmpty())
        return tr("This computer has no serial port. Plug the adapter in and search again.");
    return tr("No controller was found. Result for each port:");
}

void LinkDoctor::diagnose()
{
    begin(Depth::Diagnosis);
}

void LinkDoctor::searchUsual()
{
    begin(Depth::Usual);
}

void LinkDoctor::search()
{
    begin(Depth::Search);
}

void LinkDoctor::begin(Depth depth)
{
    // It interrupts the connection of everybody.
    if (!m_controller.accessCheck().require(Level::Operator) || !canBegin())
        return;
    m_controller.link().startScan(depth);
    emit begun(depth != Depth::Diagnosis);
}

void LinkDoctor::cancel()
{
    if (m_controller.accessCheck().require(Level::Operator) && running())
        m_controller.link().cancelScan();
}

void LinkDoctor::take()
{
    if (m_controller.accessCheck().require(Level::Technician) && canTake())
        m_settings.takeConnection(*m_report->found);
}

void LinkDoctor::takeLinkReport(const link::LinkReport& report)
{
    m_isStopWaiting = report.pendingStop.has_value();
    // Stop was pressed and needs the ports now.
    if (m_isStopWaiting && report.isScanning)
        m_controller.link().cancelScan();
    emit changed();
}

void LinkDoctor::takeDownload(const link::DownloadReport& report)
{
    const bool isBegun = report.stage == link::DownloadStage::Transferring ||
                         report.stage == link::DownloadStage::Sealing ||
                         report.stage == link::DownloadStage::Armed;
    // A download that lost its connection waits for the doctor's result.
    const bool isDownloading = isBegun && !report.isInterrupted;
    if (isDownloading == m_isDownloading)
        return;
    m_isDownloading = isDownloading;
    emit changed();
}

void LinkDoctor::takeScan(const link::ScanReport& report)
{
    m_report = report;
    showFindings();
    emit changed();
}

void LinkDoctor::showFindings()
{
    QList<OfferRow> rows;
    if (m_report) {
        for (const modbus::LineFinding& finding : m_report->findings)
            rows << OfferRow{
                tr("%1: %2", "port, what was found")
                    .arg(QString::fromStdString(finding.port), DoctorSentences::condition(finding.condition)),
                DoctorSentences::settings(finding.line, finding.unit), DoctorSentences::finding(finding),
                finding.isController()};
    }
    m_findings.setRows(rows);
}

} // namespace campanel::panel
