// SPDX-License-Identifier: Apache-2.0
// The scripted slave's side of the contract: exchange, command, transfer and read-back windows.
#include "scripted_slave.h"

#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"

#include <modbus/modbus.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace campanel::test {
namespace {

using namespace campanel::modbus;

std::uint16_t address(std::string_view name)
{
    return registerNamed(name).address;
}

std::uint16_t crc16(const std::vector<std::uint8_t>& bytes)
{
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1u) != 0 ? (crc >> 1) ^ 0xA001u : crc >> 1);
    }
    return crc;
}

std::uint16_t word(const std::uint8_t* bytes)
{
    return static_cast<std::uint16_t>((bytes[0] << 8) | bytes[1]);
}

} // namespace

ScriptedSlave::ScriptedSlave(int unit)
    : m_unit(unit)
    , m_registers(0x10000, 0)
{
    m_master = posix_openpt(O_RDWR | O_NOCTTY);
    if (m_master < 0 || grantpt(m_master) != 0 || unlockpt(m_master) != 0)
        throw std::runtime_error("no pseudo-terminal");
    m_port = ptsname(m_master);
    m_keptSlave = ::open(m_port.c_str(), O_RDWR | O_NOCTTY);
    termios settings{};
    tcgetattr(m_keptSlave, &settings);
    cfmakeraw(&settings);
    tcsetattr(m_keptSlave, TCSANOW, &settings);

    m_registers[address("identity.device_type")] = deviceType;
    m_registers[address("identity.map_major")] = mapMajor;
    m_registers[address("identity.firmware_minor")] = 3;
    m_registers[address("identity.program_kinds")] = 2;
    m_registers[address("identity.row_capacity")] = rowCapacity;
    m_registers[address("identity.timer_clock") + 1] = 10000;
    m_registers[address("identity.timer_bits")] = 32;
    m_registers[address("identity.max_pulse_frequency") + 1] = 50000;
    m_registers[address("identity.bank_registers")] = bankRegisters;
    m_registers[address("identity.block_registers")] = blockRegisters;
    m_registers[address("status.generation") + 1] = 7;
    m_thread = std::thread([this] { serve(); });
}

ScriptedSlave::~ScriptedSlave()
{
    unplug();
}

void ScriptedSlave::script(std::vector<Fault> faults)
{
    const std::scoped_lock lock(m_mutex);
    m_faults.assign(faults.begin(), faults.end());
}

void ScriptedSlave::setRegister(std::uint16_t at, std::uint16_t value)
{
    const std::scoped_lock lock(m_mutex);
    m_registers[at] = value;
}

std::uint16_t ScriptedSlave::getRegister(std::uint16_t at)
{
    const std::scoped_lock lock(m_mutex);
    return m_registers[at];
}

void ScriptedSlave::unplug()
{
    m_stop = true;
    if (m_thread.joinable())
        m_thread.join();
    for (int* descriptor : {&m_master, &m_keptSlave}) {
        if (*descriptor >= 0)
            ::close(*descriptor);
        *descriptor = -1;
    }
}

void ScriptedSlave::forgetTransfer()
{
    const std::scoped_lock lock(m_mutex);
    loseTransfer();
}

void ScriptedSlave::loseTransfer()
{
    m_received.clear();
    m_registers[address("transfer_result.session")] = 0;
}

void ScriptedSlave::restart()
{
    const std::scoped_lock lock(m_mutex);
    powerUp();
}

void ScriptedSlave::powerUp()
{
    loseTransfer();
    std::fill_n(m_registers.begin() + stagedBankBase, bankRegisters, std::uint16_t{0});
    for (const char* name : {"status.staged_state", "status.command_counter", "result.counter", "result.code",
                             "result.status", "result.reason"})
        m_registers[address(name)] = 0;
    put32(address("status.generation"), 6);
    put32(address("status.active_crc"), 0x06060606);
}

void ScriptedSlave::reachCycleBoundary()
{
    const std::scoped_lock lock(m_mutex);
    if (m_registers[address("status.staged_state")] == static_cast<std::uint16_t>(StagedState::Armed))
        activateStaged();
}

void ScriptedSlave::surround(std::vector<std::uint8_t> before, std::vector<std::uint8_t> behind)
{
    const std::scoped_lock lock(m_mutex);
    m_before = std::move(before);
    m_behind = std::move(behind);
}

void ScriptedSlave::refuseRow(std::uint16_t row)
{
    const std::scoped_lock lock(m_mutex);
    m_refusedRow = row;
}

