// SPDX-License-Identifier: Apache-2.0
// libmodbus frames and checks; this adds what it leaves out: the silence between frames, one deadline for a
// whole answer, draining after a doubt, and proof that an answer belongs to its question.
#include "modbus/rtu_client.h"

#include "modbus/codec.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>

#include <sys/prctl.h>

namespace campanel::modbus {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

// Nothing for this long after a doubt: the line is quiet. Longer than the 16 ms that USB adapters collect.
constexpr milliseconds quietTime{25};
constexpr milliseconds longestDrain{600};
// Writing flash or checking all rows takes the controller longer than answering a question. A lost answer
// costs the panel that time too: sealing must leave room to find a restarted controller within two seconds.
constexpr milliseconds flashAllowance{2000};
constexpr milliseconds sealAllowance{1000};
constexpr int resolveAttempts = 3;

std::string commandName(Command code)
{
    for (const EnumInfo& info : enumerations()) {
        if (info.name != "Command")
            continue;
        for (const EnumValue& value : info.values) {
            if (value.value == static_cast<std::uint16_t>(code))
                return std::string(value.name);
        }
    }
    return "command " + std::to_string(static_cast<unsigned>(code));
}

// Never 0: that is what a controller has which has restarted, and it would take the command for an old one.
std::uint16_t counterAfter(std::uint16_t counter)
{
    return counter == 0xFFFF ? std::uint16_t{1} : static_cast<std::uint16_t>(counter + 1u);
}

} // namespace

void RtuClient::ContextDeleter::operator()(modbus_t* context) const
{
    modbus_close(context);
    modbus_free(context);
}

RtuClient::RtuClient(LinkSettings settings)
    : m_settings(std::move(settings))
    , m_tag(static_cast<std::uint16_t>(Clock::now().time_since_epoch() / milliseconds{1}))
{
}

RtuClient::~RtuClient() = default;

LinkError RtuClient::error(LinkErrorKind kind, std::string request, std::string detail, int code) const
{
    return {kind, m_settings.port, std::move(request), std::move(detail), code};
}

tl::expected<void, LinkError> RtuClient::open()
{
    close();
    const LineSettings& line = m_settings.line;
    const auto refuse = [this](std::string detail) {
        return tl::unexpected(error(LinkErrorKind::PortSettings, {}, std::move(detail)));
    };
    if (std::ranges::find(supportedBauds, line.baud) == supportedBauds.end())
        return refuse("baud rate " + std::to_string(line.baud) +
                      " is not one of 9600, 19200, 38400, 57600, 115200.");
    if (line.stopBits < 1 || line.stopBits > 2)
        return refuse("there are 1 or 2 stop bits, not " + std::to_string(line.stopBits) + ".");
    if (m_settings.unit < 1 || m_settings.unit > 247)
        return refuse("unit numbers go from 1 to 247, not " + std::to_string(m_settings.unit) + ".");

    auto claim = PortClaim::take(m_settings.port);
    if (!claim)
        return tl::unexpected(claim.error());
    decltype(m_context) context(modbus_new_rtu(m_settings.port.c_str(), static_cast<int>(line.baud),
                                               static_cast<char>(line.parity), 8, line.stopBits));
    if (!context)
        return refuse("not enough memory.");
    modbus_set_error_recovery(context.get(), MODBUS_ERROR_RECOVERY_NONE);
    modbus_set_slave(context.get(), m_settings.unit);
    if (modbus_connect(context.get()) != 0)
        return refuse(std::string(modbus_strerror(errno)) + ".");
    // Zero: no time limit between bytes, the response timeout holds for the answer as a whole.
    modbus_set_byte_timeout(context.get(), 0, 0);
    // The kernel may round this thread's sleeps up by 50 us; the silence between frames is cut finer.
    constexpr unsigned long timerSlackNs = 1000;
    prctl(PR_SET_TIMERSLACK, timerSlackNs);
    claim->excludeOthers();
    m_claim = std::move(*claim);
    m_context = std::move(context);
    m_lineFreeAt = Clock::now();
    drainLine();
    return {};
}

void RtuClient::close()
{
    m_context.reset();
    m_claim = PortClaim();
    m_commandCounter.reset();
}

