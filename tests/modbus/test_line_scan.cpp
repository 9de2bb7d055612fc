// SPDX-License-Identifier: Apache-2.0
// The doctor: why there is no connection, and where a controller is; nothing is ever written.
#include "modbus/line/crc16.h"
#include "modbus/line/line_scan.h"
#include "modbus/map/codec.h"
#include "scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <atomic>
#include <set>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace test_line_scan {

using namespace campanel::modbus;
using campanel::test::Fault;
using campanel::test::ScriptedSlave;
using Depth = ScanPlan::Depth;

namespace {

// Answers everything with bytes that are not a frame, like a line at a wrong baud rate; or, without bytes,
// stays silent.
class NoisyPort {
public:
    explicit NoisyPort(std::vector<std::uint8_t> noise, bool isEchoing = false)
        : m_noise(std::move(noise))
        , m_isEchoing(isEchoing)
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
        m_thread = std::thread([this] { serve(); });
    }
    NoisyPort(const NoisyPort&) = delete;
    NoisyPort& operator=(const NoisyPort&) = delete;
    ~NoisyPort()
    {
        m_stop = true;
        m_thread.join();
        ::close(m_keptSlave);
        ::close(m_master);
    }

    [[nodiscard]] const std::string& port() const { return m_port; }
    [[nodiscard]] int bytes() const { return m_bytes; }

private:
    void serve()
    {
        while (!m_stop) {
            struct pollfd watched {
                m_master, POLLIN, 0
            };
            std::array<std::uint8_t, 256> request{};
            if (poll(&watched, 1, 20) <= 0)
                continue;
            const ssize_t count = ::read(m_master, request.data(), request.size());
            m_bytes += static_cast<int>(count);
            if (m_isEchoing && ::write(m_master, request.data(), static_cast<std::size_t>(count)) < 0)
                return;
            if (!m_noise.empty() && ::write(m_master, m_noise.data(), m_noise.size()) < 0)
                return;
        }
    }

    std::vector<std::uint8_t> m_noise;
    bool m_isEchoing;
    std::string m_port;
    int m_master = -1;
    int m_keptSlave = -1;
    std::atomic<int> m_bytes = 0;
    std::atomic<bool> m_stop = false;
    std::thread m_thread;
};

LineFinding diagnose(const std::string& port, int unit = 1)
{
    LineScan scan(ScanPlan{port, {}, unit, {}, Depth::Diagnosis});
    while (!scan.ended())
        scan.advance();
    return scan.findings().size() == 1 ? scan.findings().front() : LineFinding{};
}

} // namespace

class LineScanTest : public QObject {
    Q_OBJECT

private slots:
    void controllerThatAnswers()
    {
        ScriptedSlave slave;
        const LineFinding finding = diagnose(slave.port());
        QCOMPARE(finding.condition, LineCondition::Controller);
        QVERIFY(finding.isController());
        QCOMPARE(finding.identity->firmwareVersion(), std::string("0.3.0"));
        QCOMPARE(slave.requests(), 1);
        QCOMPARE(slave.writes(), 0);
    }

