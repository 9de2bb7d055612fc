// SPDX-License-Identifier: Apache-2.0
// The panel's client compared with plain libmodbus and QModbusRtuSerialClient on lines of the same speed:
// status exchanges a second, and 1024 registers written and read back. The peers neither keep the silence
// between frames nor prove their answers.
#include "bench_report.h"

#include "master.h"

#include "modbus/line/rtu_client.h"
#include "modbus/line/wire_time.h"
#include "modbus/map/codec.h"
#include "tests/support/controller_process.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <stdexcept>

namespace campanel::bench {
namespace {

using Clock = std::chrono::steady_clock;
using namespace Qt::StringLiterals;

constexpr std::uint32_t peersBaud = 115200;
constexpr int registerCount = 1024;
constexpr std::uint16_t session = 7;

double seconds(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double>(time).count();
}

// Adapts the panel's client, so that one piece of work serves all three.
class ProvenMaster : public Master {
public:
    explicit ProvenMaster(modbus::LinkSettings settings)
        : m_client(std::move(settings))
    {
        if (const auto opened = m_client.open(); !opened)
            throw std::runtime_error(describe(opened.error()));
    }
    std::vector<std::uint16_t> writeAndRead(std::uint16_t writeAddress,
                                            std::span<const std::uint16_t> written,
                                            std::uint16_t /*readAddress*/, std::uint16_t count) override
    {
        if (writeAddress == modbus::registerNamed("exchange.tag").address) {
            take(m_client.exchangeStatus(written[1], written[2]));
            return std::vector<std::uint16_t>(count);
        }
        const modbus::TransferFrame frame{written[0], static_cast<modbus::TransferOperation>(written[1]),
                                          written[2], written.subspan(4)};
        const auto answer = take(m_client.transfer(frame));
        return {answer.session, static_cast<std::uint16_t>(answer.operation), answer.block,
                static_cast<std::uint16_t>(answer.result)};
    }
    std::vector<std::uint16_t> read(std::uint16_t address, std::uint16_t count) override
    {
        return take(m_client.readProven(address, count));
    }

private:
    template <typename T> static T take(tl::expected<T, modbus::LinkError> outcome)
    {
        if (!outcome)
            throw std::runtime_error(describe(outcome.error()));
        return std::move(*outcome);
    }

    modbus::RtuClient m_client;
};

// How often a master reads the status, and what share of a core it takes for that: the price of this
// machine's line, below which no panel can be.
struct StatusRate {
    double perSecond = 0;
    double processorPercent = 0;
};

double processorSeconds()
{
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto inSeconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
    };
    return inSeconds(used.ru_utime) + inSeconds(used.ru_stime);
}

StatusRate statusRate(Master& master)
{
    const std::uint16_t tagAddress = modbus::registerNamed("exchange.tag").address;
    const std::uint16_t statusBase = modbus::registerNamed("status.tag").address;
    std::uint16_t tag = 0;
    const auto exchange = [&] {
        ++tag;
        static_cast<void>(master.writeAndRead(tagAddress, std::array<std::uint16_t, 3>{tag, tag, 0},
                                              statusBase, modbus::statusRegisters));
    };
    for (int i = 0; i < 5; ++i)
        exchange();
    int count = 0;
    const auto start = Clock::now();
    const double processorBefore = processorSeconds();
    for (; Clock::now() - start < statusTime; ++count)
        exchange();
    const double passed = seconds(Clock::now() - start);
    return {count / passed, 100 * (processorSeconds() - processorBefore) / passed};
}

void transfer(Master& master, modbus::TransferOperation operation, int block,
              std::span<const std::uint16_t> data)
{
    const std::uint16_t address = modbus::registerNamed("transfer.session").address;
    const std::uint16_t resultAddress = modbus::registerNamed("transfer_result.session").address;
    constexpr std::uint16_t resultRegisters = 8;
    std::vector<std::uint16_t> written{session, static_cast<std::uint16_t>(operation),
                                       static_cast<std::uint16_t>(block),
                                       static_cast<std::uint16_t>(data.size())};
    written.insert(written.end(), data.begin(), data.end());
    const auto answer = master.writeAndRead(address, written, resultAddress, resultRegisters);
    if (answer[3] != static_cast<std::uint16_t>(modbus::TransferResult::Accepted))
        throw std::runtime_error("the controller refused block " + std::to_string(block));
}

// Writes to the shadow bank, and reads all of it back.
double writeAndVerifySeconds(Master& master)
{
    std::vector<std::uint16_t> words(registerCount);
    for (std::size_t i = 0; i < words.size(); ++i)
        words[i] = static_cast<std::uint16_t>(i * 40503u);
    const auto start = Clock::now();
    const std::array<std::uint16_t, 3> announced{
        static_cast<std::uint16_t>(modbus::ProgramKind::RotaryCutter), registerCount, modbus::mapMajor};
    transfer(master, modbus::TransferOperation::Begin, 0, announced);
    const std::span<const std::uint16_t> all(words);
    for (int at = 0, block = 0; at < registerCount; at += modbus::blockRegisters, ++block)
        transfer(master, modbus::TransferOperation::Block, block,
                 all.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(std::min<int>(
                                                               modbus::blockRegisters, registerCount - at))));
    for (int at = 0; at < registerCount; at += modbus::readbackRegisters) {
        const int count = std::min<int>(modbus::readbackRegisters, registerCount - at);
        const auto kept = master.read(static_cast<std::uint16_t>(modbus::stagedBankBase + at),
                                      static_cast<std::uint16_t>(count));
        if (!std::equal(kept.begin(), kept.end(), words.begin() + at))
            throw std::runtime_error("what is read back is not what was written");
    }
    return seconds(Clock::now() - start);
}

