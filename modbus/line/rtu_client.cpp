// SPDX-License-Identifier: Apache-2.0
// The questions of the contract, and the proof that an answer belongs to its question.
#include "modbus/line/rtu_client.h"

#include "modbus/line/answer_reader.h"
#include "modbus/map/codec.h"
#include "modbus/map/function_codes.h"
#include "modbus/map/order_status.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <thread>

namespace campanel::modbus {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

// The additional time for checking all rows. A lost answer costs this time too: sealing must leave enough
// time to find a restarted controller within two seconds.
constexpr milliseconds sealAllowance{1000};
constexpr int resolveAttempts = 3;
// The pause between two questions whether a controller has finished its work.
constexpr milliseconds busyPause{5};
// The same while connecting, for a device that is busy.
constexpr milliseconds busyDevicePause{100};
constexpr int attemptsWhileConnecting = 6;

// Returns the next counter, never 0: that is the value after a restart, and the controller would treat the
// command as an old one.
std::uint16_t counterAfter(std::uint16_t counter)
{
    return counter == 0xFFFF ? std::uint16_t{1} : static_cast<std::uint16_t>(counter + 1u);
}

// Returns true for errors that say nothing against the device: it is busy, or the line puts bytes behind the
// answers and is not known for it yet.
bool isPassing(const LinkError& error)
{
    return isBusy(error) || (error.kind == LinkErrorKind::BadFrame && error.code > 0);
}

// Repeats a question of a connection that begins while its errors pass.
template <typename Ask> auto askWhilePassing(const Ask& ask)
{
    auto answer = ask();
    for (int i = 1; i < attemptsWhileConnecting && !answer && isPassing(answer.error()); ++i) {
        if (answer.error().kind == LinkErrorKind::Exception)
            std::this_thread::sleep_for(busyDevicePause);
        answer = ask();
    }
    return answer;
}

void appendWords(std::vector<std::uint8_t>& bytes, std::initializer_list<int> words)
{
    for (const int word : words) {
        bytes.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(word) >> 8));
        bytes.push_back(static_cast<std::uint8_t>(word));
    }
}

} // namespace

RtuClient::RtuClient(LinkSettings settings, std::shared_ptr<LinkRecord> record)
    : m_record(std::move(record))
    , m_line(std::move(settings), *m_record)
    , m_tag(static_cast<std::uint16_t>(Clock::now().time_since_epoch() / milliseconds{1}))
{
}

RtuClient::~RtuClient() = default;

LinkError RtuClient::error(LinkErrorKind kind, std::string request, std::string detail, int code) const
{
    return {kind, settings().port, std::move(request), std::move(detail), code};
}

tl::expected<void, LinkError> RtuClient::open()
{
    m_hasPermit = false;
    m_commandCounter.reset();
    return m_line.open();
}

void RtuClient::close()
{
    m_line.close();
    m_commandCounter.reset();
}

tl::expected<RtuClient::Registers, LinkError>
RtuClient::writeAndRead(const std::string& request, const WindowRead& window, const Proof& isMine)
{
    const auto written = static_cast<int>(window.written.size());
    Question question{request,
                      {functionWriteAndRead},
                      writeReadFrames(written, window.readCount),
                      window.readAddress,
                      window.readCount,
                      window.extraAllowance,
                      window.isRepeatable};
    appendWords(question.pdu, {window.readAddress, window.readCount, window.writeAddress, written});
    question.pdu.push_back(static_cast<std::uint8_t>(2 * written));
    for (const std::uint16_t value : window.written)
        appendWords(question.pdu, {value});
    Registers answer;
    return m_line
        .ask(question,
             [&](std::span<const std::uint8_t> data) {
                 answer = answeredRegisters(data);
                 return answer.size() == window.readCount && isMine(answer);
             })
        .map([&](const RtuLine::Bytes&) { return std::move(answer); });
}

tl::expected<RtuClient::Registers, LinkError> RtuClient::readPlain(const std::string& request,
                                                                   std::uint16_t address, std::uint16_t count)
{
    Question question{request, {functionRead}, readFrames(count), address, count, milliseconds{0}, true};
    appendWords(question.pdu, {address, count});
    Registers answer;
    return m_line
        .ask(question,
             [&](std::span<const std::uint8_t> data) {
                 answer = answeredRegisters(data);
                 return answer.size() == count;
             })
        .map([&](const RtuLine::Bytes&) { return std::move(answer); });
}

tl::expected<Identity, LinkError> RtuClient::identityIn(const Registers& registers) const
{
    const Identity identity = decodeIdentity(registers);
    if (identity.deviceType != deviceType)
        return tl::unexpected(error(LinkErrorKind::NotCamPanel, "identity", {}, identity.deviceType));
    if (identity.mapMajor != mapMajor)
        return tl::unexpected(error(LinkErrorKind::WrongMapMajor, "identity", {}, identity.mapMajor));
    if (const auto impossible = impossibleValue(identity))
        return tl::unexpected(error(LinkErrorKind::WrongIdentity, "identity", std::string(impossible->name),
                                    static_cast<int>(impossible->value)));
    return identity;
}

