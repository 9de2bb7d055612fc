// SPDX-License-Identifier: Apache-2.0
// The panel's changes in its controller: parameters, commands, downloads.
#include "modbus/map/codec.h"
#include "tests/soak/panel_master.h"

#include <array>

namespace campanel::soak {
namespace {

using modbus::LinkErrorKind;

constexpr std::array changedParameters{"parameter.ramp_time", "parameter.jog_frequency",
                                       "parameter.home_frequency", "parameter.following_error_limit"};

} // namespace

void PanelMaster::writeParameter()
{
    const modbus::RegisterInfo& info =
        modbus::registerNamed(changedParameters[pick(changedParameters.size())]);
    const std::uint32_t raw = 100 + pick(9000);
    std::vector<std::uint16_t> registers;
    if (info.count == 2)
        registers.push_back(0);
    registers.push_back(static_cast<std::uint16_t>(raw));
    m_truth.writing(info.address, registers);
    const int restarts = m_seen.restarts;
    const auto written = timed("parameter", 2, Slow::No,
                               [&] { return m_client->writeParameter(info, modbus::toPhysical(info, raw)); });
    if (!written) {
        noteError(written.error());
        // The exception to the write itself, not one to the read-back.
        if (written.error().kind == LinkErrorKind::Exception && written.error().request == info.name)
            m_truth.refused(info.address, registers);
        return;
    }
    ++m_tally.believed;
    if (restarts == m_seen.restarts)
        m_truth.written(info.address, registers);
}

void PanelMaster::command(modbus::Command code, modbus::CommandArguments arguments)
{
    const int restarts = m_seen.restarts;
    const auto slow = code == modbus::Command::SaveToFlash ? Slow::Yes : Slow::No;
    const auto result = timed("command", 5, slow, [&] { return m_client->command(code, arguments); });
    if (restarts != m_seen.restarts) // any effect is lost
        return;
    if (!result) {
        settle(result.error(), code);
        return;
    }
    ++m_tally.believed;
    ++m_tally.work[result->done() ? "commands done" : "commands refused"];
    const bool done = result->done();
    m_truth.commandCarriedOut(done && code == modbus::Command::Start);
    if (done && code == modbus::Command::SaveToFlash)
        m_truth.saved();
}

// Requests unknown results until they are known, like the panel.
void PanelMaster::settle(const modbus::LinkError& error, modbus::Command code)
{
    const int restarts = m_seen.restarts;
    noteError(error);
    ++m_tally.work[error.kind == LinkErrorKind::OutcomeUnknown ? "commands in doubt, settled later"
                                                               : "commands not received"];
    while (error.kind == LinkErrorKind::OutcomeUnknown) {
        connect();
        const auto found = timed("result", 1, Slow::No, [&] {
            return m_client->findResult(static_cast<std::uint16_t>(error.code));
        });
        if (restarts != m_seen.restarts)
            return;
        if (!found) {
            noteError(found.error());
            continue;
        }
        if (*found) {
            m_truth.commandCarriedOut((*found)->done() && code == modbus::Command::Start);
            if ((*found)->done() && code == modbus::Command::SaveToFlash)
                m_truth.saved();
        }
        return;
    }
}

void PanelMaster::startDownload()
{
    const auto& crcs = m_truth.imageCrcs();
    const std::uint32_t crc = crcs[pick(static_cast<std::uint32_t>(crcs.size()))];
    if (crc == m_truth.activeCrc())
        return;
    if (++m_session == 0)
        ++m_session;
    m_download = std::make_unique<modbus::Download>(
        m_truth.image(crc), *m_identity,
        modbus::Download::Options{modbus::ApplyMode::NextCycle, m_session, pick(4) == 0});
    ++m_tally.work["downloads begun"];
}

void PanelMaster::stepDownload()
{
    using Phase = modbus::Download::Phase;
    const Phase before = m_download->phase();
    const int restarts = m_seen.restarts;
    if (before == Phase::AwaitActive) {
        pollStatus();
        return;
    }
    if (before == Phase::Apply)
        m_truth.applying(m_download->crc());
    const auto slow = before == Phase::Seal ? Slow::Yes : Slow::No;
    const auto step = timed("download", before == Phase::Apply ? 6 : 1, slow,
                            [&] { return m_download->advance(*m_client); });
    if (restarts != m_seen.restarts) {
        if (!step && step.error().kind == modbus::DownloadErrorKind::Link)
            noteError(step.error().link);
        else if (!step)
            endDownload(&step.error());
        return;
    }
    const bool refused = !step && step.error().kind == modbus::DownloadErrorKind::CommandRefused;
    if (before == Phase::Apply && (step || refused))
        m_truth.commandCarriedOut(false);
    if (step)
        return;
    if (step.error().kind != modbus::DownloadErrorKind::Link)
        endDownload(&step.error());
    else if (before == Phase::Apply)
        settle(step.error().link, modbus::Command::ApplyStaged);
    else
        noteError(step.error().link);
}

void PanelMaster::endDownload(const modbus::DownloadError* error)
{
    if (error == nullptr) {
        ++m_tally.work["downloads active"];
        if (m_truth.activeCrc() != m_download->crc())
            m_tally.find(m_tally.wrong, "a download said that it is active, and is not");
    } else {
        ++m_tally.work["downloads ended: error " + std::to_string(static_cast<int>(error->kind))];
        // Withdrawn by the soak's own command or, after arming, by a restart; nothing else may cause it.
        if (error->kind != modbus::DownloadErrorKind::Withdrawn)
            m_tally.find(m_tally.hangs, "a download did not survive: error " +
                                            std::to_string(static_cast<int>(error->kind)));
        m_truth.notApplied(); // all mean that the active program is unchanged
    }
    m_download.reset();
}

} // namespace campanel::soak
