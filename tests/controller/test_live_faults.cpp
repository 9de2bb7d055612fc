// SPDX-License-Identifier: Apache-2.0
// Fault rules sent to the running program: its answers, and the state of its port.
#include "rig.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace test_live_faults {

using namespace campanel::test;
using namespace Qt::StringLiterals;

namespace {

constexpr int waitMs = 10'000;

class Program {
public:
    explicit Program(const QStringList& arguments = {})
    {
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(campanel::test::programPath("campanel-controller"),
                        QStringList{u"--control"_s, u"--no-pacing"_s, u"--state"_s, path(u"state"_s),
                                    u"--link"_s, path(u"port"_s)} +
                            arguments);
        m_port = line();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program()
    {
        m_process.terminate();
        m_process.waitForFinished();
    }
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString port() const { return m_port; }
    // Returns the next printed line, empty when none comes.
    [[nodiscard]] QString line()
    {
        while (!m_process.canReadLine()) {
            if (!m_process.waitForReadyRead(waitMs))
                return {};
        }
        return QString::fromLocal8Bit(m_process.readLine()).trimmed();
    }
    [[nodiscard]] QString tell(const char* rules)
    {
        m_process.write(rules);
        m_process.write("\n");
        return line();
    }

private:
    QTemporaryDir m_folder;
    QProcess m_process;
    QString m_port;
};

const Bytes readDeviceType{1, 3, 0, 0, 0, 1};
const Bytes deviceTypeAnswer{1, 3, 2, 0xCA, 0x3D};

// Returns the bytes within the time, at most the length of a correct answer; nothing for a lost port.
Bytes ask(const QString& path, int timeMs)
{
    const int port = open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const Bytes request = frame(readDeviceType);
    Bytes bytes;
    if (port < 0 || write(port, request.data(), request.size()) != static_cast<ssize_t>(request.size()))
        return bytes;
    pollfd waiting{port, POLLIN, 0};
    while (bytes.size() < 7 && poll(&waiting, 1, timeMs) > 0) {
        Bytes piece(7 - bytes.size());
        const ssize_t got = read(port, piece.data(), piece.size());
        if (got <= 0)
            break;
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
    }
    close(port);
    return bytes;
}

} // namespace

class TestLiveFaults : public QObject {
    Q_OBJECT

private slots:
    void rulesAreReplaced();
    void wrongRulesChangeNothing();
    void portComesBackUnderAnotherName();
    void restartLosesWhatIsInRam();
    void fileOfRules();
    void endOfInputIsNotTheEnd();
    void thereIsNothingToMeasureBeforeABag();
};

void TestLiveFaults::rulesAreReplaced()
{
    Program controller;
    QVERIFY(ask(controller.port(), waitMs) == frame(deviceTypeAnswer));
    QCOMPARE(controller.tell("exception code=4"), u"ok 0"_s);
    QVERIFY(ask(controller.port(), 200) == frame({1, 0x83, 4}));
    QCOMPARE(controller.tell("clear"), u"ok 1"_s);
    QVERIFY(ask(controller.port(), waitMs) == frame(deviceTypeAnswer));
}

void TestLiveFaults::wrongRulesChangeNothing()
{
    Program controller;
    QCOMPARE(controller.tell("wrong-unit"), u"ok 0"_s);
    const QString answer = controller.tell("clear; exception code=nine");
    QVERIFY2(answer.startsWith(u"error line 1: 'code=nine' is wrong"_s), qPrintable(answer));
    const Bytes heard = ask(controller.port(), waitMs);
    QCOMPARE(heard.size(), std::size_t{7});
    QVERIFY(heard.at(0) != 1);
}

void TestLiveFaults::portComesBackUnderAnotherName()
{
    Program controller;
    const QString other = controller.path(u"other"_s);
    QCOMPARE(controller.tell(qPrintable(u"unplug when=answer time=50 limit=1 port="_s + other)), u"ok 0"_s);
    QVERIFY(ask(controller.path(u"port"_s), waitMs).size() < 7);
    QCOMPARE(controller.line(), u"unplugged"_s);
    const QString back = controller.line();
    QVERIFY2(back.startsWith(u"port /dev/pts/"_s), qPrintable(back));
    QVERIFY(!QFileInfo::exists(controller.path(u"port"_s)));
    QCOMPARE(QFile::symLinkTarget(other), back.mid(5));
    QVERIFY(ask(other, waitMs) == frame(deviceTypeAnswer));
    // Unplugged for an hour, and restored.
    QCOMPARE(controller.tell("unplug when=idle time=3600000 limit=1"), u"ok 1"_s);
    QVERIFY(ask(other, waitMs) == frame(deviceTypeAnswer));
    QCOMPARE(controller.line(), u"unplugged"_s);
    QCOMPARE(controller.tell("clear"), u"ok 1"_s);
    QVERIFY(controller.line().startsWith(u"port /dev/pts/"_s));
    QVERIFY(ask(other, waitMs) == frame(deviceTypeAnswer));
}

void TestLiveFaults::restartLosesWhatIsInRam()
{
    Program controller;
    const auto exchange = [&controller](Bytes request, std::size_t size) {
        const int port =
            open(QFile::encodeName(controller.port()).constData(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        request = frame(std::move(request));
        Bytes answer;
        pollfd waiting{port, POLLIN, 0};
        if (write(port, request.data(), request.size()) == static_cast<ssize_t>(request.size())) {
            while (answer.size() < size && poll(&waiting, 1, waitMs) > 0) {
                Bytes piece(size - answer.size());
                const ssize_t got = read(port, piece.data(), piece.size());
                answer.insert(answer.end(), piece.begin(), piece.begin() + std::max<ssize_t>(0, got));
            }
        }
        close(port);
        return answer;
    };
    const Bytes readRampTime{1, 3, 0, 0x82, 0, 1};
    const Bytes byDefault = exchange(readRampTime, 7);
    QCOMPARE(exchange({1, 6, 0, 0x82, 1, 0}, 8).size(), std::size_t{8});
    QVERIFY(exchange(readRampTime, 7) == frame({1, 3, 2, 1, 0}));
    QCOMPARE(controller.tell("restart time=30 limit=1"), u"ok 0"_s);
    QVERIFY(ask(controller.port(), 20).empty());
    QCOMPARE(controller.line(), u"restarted"_s);
    QVERIFY(exchange(readRampTime, 7) == byDefault);
}

void TestLiveFaults::fileOfRules()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(u"faults"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("# the second answer is lost\nlost-answer every=2 limit=1\n");
    file.close();
    Program controller({u"--faults"_s, file.fileName(), u"--fault-seed"_s, u"3"_s});
    QVERIFY(ask(controller.port(), waitMs) == frame(deviceTypeAnswer));
    QVERIFY(ask(controller.port(), 100).empty());
    QVERIFY(ask(controller.port(), waitMs) == frame(deviceTypeAnswer));

    QVERIFY(file.open(QIODevice::Append));
    file.write("late times=often\n");
    file.close();
    QProcess wrong;
    wrong.start(campanel::test::programPath("campanel-controller"), {u"--faults"_s, file.fileName()});
    QVERIFY(wrong.waitForFinished(waitMs));
    QCOMPARE(wrong.exitCode(), 2);
    const QByteArray sentence = wrong.readAllStandardError();
    QVERIFY2(sentence.contains("line 3: 'times=often' is wrong"), sentence.constData());
    wrong.start(campanel::test::programPath("campanel-controller"),
                {u"--faults"_s, folder.filePath(u"none"_s)});
    QVERIFY(wrong.waitForFinished(waitMs));
    QCOMPARE(wrong.exitCode(), 2);
    QVERIFY(wrong.readAllStandardError().contains("cannot read"));
}

void TestLiveFaults::thereIsNothingToMeasureBeforeABag()
{
    Program controller;
    QCOMPARE(controller.tell("exception code=4"), u"ok 0"_s);
    QCOMPARE(controller.tell("measure"), u"measured none"_s);
    QVERIFY(ask(controller.port(), 200) == frame({1, 0x83, 4}));
    QCOMPARE(controller.tell("clear"), u"ok 1"_s); // measuring is not a rule
}

void TestLiveFaults::endOfInputIsNotTheEnd()
{
    QProcess process;
    const QTemporaryDir state;
    process.start(campanel::test::programPath("campanel-controller"),
                  {u"--control"_s, u"--state"_s, state.path()});
    QVERIFY(process.waitForReadyRead(waitMs));
    const QString port = QString::fromLocal8Bit(process.readLine()).trimmed();
    process.closeWriteChannel();
    QVERIFY(ask(port, waitMs) == frame(deviceTypeAnswer));
    process.terminate();
    QVERIFY(process.waitForFinished(waitMs));
    QCOMPARE(process.exitCode(), 0);
}

CAMPANEL_TEST(TestLiveFaults)

} // namespace test_live_faults

#include "test_live_faults.moc"
