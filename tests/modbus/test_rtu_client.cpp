// SPDX-License-Identifier: Apache-2.0
// The client against a scripted slave: every doubtful answer ends in an error, never in a wrong value, and
// the line is usable afterwards.
#include "modbus/line/answer_reader.h"
#include "modbus/line/rtu_client.h"
#include "modbus/map/codec.h"
#include "scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <random>

#include <fcntl.h>
#include <grp.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test_rtu_client {

using namespace campanel::modbus;
using campanel::test::Fault;
using campanel::test::ScriptedSlave;

namespace {

// Long enough that a busy machine does not turn a normal answer into a lost one.
constexpr std::chrono::milliseconds allowance{400};

LinkSettings settingsFor(const std::string& port)
{
    LinkSettings settings;
    settings.port = port;
    settings.answerAllowance = allowance;
    return settings;
}

} // namespace

class RtuClientTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void identity();
    void foreignDeviceIsLeftAlone();
    void busyDeviceIsAskedAgain_data();
    void busyDeviceIsAskedAgain();
    void strayBytesAreSkipped_data();
    void strayBytesAreSkipped();
    void singleFollowedAnswerIsNotBelieved();
    void otherMapMajorIsRefused();
    void impossibleIdentityIsRefused_data();
    void impossibleIdentityIsRefused();
    void status();
    void doubtfulStatus_data();
    void doubtfulStatus();
    void lateAnswersNeverBecomeValues();
    void answersThatAreAlwaysLateAreTaken();
    void slowerAnswersAreWaitedForSoon();
    void commandInPiecesIsWaitedFor();
    void commandInPiecesThatNeverEnds();
    void echoIsTakenOffTheAnswers();
    void exceptionIsNotWaitedOut();
    void answerToNobodyIsDropped();
    void provenRead();
    void rangeThatCannotBeRead();
    void doubtfulCommand_data();
    void doubtfulCommand();
    void commandWithoutAnyAnswerIsUnknown();
    void commandBeforeARestartIsUnknown();
    void counterOfARestartedControllerIsNotUsed();
    void refusedCommandIsAResult();
    void parameterIsProven();
    void parameterOutsideItsLimitsIsNotSent();
    void pulledAdapter();
    void portsThatCannotBeOpened();
    void portWithoutPermission();
    void busyPort();
    void settingsThatCannotBeUsed_data();
    void settingsThatCannotBeUsed();
    void killedOwnerLeavesThePortFree();
    void silenceIsKeptBetweenFrames();

private:
    std::unique_ptr<ScriptedSlave> m_slave;
    std::unique_ptr<RtuClient> m_client;
};

void RtuClientTest::init()
{
    m_slave = std::make_unique<ScriptedSlave>();
    m_client = std::make_unique<RtuClient>(settingsFor(m_slave->port()));
    const auto opened = m_client->open();
    QVERIFY2(opened.has_value(), opened ? "" : describe(opened.error()).c_str());
}

void RtuClientTest::cleanup()
{
    m_client.reset();
    m_slave.reset();
}

void RtuClientTest::commandInPiecesIsWaitedFor()
{
    m_slave->setBusy(4);
    const int before = m_slave->requests();
    const auto result = m_client->command(Command::SaveToFlash);
    QVERIFY2(result.has_value(), result ? "" : describe(result.error()).c_str());
    QCOMPARE(result->status, CommandStatus::Done);
    QCOMPARE(m_slave->commandsExecuted(), 1);
    QVERIFY(m_slave->requests() >= before + 5);
}

void RtuClientTest::commandInPiecesThatNeverEnds()
{
    m_slave->setBusy(1'000'000);
    const auto result = m_client->command(Command::SaveToFlash);
    QVERIFY(!result.has_value());
    QCOMPARE(result.error().kind, LinkErrorKind::OutcomeUnknown);
    QCOMPARE(m_slave->commandsExecuted(), 1);
}

void RtuClientTest::identity()
{
    const auto identity = m_client->identify();
    QVERIFY2(identity.has_value(), identity ? "" : describe(identity.error()).c_str());
    QCOMPARE(identity->firmwareVersion(), std::string("0.3.0"));
    QVERIFY(identity->supports(ProgramKind::RotaryCutter));
    QVERIFY(!identity->supports(ProgramKind::None));
}

