// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/rtu_line.h"

#include "modbus/line/answer_reader.h"
#include "modbus/line/crc16.h"

#include <algorithm>
#include <cerrno>
#include <thread>

#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace campanel::modbus {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

// The silence after a doubt: longer than the 16 ms that USB adapters collect.
constexpr milliseconds quietTime{25};
constexpr milliseconds longestDrain{600};

enum class Readiness { Input, Nothing, Gone };

Readiness waitForInput(int descriptor, std::chrono::steady_clock::time_point deadline)
{
    const auto left = std::max(nanoseconds{0}, nanoseconds(deadline - std::chrono::steady_clock::now()));
    constexpr long long perSecond = 1'000'000'000;
    const timespec limit{left.count() / perSecond, left.count() % perSecond};
    struct pollfd watched {
        descriptor, POLLIN, 0
    };
    const int ready = ppoll(&watched, 1, &limit, nullptr);
    if (ready == 0)
        return Readiness::Nothing;
    if (ready > 0 && (watched.revents & POLLIN) == 0)
        return Readiness::Gone;
    return Readiness::Input; // or interrupted: the read tells
}

LinkErrorKind kindOf(FrameVerdict verdict)
{
    switch (verdict) {
    case FrameVerdict::Exception:
        return LinkErrorKind::Exception;
    case FrameVerdict::Foreign:
        return LinkErrorKind::ForeignAnswer;
    case FrameVerdict::BadChecksum:
        return LinkErrorKind::BadChecksum;
    case FrameVerdict::Malformed:
        return LinkErrorKind::BadFrame;
    case FrameVerdict::PortGone:
        return LinkErrorKind::PortGone;
    default:
        return LinkErrorKind::NoAnswer;
    }
}

bool isGone(int errorNumber)
{
    switch (errorNumber) {
    case EIO:
    case ECONNRESET:
    case EBADF:
    case ENXIO:
    case ENODEV:
    case EPIPE:
        return true;
    default:
        return false;
    }
}

} // namespace

struct RtuLine::Received {
    enum class End { Complete, TimedOut, Gone };

    AnswerReader reader;
    End end = End::TimedOut;

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return reader.bytes(); }
};

void RtuLine::ContextDeleter::operator()(modbus_t* context) const
{
    modbus_close(context);
    modbus_free(context);
}

RtuLine::RtuLine(LinkSettings settings, LinkRecord& record)
    : m_settings(std::move(settings))
    , m_record(record)
    , m_allowance(m_settings.answerAllowance)
{
}

RtuLine::~RtuLine()
{
    close();
}

LinkError RtuLine::error(LinkErrorKind kind, std::string request, std::string detail, int code) const
{
    return {kind, m_settings.port, std::move(request), std::move(detail), code};
}

tl::expected<void, LinkError> RtuLine::open()
{
    close();
    const LineSettings& line = m_settings.line;
    const auto refuse = [this](std::string detail) {
        return tl::unexpected(error(LinkErrorKind::PortSettings, {}, std::move(detail)));
    };
    if (std::ranges::find(supportedBauds, line.baud) == supportedBauds.end())
        return refuse("baud rate " + std::to_string(line.baud) +
                      " is not one of 9600, 19200, 38400, 57600, 115200");
    if (line.stopBits < 1 || line.stopBits > 2)
        return refuse("there are 1 or 2 stop bits, not " + std::to_string(line.stopBits));
    if (m_settings.unit < 1 || m_settings.unit > lastUnit)
        return refuse("unit numbers go from 1 to 247, not " + std::to_string(m_settings.unit));

    auto claim = PortClaim::take(m_settings.port);
    if (!claim)
        return tl::unexpected(claim.error());
    decltype(m_context) context(modbus_new_rtu(m_settings.port.c_str(), static_cast<int>(line.baud),
                                               static_cast<char>(line.parity), 8, line.stopBits));
    if (!context)
        return refuse("not enough memory");
    modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
    if (modbus_connect(context.get()) != 0)
        return refuse(modbus_strerror(errno));
    // The timer slack. The kernel may delay this thread's wake-ups by 50 us by default, but the silence
    // between frames needs a finer resolution.
    constexpr unsigned long timerSlackNs = 1000;
    prctl(PR_SET_TIMERSLACK, timerSlackNs);
    claim->excludeOthers();
    m_claim = std::move(*claim);
    m_context = std::move(context);
    m_lineFreeAt = Clock::now();
    drainLine(Drain::Opening);
    m_record.allowance = m_allowance.value();
    return {};
}