tl::expected<void, LinkError> RtuClient::prepare(const std::string& request, const FramePair& frames,
                                                 milliseconds extraAllowance)
{
    if (!m_context)
        return tl::unexpected(error(LinkErrorKind::NotOpen, request));
    std::this_thread::sleep_until(m_lineFreeAt);
    // Bytes that nobody asked for: a late answer, or noise. They must not become this question's answer.
    if (hasInput(modbus_get_socket(m_context.get())))
        drainLine();
    const auto total = std::chrono::duration_cast<std::chrono::microseconds>(
        pairTime(m_settings.line, frames) + m_settings.answerAllowance + extraAllowance);
    constexpr long long perSecond = 1'000'000;
    modbus_set_response_timeout(m_context.get(), static_cast<std::uint32_t>(total.count() / perSecond),
                                static_cast<std::uint32_t>(total.count() % perSecond));
    return {};
}

void RtuClient::drainLine()
{
    const int descriptor = modbus_get_socket(m_context.get());
    const auto quiet = std::max(quietTime, std::chrono::ceil<milliseconds>(frameSilence(m_settings.line)));
    // A port that is gone shows itself at the next request, with its own error.
    static_cast<void>(drain(descriptor, quiet, longestDrain));
    m_lineFreeAt = Clock::now();
}

LinkError RtuClient::failed(const std::string& request, int errorNumber)
{
    switch (errorNumber) {
    case EIO:
    case ECONNRESET:
    case EBADF:
    case ENXIO:
    case ENODEV:
    case EPIPE:
        return error(LinkErrorKind::PortGone, request);
    default:
        break;
    }
    // An exception carries no tag either: it may be the late answer to another question, and this one's still
    // to come.
    drainLine();
    if (errorNumber > MODBUS_ENOBASE && errorNumber < EMBBADCRC)
        return error(LinkErrorKind::Exception, request, {}, errorNumber - MODBUS_ENOBASE);
    switch (errorNumber) {
    case ETIMEDOUT:
        return error(LinkErrorKind::NoAnswer, request);
    case EMBBADCRC:
        return error(LinkErrorKind::BadChecksum, request);
    case EMBBADSLAVE:
    case EMBBADDATA: // whole and undamaged, but of another length or function
        return error(LinkErrorKind::ForeignAnswer, request);
    default:
        return error(LinkErrorKind::BadFrame, request, modbus_strerror(errorNumber));
    }
}

LinkError RtuClient::dropForeign(const std::string& request)
{
    drainLine();
    return error(LinkErrorKind::ForeignAnswer, request);
}

tl::expected<std::vector<std::uint16_t>, LinkError> RtuClient::writeAndRead(const std::string& request,
                                                                            const WindowRead& window)
{
    const auto frames = writeReadFrames(static_cast<int>(window.written.size()), window.readCount);
    if (const auto ready = prepare(request, frames, window.extraAllowance); !ready)
        return tl::unexpected(ready.error());
    std::vector<std::uint16_t> answer(window.readCount);
    const int read = modbus_write_and_read_registers(
        m_context.get(), window.writeAddress, static_cast<int>(window.written.size()), window.written.data(),
        window.readAddress, window.readCount, answer.data());
    if (read != window.readCount)
        return tl::unexpected(failed(request, errno));
    m_lineFreeAt = Clock::now() + frameSilence(m_settings.line);
    return answer;
}

tl::expected<std::vector<std::uint16_t>, LinkError>
RtuClient::readPlain(const std::string& request, std::uint16_t address, std::uint16_t count)
{
    if (const auto ready = prepare(request, readFrames(count), milliseconds{0}); !ready)
        return tl::unexpected(ready.error());
    std::vector<std::uint16_t> answer(count);
    if (modbus_read_registers(m_context.get(), address, count, answer.data()) != count)
        return tl::unexpected(failed(request, errno));
    m_lineFreeAt = Clock::now() + frameSilence(m_settings.line);
    return answer;
}

tl::expected<Identity, LinkError> RtuClient::identify()
{
    const auto check = [this](const std::vector<std::uint16_t>& registers) -> std::optional<LinkError> {
        const Identity identity = decodeIdentity(registers);
        if (identity.deviceType != deviceType)
            return error(LinkErrorKind::NotCamPanel, "identity", {}, identity.deviceType);
        if (identity.mapMajor != mapMajor)
            return error(LinkErrorKind::WrongMapMajor, "identity", {}, identity.mapMajor);
        return std::nullopt;
    };
    const auto plain = readPlain("identity", identityAddress, identityRegisters);
    if (!plain) {
        // No such function or registers; a device that is busy or has failed may be any.
        const bool isForeign = plain.error().kind == LinkErrorKind::Exception &&
                               plain.error().code <= MODBUS_EXCEPTION_ILLEGAL_DATA_VALUE;
        return tl::unexpected(isForeign ? error(LinkErrorKind::NotCamPanel, "identity") : plain.error());
    }
    if (const auto refused = check(*plain))
        return tl::unexpected(*refused);
    const auto proven = readProven(identityAddress, identityRegisters);
    if (!proven)
        return tl::unexpected(proven.error());
    if (const auto refused = check(*proven))
        return tl::unexpected(*refused);
    return decodeIdentity(*proven);
}