void RtuClientTest::foreignDeviceIsLeftAlone()
{
    m_slave->setRegister(0, 0x1234);
    const auto identity = m_client->identify();
    QVERIFY(!identity.has_value());
    QCOMPARE(identity.error().kind, LinkErrorKind::NotCamPanel);
    QCOMPARE(identity.error().code, 0x1234);
    m_slave->script({Fault::Exception2});
    QCOMPARE(m_client->identify().error().kind, LinkErrorKind::NotCamPanel);
    QCOMPARE(m_slave->writes(), 0);
}

void RtuClientTest::busyDeviceIsAskedAgain_data()
{
    QTest::addColumn<int>("exception");
    QTest::addColumn<int>("requests");
    QTest::newRow("device failure") << 4 << 1;
    QTest::newRow("acknowledged") << 5 << 6;
    QTest::newRow("busy") << 6 << 6;
    QTest::newRow("gateway path unavailable") << 10 << 1;
    QTest::newRow("nobody behind the gateway") << 11 << 1;
}

void RtuClientTest::busyDeviceIsAskedAgain()
{
    QFETCH(int, exception);
    QFETCH(int, requests);
    m_slave->setException(static_cast<std::uint8_t>(exception));
    const auto identity = m_client->identify();
    QCOMPARE(identity.error().kind, LinkErrorKind::Exception);
    QCOMPARE(identity.error().code, exception);
    QCOMPARE(m_slave->requests(), requests);
    QCOMPARE(m_slave->writes(), 0);
    m_slave->setException(0);
    m_slave->script({Fault::Busy, Fault::Busy, Fault::None, Fault::Busy});
    QVERIFY(m_client->identify().has_value());
}

void RtuClientTest::strayBytesAreSkipped_data()
{
    using Bytes = std::vector<std::uint8_t>;
    QTest::addColumn<Bytes>("before");
    QTest::addColumn<Bytes>("behind");
    QTest::newRow("a zero before") << Bytes{0x00} << Bytes{};
    QTest::newRow("FF before") << Bytes{0xFF} << Bytes{};
    QTest::newRow("the unit before") << Bytes{0x01} << Bytes{};
    QTest::newRow("a zero behind") << Bytes{} << Bytes{0x00};
    QTest::newRow("zeros behind") << Bytes{} << Bytes(5, 0x00);
    QTest::newRow("noise on both sides") << Bytes{0x80, 0xFE, 0x55} << Bytes{0xF8, 0x01, 0x17, 0x50};
}

void RtuClientTest::strayBytesAreSkipped()
{
    using Bytes = std::vector<std::uint8_t>;
    QFETCH(const Bytes, before);
    QFETCH(const Bytes, behind);
    m_slave->surround(before, behind);
    m_slave->setRegister(0x0400, 4711);
    const auto identity = m_client->identify();
    QVERIFY2(identity.has_value(), identity ? "" : describe(identity.error()).c_str());
    const std::uint64_t failed = m_client->record().figures.requests() - m_client->record().figures.answers();
    QVERIFY(failed <= followedAnswersDropped);
    for (std::uint16_t heartbeat = 1; heartbeat <= 5; ++heartbeat)
        QVERIFY(m_client->exchangeStatus(heartbeat, 0).has_value());
    QCOMPARE(m_client->readProven(0x0400, 1)->front(), std::uint16_t{4711});
    QVERIFY(m_client->writeParameter(registerNamed("parameter.ramp_time"), 500).has_value());
    QVERIFY(m_client->command(Command::Start).has_value());
    const LinkFigures& figures = m_client->record().figures;
    QCOMPARE(figures.strayBytes(), figures.requests() * (before.size() + behind.size()));
    QCOMPARE(figures.followedAnswers(), behind.empty() ? std::uint64_t{0} : figures.requests());
    m_slave->surround({}, {});
    const std::uint64_t strays = figures.strayBytes();
    QVERIFY(m_client->exchangeStatus(9, 0).has_value());
    QCOMPARE(figures.strayBytes(), strays);
}