tl::expected<Identity, LinkError> RtuClient::probe(int unit)
{
    m_line.setUnit(unit);
    const auto plain =
        askWhilePassing([this] { return readPlain("identity", identityAddress, identityRegisters); });
    if (!plain) {
        // Missing functions or registers mean a foreign device; a busy or failed device may be any.
        const bool isForeign = plain.error().kind == LinkErrorKind::Exception &&
                               plain.error().code <= MODBUS_EXCEPTION_ILLEGAL_DATA_VALUE;
        return tl::unexpected(isForeign ? error(LinkErrorKind::NotCamPanel, "identity") : plain.error());
    }
    return identityIn(*plain);
}

tl::expected<Identity, LinkError> RtuClient::identify()
{
    // Reads before it writes.
    if (const auto plain = probe(settings().unit); !plain)
        return plain;
    const auto proven = askWhilePassing([this] { return readProven(identityAddress, identityRegisters); });
    if (!proven)
        return tl::unexpected(proven.error());
    auto identity = identityIn(*proven);
    m_hasPermit = identity && identity->hasRegister("exchange.permit");
    constexpr std::uint16_t firstMinorWithLayouts = 4;
    if (!identity || identity->mapMinor < firstMinorWithLayouts)
        return identity;
    static const std::uint16_t layoutsAddress = registerNamed("identity.table_layouts").address;
    const auto readLayouts = [this] { return readProven(layoutsAddress, 1); };
    auto layouts = askWhilePassing(readLayouts);
    if (!layouts) // a line that spoils each third answer would spoil one of these four each time
        layouts = askWhilePassing(readLayouts);
    if (!layouts)
        return tl::unexpected(layouts.error());
    identity->tableLayouts = layouts->front();
    return identity;
}

tl::expected<StatusBlock, LinkError> RtuClient::exchangeStatus(std::uint16_t heartbeat, std::uint16_t jogBits,
                                                               std::uint16_t permitBits)
{
    const std::array<std::uint16_t, 4> registers{++m_tag, heartbeat, jogBits, permitBits};
    const std::span written = std::span(registers).first(m_hasPermit ? 4 : 3);
    static const std::uint16_t exchangeAddress = registerNamed("exchange.tag").address;
    StatusBlock status;
    const auto answer =
        writeAndRead("status", {exchangeAddress, written, statusAddress, statusRegisters, milliseconds{0}},
                     [&](const Registers& answered) {
                         status = decodeStatus(answered);
                         return status.tag == m_tag && status.heartbeat == heartbeat;
                     });
    if (!answer)
        return tl::unexpected(answer.error());
    m_commandCounter = status.commandCounter;
    m_record->figures.noteController(status);
    return status;
}

tl::expected<std::vector<std::uint16_t>, LinkError> RtuClient::readProven(std::uint16_t address,
                                                                          std::uint16_t count)
{
    const std::string request = "registers from " + std::to_string(address);
    if (count < 1 || count > readbackRegisters)
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request, {}, count));
    static const std::uint16_t questionAddress = registerNamed("readback.tag").address;
    static const std::uint16_t answerAddress = registerNamed("readback_result.tag").address;
    constexpr std::uint16_t echoed = 3;
    const std::array<std::uint16_t, echoed> written{++m_tag, address, count};
    auto answer = writeAndRead(
        request,
        {questionAddress, written, answerAddress, static_cast<std::uint16_t>(echoed + count),
         milliseconds{0}},
        [&](const Registers& registers) { return registers[0] == m_tag && registers[1] == address; });
    if (!answer)
        return answer;
    if ((*answer)[2] != count)
        return tl::unexpected(error(LinkErrorKind::RangeNotReadable, request,
                                    std::to_string(count) + " from " + std::to_string(address)));
    answer->erase(answer->begin(), answer->begin() + echoed);
    return answer;
}

tl::expected<void, LinkError> RtuClient::writeOrderLot(std::string_view lot)
{
    const std::string request = "order.lot";
    const auto registers = encodeOrderLot(lot);
    if (!registers)
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request));
    const auto count = static_cast<std::uint16_t>(registers->size());
    const auto written = writeAndRead(request, {orderLotAddress, *registers, orderLotAddress, count},
                                      [&](const Registers& read) { return read == *registers; });
    if (!written)
        return tl::unexpected(written.error());
    return {};
}