void RtuLine::close()
{
    m_context.reset();
    m_claim = PortClaim();
    m_failedRequest.reset();
    m_record.allowance = milliseconds{0};
}

tl::expected<RtuLine::Bytes, LinkError> RtuLine::send(const Question& question)
{
    Bytes frame;
    frame.reserve(question.pdu.size() + 3);
    frame.push_back(static_cast<std::uint8_t>(m_settings.unit));
    frame.insert(frame.end(), question.pdu.begin(), question.pdu.end());
    const int sent = modbus_send_raw_request(m_context.get(), frame.data(), static_cast<int>(frame.size()));
    const int errorNumber = errno;
    const std::uint16_t crc = crc16(frame); // as added by libmodbus
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    if (sent == static_cast<int>(frame.size())) {
        m_record.frames.add(FrameVerdict::Sent, frame, question.readAddress, question.readCount);
        m_record.figures.noteRequest(sent, question.isRepeatable && m_failedRequest == question.name);
        return frame;
    }
    const bool gone = sent < 0 && isGone(errorNumber);
    const auto kind = gone ? LinkErrorKind::PortGone : LinkErrorKind::BadFrame;
    m_record.frames.add(gone ? FrameVerdict::PortGone : FrameVerdict::Malformed, {});
    m_record.figures.noteError(kind, nanoseconds{0}, LinkFigures::WallTime::clock::now());
    return tl::unexpected(error(kind, question.name, gone ? std::string() : modbus_strerror(errorNumber)));
}

RtuLine::Received RtuLine::receive(std::span<const std::uint8_t> sent, Clock::time_point deadline)
{
    Received received{AnswerReader(sent)};
    const int descriptor = modbus_get_socket(m_context.get());
    while (!received.reader.space().empty()) {
        const Readiness readiness = waitForInput(descriptor, deadline);
        if (readiness == Readiness::Nothing)
            break;
        const auto space = received.reader.space();
        ssize_t count = 0;
        if (readiness == Readiness::Input)
            count = read(descriptor, space.data(), space.size());
        if (count < 0 && (errno == EAGAIN || errno == EINTR))
            continue;
        if (count <= 0) {
            received.end = Received::End::Gone;
            break;
        }
        received.reader.take(static_cast<std::size_t>(count));
    }
    if (received.reader.space().empty())
        received.end = Received::End::Complete;
    m_isEchoing = received.reader.isEchoing();
    return received;
}

FrameVerdict RtuLine::judge(const Question& question, const Received& received, const Proof& isMine) const
{
    switch (received.end) {
    case Received::End::Gone:
        return FrameVerdict::PortGone;
    case Received::End::TimedOut:
        return received.bytes().empty() ? FrameVerdict::Silence : FrameVerdict::Incomplete;
    case Received::End::Complete:
        break;
    }
    const AnswerForm form{m_settings.unit, question.pdu.front(),
                          static_cast<std::size_t>(question.frames.answerBytes)};
    const FrameVerdict verdict = received.reader.verdict(form);
    const auto frame = received.bytes();
    return verdict == FrameVerdict::Answer && !isMine(frame.subspan(2, frame.size() - 4))
               ? FrameVerdict::Foreign
               : verdict;
}