// A line that is not known for bytes behind the answers: the answer may have gained a byte.
void RtuClientTest::singleFollowedAnswerIsNotBelieved()
{
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->surround({}, {0x00});
    const auto doubtful = m_client->exchangeStatus(2, 0);
    QCOMPARE(doubtful.error().kind, LinkErrorKind::BadFrame);
    QCOMPARE(doubtful.error().code, 1);
    m_slave->surround({}, {});
    QVERIFY(m_client->exchangeStatus(3, 0).has_value());
}

void RtuClientTest::otherMapMajorIsRefused()
{
    m_slave->setRegister(1, mapMajor + 1);
    const auto identity = m_client->identify();
    QVERIFY(!identity.has_value());
    QCOMPARE(identity.error().kind, LinkErrorKind::WrongMapMajor);
    QCOMPARE(identity.error().code, mapMajor + 1);
    QCOMPARE(m_slave->writes(), 0);
}

void RtuClientTest::impossibleIdentityIsRefused_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<quint16>("value");
    QTest::newRow("no clock") << QByteArray("identity.timer_clock") << quint16{0};
    QTest::newRow("no rows") << QByteArray("identity.row_capacity") << quint16{0};
    QTest::newRow("no header") << QByteArray("identity.bank_registers") << quint16{3};
    QTest::newRow("no block") << QByteArray("identity.block_registers") << quint16{0};
    QTest::newRow("no timer") << QByteArray("identity.timer_bits") << quint16{33};
    QTest::newRow("no pulses") << QByteArray("identity.max_pulse_frequency") << quint16{0};
}

void RtuClientTest::impossibleIdentityIsRefused()
{
    QFETCH(const QByteArray, name);
    QFETCH(const quint16, value);
    const RegisterInfo& info = registerNamed(name.toStdString());
    for (int i = 0; i < info.count; ++i)
        m_slave->setRegister(static_cast<std::uint16_t>(info.address + i), i + 1 == info.count ? value : 0);
    const auto identity = m_client->identify();
    QVERIFY(!identity.has_value());
    QCOMPARE(identity.error().kind, LinkErrorKind::WrongIdentity);
    QCOMPARE(QByteArray::fromStdString(identity.error().detail), name);
    QCOMPARE(identity.error().code, int{value});
    QCOMPARE(m_slave->writes(), 0);
}

void RtuClientTest::status()
{
    m_slave->setRegister(registerNamed("status.state").address, static_cast<std::uint16_t>(State::Ready));
    const auto first = m_client->exchangeStatus(41, 1);
    QVERIFY2(first.has_value(), first ? "" : describe(first.error()).c_str());
    QCOMPARE(first->heartbeat, std::uint16_t{41});
    QCOMPARE(first->state, State::Ready);
    QCOMPARE(m_slave->getRegister(registerNamed("exchange.jog").address), std::uint16_t{1});
    const auto second = m_client->exchangeStatus(42, 0);
    QVERIFY(second.has_value());
    QVERIFY(second->tag != first->tag);
}

void RtuClientTest::doubtfulStatus_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("kind");
    const auto row = [](const char* tag, Fault fault, LinkErrorKind kind) {
        QTest::newRow(tag) << static_cast<int>(fault) << static_cast<int>(kind);
    };
    row("request lost", Fault::LostRequest, LinkErrorKind::NoAnswer);
    row("answer lost", Fault::LostAnswer, LinkErrorKind::NoAnswer);
    row("answer truncated", Fault::Truncated, LinkErrorKind::NoAnswer);
    row("wrong CRC", Fault::BadChecksum, LinkErrorKind::BadChecksum);
    row("exception", Fault::Exception2, LinkErrorKind::Exception);
}

void RtuClientTest::doubtfulStatus()
{
    QFETCH(int, fault);
    QFETCH(int, kind);
    m_slave->script({static_cast<Fault>(fault)});
    const auto doubtful = m_client->exchangeStatus(1, 0);
    QVERIFY(!doubtful.has_value());
    QCOMPARE(static_cast<int>(doubtful.error().kind), kind);
    QVERIFY(!portIsLost(doubtful.error()));
    QVERIFY(m_client->exchangeStatus(2, 0).has_value());
}