tl::expected<StatusBlock, LinkError> RtuClient::exchangeStatus(std::uint16_t heartbeat, std::uint16_t jogBits)
{
    const std::array<std::uint16_t, 3> written{++m_tag, heartbeat, jogBits};
    static const std::uint16_t exchangeAddress = registerNamed("exchange.tag").address;
    const auto answer =
        writeAndRead("status", {exchangeAddress, written, statusAddress, statusRegisters, milliseconds{0}});
    if (!answer)
        return tl::unexpected(answer.error());
    const StatusBlock status = decodeStatus(*answer);
    if (status.tag != m_tag || status.heartbeat != heartbeat)
        return tl::unexpected(dropForeign("status"));
    m_commandCounter = status.commandCounter;
    return status;
}

tl::expected<std::vector<std::uint16_t>, LinkError> RtuClient::readProven(std::uint16_t address,
                                                                          std::uint16_t count)
{
    const std::string request = "registers from " + std::to_string(address);
    if (count < 1 || count > readbackRegisters)
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request,
                                    "1 to " + std::to_string(readbackRegisters) +
                                        " registers can be read at once, not " + std::to_string(count) +
                                        "."));
    static const std::uint16_t questionAddress = registerNamed("readback.tag").address;
    static const std::uint16_t answerAddress = registerNamed("readback_result.tag").address;
    constexpr std::uint16_t echoed = 3;
    const std::array<std::uint16_t, echoed> written{++m_tag, address, count};
    auto answer = writeAndRead(request, {questionAddress, written, answerAddress,
                                         static_cast<std::uint16_t>(echoed + count), milliseconds{0}});
    if (!answer)
        return answer;
    if ((*answer)[0] != m_tag || (*answer)[1] != address)
        return tl::unexpected(dropForeign(request));
    if ((*answer)[2] != count)
        return tl::unexpected(error(LinkErrorKind::RangeNotReadable, request,
                                    std::to_string(count) + " from " + std::to_string(address)));
    answer->erase(answer->begin(), answer->begin() + echoed);
    return answer;
}

tl::expected<CommandResult, LinkError> RtuClient::command(Command code, CommandArguments arguments)
{
    const std::string request = commandName(code);
    static const std::uint16_t commandAddress = registerNamed("command.counter").address;
    static const std::uint16_t resultAddress = registerNamed("result.counter").address;
    if (!m_commandCounter) {
        const auto last = readProven(resultAddress, commandResultRegisters);
        if (!last)
            return tl::unexpected(last.error());
        m_commandCounter = decodeCommandResult(*last).counter;
    }
    const std::uint16_t counter = counterAfter(*m_commandCounter);
    const std::array<std::uint16_t, 6> written{counter,
                                               static_cast<std::uint16_t>(code),
                                               arguments.argument0,
                                               arguments.argument1,
                                               static_cast<std::uint16_t>(arguments.argument2 >> 16),
                                               static_cast<std::uint16_t>(arguments.argument2 & 0xFFFFu)};
    const auto allowance = code == Command::SaveToFlash ? flashAllowance : milliseconds{0};
    const auto answer =
        writeAndRead(request, {commandAddress, written, resultAddress, commandResultRegisters, allowance});
    m_commandCounter.reset();
    if (!answer) {
        if (answer.error().kind == LinkErrorKind::NotOpen)
            return tl::unexpected(answer.error());
        auto found = resolve(request, counter);
        // The exception was this command's own when the controller has not carried it out.
        if (!found && found.error().kind == LinkErrorKind::CommandLost &&
            answer.error().kind == LinkErrorKind::Exception)
            return tl::unexpected(answer.error());
        return found;
    }
    const CommandResult result = decodeCommandResult(*answer);
    if (result.counter != counter || result.code != code) {
        drainLine();
        return resolve(request, counter);
    }
    m_commandCounter = counter;
    return result;
}