// Includes both silences around every frame; plain reads for the peers, proven ones (three registers more in
// each direction) for ours.
double wireSeconds(const modbus::LineSettings& line)
{
    std::chrono::nanoseconds total = modbus::pairTime(line, modbus::transferFrames(3));
    for (int left = registerCount; left > 0; left -= modbus::blockRegisters)
        total += modbus::pairTime(line, modbus::transferFrames(std::min<int>(left, modbus::blockRegisters)));
    for (int left = registerCount; left > 0; left -= modbus::readbackRegisters)
        total += modbus::pairTime(
            line, modbus::writeReadFrames(3, 3 + std::min<int>(left, modbus::readbackRegisters)));
    return seconds(total);
}

} // namespace

Figures measurePeers()
{
    const test::ControllerProcess controller({u"--baud"_s, QString::number(peersBaud)});
    const std::string port = controller.port().toStdString();
    modbus::LinkSettings settings;
    settings.port = port;
    settings.line.baud = peersBaud;
    Figures figures;
    StatusRate ours;
    double oursWritten = 0;
    {
        ProvenMaster master(settings);
        ours = statusRate(master);
        oursWritten = writeAndVerifySeconds(master);
    }
    const double wire =
        1 / seconds(modbus::pairTime(settings.line, modbus::writeReadFrames(3, modbus::statusRegisters)));
    figures.push_back(
        {"status exchanges", ours.perSecond, 0.95 * wire, "/s", "95 % of the wire's limit", false});
    figures.push_back({"1024 registers written and read back", oursWritten, wireSeconds(settings.line) / 0.95,
                       "s", "wire's limit / 0.95", true});
    const auto beside = [&](const std::string& name, Master& master) {
        const StatusRate peer = statusRate(master);
        figures.push_back({"status exchanges", ours.perSecond, peer.perSecond, "/s", name, false, true});
        figures.push_back(
            {"processor for them", ours.processorPercent, peer.processorPercent, "%", name, true, true});
        figures.push_back({"1024 registers written and read back", oursWritten, writeAndVerifySeconds(master),
                           "s", name, true, true});
    };
    beside("plain libmodbus", *plainMaster(port, peersBaud));
    if (const auto master = qtMaster(port, peersBaud))
        beside("QModbusRtuSerialClient", *master);
    else
        std::cerr << "campanel-bench: built without QModbusRtuSerialClient; install qt6-serialbus-dev and "
                     "build again\n";
    return figures;
}

} // namespace campanel::bench