// Up to 400 ms are promised.
void RtuClientTest::answersThatAreAlwaysLateAreTaken()
{
    m_slave->delayAnswers(std::chrono::milliseconds{300});
    LinkSettings settings;
    settings.port = m_slave->port();
    m_client = nullptr;
    m_client = std::make_unique<RtuClient>(settings);
    QVERIFY(m_client->open().has_value());
    QVERIFY(m_client->identify().has_value());
    for (std::uint16_t heartbeat = 1; heartbeat <= 3; ++heartbeat)
        QVERIFY(m_client->exchangeStatus(heartbeat, 0).has_value());
}

// The answers of a slow controller come during the next question, where they are foreign.
void RtuClientTest::slowerAnswersAreWaitedForSoon()
{
    LinkSettings settings;
    settings.port = m_slave->port();
    settings.answerAllowance = AnswerAllowance::shortest;
    m_client = nullptr;
    m_client = std::make_unique<RtuClient>(settings);
    QVERIFY(m_client->open().has_value());
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->delayAnswers(std::chrono::milliseconds{200});
    int failures = 0;
    std::uint16_t heartbeat = 1;
    while (failures < 20 && !m_client->exchangeStatus(++heartbeat, 0))
        ++failures;
    QVERIFY2(failures <= 6, qPrintable(QString::number(failures)));
    QVERIFY(m_client->exchangeStatus(++heartbeat, 0).has_value());
}

void RtuClientTest::echoIsTakenOffTheAnswers()
{
    m_slave->setEchoing(true);
    m_slave->setRegister(0x0400, 4711);
    QVERIFY(m_client->identify().has_value());
    for (std::uint16_t heartbeat = 1; heartbeat <= 3; ++heartbeat)
        QVERIFY(m_client->exchangeStatus(heartbeat, 0).has_value());
    const auto read = m_client->readProven(0x0400, 1);
    QVERIFY(read.has_value());
    QCOMPARE(read->front(), std::uint16_t{4711});
    QVERIFY(m_client->isEchoing());
    QVERIFY(m_client->writeParameter(registerNamed("parameter.ramp_time"), 500).has_value());
    QVERIFY(m_client->command(Command::Start).has_value());
    QCOMPARE(m_client->record().figures.drains(), std::uint64_t{0});
    m_slave->setEchoing(false);
    QVERIFY(m_client->exchangeStatus(9, 0).has_value());
    QVERIFY(!m_client->isEchoing());
}

void RtuClientTest::lateAnswersNeverBecomeValues()
{
    // Seeded; on average every second request is answered late, so that its answer meets the next question.
    const unsigned seed = 20240517;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    constexpr int rounds = 12;
    m_client = nullptr;
    LinkSettings settings = settingsFor(m_slave->port());
    settings.answerAllowance = std::chrono::milliseconds{120};
    m_client = std::make_unique<RtuClient>(settings);
    QVERIFY(m_client->open().has_value());
    int right = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto value = static_cast<std::uint16_t>(random());
        m_slave->setRegister(0x0400, value);
        m_slave->script({random() % 2 == 0 ? Fault::LateAnswer : Fault::None});
        const auto read = m_client->readProven(0x0400, 1);
        if (read) {
            QCOMPARE((*read)[0], value);
            ++right;
        }
        const auto status = m_client->exchangeStatus(static_cast<std::uint16_t>(i), 0);
        if (status)
            QCOMPARE(status->heartbeat, static_cast<std::uint16_t>(i));
    }
    QVERIFY(right > 0);
    // Answered late, then another question: the late answer has another length.
    m_slave->script({Fault::LateAnswer});
    QCOMPARE(m_client->exchangeStatus(0, 0).error().kind, LinkErrorKind::NoAnswer);
    QVERIFY(m_client->readProven(0x0400, 1).has_value());
    // The same question answered late and repeated: the late answer has the right length and address.
    m_slave->setRegister(0x0400, 1);
    m_slave->script({Fault::LateAnswer});
    QCOMPARE(m_client->readProven(0x0400, 1).error().kind, LinkErrorKind::NoAnswer);
    m_slave->setRegister(0x0400, 2);
    QCOMPARE(m_client->readProven(0x0400, 1)->front(), std::uint16_t{2});
}