void ScriptedSlave::serve()
{
    using Context = std::unique_ptr<modbus_t, decltype(&modbus_free)>;
    const auto listen = [this] {
        Context context(modbus_new_rtu("/dev/null", 115200, 'N', 8, 1), &modbus_free);
        modbus_set_slave(context.get(), m_unit);
        modbus_set_socket(context.get(), m_master);
        constexpr std::uint32_t stopCheckUs = 20'000;
        modbus_set_indication_timeout(context.get(), 0, stopCheckUs);
        return context;
    };
    Context context = listen();
    std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> buffer{};
    while (!m_stop) {
        const int length = modbus_receive(context.get(), buffer.data());
        if (length == 0)
            context =
                listen(); // after a request to another unit, libmodbus skips the next frame as its answer
        if (length <= 0)
            continue;
        const Bytes request(buffer.begin(), buffer.begin() + length);
        if (m_isEchoing)
            send(request);
        std::this_thread::sleep_for(std::chrono::milliseconds(m_delayMs));
        answer(request);
    }
}

void ScriptedSlave::answer(const Bytes& request)
{
    const std::scoped_lock lock(m_mutex);
    ++m_requests;
    Fault fault = Fault::None;
    if (!m_faults.empty()) {
        fault = m_faults.front();
        m_faults.pop_front();
    }
    if (fault == Fault::LostRequest)
        return;
    Bytes reply{request[0], static_cast<std::uint8_t>(request[1] | 0x80u), 2};
    if (fault == Fault::Busy || m_exception != 0) {
        reply[2] = m_exception != 0 ? m_exception.load() : std::uint8_t{6};
    } else if (fault != Fault::Exception2) {
        const Bytes right = execute(request);
        reply = fault == Fault::Exception2Done ? reply : right;
    }
    const auto crc = static_cast<std::uint16_t>(crc16(reply) ^ (fault == Fault::BadChecksum ? 0xFFFFu : 0u));
    reply.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    reply.push_back(static_cast<std::uint8_t>(crc >> 8));
    if (fault == Fault::Truncated)
        reply.resize(reply.size() / 2);
    reply.insert(reply.begin(), m_before.begin(), m_before.end());
    reply.insert(reply.end(), m_behind.begin(), m_behind.end());
    const Bytes late = std::exchange(m_late, {});
    if (!late.empty())
        send(late);
    if (fault == Fault::Restart)
        powerUp();
    else if (fault == Fault::LateAnswer)
        m_late = reply;
    else if (fault != Fault::LostAnswer)
        send(reply);
}