    void otherMapAndOtherDevice()
    {
        ScriptedSlave slave;
        slave.setRegister(1, mapMajor + 1);
        const LineFinding otherMap = diagnose(slave.port());
        QCOMPARE(otherMap.condition, LineCondition::OtherMapVersion);
        QCOMPARE(otherMap.code, mapMajor + 1);
        QVERIFY(!otherMap.isController());

        slave.setRegister(0, 0x1234);
        const LineFinding otherDevice = diagnose(slave.port());
        QCOMPARE(otherDevice.condition, LineCondition::OtherDevice);
        QCOMPARE(otherDevice.code, 0x1234);

        slave.script({Fault::Exception2});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::OtherDevice);
        QCOMPARE(slave.writes(), 0);
    }

    void deviceThatOnlyAnswersWithErrors()
    {
        ScriptedSlave slave;
        for (const std::uint8_t code : {std::uint8_t{4}, std::uint8_t{6}, std::uint8_t{11}}) {
            slave.setException(code);
            const LineFinding finding = diagnose(slave.port());
            QCOMPARE(finding.condition, LineCondition::Refused);
            QCOMPARE(finding.code, int{code});
        }
        slave.setException(0);
        slave.script({Fault::Busy});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
        QCOMPARE(slave.writes(), 0);
    }

    void strayBytesDoNotHideAController()
    {
        ScriptedSlave slave;
        QCOMPARE(diagnose(slave.port()).strayBytes, std::uint64_t{0});
        slave.surround({0x00}, {});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
        QCOMPARE(diagnose(slave.port()).strayBytes, std::uint64_t{1});
        slave.surround({}, {0x00, 0x00});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
        QVERIFY(diagnose(slave.port()).strayBytes >= 2);
    }

    void lineWithoutASpeedEnds()
    {
        ScriptedSlave slave;
        for (const Depth depth : {Depth::Diagnosis, Depth::Search}) {
            LineSettings line;
            line.baud = 0;
            LineScan scan(ScanPlan{slave.port(), line, 1, {}, depth});
            while (!scan.ended())
                scan.advance();
            QCOMPARE(scan.findings().front().condition, LineCondition::PortSettings);
        }
    }

    void oneDamagedAnswerIsNoVerdict()
    {
        ScriptedSlave slave;
        slave.script({Fault::BadChecksum});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
        QCOMPARE(slave.requests(), 2);
    }

    void lateAnswersAreNoOtherDevice()
    {
        ScriptedSlave slave;
        slave.delayAnswers(std::chrono::milliseconds{200});
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
    }

    void searchFindsAControllerThatIsAlwaysLate()
    {
        ScriptedSlave slave(9);
        slave.delayAnswers(std::chrono::milliseconds{200});
        LineScan scan(ScanPlan{slave.port(), {}, 1, {}, Depth::Search});
        while (!scan.ended())
            scan.advance();
        QVERIFY(scan.controller() != nullptr);
        QCOMPARE(scan.controller()->unit, 9);
        QCOMPARE(scan.findings().size(), std::size_t{1}); // no other device at the other units
        QCOMPARE(slave.writes(), 0);
    }

    void aUsualSearchTriesTheUsualSettings()
    {
        ScriptedSlave silent(9); // a unit that only a search of all settings asks
        LineScan scan(ScanPlan{silent.port(), {}, 2, {"/dev/ttyNONE1", "/dev/ttyNONE2"}, Depth::Usual});
        QCOMPARE(scan.progress().total, 3 * 2 * 10); // ports, units 2 and 1, lines
        QVERIFY(scan.progress().remaining < std::chrono::seconds{10});
        while (!scan.ended())
            scan.advance();
        QVERIFY(scan.controller() == nullptr);
        QCOMPARE(scan.findings().size(), std::size_t{3}); // the reason of each port

        ScriptedSlave answering; // unit 1, beside the configured one
        LineScan found(ScanPlan{"", {}, 2, {answering.port()}, Depth::Usual});
        while (!found.ended())
            found.advance();
        QVERIFY(found.controller() != nullptr);
        QCOMPARE(found.controller()->unit, 1);
        QCOMPARE(answering.writes(), 0);
    }

    void echoIsNoGarbage()
    {
        ScriptedSlave slave;
        slave.setEchoing(true);
        QCOMPARE(diagnose(slave.port()).condition, LineCondition::Controller);
        NoisyPort echo({}, true);
        const LineFinding finding = diagnose(echo.port());
        QCOMPARE(finding.condition, LineCondition::EchoOnly);
    }

    void garbageAndSilence()
    {
        NoisyPort noisy({0xFF, 0x00, 0xF8, 0x80, 0x7E});
        const LineFinding garbage = diagnose(noisy.port());
        QCOMPARE(garbage.condition, LineCondition::Garbage);
        QVERIFY(garbage.bytesSeen >= 10);

        NoisyPort silent({});
        const LineFinding silence = diagnose(silent.port());
        QCOMPARE(silence.condition, LineCondition::NoBytes);
        QCOMPARE(silence.bytesSeen, std::uint64_t{0});
        QVERIFY(silent.bytes() > 0);
    }

    void noiseAfterAnAnswerDoesNotHideIt()
    {
        std::vector<std::uint8_t> refusal{1, 0x83, 2};
        const std::uint16_t crc = crc16(refusal);
        for (const unsigned byte : {crc & 0xFFu, unsigned{crc} >> 8, 0x55u, 0xAAu})
            refusal.push_back(static_cast<std::uint8_t>(byte));
        NoisyPort device(refusal);
        QCOMPARE(diagnose(device.port()).condition, LineCondition::OtherDevice);
    }

    void portsThatCannotBeUsed()
    {
        QCOMPARE(diagnose("/dev/ttyThatIsNotThere").condition, LineCondition::PortAbsent);
        QCOMPARE(diagnose("/dev/null").condition, LineCondition::PortNotSerial);
        QVERIFY(joinGroupCommand("dialout").find("usermod -aG dialout ") != std::string::npos);
    }

    void busyPortNamesItsOwner()
    {
        ScriptedSlave slave;
        // Another process with the port open and locked, like a terminal program.
        QProcess owner;
        owner.start("flock",
                    {"-n", QString::fromStdString(slave.port()), "-c", "echo locked; exec sleep 60"});
        QVERIFY(owner.waitForStarted());
        QVERIFY(owner.waitForReadyRead());
        const LineFinding busy = diagnose(slave.port());
        owner.kill();
        owner.waitForFinished();
        QCOMPARE(busy.condition, LineCondition::PortBusy);
        const bool isNamed = std::ranges::any_of(busy.holders, [&](const PortHolder& holder) {
            return holder.processId == owner.processId() || holder.program == "flock" ||
                   holder.program == "sleep" || holder.program == "sh";
        });
        QVERIFY(isNamed);
    }

    void holdersAndLatencyAreReadFromTheSystemsFolders()
    {
        QTemporaryDir folder;
        const QDir root(folder.path());
        QVERIFY(root.mkpath("proc/1234/fd") && root.mkpath("proc/99/fd") && root.mkpath("sys/ttyUSB7"));
        const QString port = root.filePath("ttyUSB7");
        const auto write = [&root](const char* name, const char* text) {
            QFile file(root.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        write("ttyUSB7", "");
        write("proc/1234/comm", "screen\n");
        write("sys/ttyUSB7/latency_timer", "16\n");
        QVERIFY(QFile::link(port, root.filePath("proc/1234/fd/5")));
        QVERIFY(QFile::link("/dev/null", root.filePath("proc/99/fd/5")));
        const auto holders = holdersOf(port.toStdString(), root.filePath("proc").toStdString());
        QCOMPARE(holders, (std::vector<PortHolder>{{1234, "screen"}}));
        const auto latency = ftdiLatencyMs(port.toStdString(), root.filePath("sys").toStdString());
        QCOMPARE(latency, std::optional(16));
        QVERIFY(!ftdiLatencyMs("/dev/null", root.filePath("sys").toStdString()));
    }

    void likelyLinesAreAllAndOnce()
    {
        const LineSettings first{38400, Parity::Odd, 2};
        const auto lines = likelyLines(first);
        QCOMPARE(lines.front().baud, 38400u);
        QCOMPARE(lines[1].baud, 115200u);
        QCOMPARE(lines[1].parity, Parity::None);
        std::set<std::tuple<std::uint32_t, Parity, int>> distinct;
        for (const LineSettings& line : lines)
            distinct.insert({line.baud, line.parity, line.stopBits});
        QCOMPARE(lines.size(), supportedBauds.size() * 3 * 2);
        QCOMPARE(distinct.size(), lines.size());
    }

    void searchTriesTheOtherPortsAndSaysWhatIsWrongWithThem()
    {
        NoisyPort silent({});
        ScriptedSlave slave;
        LineScan scan(
            ScanPlan{silent.port(), {}, 1, {"/dev/null", slave.port(), silent.port()}, Depth::Search});
        const ScanProgress before = scan.progress();
        QCOMPARE(before.done, 0);
        QCOMPARE(before.total, 3 * 30 * 248);
        QCOMPARE(before.port, silent.port());
        ScanProgress last = before;
        while (!scan.ended()) {
            scan.advance();
            const ScanProgress now = scan.progress();
            // A damaged answer is asked for again, a late one adds questions.
            QVERIFY(now.remaining < last.remaining || now.done == last.done || now.total > last.total);
            last = now;
        }
        QVERIFY(scan.controller() != nullptr);
        QCOMPARE(scan.controller()->port, slave.port());
        QCOMPARE(scan.findings().front().condition, LineCondition::PortNotSerial);
        QCOMPARE(slave.writes(), 0);
        QVERIFY(scan.progress().done < 300); // the useless port was skipped, the likely settings came first
    }

    void adapterThatDisappears()
    {
        ScriptedSlave slave;
        slave.script(std::vector<Fault>(3, Fault::LostAnswer));
        LineScan scan(ScanPlan{slave.port(), {}, 1, {}, Depth::Diagnosis});
        scan.advance();
        QVERIFY(!scan.ended());
        slave.unplug();
        while (!scan.ended())
            scan.advance();
        QCOMPARE(scan.findings().size(), std::size_t{1});
        QCOMPARE(scan.findings().front().condition, LineCondition::PortGone);
    }

    void nothingToScanEndsAtOnce()
    {
        LineScan scan(ScanPlan{{}, {}, 1, {}, Depth::Search});
        QVERIFY(scan.ended());
        QVERIFY(scan.findings().empty());
        QCOMPARE(scan.progress().total, 0);
    }
};

CAMPANEL_TEST(LineScanTest)

} // namespace test_line_scan

#include "test_line_scan.moc"