void RtuClientTest::exceptionIsNotWaitedOut()
{
    m_slave->script({Fault::Exception2});
    QElapsedTimer timer;
    timer.start();
    const auto answer = m_client->exchangeStatus(1, 0);
    QCOMPARE(answer.error().kind, LinkErrorKind::Exception);
    QCOMPARE(answer.error().code, 2);
    QVERIFY2(timer.elapsed() < allowance.count() / 2, qPrintable(QString::number(timer.elapsed())));
}

void RtuClientTest::answerToNobodyIsDropped()
{
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    // Bytes between the questions, as from a late answer: written from the slave's side.
    m_slave->script({Fault::LateAnswer, Fault::LostAnswer});
    QVERIFY(!m_client->exchangeStatus(2, 0).has_value());
    QVERIFY(!m_client->exchangeStatus(3, 0).has_value());
    const auto status = m_client->exchangeStatus(4, 0);
    QVERIFY(status.has_value());
    QCOMPARE(status->heartbeat, std::uint16_t{4});
}

void RtuClientTest::provenRead()
{
    for (std::uint16_t i = 0; i < readbackRegisters; ++i)
        m_slave->setRegister(static_cast<std::uint16_t>(0x0400 + i), i);
    const auto read = m_client->readProven(0x0400, readbackRegisters);
    QVERIFY2(read.has_value(), read ? "" : describe(read.error()).c_str());
    QCOMPARE(read->size(), std::size_t{readbackRegisters});
    QCOMPARE(read->back(), static_cast<std::uint16_t>(readbackRegisters - 1));
    QCOMPARE(m_client->readProven(0x0400, 0).error().kind, LinkErrorKind::ValueRefused);
    QCOMPARE(m_client->readProven(0x0400, readbackRegisters + 1).error().kind, LinkErrorKind::ValueRefused);
}

void RtuClientTest::rangeThatCannotBeRead()
{
    QCOMPARE(m_client->readProven(0xF800, 4).error().kind, LinkErrorKind::RangeNotReadable);
}

void RtuClientTest::doubtfulCommand_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<bool>("received");
    QTest::newRow("clean") << static_cast<int>(Fault::None) << true;
    QTest::newRow("answer lost") << static_cast<int>(Fault::LostAnswer) << true;
    QTest::newRow("answer late") << static_cast<int>(Fault::LateAnswer) << true;
    QTest::newRow("wrong CRC") << static_cast<int>(Fault::BadChecksum) << true;
    QTest::newRow("truncated") << static_cast<int>(Fault::Truncated) << true;
    QTest::newRow("request lost") << static_cast<int>(Fault::LostRequest) << false;
}

void RtuClientTest::doubtfulCommand()
{
    QFETCH(int, fault);
    QFETCH(bool, received);
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->script({static_cast<Fault>(fault)});
    const auto result = m_client->command(Command::Start);
    if (received) {
        QVERIFY2(result.has_value(), result ? "" : describe(result.error()).c_str());
        QVERIFY(result->done());
        QCOMPARE(result->code, Command::Start);
        QCOMPARE(m_slave->commandsExecuted(), 1);
    } else {
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().kind, LinkErrorKind::CommandLost);
        QCOMPARE(m_slave->commandsExecuted(), 0);
    }
    QVERIFY(m_client->command(Command::StopNow).has_value());
    QCOMPARE(m_slave->commandsExecuted(), received ? 2 : 1);
}

void RtuClientTest::commandWithoutAnyAnswerIsUnknown()
{
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->script({Fault::LostAnswer, Fault::LostRequest, Fault::LostRequest, Fault::LostRequest});
    const auto result = m_client->command(Command::Start);
    QVERIFY(!result.has_value());
    QCOMPARE(result.error().kind, LinkErrorKind::OutcomeUnknown);
    const auto found = m_client->findResult(static_cast<std::uint16_t>(result.error().code));
    QVERIFY(found.has_value());
    QVERIFY(found->has_value());
    QVERIFY((*found)->done());
    QCOMPARE(m_slave->commandsExecuted(), 1);
}