void ScriptedSlave::send(const Bytes& bytes)
{
    if (::write(m_master, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error("the pseudo-terminal takes no bytes");
}

ScriptedSlave::Bytes ScriptedSlave::execute(const Bytes& request)
{
    constexpr std::uint8_t readHolding = 3;
    constexpr std::uint8_t writeMultiple = 16;
    const std::uint16_t first = word(&request[2]);
    const std::uint16_t count = word(&request[4]);
    Bytes reply(request.begin(), request.begin() + 2);
    std::uint16_t& status = m_registers[address("result.status")];
    if (status == static_cast<std::uint16_t>(CommandStatus::Busy) && --m_busy <= 0)
        status = static_cast<std::uint16_t>(CommandStatus::Done);
    if (request[1] == writeMultiple) {
        write(first, &request[7], count);
        reply.insert(reply.end(), request.begin() + 2, request.begin() + 6);
        return reply;
    }
    if (request[1] != readHolding)
        write(word(&request[6]), &request[11], word(&request[8]));
    reply.push_back(static_cast<std::uint8_t>(2 * count));
    for (int i = 0; i < count; ++i) {
        const std::uint16_t value = m_registers[static_cast<std::size_t>(first + i)];
        reply.push_back(static_cast<std::uint8_t>(value >> 8));
        reply.push_back(static_cast<std::uint8_t>(value & 0xFFu));
    }
    return reply;
}

void ScriptedSlave::write(std::uint16_t at, const std::uint8_t* data, std::uint16_t count)
{
    ++m_writes;
    for (int i = 0; i < count; ++i)
        m_registers[static_cast<std::size_t>(at + i)] = word(data + 2 * i);
    if (at == address("exchange.tag")) {
        m_registers[address("status.tag")] = m_registers[at];
        m_registers[address("status.heartbeat")] = m_registers[at + 1u];
    } else if (at == address("command.counter")) {
        runCommand();
    } else if (at == address("transfer.session")) {
        runTransfer();
    } else if (at == address("readback.tag")) {
        runReadback();
    }
}

void ScriptedSlave::runReadback()
{
    const std::uint16_t from = m_registers[address("readback.address")];
    const std::uint16_t count = m_registers[address("readback.count")];
    m_registers[address("readback_result.tag")] = m_registers[address("readback.tag")];
    m_registers[address("readback_result.address")] = from;
    const bool readable = from + count <= 0xF000;
    m_registers[address("readback_result.count")] = readable ? count : std::uint16_t{0};
    if (readable)
        std::copy_n(m_registers.begin() + from, count, m_registers.begin() + address("readback_result.data"));
}

void ScriptedSlave::runCommand()
{
    const std::uint16_t counter = m_registers[address("command.counter")];
    if (counter == m_registers[address("result.counter")])
        return;
    ++m_commands;
    const auto code = static_cast<Command>(m_registers[address("command.code")]);
    Refusal refusal = Refusal::None;
    std::uint16_t& staged = m_registers[address("status.staged_state")];
    if (code == Command::Home) {
        refusal = Refusal::InFault;
    } else if (code == Command::ApplyStaged && staged < static_cast<std::uint16_t>(StagedState::Sealed)) {
        refusal = Refusal::NothingSealed;
    } else if (code == Command::ApplyStaged) {
        if (m_registers[address("command.argument0")] == static_cast<std::uint16_t>(ApplyMode::NextCycle))
            staged = static_cast<std::uint16_t>(StagedState::Armed);
        else
            activateStaged();
    } else if (code == Command::CancelApply) {
        staged = static_cast<std::uint16_t>(StagedState::Sealed);
    } else if (code == Command::DiscardStaged) {
        staged = static_cast<std::uint16_t>(StagedState::Empty);
    }
    m_registers[address("result.counter")] = counter;
    m_registers[address("status.command_counter")] = counter;
    m_registers[address("result.code")] = m_registers[address("command.code")];
    m_registers[address("result.status")] = refusal == Refusal::None
                                                ? static_cast<std::uint16_t>(CommandStatus::Done)
                                                : static_cast<std::uint16_t>(CommandStatus::Refused);
    m_registers[address("result.reason")] = static_cast<std::uint16_t>(refusal);
    if (m_busy > 0 && code == Command::SaveToFlash)
        m_registers[address("result.status")] = static_cast<std::uint16_t>(CommandStatus::Busy);
}

void ScriptedSlave::activateStaged()
{
    std::copy_n(m_registers.begin() + stagedBankBase, m_announced, m_registers.begin() + activeBankBase);
    ++m_registers[address("status.generation") + 1u];
    const auto crc = crc32OfRegisters(std::span(m_registers).subspan(activeBankBase, m_announced));
    put32(address("status.active_crc"), crc);
    m_registers[address("status.staged_state")] = static_cast<std::uint16_t>(StagedState::Empty);
}

void ScriptedSlave::runTransfer()
{
    const std::uint16_t session = m_registers[address("transfer.session")];
    const auto operation = static_cast<TransferOperation>(m_registers[address("transfer.operation")]);
    const std::uint16_t block = m_registers[address("transfer.block")];
    const std::uint16_t length = m_registers[address("transfer.length")];
    const auto data = m_registers.begin() + address("transfer.data");
    std::uint16_t& mySession = m_registers[address("transfer_result.session")];
    TransferResult result = TransferResult::Accepted;
    if (m_busy > 0 && operation != TransferOperation::Block) {
        --m_busy;
        result = TransferResult::Busy;
    } else if (operation == TransferOperation::Begin) {
        mySession = session;
        m_announced = data[1];
        m_received.assign((m_announced + blockRegisters - 1u) / blockRegisters, false);
    } else if (session != mySession) {
        result = TransferResult::WrongSession;
    } else if (operation == TransferOperation::Block) {
        std::copy_n(data, length, m_registers.begin() + stagedBankBase + block * blockRegisters);
        m_received[block] = true;
    } else if (std::ranges::find(m_received, false) != m_received.end()) {
        result = TransferResult::BlocksMissing;
    } else if (m_refusedRow != 0xFFFF) {
        result = TransferResult::BadRow;
        m_registers[address("transfer_result.detail")] = m_refusedRow;
    } else {
        put32(address("transfer_result.staged_crc"),
              crc32OfRegisters(std::span(m_registers).subspan(stagedBankBase, m_announced)));
        m_registers[address("status.staged_state")] = static_cast<std::uint16_t>(StagedState::Sealed);
    }
    m_registers[address("transfer_result.operation")] = static_cast<std::uint16_t>(operation);
    m_registers[address("transfer_result.block")] = block;
    m_registers[address("transfer_result.result")] = static_cast<std::uint16_t>(result);
    m_registers[address("transfer_result.next_missing")] =
        static_cast<std::uint16_t>(std::ranges::find(m_received, false) - m_received.begin());
}

void ScriptedSlave::put32(std::uint16_t at, std::uint32_t value)
{
    m_registers[at] = static_cast<std::uint16_t>(value >> 16);
    m_registers[at + 1u] = static_cast<std::uint16_t>(value & 0xFFFFu);
}

} // namespace campanel::test