tl::expected<RtuLine::Bytes, LinkError> RtuLine::ask(const Question& question, const Proof& isMine)
{
    if (!m_context)
        return tl::unexpected(error(LinkErrorKind::NotOpen, question.name));
    std::this_thread::sleep_until(m_lineFreeAt);
    // Unrequested bytes: a late answer, or noise. They must not become this question's answer.
    if (hasInput(modbus_get_socket(m_context.get())))
        drainLine();
    const auto startedAt = Clock::now();
    const auto sent = send(question);
    if (!sent)
        return tl::unexpected(sent.error());
    const auto wire = pairTime(m_settings.line, question.frames);
    const auto deadline = startedAt + wire + m_allowance.value() + question.extraAllowance;
    Received received{AnswerReader(*sent)};
    FrameVerdict verdict = FrameVerdict::Silence;
    // A complete answer of this unit to an earlier question is late. The answer to this question is still to
    // come: giving up here would keep the panel one answer behind permanently.
    bool isLate = false;
    do {
        Received next = receive(*sent, deadline);
        const FrameVerdict nextVerdict = judge(question, next, isMine);
        m_record.figures.noteReceived(static_cast<int>(next.bytes().size()));
        if (isLate && nextVerdict == FrameVerdict::Silence)
            break;
        m_record.frames.add(nextVerdict, next.bytes(), question.readAddress, question.readCount);
        verdict = nextVerdict;
        received = next;
        isLate = isLate || (verdict == FrameVerdict::Foreign && received.bytes()[0] == m_settings.unit);
        if (isLate && verdict == FrameVerdict::Foreign)
            m_record.figures.noteDrain(static_cast<int>(received.bytes().size()));
    } while (isLate && verdict == FrameVerdict::Foreign);
    const auto completeAt = Clock::now();
    if (isLate && m_settings.isAllowanceMeasured)
        m_allowance.noteSilence();
    if (verdict != FrameVerdict::Answer)
        return tl::unexpected(fail(question, verdict, received, startedAt));

    const auto silence = frameSilence(m_settings.line);
    m_lineFreeAt = completeAt + silence;
    m_failedRequest.reset();
    m_record.figures.noteAnswer(completeAt - startedAt, wire, completeAt + silence - startedAt,
                                LinkFigures::WallTime::clock::now());
    // The extra allowance is for work that a usual answer does not need.
    if (m_settings.isAllowanceMeasured && question.extraAllowance == milliseconds{0})
        m_allowance.noteTurnaround(completeAt - startedAt - (wire - silence));
    m_record.allowance = m_allowance.value();
    const auto frame = received.bytes();
    return Bytes(frame.begin() + 2, frame.end() - 2);
}

LinkError RtuLine::fail(const Question& question, FrameVerdict verdict, const Received& received,
                        Clock::time_point startedAt)
{
    const LinkErrorKind kind = kindOf(verdict);
    // An exception has no tag either: it may be the late answer to another question, and this one's still to
    // come. A lost port has nothing to drain.
    if (kind != LinkErrorKind::PortGone)
        drainLine();
    if (m_settings.isAllowanceMeasured && kind == LinkErrorKind::NoAnswer)
        m_allowance.noteSilence();
    m_record.allowance = m_allowance.value();
    m_record.figures.noteError(kind, Clock::now() - startedAt, LinkFigures::WallTime::clock::now());
    m_failedRequest = question.name;
    const bool isException = kind == LinkErrorKind::Exception;
    return error(kind, question.name, {}, isException ? received.bytes()[2] : 0);
}

void RtuLine::drainLine(Drain reason)
{
    const auto quiet = std::max(quietTime, std::chrono::ceil<milliseconds>(frameSilence(m_settings.line)));
    int dropped = 0;
    // The next request reports a lost port with its own error.
    static_cast<void>(drain(modbus_get_socket(m_context.get()), quiet, longestDrain,
                            [this, &dropped](std::span<const std::uint8_t> bytes) {
                                dropped += static_cast<int>(bytes.size());
                                m_record.frames.add(FrameVerdict::Drained, bytes);
                            }));
    if (reason == Drain::Doubt || dropped > 0)
        m_record.figures.noteDrain(dropped);
    m_lineFreeAt = Clock::now();
}

} // namespace campanel::modbus