void RtuClientTest::commandBeforeARestartIsUnknown()
{
    QVERIFY(m_client->command(Command::Start).has_value());
    m_slave->script({Fault::Restart}); // executed, then nothing is known of it
    const auto result = m_client->command(Command::SaveToFlash);
    QVERIFY(!result.has_value());
    QCOMPARE(result.error().kind, LinkErrorKind::OutcomeUnknown);
    QCOMPARE(m_slave->commandsExecuted(), 2);
    QVERIFY(m_client->command(Command::StopNow).has_value());
    QCOMPARE(m_slave->commandsExecuted(), 3);
}

void RtuClientTest::counterOfARestartedControllerIsNotUsed()
{
    m_slave->setRegister(registerNamed("status.command_counter").address, 0xFFFF);
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->restart(); // its counter is 0, and the command after 0xFFFF is unknown to it
    const auto result = m_client->command(Command::Start);
    QVERIFY(result.has_value());
    QVERIFY(result->done());
    QCOMPARE(m_slave->commandsExecuted(), 1);
}

void RtuClientTest::refusedCommandIsAResult()
{
    const auto result = m_client->command(Command::Home);
    QVERIFY(result.has_value());
    QVERIFY(!result->done());
    QCOMPARE(result->reason, Refusal::InFault);
}

void RtuClientTest::parameterIsProven()
{
    const RegisterInfo& info = registerNamed("parameter.following_error_limit");
    QVERIFY(m_client->writeParameter(info, 70000).has_value());
    QCOMPARE(m_slave->getRegister(info.address), std::uint16_t{1});
    QCOMPARE(m_slave->getRegister(static_cast<std::uint16_t>(info.address + 1)), std::uint16_t{4464});
    m_slave->script({Fault::LostAnswer});
    QVERIFY(m_client->writeParameter(info, 80000).has_value());
    m_slave->script({Fault::LostRequest});
    const auto lost = m_client->writeParameter(info, 90000);
    QVERIFY(!lost.has_value());
    QCOMPARE(lost.error().kind, LinkErrorKind::ReadBackDiffers);
    // An exception may belong to another question: the register decides.
    m_slave->script({Fault::Exception2Done});
    QVERIFY(m_client->writeParameter(info, 91000).has_value());
    m_slave->script({Fault::Exception2});
    QCOMPARE(m_client->writeParameter(info, 92000).error().kind, LinkErrorKind::Exception);
}

void RtuClientTest::parameterOutsideItsLimitsIsNotSent()
{
    const auto refused = m_client->writeParameter(registerNamed("parameter.ramp_time"), 5);
    QVERIFY(!refused.has_value());
    QCOMPARE(refused.error().kind, LinkErrorKind::ValueRefused);
    QVERIFY(refused.error().limits.has_value());
    QCOMPARE(refused.error().limits->minimum, 50.0);
    QCOMPARE(refused.error().limits->maximum, 10000.0);
    const auto fixed = m_client->writeParameter(registerNamed("status.state"), 1);
    QCOMPARE(fixed.error().kind, LinkErrorKind::ValueRefused);
    QVERIFY(!fixed.error().limits);
    QCOMPARE(m_slave->requests(), 0);
}

void RtuClientTest::pulledAdapter()
{
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_slave->unplug();
    QElapsedTimer timer;
    timer.start();
    const auto gone = m_client->exchangeStatus(2, 0);
    QVERIFY(!gone.has_value());
    QCOMPARE(gone.error().kind, LinkErrorKind::PortGone);
    QVERIFY(portIsLost(gone.error()));
    QVERIFY(timer.elapsed() < 2 * allowance.count());
    m_client->close();
    QCOMPARE(m_client->exchangeStatus(3, 0).error().kind, LinkErrorKind::NotOpen);
    QCOMPARE(m_client->open().error().kind, LinkErrorKind::PortAbsent);
}