tl::expected<CommandResult, LinkError> RtuClient::resolve(const std::string& request, std::uint16_t counter)
{
    for (int attempt = 0; attempt < resolveAttempts; ++attempt) {
        const auto found = findResult(counter);
        if (found && *found)
            return **found;
        // Not received for certain only when the controller still has the one before: a restarted one has
        // none, and has perhaps carried it out before.
        if (found && counterAfter(*m_commandCounter) == counter)
            return tl::unexpected(error(LinkErrorKind::CommandLost, request, {}, counter));
        if (found)
            break;
        if (portIsLost(found.error()))
            break;
    }
    return tl::unexpected(error(LinkErrorKind::OutcomeUnknown, request, {}, counter));
}

tl::expected<std::optional<CommandResult>, LinkError> RtuClient::findResult(std::uint16_t counter)
{
    const auto registers = readProven(registerNamed("result.counter").address, commandResultRegisters);
    if (!registers)
        return tl::unexpected(registers.error());
    const CommandResult result = decodeCommandResult(*registers);
    m_commandCounter = result.counter;
    return result.counter == counter ? std::optional(result) : std::nullopt;
}

tl::expected<TransferAnswer, LinkError> RtuClient::transfer(const TransferFrame& frame)
{
    const std::string request = "transfer of block " + std::to_string(frame.block);
    if (frame.data.size() > blockRegisters)
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request, "the block is too long."));
    static const std::uint16_t transferAddress = registerNamed("transfer.session").address;
    static const std::uint16_t resultAddress = registerNamed("transfer_result.session").address;
    std::vector<std::uint16_t> written{frame.session, static_cast<std::uint16_t>(frame.operation),
                                       frame.block, static_cast<std::uint16_t>(frame.data.size())};
    written.insert(written.end(), frame.data.begin(), frame.data.end());
    const auto allowance = frame.operation == TransferOperation::Seal ? sealAllowance : milliseconds{0};
    const auto registers =
        writeAndRead(request, {transferAddress, written, resultAddress, transferResultRegisters, allowance});
    if (!registers)
        return tl::unexpected(registers.error());
    const TransferAnswer answer = decodeTransferAnswer(*registers);
    const bool sessionIsMine =
        answer.session == frame.session || answer.result == TransferResult::WrongSession ||
        answer.result == TransferResult::NotReceiving || frame.operation == TransferOperation::Begin;
    if (answer.operation != frame.operation || answer.block != frame.block || !sessionIsMine)
        return tl::unexpected(dropForeign(request));
    return answer;
}

tl::expected<TransferAnswer, LinkError> RtuClient::readTransferResult()
{
    return readProven(registerNamed("transfer_result.session").address, transferResultRegisters)
        .map([](const std::vector<std::uint16_t>& registers) { return decodeTransferAnswer(registers); });
}

tl::expected<void, LinkError> RtuClient::writeParameter(const RegisterInfo& info, double physical)
{
    const std::string request(info.name);
    const auto raw = toRaw(info, physical);
    if (!raw || info.access != Access::ReadWrite)
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request,
                                    raw ? request + " cannot be written." : describe(raw.error())));
    std::array<std::uint16_t, 2> registers{};
    RegisterWriter writer{std::span(registers).first(info.count), info.address};
    static_cast<void>(writer.physical(info, physical)); // fits: toRaw() said so
    if (const auto ready = prepare(request, writeFrames(info.count), milliseconds{0}); !ready)
        return ready;
    const int sent = modbus_write_registers(m_context.get(), info.address, info.count, registers.data());
    std::optional<LinkError> refusal;
    if (sent != info.count) {
        const LinkError failure = failed(request, errno);
        if (failure.kind == LinkErrorKind::PortGone)
            return tl::unexpected(failure);
        if (failure.kind == LinkErrorKind::Exception) // perhaps the late one to another question
            refusal = failure;
    } else {
        m_lineFreeAt = Clock::now() + frameSilence(m_settings.line);
    }
    // Whatever became of the answer, the registers themselves tell.
    const auto kept = readProven(info.address, info.count);
    if (!kept)
        return tl::unexpected(kept.error());
    if (std::equal(kept->begin(), kept->end(), registers.begin()))
        return {};
    if (refusal)
        return tl::unexpected(*refusal);
    return tl::unexpected(
        error(LinkErrorKind::ReadBackDiffers, request,
              request + " reads " + std::to_string(RegisterReader(*kept, info.address).physical(info))));
}

} // namespace campanel::modbus