tl::expected<CommandResult, LinkError> RtuClient::begin(Command code, const CommandArguments& arguments)
{
    const std::string request = enumName(code);
    if (code == Command::OrderStart) {
        if (const auto lot = writeOrderLot(arguments.lot); !lot)
            return tl::unexpected(lot.error());
    }
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
    CommandResult result;
    constexpr bool isRepeatable = false;
    const auto answer = writeAndRead(
        request, {commandAddress, written, resultAddress, commandResultRegisters, allowance, isRepeatable},
        [&](const Registers& registers) {
            result = decodeCommandResult(registers);
            return result.counter == counter && result.code == code;
        });
    m_commandCounter.reset();
    if (!answer) {
        if (answer.error().kind == LinkErrorKind::NotOpen)
            return tl::unexpected(answer.error());
        auto found = resolve(code, counter, &RtuClient::readResult);
        // The exception belongs to this command when the controller has not executed it.
        if (!found && found.error().kind == LinkErrorKind::CommandLost &&
            answer.error().kind == LinkErrorKind::Exception)
            return tl::unexpected(answer.error());
        return found;
    }
    m_commandCounter = counter;
    return result;
}

tl::expected<CommandResult, LinkError> RtuClient::command(Command code, const CommandArguments& arguments)
{
    const auto begun = begin(code, arguments);
    if (!begun || begun->status != CommandStatus::Busy)
        return begun;
    return resolve(code, begun->counter, &RtuClient::findResult);
}

tl::expected<CommandResult, LinkError> RtuClient::resolve(Command code, std::uint16_t counter,
                                                          FindResult find)
{
    const std::string request = enumName(code);
    for (int attempt = 0; attempt < resolveAttempts; ++attempt) {
        const auto found = (this->*find)(counter);
        if (found && *found)
            return **found;
        // Certainly not received only when the controller still has the previous counter: a restarted one has
        // none, and may have executed the command before.
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
    const auto deadline = Clock::now() + flashAllowance;
    for (;;) {
        auto found = readResult(counter);
        if (!found || !*found || (*found)->status != CommandStatus::Busy)
            return found;
        if (Clock::now() >= deadline)
            return tl::unexpected(
                error(LinkErrorKind::OutcomeUnknown, enumName((*found)->code), {}, counter));
        std::this_thread::sleep_for(busyPause);
    }
}

tl::expected<std::optional<CommandResult>, LinkError> RtuClient::readResult(std::uint16_t counter)
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
        return tl::unexpected(error(LinkErrorKind::ValueRefused, request));
    static const std::uint16_t transferAddress = registerNamed("transfer.session").address;
    static const std::uint16_t resultAddress = registerNamed("transfer_result.session").address;
    std::vector<std::uint16_t> written{frame.session, static_cast<std::uint16_t>(frame.operation),
                                       frame.block, static_cast<std::uint16_t>(frame.data.size())};
    written.insert(written.end(), frame.data.begin(), frame.data.end());
    const auto allowance = frame.operation == TransferOperation::Seal ? sealAllowance : milliseconds{0};
    TransferAnswer answer;
    const auto isMine = [&](const Registers& registers) {
        answer = decodeTransferAnswer(registers);
        const bool sessionIsMine =
            answer.session == frame.session || answer.result == TransferResult::WrongSession ||
            answer.result == TransferResult::NotReceiving || frame.operation == TransferOperation::Begin;
        return answer.operation == frame.operation && answer.block == frame.block && sessionIsMine;
    };
    const auto registers = writeAndRead(
        request, {transferAddress, written, resultAddress, transferResultRegisters, allowance}, isMine);
    if (!registers)
        return tl::unexpected(registers.error());
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
    if (!raw || info.access != Access::ReadWrite) {
        LinkError refused = error(LinkErrorKind::ValueRefused, request);
        if (!raw)
            refused.limits = raw.error();
        return tl::unexpected(std::move(refused));
    }
    std::array<std::uint16_t, 2> registers{};
    RegisterWriter writer{std::span(registers).first(info.count), info.address};
    static_cast<void>(writer.physical(info, physical)); // fits, as checked by toRaw()
    Question question{request, {functionWrite}, writeFrames(info.count), 0, 0, milliseconds{0}, true};
    appendWords(question.pdu, {info.address, info.count});
    const RtuLine::Bytes echo(question.pdu.begin() + 1, question.pdu.end());
    question.pdu.push_back(static_cast<std::uint8_t>(2 * info.count));
    for (const std::uint16_t value : std::span(registers).first(info.count))
        appendWords(question.pdu, {value});
    const auto sent = m_line.ask(
        question, [&](std::span<const std::uint8_t> data) { return std::ranges::equal(data, echo); });
    std::optional<LinkError> refusal;
    if (!sent) {
        if (portIsLost(sent.error()))
            return tl::unexpected(sent.error());
        if (sent.error().kind == LinkErrorKind::Exception) // possibly the late one to another question
            refusal = sent.error();
    }
    // The registers themselves tell, regardless of the answer.
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