void RtuClientTest::portsThatCannotBeOpened()
{
    const auto kindOf = [](const std::string& port) {
        RtuClient client(settingsFor(port));
        const auto opened = client.open();
        return opened ? LinkErrorKind::NoAnswer : opened.error().kind;
    };
    QTemporaryDir directory;
    const std::string folder = directory.path().toStdString();
    QFile file(directory.filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(kindOf(folder + "/absent"), LinkErrorKind::PortAbsent);
    QCOMPARE(kindOf(folder + "/file"), LinkErrorKind::PortNotSerial);
    QCOMPARE(kindOf(folder), LinkErrorKind::PortNotSerial);
    QCOMPARE(kindOf("/dev/null"), LinkErrorKind::PortNotSerial);
}

// As a user who is not in the group of the port. The superuser may open every node, so a child is one of the
// others.
void RtuClientTest::portWithoutPermission()
{
    struct stat node {};
    QCOMPARE(stat(m_slave->port().c_str(), &node), 0);
    QCOMPARE(chmod(m_slave->port().c_str(), 0600), 0);
    const group* owner = getgrgid(node.st_gid);
    const std::string expected = owner != nullptr ? owner->gr_name : std::to_string(node.st_gid);
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) {
        constexpr id_t nobody = 65534;
        if (getuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0))
            _exit(3);
        if (getuid() == node.st_uid && chmod(m_slave->port().c_str(), 0) != 0)
            _exit(4);
        RtuClient client(settingsFor(m_slave->port()));
        const auto opened = client.open();
        if (opened || opened.error().kind != LinkErrorKind::PortNotPermitted)
            _exit(1);
        _exit(opened.error().detail == expected ? 0 : 2);
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QCOMPARE(WEXITSTATUS(status), 0);
}

void RtuClientTest::busyPort()
{
    RtuClient second(settingsFor(m_slave->port()));
    const auto opened = second.open();
    QVERIFY(!opened.has_value());
    QCOMPARE(opened.error().kind, LinkErrorKind::PortBusy);
    QVERIFY(m_client->exchangeStatus(1, 0).has_value());
    m_client->close();
    QVERIFY(second.open().has_value());
}

void RtuClientTest::settingsThatCannotBeUsed_data()
{
    QTest::addColumn<unsigned>("baud");
    QTest::addColumn<int>("stopBits");
    QTest::addColumn<int>("unit");
    QTest::newRow("baud rate that libmodbus would replace") << 12345u << 1 << 1;
    QTest::newRow("three stop bits") << 9600u << 3 << 1;
    QTest::newRow("unit 0 is broadcast") << 9600u << 1 << 0;
    QTest::newRow("unit 248") << 9600u << 1 << 248;
}

void RtuClientTest::settingsThatCannotBeUsed()
{
    QFETCH(unsigned, baud);
    QFETCH(int, stopBits);
    QFETCH(int, unit);
    LinkSettings settings = settingsFor(m_slave->port());
    settings.line.baud = baud;
    settings.line.stopBits = static_cast<std::uint8_t>(stopBits);
    settings.unit = unit;
    m_client->close();
    RtuClient client(settings);
    const auto opened = client.open();
    QVERIFY(!opened.has_value());
    QCOMPARE(opened.error().kind, LinkErrorKind::PortSettings);
}

void RtuClientTest::killedOwnerLeavesThePortFree()
{
    m_client->close();
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) {
        RtuClient owner(settingsFor(m_slave->port()));
        _exit(owner.open().has_value() ? 0 : 1); // no destructor runs, as after a kill
    }
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QCOMPARE(WEXITSTATUS(status), 0);
    QVERIFY(m_client->open().has_value());
}

void RtuClientTest::silenceIsKeptBetweenFrames()
{
    LinkSettings settings = settingsFor(m_slave->port());
    settings.line.baud = 9600;
    m_client->close();
    RtuClient slow(settings);
    QVERIFY(slow.open().has_value());
    QVERIFY(slow.exchangeStatus(0, 0).has_value());
    constexpr int exchanges = 10;
    QElapsedTimer timer;
    timer.start();
    for (std::uint16_t i = 1; i <= exchanges; ++i)
        QVERIFY(slow.exchangeStatus(i, 0).has_value());
    // The scripted slave answers at once, so only the silences take time.
    QVERIFY(std::chrono::nanoseconds(timer.nsecsElapsed()) >= exchanges * frameSilence(settings.line));
}

CAMPANEL_TEST(RtuClientTest)

} // namespace test_rtu_client

#include "test_rtu_client.moc"
