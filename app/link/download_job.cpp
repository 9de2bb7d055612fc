// SPDX-License-Identifier: Apache-2.0
#include "app/link/download_job.h"

namespace campanel::link {

namespace {

using Phase = modbus::Download::Phase;

DownloadStage stageOf(Phase phase)
{
    switch (phase) {
    case Phase::Begin:
    case Phase::Resuming:
    case Phase::Blocks:
        return DownloadStage::Transferring;
    case Phase::Seal:
    case Phase::Verify:
    case Phase::Apply:
        return DownloadStage::Sealing;
    case Phase::AwaitActive:
        return DownloadStage::Armed;
    case Phase::Active:
        return DownloadStage::Active;
    case Phase::Failed:
        return DownloadStage::Failed;
    case Phase::Cancelled:
        return DownloadStage::Canceled;
    }
    return DownloadStage::Failed;
}

} // namespace

DownloadJob::DownloadJob(std::vector<std::uint16_t> bank, const modbus::Identity& controller,
                         std::uint16_t session)
    : m_download(std::move(bank), controller, {modbus::ApplyMode::NextCycle, session, false})
{
    m_report.crc = m_download.crc();
}

void DownloadJob::advance(modbus::RtuClient& client)
{
    take(m_isCancelWanted ? m_download.cancel(client) : m_download.advance(client));
}

void DownloadJob::noteStatus(const modbus::StatusBlock& status)
{
    take(m_download.noteStatus(status));
}

void DownloadJob::take(const Step& step)
{
    m_report.stage = stageOf(m_download.phase());
    m_report.fraction = m_download.progress();
    if (step) {
        m_failuresInARow = 0;
        return;
    }
    if (step.error().kind == modbus::DownloadErrorKind::Link) {
        m_isPortLost = modbus::portIsLost(step.error().link);
        if (m_isPortLost || ++m_failuresInARow < maxFailuresInARow)
            return;
        m_report.stage = DownloadStage::Failed;
    }
    if (m_isCancelWanted && m_report.stage != DownloadStage::Failed) {
        // Too late to cancel: the change has become active, and the next status reports it.
        m_isCancelWanted = false;
        return;
    }
    m_report.error = step.error();
}

void DownloadJob::cancel(bool isConnected)
{
    m_isCancelWanted = true;
    if (!isConnected && m_download.phase() != Phase::AwaitActive)
        m_report.stage = DownloadStage::Canceled;
}

void DownloadJob::connectionLost()
{
    m_report.isInterrupted = true;
    m_isPortLost = false;
}

void DownloadJob::connectionFound()
{
    m_report.isInterrupted = false;
    m_failuresInARow = 0;
    m_download.resume();
}

bool DownloadJob::hasWork() const
{
    return !ended() && (m_isCancelWanted || m_report.stage != DownloadStage::Armed);
}

bool DownloadJob::ended() const
{
    return m_report.stage == DownloadStage::Active || m_report.stage == DownloadStage::Failed ||
           m_report.stage == DownloadStage::Canceled;
}

} // namespace campanel::link
