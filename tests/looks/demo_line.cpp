// SPDX-License-Identifier: Apache-2.0
// A day of a line, invented; see demo_line.h.
#include "tests/looks/demo_line.h"

#include "modbus/map/codec.h"
#include "modbus/map/io_status.h"

#include <QByteArray>
#include <QDateTime>

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

using namespace std::chrono_literals;

namespace campanel::looks {
namespace {

using Verdict = modbus::FrameVerdict;

constexpr unsigned answerSeed = 11;
constexpr int answersPerMinute = 60; // less than a real line, because each is created separately
constexpr int badHour = 9;           // hour of a welder beside the cable
constexpr int nightEnds = 5;         // the panel was off before

struct Frame {
    Verdict verdict;
    std::chrono::milliseconds at;
    std::uint16_t readAddress;
    std::uint16_t readCount;
    std::string_view hex;
};

constexpr std::array frames{
    Frame{Verdict::Sent, 0ms, 0x0000, 0, "01170100002802000003060007006B000026CF"},
    Frame{Verdict::Answer, 11ms, 0x0100, 40,
          "0117500007006B000200000000000100000000000D1234567812345678000030C0303927100000264800"
          "0026340000100400001000000430390003D0F80028000030C0000015180002000000000000006B005469"
          "8B"},
    Frame{Verdict::Sent, 12ms, 0x0000, 0, "011702300004022000060C0009000100000000000000000BD5"},
    Frame{Verdict::Answer, 17ms, 0x0230, 4, "01170800090001000100002097"},
    Frame{Verdict::Sent, 18ms, 0x0000, 0, "01170100002802000003060008006C0000C30F"},
    Frame{Verdict::Silence, 130ms, 0x0000, 0, ""},
    Frame{Verdict::Sent, 131ms, 0x0000, 0, "01170100002802000003060009006D0000AF0F"},
    Frame{Verdict::BadChecksum, 142ms, 0x0100, 40,
          "0117500009006D000200000000000100000000000D1234567812345678000030C032C827100000264800"
          "0026340000100400001000000432C80003D0F80028000030C0000015180002000000000000006D006C00"
          "00"},
    Frame{Verdict::Sent, 170ms, 0x0000, 0, "011000820001020384B8E1"},
    Frame{Verdict::Answer, 176ms, 0x0000, 0, "011000820001A1E1"},
    Frame{Verdict::Sent, 178ms, 0x0000, 0, "0117031000040300000306001500820001887A"},
    Frame{Verdict::Answer, 186ms, 0x0310, 4, "0117080015008200010384B81B"},
    Frame{Verdict::Sent, 188ms, 0x0000, 0, "010310000002C0CB"},
    Frame{Verdict::Exception, 193ms, 0x1000, 2, "018302C0F1"},
    Frame{Verdict::Sent, 196ms, 0x0000, 0, "0117010000280200000306000A006E00001B0F"},
    Frame{Verdict::Answer, 207ms, 0x0100, 40,
          "011750000A006E000200000000000100000000000D1234567812345678000030C0358427100000264800"
          "0026340000100400001000000435840003D0F80028000030C0000015180002000000000000006E0078E5"
          "5D"},
};
constexpr std::size_t statusFrame = 1; // the answer with the displayed registers

modbus::FrameRecord recordOf(const Frame& frame, std::uint64_t number, link::SteadyTime end)
{
    modbus::FrameRecord record;
    record.number = number;
    record.at = end - (frames.back().at - frame.at);
    record.verdict = frame.verdict;
    record.readAddress = frame.readAddress;
    record.readCount = frame.readCount;
    const QByteArray bytes =
        QByteArray::fromHex({frame.hex.data(), static_cast<qsizetype>(frame.hex.size())});
    record.length = static_cast<std::uint16_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), record.data.begin());
    return record;
}

modbus::LinkFigures figuresOfADay()
{
    modbus::LinkFigures figures;
    std::mt19937 random(answerSeed);
    std::gamma_distribution<double> delayMs(3.0, 1.1);
    const qint64 end = QDateTime(QDate(2026, 1, 15), QTime(14, 7)).toSecsSinceEpoch();
    for (qint64 at = end - 60 * (modbus::LinkFigures::stripMinutes - 1); at <= end; at += 60) {
        const int hour = QDateTime::fromSecsSinceEpoch(at).time().hour();
        if (hour < nightEnds)
            continue;
        const std::chrono::system_clock::time_point time{std::chrono::seconds(at)};
        for (int i = 0; i < answersPerMinute - hour; ++i) {
            const auto latency = std::chrono::microseconds(static_cast<int>(1000 * (11 + delayMs(random))));
            figures.noteRequest(21, false);
            figures.noteReceived(85);
            figures.noteAnswer(latency, 10'900us, latency + 200us, time);
        }
        if (hour != badHour)
            continue;
        figures.noteRequest(21, true);
        figures.noteDrain(17);
        figures.noteError(random() % 3 == 0 ? modbus::LinkErrorKind::BadChecksum
                                            : modbus::LinkErrorKind::NoAnswer,
                          110ms, time);
    }
    modbus::StatusBlock status;
    figures.noteController(status);
    status.linkRequests = 47213;
    status.linkCrcErrors = 14;
    status.uptimeS = 30000;
    figures.noteController(status);
    return figures;
}

modbus::LineFinding findingAt(const char* port, modbus::LineCondition condition)
{
    modbus::LineFinding finding;
    finding.port = port;
    finding.condition = condition;
    return finding;
}

QList<modbus::LineFinding> troubles()
{
    using modbus::LineCondition;
    auto busy = findingAt("/dev/ttyS0", LineCondition::PortBusy);
    busy.holders = {{812, "screen"}};
    auto garbage = findingAt("/dev/ttyUSB0", LineCondition::Garbage);
    garbage.line.baud = 9600;
    garbage.bytesSeen = 148;
    garbage.latencyTimerMs = 16;
    return {busy, garbage, findingAt("/dev/ttyUSB2", LineCondition::NoBytes)};
}

} // namespace

