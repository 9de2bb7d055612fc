// SPDX-License-Identifier: Apache-2.0
// The steps of a download.
#include "modbus/download/download.h"

#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"

#include <algorithm>
#include <array>
#include <utility>

namespace campanel::modbus {
namespace {

// The maximum number of starts: the download of another panel would alternate with this one endlessly.
constexpr int maxBeginnings = 20;
// The maximum time for checking or saving in pieces.
constexpr std::chrono::seconds longestBusy{10};

bool isWithoutSession(TransferResult result)
{
    return result == TransferResult::NotReceiving || result == TransferResult::WrongSession;
}

} // namespace

Download::Download(std::vector<std::uint16_t> image, const Identity& controller, Options options)
    : m_image(std::move(image))
    , m_options(options)
    , m_blockRegisters(std::min(controller.blockRegisters, blockRegisters))
    , m_bankRegisters(controller.bankRegisters)
    , m_kind(RegisterReader(m_image, 0).u16("bank.kind"))
    , m_layout(static_cast<TableLayout>(RegisterReader(m_image, 0).u16("bank.layout")))
    , m_kindSupported(controller.supports(static_cast<ProgramKind>(m_kind)))
    , m_layoutSupported(controller.supports(m_layout))
    , m_crc(crc32OfRegisters(m_image))
{
}

bool Download::ended() const
{
    return m_phase == Phase::Active || m_phase == Phase::Failed || m_phase == Phase::Cancelled;
}

std::uint16_t Download::blockCount() const
{
    if (m_blockRegisters == 0)
        return 0;
    return static_cast<std::uint16_t>((m_image.size() + m_blockRegisters - 1u) / m_blockRegisters);
}

double Download::progress() const
{
    // begin, seal and apply count one frame each.
    const double frames = 3.0 + blockCount();
    switch (m_phase) {
    case Phase::Begin:
    case Phase::Failed:
    case Phase::Cancelled:
        return 0.0;
    case Phase::Resuming:
    case Phase::Blocks:
        return (1.0 + m_nextBlock) / frames;
    case Phase::Seal:
        return (1.0 + blockCount()) / frames;
    case Phase::Verify:
    case Phase::Apply:
        return (2.0 + blockCount()) / frames;
    case Phase::AwaitActive:
    case Phase::Active:
        break;
    }
    return 1.0;
}

Download::Step Download::fail(DownloadError error)
{
    m_phase = Phase::Failed;
    return tl::unexpected(std::move(error));
}

Download::Step Download::refused(const TransferAnswer& answer)
{
    DownloadError error;
    error.kind = answer.result == TransferResult::KindNotSupported ? DownloadErrorKind::KindNotSupported
                                                                   : DownloadErrorKind::TransferRefused;
    error.transfer = answer;
    return fail(std::move(error));
}

// Starts again after a restart of the controller, which may leave the connection intact, or after another
// panel's start. Returns false when that has happened too often.
bool Download::beginAgain()
{
    if (++m_beginnings > maxBeginnings)
        return false;
    m_phase = Phase::Begin;
    // A restarted controller may be back at an older program, and count from there.
    m_generationBefore.reset();
    m_isMismatchKnown = false; // the reason is known
    return true;
}

// A slow controller checks a table in pieces, and takes no other one while it saves: the step is repeated.
// Returns false when that takes too long.
bool Download::isStillBusy(const TransferAnswer& answer)
{
    if (answer.result != TransferResult::Busy) {
        m_busySince.reset();
        return false;
    }
    const auto now = std::chrono::steady_clock::now();
    if (!m_busySince)
        m_busySince = now;
    return now - *m_busySince < longestBusy;
}

Download::Step Download::linkFailed(const LinkError& error)
{
    DownloadError failure;
    failure.kind = DownloadErrorKind::Link;
    failure.link = error;
    return tl::unexpected(std::move(failure));
}

Download::Step Download::advance(RtuClient& client)
{
    switch (m_phase) {
    case Phase::Begin:
        return begin(client);
    case Phase::Resuming:
        return askMissing(client);
    case Phase::Blocks:
        return sendBlock(client);
    case Phase::Seal:
        return seal(client);
    case Phase::Verify:
        return verify(client);
    case Phase::Apply:
        return apply(client);
    case Phase::AwaitActive:
    case Phase::Active:
    case Phase::Failed:
    case Phase::Cancelled:
        break;
    }
    return m_phase;
}

void Download::resume()
{
    if (m_phase == Phase::Blocks || m_phase == Phase::Seal || m_phase == Phase::Verify ||
        m_phase == Phase::Apply)
        m_phase = Phase::Resuming;
    m_reader.reset();
}

Download::Step Download::begin(RtuClient& client)
{
    if (!m_layoutSupported && m_layout == TableLayout::Intervals)
        return fail({DownloadErrorKind::IntervalsNotSupported, {}, {}, Refusal::None, 0, 0, 0});
    if (!m_kindSupported || !m_layoutSupported)
        return fail({DownloadErrorKind::KindNotSupported, {}, {}, Refusal::None, 0, 0, 0});
    if (m_blockRegisters == 0 || m_image.size() > m_bankRegisters)
        return fail({DownloadErrorKind::ImageTooLong,
                     {},
                     {},
                     Refusal::None,
                     0,
                     m_bankRegisters,
                     static_cast<std::uint32_t>(m_image.size())});
    const std::array<std::uint16_t, 3> announced{m_kind, static_cast<std::uint16_t>(m_image.size()),
                                                 mapMajor};
    const auto answer = client.transfer({m_options.session, TransferOperation::Begin, 0, announced});
    if (!answer)
        return linkFailed(answer.error());
    if (isStillBusy(*answer))
        return m_phase;
    if (!answer->accepted())
        return refused(*answer);
    m_nextBlock = 0;
    m_phase = Phase::Blocks;
    return m_phase;
}

Download::Step Download::askMissing(RtuClient& client)
{
    const auto answer = client.readTransferResult();
    if (!answer)
        return linkFailed(answer.error());
    if (m_applySent) {
        // Still staged: apply again, without harm. Not staged: applied or lost, the status tells.
        m_phase = answer->session == m_options.session ? Phase::Apply : Phase::AwaitActive;
        return m_phase;
    }
    if (answer->session != m_options.session)
        return beginAgain() ? Step(m_phase) : refused(*answer);
    m_nextBlock = answer->nextMissing;
    m_phase = m_nextBlock >= blockCount() ? Phase::Seal : Phase::Blocks;
    return m_phase;
}

Download::Step Download::sendBlock(RtuClient& client)
{
    const std::size_t first = static_cast<std::size_t>(m_nextBlock) * m_blockRegisters;
    const std::size_t length = std::min<std::size_t>(m_blockRegisters, m_image.size() - first);
    const auto answer = client.transfer({m_options.session, TransferOperation::Block, m_nextBlock,
                                         std::span(m_image).subspan(first, length)});
    if (!answer)
        return linkFailed(answer.error());
    if (isWithoutSession(answer->result) && beginAgain())
        return m_phase;
    if (!answer->accepted())
        return refused(*answer);
    // The controller returns the lowest missing block, usually the next one.
    m_nextBlock = answer->nextMissing;
    if (m_nextBlock >= blockCount())
        m_phase = Phase::Seal;
    return m_phase;
}

Download::Step Download::seal(RtuClient& client)
{
    const auto answer = client.transfer({m_options.session, TransferOperation::Seal, 0, {}});
    if (!answer)
        return linkFailed(answer.error());
    if (answer->result == TransferResult::BlocksMissing) {
        m_phase = Phase::Resuming;
        return m_phase;
    }
    if (isWithoutSession(answer->result) && beginAgain())
        return m_phase;
    if (isStillBusy(*answer))
        return m_phase;
    if (!answer->accepted())
        return refused(*answer);
    if (answer->stagedCrc != m_crc)
        return fail(
            {DownloadErrorKind::ChecksumDiffers, {}, *answer, Refusal::None, 0, m_crc, answer->stagedCrc});
    m_phase = m_options.verify ? Phase::Verify : Phase::Apply;
    return m_phase;
}

Download::Step Download::verify(RtuClient& client)
{
    if (!m_reader)
        m_reader.emplace(stagedBankBase, static_cast<std::uint16_t>(m_image.size()));
    const auto complete = m_reader->advance(client);
    if (!complete)
        return linkFailed(complete.error());
    if (!*complete)
        return m_phase;
    const auto [sent, held] = std::ranges::mismatch(m_image, m_reader->registers());
    if (sent != m_image.end() && !std::exchange(m_isMismatchKnown, true)) {
        // A restarted controller has no staged data: its answer about the session decides.
        resume();
        return m_phase;
    }
    if (sent != m_image.end())
        return fail({DownloadErrorKind::RowsDiffer,
                     {},
                     {},
                     Refusal::None,
                     static_cast<std::uint32_t>(sent - m_image.begin()),
                     *sent,
                     *held});
    m_reader.reset();
    m_phase = Phase::Apply;
    return m_phase;
}

Download::Step Download::apply(RtuClient& client)
{
    if (!m_generationBefore) {
        const RegisterInfo& info = registerNamed("status.generation");
        const auto registers = client.readProven(info.address, info.count);
        if (!registers)
            return linkFailed(registers.error());
        m_generationBefore = RegisterReader(*registers, info.address).u32(info.name);
    }
    const bool again = std::exchange(m_applySent, true);
    const auto result = client.command(
        Command::ApplyStaged, {static_cast<std::uint16_t>(m_options.mode), m_options.session, m_crc});
    if (!result)
        return linkFailed(result.error());
    // Nothing staged after an earlier unanswered attempt, which may have succeeded: the status tells.
    const bool perhapsDone = again && result->reason == Refusal::NothingSealed;
    if (!again && result->reason == Refusal::NothingSealed && beginAgain()) {
        m_applySent = false;
        return m_phase;
    }
    if (!result->done() && !perhapsDone)
        return fail({DownloadErrorKind::CommandRefused, {}, {}, result->reason, 0, 0, 0});
    m_phase = Phase::AwaitActive;
    return m_phase;
}

Download::Step Download::noteStatus(const StatusBlock& status)
{
    if (ended())
        return m_phase;
    if (!m_generationBefore)
        m_generationBefore = status.generation;
    const bool isActive = status.generation != *m_generationBefore && status.activeCrc == m_crc;
    const bool isArmed = status.stagedState == StagedState::Armed;
    // The answer to apply may have been lost, so the phase may be behind the status.
    if (m_applySent && isActive)
        m_phase = Phase::Active;
    else if (m_applySent && isArmed)
        m_phase = Phase::AwaitActive;
    else if (m_phase == Phase::AwaitActive)
        return fail({DownloadErrorKind::Withdrawn, {}, {}, Refusal::None, 0, 0, 0});
    return m_phase;
}

Download::Step Download::cancel(RtuClient& client)
{
    if (ended())
        return m_phase;
    if (m_phase == Phase::AwaitActive) {
        const auto disarmed = client.command(Command::CancelApply);
        if (!disarmed)
            return linkFailed(disarmed.error());
        if (!disarmed->done())
            return tl::unexpected(
                DownloadError{DownloadErrorKind::CommandRefused, {}, {}, disarmed->reason, 0, 0, 0});
    }
    if (m_phase != Phase::Begin) {
        const auto discarded = client.command(Command::DiscardStaged);
        if (!discarded)
            return linkFailed(discarded.error());
    }
    m_phase = Phase::Cancelled;
    return m_phase;
}

} // namespace campanel::modbus
