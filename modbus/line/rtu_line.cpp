// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/rtu_line.h"

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

RtuLine::Input RtuLine::waitForInput(int descriptor, std::chrono::steady_clock::time_point deadline)
{
    const auto left = std::max(nanoseconds{0}, nanoseconds(deadline - std::chrono::steady_clock::now()));
    constexpr long long perSecond = 1'000'000'000;
    const timespec limit{left.count() / perSecond, left.count() % perSecond};
    struct pollfd watched {
        descriptor, POLLIN, 0
    };
    const int ready = ppoll(&watched, 1, &limit, nullptr);
    if (ready == 0)
        return Input::Nothing;
    if (ready > 0 && (watched.revents & POLLIN) == 0)
        return Input::Gone;
    return Input::Bytes; // or interrupted: the read tells
}

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

AnswerReader::Piece RtuLine::receive(AnswerReader& reader, Clock::time_point deadline)
{
    for (;;) {
        if (const auto piece = reader.next())
            return *piece;
        const Input input = readInput(reader, deadline);
        if (input == Input::Gone)
            return {FrameVerdict::PortGone, {}, reader.unread()};
        if (input == Input::Nothing)
            return reader.rest();
    }
}

RtuLine::Input RtuLine::readInput(AnswerReader& reader, Clock::time_point deadline)
{
    const auto space = reader.space();
    if (space.empty())
        return Input::Nothing;
    const int descriptor = modbus_get_socket(m_context.get());
    for (;;) {
        const Input readiness = waitForInput(descriptor, deadline);
        if (readiness != Input::Bytes)
            return readiness;
        const ssize_t count = read(descriptor, space.data(), space.size());
        if (count < 0 && (errno == EAGAIN || errno == EINTR))
            continue;
        if (count <= 0)
            return Input::Gone;
        reader.take(static_cast<std::size_t>(count));
        return Input::Bytes;
    }
}

// A complete answer of this unit to an earlier question is late. The answer to this question is still to
// come: giving up here would keep the panel one answer behind permanently.
AnswerReader::Piece RtuLine::receiveAnswer(const Question& question, AnswerReader& reader,
                                           Clock::time_point deadline)
{
    AnswerReader::Piece last;
    bool isLate = false;
    do {
        const AnswerReader::Piece piece = receive(reader, deadline);
        m_isEchoing = reader.isEchoing();
        if (last.verdict == FrameVerdict::Foreign && piece.verdict == FrameVerdict::Silence)
            break;
        if (!piece.strays.empty()) {
            m_record.frames.add(FrameVerdict::Stray, piece.strays);
            m_record.figures.noteStrays(piece.strays.size());
        }
        m_record.frames.add(piece.verdict, piece.frame, question.readAddress, question.readCount);
        const auto size = static_cast<int>(piece.frame.size());
        if (piece.verdict == FrameVerdict::Foreign)
            m_record.figures.noteDrain(size);
        else
            m_record.figures.noteReceived(size);
        isLate = isLate || (piece.verdict == FrameVerdict::Foreign && piece.frame[0] == m_settings.unit);
        last = piece;
    } while (last.verdict == FrameVerdict::Foreign);
    if (isLate && m_settings.isAllowanceMeasured)
        m_allowance.noteSilence();
    return last;
}

// Waits for the silence that ends the frame of `completeAt`. Returns false when bytes came behind the answer
// and the line is not known for this.
bool RtuLine::endsWithSilence(AnswerReader& reader, Clock::time_point completeAt)
{
    const auto silence = frameSilence(m_settings.line);
    auto end = completeAt + silence;
    while (readInput(reader, end) == Input::Bytes)
        end = Clock::now() + silence;
    const auto strays = reader.unread();
    if (strays.empty())
        return true;
    m_record.frames.add(FrameVerdict::Stray, strays);
    m_record.figures.noteFollowedAnswer(strays.size());
    return m_record.figures.followedAnswers() > followedAnswersDropped;
}

tl::expected<RtuLine::Bytes, LinkError> RtuLine::ask(const Question& question, const Proof& isMine)
{
    if (!m_context)
        return tl::unexpected(error(LinkErrorKind::NotOpen, question.name));
    std::this_thread::sleep_until(m_lineFreeAt);
    // Unrequested bytes: a late answer, or noise. They must not become this question's answer.
    if (hasInput(modbus_get_socket(m_context.get())))
        drainLine(m_failedRequest ? Drain::Doubt : Drain::Unasked);
    const auto startedAt = Clock::now();
    const auto sent = send(question);
    if (!sent)
        return tl::unexpected(sent.error());
    const auto wire = pairTime(m_settings.line, question.frames);
    const auto deadline = startedAt + wire + m_allowance.value() + question.extraAllowance;
    const AnswerForm form{m_settings.unit, question.pdu.front(),
                          static_cast<std::size_t>(question.frames.answerBytes)};
    AnswerReader reader(*sent, form, isMine);
    const AnswerReader::Piece piece = receiveAnswer(question, reader, deadline);
    const auto completeAt = Clock::now();
    if (piece.verdict != FrameVerdict::Answer)
        return tl::unexpected(fail(question, piece, startedAt));
    Bytes data(piece.frame.begin() + 2, piece.frame.end() - 2);
    if (!endsWithSilence(reader, completeAt))
        return tl::unexpected(fail(question, {FrameVerdict::Malformed, reader.unread(), {}}, startedAt));

    const auto silence = frameSilence(m_settings.line);
    m_lineFreeAt = completeAt + silence;
    m_failedRequest.reset();
    m_record.figures.noteAnswer(completeAt - startedAt, wire, completeAt + silence - startedAt,
                                LinkFigures::WallTime::clock::now());
    // The extra allowance is for work that a usual answer does not need.
    if (m_settings.isAllowanceMeasured && question.extraAllowance == milliseconds{0})
        m_allowance.noteTurnaround(completeAt - startedAt - (wire - silence));
    m_record.allowance = m_allowance.value();
    return data;
}

LinkError RtuLine::fail(const Question& question, const AnswerReader::Piece& piece,
                        Clock::time_point startedAt)
{
    const LinkErrorKind kind = kindOf(piece.verdict);
    // An exception has no tag either: it may be the late answer to another question, and this one's still to
    // come. A lost port has nothing to drain.
    if (kind != LinkErrorKind::PortGone)
        drainLine();
    if (m_settings.isAllowanceMeasured && kind == LinkErrorKind::NoAnswer)
        m_allowance.noteSilence();
    m_record.allowance = m_allowance.value();
    m_record.figures.noteError(kind, Clock::now() - startedAt, LinkFigures::WallTime::clock::now());
    m_failedRequest = question.name;
    int code = 0;
    if (kind == LinkErrorKind::Exception)
        code = piece.frame[2];
    else if (piece.frame.empty())
        code = static_cast<int>(piece.strays.size());
    return error(kind, question.name, {}, code);
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
    if (reason == Drain::Unasked)
        m_record.figures.noteStrays(static_cast<std::size_t>(dropped));
    else if (reason == Drain::Doubt || dropped > 0)
        m_record.figures.noteDrain(dropped);
    m_lineFreeAt = Clock::now();
}

} // namespace campanel::modbus