link::FiguresReport demoFigures(link::SteadyTime now)
{
    static const modbus::LinkFigures figures = figuresOfADay();
    return {now, figures, 50ms};
}

QList<modbus::FrameRecord> demoFrames(link::SteadyTime now)
{
    QList<modbus::FrameRecord> records;
    for (std::size_t i = 0; i < frames.size(); ++i)
        records << recordOf(frames[i], i + 1, now);
    return records;
}

link::ScanReport demoSearch(modbus::ScanPlan::Depth depth)
{
    link::ScanReport report;
    report.depth = depth;
    report.isRunning = true;
    report.progress = {37, 7410, "/dev/ttyUSB1", {19200, modbus::Parity::Even, 1}, 7, 11min};
    report.findings = troubles().first(1);
    return report;
}

link::ScanReport demoSearchEnd(modbus::ScanPlan::Depth depth, bool isFound, const modbus::Identity& identity)
{
    link::ScanReport report;
    report.depth = depth;
    report.findings = troubles();
    if (!isFound)
        return report;
    auto controller = findingAt("/dev/ttyUSB1", modbus::LineCondition::WrongUnit);
    controller.line = {19200, modbus::Parity::Even, 1};
    controller.unit = 7;
    controller.identity = identity;
    report.findings = {report.findings.first(), controller};
    link::ConnectionSettings found;
    found.simulated = false;
    found.port = QStringLiteral("/dev/ttyUSB1");
    found.line = controller.line;
    found.unit = controller.unit;
    report.found = found;
    return report;
}

namespace {

// An engaged encoder of 10 000 counts on 250 mm at 250 mm/s.
void copyMaster(std::vector<std::uint16_t>& map)
{
    modbus::RegisterWriter writer(map, 0);
    const auto put = [&writer](const char* name, double value) {
        if (!writer.physical(name, value))
            qFatal("%s does not fit its register", name);
    };
    put("master_status.available", 1);
    put("master_status.state", static_cast<double>(modbus::MasterState::Engaged));
    put("master_status.counts", 4127350);
    put("master_status.speed", 250.4);
    put("master_status.angle", 264.6);
    put("master_status.error", -0.007);
    put("master_status.lead", 0.813);
    put("master_status.smoothing", 5);
    put("master_status.ripple", 1.02);
    put("master_status.index_error", 1);
    put("master_status.slip", 0.024);
    put("master_status.lag", 0.043);
}

} // namespace

std::vector<std::uint16_t> demoRegisters(const link::ReadRequest& request,
                                         const program::ProgramImage& program, bool hasEncoder)
{
    // Has the size of the map.
    std::vector<std::uint16_t> map(modbus::stagedBankBase + modbus::bankRegisters);
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (info.defaultValue != 0)
            map[info.address + info.count - 1U] = static_cast<std::uint16_t>(info.defaultValue / info.scale);
    }
    map[modbus::findSpan("identity.device_type")->address] = modbus::deviceType;
    map[modbus::findSpan("identity.map_major")->address] = modbus::mapMajor;
    map[modbus::findSpan("identity.firmware_major")->address] = 1;
    const modbus::FrameRecord status = recordOf(frames[statusFrame], 1, {});
    for (std::size_t i = 0; i < status.readCount; ++i)
        map[status.readAddress + i] =
            static_cast<std::uint16_t>(status.data[3 + 2 * i] << 8 | status.data[4 + 2 * i]);
    // Motors can be reversed, switches 1 and 3 on, 37.2 % torque at the angle of the status; the infeed of a
    // cutter only.
    const bool isCutter = program.recipe.isCutter();
    const std::array<std::uint16_t, 9> io{
        static_cast<std::uint16_t>(isCutter ? 0x008F : 0x008B), 0x0020, 0x0105, 372, 0x002F, 0x1A80, 3180,
        map[modbus::findSpan("status.master_angle")->address],  1};
    std::ranges::copy(io, map.begin() + modbus::ioAddress);
    if (hasEncoder)
        copyMaster(map);
    std::ranges::copy(program.registers, map.begin() + modbus::activeBankBase);
    const auto first = map.begin() + request.address;
    return {first, first + request.count};
}

} // namespace campanel::looks
