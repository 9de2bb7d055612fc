// SPDX-License-Identifier: Apache-2.0
// campanel-controller as a process: its port, its options, its end, its flash; and its idle load.
#include "rig.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace test_executable {

using namespace campanel::test;
using namespace Qt::StringLiterals;

namespace {

constexpr int answerTimeoutMs = 3000;
constexpr int startTimeoutMs = 10000;

// The program, with a state directory of its own unless the arguments set one.
class Program {
public:
    explicit Program(QStringList arguments = {})
    {
        if (!arguments.contains(u"--state"_s))
            arguments << u"--state"_s << m_state.path();
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(campanel::test::programPath("campanel-controller"), arguments);
        while (!m_process.canReadLine()) {
            if (!m_process.waitForReadyRead(startTimeoutMs))
                qFatal("campanel-controller printed no port");
        }
        m_port = QString::fromLocal8Bit(m_process.readLine()).trimmed();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program()
    {
        m_process.terminate();
        m_process.waitForFinished();
    }
    [[nodiscard]] QString port() const { return m_port; }
    [[nodiscard]] qint64 processId() const { return m_process.processId(); }
    // Ends the program and returns true for a clean exit.
    [[nodiscard]] bool endsCleanly()
    {
        m_process.terminate();
        return m_process.waitForFinished() && m_process.exitStatus() == QProcess::NormalExit &&
               m_process.exitCode() == 0;
    }
    // Sends a line to standard input; returns what is answered.
    [[nodiscard]] QByteArray tell(const QByteArray& line)
    {
        m_process.write(line + '\n');
        return readLine();
    }
    [[nodiscard]] QByteArray readLine()
    {
        while (!m_process.canReadLine()) {
            if (!m_process.waitForReadyRead(answerTimeoutMs))
                return "nothing";
        }
        return m_process.readLine().trimmed();
    }
    void killHard()
    {
        m_process.kill();
        m_process.waitForFinished();
    }

private:
    QTemporaryDir m_state;
    QProcess m_process;
    QString m_port;
};

// The panel's side of the port.
class Port {
public:
    explicit Port(const QString& path)
        : m_descriptor(open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
    }
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;
    ~Port()
    {
        if (m_descriptor >= 0)
            close(m_descriptor);
    }
    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    void send(const Bytes& bytes) const
    {
        if (write(m_descriptor, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            qFatal("cannot write to the port");
    }
    // Returns the requested number of bytes, fewer when they do not arrive in time.
    [[nodiscard]] Bytes receive(std::size_t size) const
    {
        Bytes bytes;
        pollfd waiting{m_descriptor, POLLIN, 0};
        while (bytes.size() < size && poll(&waiting, 1, answerTimeoutMs) > 0) {
            Bytes piece(size - bytes.size());
            const ssize_t got = read(m_descriptor, piece.data(), piece.size());
            if (got <= 0)
                break;
            bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
        }
        return bytes;
    }
    [[nodiscard]] Bytes ask(const Bytes& request, std::size_t answerSize) const
    {
        send(frame(request));
        return receive(answerSize);
    }

private:
    int m_descriptor = -1;
};

const Bytes readDeviceType{1, 3, 0, 0, 0, 1};
const Bytes readStatus{1, 3, 1, 0, 0, 40};

// Returns the exit code and the error output.
std::pair<int, QByteArray> runToEnd(const QStringList& arguments)
{
    QProcess process;
    process.start(campanel::test::programPath("campanel-controller"), arguments);
    if (!process.waitForFinished(5000))
        return {-1, {}};
    return {process.exitCode(), process.readAllStandardError() + process.readAllStandardOutput()};
}

} // namespace

class TestExecutable : public QObject {
    Q_OBJECT

private slots:
    void answersAndSurvivesReopening();
    void exclusiveAccessEndsWithTheClose();
    void linkAppearsAndGoes();
    void programSurvivesAHardKill();
    void answersTakeAsLongAsOnTheWire_data();
    void answersTakeAsLongAsOnTheWire();
    void wrongOptions_data();
    void wrongOptions();
    void helpAndVersion();
    void pinsAreSetFromOutside();
    void aControllerThatRestartsFindsARunningLine();
    void stateDirectoryIsUsedOnce();
    void endsWithItsParent();
    void idlesCheaply();
};

void TestExecutable::answersAndSurvivesReopening()
{
    const Program controller;
    for (int i = 0; i < 5; ++i) {
        const Port port(controller.port());
        QVERIFY(port.isOpen());
        QCOMPARE(port.ask(readDeviceType, 7), frame({1, 3, 2, 0xCA, 0x3D}));
    }
    { // a panel that dies in the middle of a frame
        const Port port(controller.port());
        port.send({1, 3, 0});
    }
    const Port port(controller.port());
    QTRY_COMPARE(port.ask(readDeviceType, 7), frame({1, 3, 2, 0xCA, 0x3D}));
}

void TestExecutable::exclusiveAccessEndsWithTheClose()
{
    const Program controller;
    const auto isExclusive = [&controller] {
        const Port port(controller.port());
        int exclusive = 1;
        ioctl(port.descriptor(), TIOCGEXCL, &exclusive);
        return exclusive != 0;
    };
    {
        const Port port(controller.port());
        QCOMPARE(ioctl(port.descriptor(), TIOCEXCL), 0);
    }
    QTRY_VERIFY(!isExclusive());
}

void TestExecutable::linkAppearsAndGoes()
{
    const QTemporaryDir directory;
    const QString link = directory.filePath(u"port"_s);
    {
        Program controller({u"--link"_s, link});
        QCOMPARE(QFile::symLinkTarget(link), controller.port());
        QCOMPARE(Port(link).ask(readDeviceType, 7).size(), std::size_t{7});
        QVERIFY(controller.endsCleanly());
    }
    QVERIFY(!QFileInfo(link).isSymLink());
    QFile file(directory.filePath(u"file"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const auto [code, text] = runToEnd({u"--state"_s, directory.path(), u"--link"_s, file.fileName()});
    QCOMPARE(code, 1);
    QVERIFY2(text.contains("cannot make the link"), text.constData());
    QVERIFY(file.exists());
}

void TestExecutable::programSurvivesAHardKill()
{
    const QTemporaryDir state;
    const QStringList arguments{u"--state"_s, state.path(), u"--no-pacing"_s};
    const Registers image = camBank(10000, 1, 8'000'000, 8).registers();
    const auto writeRegisters = [](const Port& port, std::uint16_t address, const Registers& values) {
        Bytes request{1,
                      16,
                      static_cast<std::uint8_t>(address >> 8),
                      static_cast<std::uint8_t>(address & 0xFF),
                      0,
                      static_cast<std::uint8_t>(values.size()),
                      static_cast<std::uint8_t>(2 * values.size())};
        for (const std::uint16_t value : values)
            request.insert(request.end(),
                           {static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value & 0xFF)});
        return port.ask(request, 8).size() == 8;
    };
    const std::uint32_t crc = crc32(image);
    const auto high = static_cast<std::uint16_t>(crc >> 16);
    const auto low = static_cast<std::uint16_t>(crc & 0xFFFF);
    {
        Program controller(arguments);
        const Port port(controller.port());
        const auto size = static_cast<std::uint16_t>(image.size());
        QVERIFY(writeRegisters(port, CTL_REG_TRANSFER_SESSION,
                               {1, CTL_TRANSFER_OPERATION_BEGIN, 0, 3, 1, size, 1}));
        Registers block{1, CTL_TRANSFER_OPERATION_BLOCK, 0, size};
        block.insert(block.end(), image.begin(), image.end());
        QVERIFY(writeRegisters(port, CTL_REG_TRANSFER_SESSION, block));
        QVERIFY(writeRegisters(port, CTL_REG_TRANSFER_SESSION, {1, CTL_TRANSFER_OPERATION_SEAL, 0, 0}));
        QVERIFY(
            writeRegisters(port, CTL_REG_COMMAND_COUNTER, {1, CTL_COMMAND_APPLY_STAGED, 0, 1, high, low}));
        QVERIFY(
            writeRegisters(port, CTL_REG_COMMAND_COUNTER, {2, CTL_COMMAND_SAVE_TO_FLASH, 0, 0, high, low}));
        QCOMPARE(port.ask({1, 3, 0x02, 0x33, 0, 1}, 7), frame({1, 3, 2, 0, 0}));
        controller.killHard();
    }
    const Program controller(arguments);
    const Bytes answer = Port(controller.port()).ask(readStatus, 85);
    QCOMPARE(answer.size(), std::size_t{85});
    QCOMPARE(int{answer[3 + 2 * 2 + 1]}, int{CTL_STATE_READY});
    QCOMPARE(Bytes(answer.begin() + 3 + 2 * 9, answer.begin() + 3 + 2 * 11),
             (Bytes{static_cast<std::uint8_t>(high >> 8), static_cast<std::uint8_t>(high & 0xFF),
                    static_cast<std::uint8_t>(low >> 8), static_cast<std::uint8_t>(low & 0xFF)}));
}

void TestExecutable::answersTakeAsLongAsOnTheWire_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<QString>("parity");
    QTest::addColumn<double>("minMs");
    // 8 bytes out, 3.5 characters of silence, 85 bytes back.
    QTest::newRow("115200 8N1") << 115200 << u"N"_s << (93 * 10 / 115.2 + 1.75);
    QTest::newRow("9600 8E1") << 9600 << u"E"_s << (93 + 3.5) * 11 / 9.6;
}

void TestExecutable::answersTakeAsLongAsOnTheWire()
{
    QFETCH(int, baud);
    QFETCH(QString, parity);
    QFETCH(double, minMs);
    const Program controller({u"--baud"_s, QString::number(baud), u"--parity"_s, parity});
    const Port port(controller.port());
    double bestMs = 1e9;
    for (int i = 0; i < 10; ++i) {
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(port.ask(readStatus, 85).size(), std::size_t{85});
        bestMs = std::min(bestMs, static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    qInfo("%.2f ms, on the wire %.2f ms", bestMs, minMs);
    QVERIFY(bestMs >= minMs - 0.01);
    QVERIFY(bestMs <= minMs * 1.05 + 1.0);
}

void TestExecutable::wrongOptions_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    QTest::newRow("unknown") << QStringList{u"--nonsense"_s} << QByteArray("--nonsense");
    QTest::newRow("unit") << QStringList{u"--unit"_s, u"0"_s} << QByteArray("--unit cannot be '0'");
    QTest::newRow("unit 248") << QStringList{u"--unit=248"_s} << QByteArray("--unit cannot be '248'");
    QTest::newRow("unit text") << QStringList{u"--unit"_s, u"1x"_s} << QByteArray("'1x'");
    QTest::newRow("baud") << QStringList{u"--baud"_s, u"10"_s} << QByteArray("--baud");
    QTest::newRow("parity") << QStringList{u"--parity"_s, u"S"_s} << QByteArray("--parity");
    QTest::newRow("stop bits") << QStringList{u"--stop-bits"_s, u"3"_s} << QByteArray("--stop-bits");
    QTest::newRow("speed") << QStringList{u"--speed"_s, u"nan"_s} << QByteArray("--speed");
    QTest::newRow("slip") << QStringList{u"--film-slip"_s, u"-1"_s} << QByteArray("--film-slip");
    QTest::newRow("missing") << QStringList{u"--work-piece-missing"_s, u"1.1"_s}
                             << QByteArray("--work-piece-missing");
    QTest::newRow("play") << QStringList{u"--press-backlash"_s, u"-1"_s} << QByteArray("--press-backlash");
    QTest::newRow("no argument") << QStringList{u"--baud"_s} << QByteArray("--baud");
    QTest::newRow("word") << QStringList{u"word"_s} << QByteArray("word");
}

void TestExecutable::wrongOptions()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, named);
    const auto [code, text] = runToEnd(arguments);
    QCOMPARE(code, 2);
    QVERIFY2(text.contains(named), text.constData());
    QVERIFY2(text.contains("see --help"), text.constData());
}

void TestExecutable::helpAndVersion()
{
    const auto help = runToEnd({u"--help"_s});
    QCOMPARE(help.first, 0);
    for (const char* option : {"--link",
                               "--unit",
                               "--baud",
                               "--parity",
                               "--stop-bits",
                               "--no-pacing",
                               "--state",
                               "--speed",
                               "--seed",
                               "--pins",
                               "--film-slip",
                               "--work-piece",
                               "--work-piece-scatter",
                               "--work-piece-missing",
                               "--work-piece-stiffness",
                               "--press-backlash",
                               "--press-lead-error",
                               "--press-screw-error",
                               "--press-drift",
                               "--drive-inertia",
                               "--drive-friction",
                               "--drive-rated-torque",
                               "--faults",
                               "--fault-seed",
                               "--control",
                               "--exit-with-parent"})
        QVERIFY2(help.second.contains(option), option);
    const auto version = runToEnd({u"--version"_s});
    QCOMPARE(version.first, 0);
    QVERIFY(version.second.startsWith("campanel-controller "));
}

void TestExecutable::pinsAreSetFromOutside()
{
    Program controller({u"--control"_s, u"--pins"_s, u"limit-forward"_s});
    const Port port(controller.port());
    const auto registerAt = [&port](std::uint16_t address) {
        const Bytes answer = port.ask(
            {1, 3, static_cast<std::uint8_t>(address >> 8), static_cast<std::uint8_t>(address & 0xFFu), 0, 1},
            7);
        return answer.size() == 7 ? answer[3] << 8 | answer[4] : -1;
    };
    constexpr int limit = 1 << CTL_INPUT_BIT_LIMIT_FORWARD;
    constexpr int stop = 1 << CTL_INPUT_BIT_EMERGENCY_STOP;
    constexpr int alarm = 1 << CTL_INPUT_BIT_DRIVE_ALARM;
    constexpr int settable = limit | stop | alarm | 1 << CTL_INPUT_BIT_LIMIT_REVERSE;
    QTRY_COMPARE(registerAt(CTL_REG_IO_INPUTS) & settable, limit);
    QCOMPARE(controller.tell("pin emergency-stop on"), "pin emergency-stop on");
    QTRY_COMPARE(registerAt(CTL_REG_IO_INPUTS) & settable, limit | stop);
    QCOMPARE(registerAt(CTL_REG_STATUS_STATE), static_cast<int>(CTL_STATE_IDLE));
    QCOMPARE(controller.tell("pin drive-alarm on"), "pin drive-alarm on");
    QTRY_COMPARE(registerAt(CTL_REG_STATUS_FAULT), 1 << CTL_FAULT_BIT_DRIVE_ALARM);
    // The pins are the machine's: a controller that restarts finds them as they are.
    QCOMPARE(controller.tell("restart time=10 limit=1"), "ok 0");
    QVERIFY(port.ask(readDeviceType, 7).empty());
    QCOMPARE(controller.readLine(), "restarted");
    QTRY_COMPARE(registerAt(CTL_REG_IO_INPUTS) & settable, limit | stop | alarm);
    QCOMPARE(controller.tell("pin drive-alarm off"), "pin drive-alarm off");
    QTRY_COMPARE(registerAt(CTL_REG_IO_INPUTS) & settable, limit | stop);
    QVERIFY(controller.tell("pin eye on").startsWith("error "));
}

void TestExecutable::aControllerThatRestartsFindsARunningLine()
{
    Program controller({u"--control"_s});
    const Port port(controller.port());
    const auto bytesOf = [](std::uint32_t address) {
        return std::pair{static_cast<std::uint8_t>(address >> 8u),
                         static_cast<std::uint8_t>(address & 0xFFu)};
    };
    const auto followEncoder = [&port, &bytesOf] {
        const auto [high, low] = bytesOf(CTL_REG_MASTER_SOURCE);
        return port.ask({1, 16, high, low, 0, 1, 2, 0, CTL_MASTER_SOURCE_ENCODER}, 8).size() == 8;
    };
    const auto upperWordOfSpeed = [&port, &bytesOf] { // of 250 000 um/s it is 3
        const auto [high, low] = bytesOf(CTL_REG_MASTER_STATUS_SPEED);
        const Bytes answer = port.ask({1, 3, high, low, 0, 1}, 7);
        return answer.size() == 7 ? answer[3] << 8 | answer[4] : -1;
    };
    QVERIFY(followEncoder());
    QCOMPARE(upperWordOfSpeed(), 0);
    QCOMPARE(controller.tell("line start 250"), "line start 250");
    QTRY_COMPARE(upperWordOfSpeed(), 3);
    QCOMPARE(controller.tell("restart time=10 limit=1"), "ok 0");
    QVERIFY(port.ask(readDeviceType, 7).empty());
    QCOMPARE(controller.readLine(), "restarted");
    QVERIFY(followEncoder());
    QTRY_COMPARE(upperWordOfSpeed(), 3);
    QCOMPARE(controller.tell("line stop"), "line stop");
    QTRY_COMPARE(upperWordOfSpeed(), 0);
    QVERIFY(controller.tell("line slip 2").startsWith("error "));
}

void TestExecutable::stateDirectoryIsUsedOnce()
{
    const QTemporaryDir state;
    const Program controller({u"--state"_s, state.path()});
    const auto [code, text] = runToEnd({u"--state"_s, state.path()});
    QCOMPARE(code, 1);
    QVERIFY2(text.contains("another campanel-controller uses it"), text.constData());
    QFile file(state.filePath(u"file"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const auto blocked = runToEnd({u"--state"_s, file.fileName()});
    QCOMPARE(blocked.first, 1);
    QVERIFY2(blocked.second.contains("--state"), blocked.second.constData());
}

void TestExecutable::endsWithItsParent()
{
    const QTemporaryDir state;
    QProcess shell;
    shell.start(u"/bin/sh"_s,
                {u"-c"_s, campanel::test::programPath("campanel-controller") +
                              u" --exit-with-parent --state "_s + state.path() + u" & echo $!; read line"_s});
    QVERIFY(shell.waitForStarted());
    QByteArray lines;
    QTRY_VERIFY((lines += shell.readAll()).count('\n') >= 2);
    qint64 controller = 0; // its number and its port may come in either order
    for (const QByteArray& line : lines.split('\n'))
        controller = line.startsWith('/') || line.isEmpty() ? controller : line.toLongLong();
    QVERIFY(controller > 0);
    QCOMPARE(kill(static_cast<pid_t>(controller), 0), 0);
    shell.kill();
    shell.waitForFinished();
    const auto isGone = [controller] { // or waits for its new parent
        QFile status(u"/proc/%1/stat"_s.arg(controller));
        return !status.open(QIODevice::ReadOnly) || status.readAll().contains(") Z ");
    };
    QTRY_VERIFY(isGone());
}

void TestExecutable::idlesCheaply()
{
    const Program controller;
    const auto processorMs = [&controller] {
        QFile status(u"/proc/%1/stat"_s.arg(controller.processId()));
        if (!status.open(QIODevice::ReadOnly))
            qFatal("cannot read the process's times");
        const QList<QByteArray> fields = status.readAll().split(')').last().trimmed().split(' ');
        return (fields.at(11).toLongLong() + fields.at(12).toLongLong()) * 1000 / sysconf(_SC_CLK_TCK);
    };
    const qint64 beforeMs = processorMs();
    const Port port(controller.port());
    pollfd nothing{port.descriptor(), POLLIN, 0};
    constexpr int idleMs = 2000;
    QCOMPARE(poll(&nothing, 1, idleMs), 0); // an idle controller prints nothing
    const qint64 usedMs = processorMs() - beforeMs;
    qInfo("%.1f %% of a processor", 100.0 * static_cast<double>(usedMs) / idleMs);
    QVERIFY(usedMs <= idleMs * 3 / 100);
}

CAMPANEL_TEST(TestExecutable)

} // namespace test_executable

#include "test_executable.moc"
