// SPDX-License-Identifier: Apache-2.0
// The download against a scripted slave: complete, interrupted and resumed, cancelled, refused.
#include "modbus/download/download.h"
#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"
#include "scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <random>

namespace test_download {

using namespace campanel::modbus;
using campanel::test::Fault;
using campanel::test::ScriptedSlave;

class DownloadTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void becomesActiveAtTheCycleBoundary();
    void appliedAtOnceWhenStopped();
    void linkErrorsAreRepeated_data();
    void linkErrorsAreRepeated();
    void busyStepsAreRepeated();
    void resumesAtTheMissingBlock();
    void beginsAgainAfterARestartOfTheController();
    void beginsAgainWhenNobodySawTheRestart_data();
    void beginsAgainWhenNobodySawTheRestart();
    void resumedAfterApplyWasSent_data();
    void resumedAfterApplyWasSent();
    void applyWithoutAnyAnswer_data();
    void applyWithoutAnyAnswer();
    void cancelledWhileTransferring();
    void cancelledWhileArmed();
    void refusedRowLeavesTheActiveProgram();
    void differingRegisterIsNamed();
    void tooLongAnImageIsNotSent();
    void kindIsThatOfTheImage();
    void withdrawnElsewhere();

private:
    [[nodiscard]] Download make(Download::Options options = {});
    void setKind(ProgramKind kind)
    {
        m_image.at(registerNamed("bank.kind").address) = static_cast<std::uint16_t>(kind);
    }
    // Steps with a status exchange in between, until the phase is reached; link errors are repeated.
    [[nodiscard]] bool run(Download& download, Download::Phase until);
    [[nodiscard]] tl::expected<Download::Phase, DownloadError> pollStatus(Download& download);

    std::unique_ptr<ScriptedSlave> m_slave;
    std::unique_ptr<RtuClient> m_client;
    std::vector<std::uint16_t> m_image;
    Identity m_identity;
};

void DownloadTest::init()
{
    m_slave = std::make_unique<ScriptedSlave>();
    LinkSettings settings;
    settings.port = m_slave->port();
    settings.answerAllowance = std::chrono::milliseconds{300};
    m_client = std::make_unique<RtuClient>(settings);
    QVERIFY(m_client->open().has_value());
    m_identity = m_client->identify().value();
    const unsigned seed = 4711;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    m_image.resize(bankHeaderRegisters + 3 * 150);
    for (std::uint16_t& value : m_image)
        value = static_cast<std::uint16_t>(random());
    setKind(ProgramKind::RotaryCutter);
}

void DownloadTest::cleanup()
{
    m_client.reset();
    m_slave.reset();
}

Download DownloadTest::make(Download::Options options)
{
    return Download(m_image, m_identity, options);
}

tl::expected<Download::Phase, DownloadError> DownloadTest::pollStatus(Download& download)
{
    static std::uint16_t heartbeat = 0;
    const auto status = m_client->exchangeStatus(++heartbeat, 0);
    if (!status)
        return download.phase();
    return download.noteStatus(*status);
}

bool DownloadTest::run(Download& download, Download::Phase until)
{
    for (int step = 0; step < 200 && download.phase() != until; ++step) {
        const auto noted = pollStatus(download);
        const auto phase = download.advance(*m_client);
        for (const auto* outcome : {&noted, &phase}) {
            if (!*outcome && outcome->error().kind != DownloadErrorKind::Link) {
                qInfo("error %d", static_cast<int>(outcome->error().kind));
                return false;
            }
        }
    }
    return download.phase() == until;
}

void DownloadTest::becomesActiveAtTheCycleBoundary()
{
    Download download = make({ApplyMode::NextCycle, 21, true});
    QCOMPARE(download.progress(), 0.0);
    double last = 0.0;
    while (download.phase() != Download::Phase::AwaitActive) {
        QVERIFY(pollStatus(download).has_value());
        const auto phase = download.advance(*m_client);
        QVERIFY2(phase.has_value(), phase ? "" : describe(phase.error().link).c_str());
        QVERIFY(download.progress() >= last);
        last = download.progress();
    }
    QCOMPARE(last, 1.0);
    QCOMPARE(pollStatus(download), Download::Phase::AwaitActive);
    m_slave->reachCycleBoundary();
    QCOMPARE(pollStatus(download), Download::Phase::Active);
    QCOMPARE(download.crc(), crc32OfRegisters(m_image));
    for (std::size_t i = 0; i < m_image.size(); ++i)
        QCOMPARE(m_slave->getRegister(static_cast<std::uint16_t>(activeBankBase + i)), m_image[i]);
}

// A slow controller: the last bank is still being saved at the Begin, and the Seal goes in pieces.
void DownloadTest::busyStepsAreRepeated()
{
    Download download = make({ApplyMode::WhenStopped, 23, false});
    m_slave->setBusy(5);
    QVERIFY(run(download, Download::Phase::Seal));
    m_slave->setBusy(5);
    for (int i = 0; i < 5; ++i)
        QCOMPARE(download.advance(*m_client), Download::Phase::Seal);
    QVERIFY(run(download, Download::Phase::Active));
}

void DownloadTest::appliedAtOnceWhenStopped()
{
    Download download = make({ApplyMode::WhenStopped, 22, false});
    QVERIFY(run(download, Download::Phase::Active));
}

void DownloadTest::linkErrorsAreRepeated_data()
{
    QTest::addColumn<int>("fault");
    QTest::newRow("request lost") << static_cast<int>(Fault::LostRequest);
    QTest::newRow("answer lost") << static_cast<int>(Fault::LostAnswer);
    QTest::newRow("answer late") << static_cast<int>(Fault::LateAnswer);
    QTest::newRow("wrong CRC") << static_cast<int>(Fault::BadChecksum);
}

void DownloadTest::linkErrorsAreRepeated()
{
    QFETCH(int, fault);
    const auto f = static_cast<Fault>(fault);
    const auto ok = Fault::None;
    // Begin, the second block, seal and apply get the fault; status exchanges are in between.
    m_slave->script({ok, f, ok, ok, ok, f, ok, ok, ok, f, ok, ok, f, ok, ok, f});
    Download download = make({ApplyMode::WhenStopped, 23, true});
    QVERIFY(run(download, Download::Phase::Active));
    QCOMPARE(m_slave->commandsExecuted(), 1);
}

void DownloadTest::resumesAtTheMissingBlock()
{
    Download download = make({ApplyMode::WhenStopped, 24, false});
    QVERIFY(run(download, Download::Phase::Blocks));
    QVERIFY(download.advance(*m_client).has_value());
    QVERIFY(download.advance(*m_client).has_value());
    const double before = download.progress();
    m_client->close();
    QCOMPARE(download.advance(*m_client).error().kind, DownloadErrorKind::Link);
    QVERIFY(m_client->open().has_value());
    download.resume();
    QVERIFY(download.advance(*m_client).has_value());
    QCOMPARE(download.phase(), Download::Phase::Blocks);
    QCOMPARE(download.progress(), before);
    QVERIFY(run(download, Download::Phase::Active));
}

void DownloadTest::beginsAgainAfterARestartOfTheController()
{
    Download download = make({ApplyMode::WhenStopped, 25, false});
    QVERIFY(run(download, Download::Phase::Seal));
    m_slave->forgetTransfer();
    download.resume();
    QCOMPARE(download.advance(*m_client), Download::Phase::Begin);
    QVERIFY(run(download, Download::Phase::Active));
}

void DownloadTest::beginsAgainWhenNobodySawTheRestart_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("verify");
    QTest::newRow("blocks") << static_cast<int>(Download::Phase::Blocks) << false;
    QTest::newRow("seal") << static_cast<int>(Download::Phase::Seal) << false;
    QTest::newRow("verify") << static_cast<int>(Download::Phase::Verify) << true;
    QTest::newRow("apply") << static_cast<int>(Download::Phase::Apply) << false;
}

void DownloadTest::beginsAgainWhenNobodySawTheRestart()
{
    QFETCH(int, phase);
    QFETCH(bool, verify);
    Download download = make({ApplyMode::WhenStopped, 28, verify});
    QVERIFY(run(download, static_cast<Download::Phase>(phase)));
    m_slave->restart();
    QVERIFY(run(download, Download::Phase::Active));
    QCOMPARE(m_client->exchangeStatus(0, 0)->generation, 7u); // 6 in its flash, and this one
}

void DownloadTest::resumedAfterApplyWasSent_data()
{
    QTest::addColumn<int>("mode");
    QTest::newRow("became active") << static_cast<int>(ApplyMode::WhenStopped);
    QTest::newRow("is armed") << static_cast<int>(ApplyMode::NextCycle);
}

void DownloadTest::resumedAfterApplyWasSent()
{
    QFETCH(int, mode);
    Download download = make({static_cast<ApplyMode>(mode), 29, false});
    QVERIFY(run(download, Download::Phase::Apply));
    m_slave->script({Fault::LostAnswer, Fault::LostRequest, Fault::LostRequest, Fault::LostRequest});
    QVERIFY(!download.advance(*m_client).has_value());
    download.resume(); // as after a broken line, before any status
    while (download.phase() != Download::Phase::AwaitActive)
        QVERIFY(download.advance(*m_client).has_value());
    m_slave->reachCycleBoundary();
    QCOMPARE(pollStatus(download), Download::Phase::Active);
    QCOMPARE(m_client->exchangeStatus(0, 0)->generation, 8u); // once
}

void DownloadTest::applyWithoutAnyAnswer_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("statusFirst");
    QTest::newRow("at once, status tells") << static_cast<int>(ApplyMode::WhenStopped) << true;
    QTest::newRow("at once, asked again") << static_cast<int>(ApplyMode::WhenStopped) << false;
    QTest::newRow("armed, status tells") << static_cast<int>(ApplyMode::NextCycle) << true;
    QTest::newRow("armed, asked again") << static_cast<int>(ApplyMode::NextCycle) << false;
}

void DownloadTest::applyWithoutAnyAnswer()
{
    QFETCH(int, mode);
    QFETCH(bool, statusFirst);
    Download download = make({static_cast<ApplyMode>(mode), 27, false});
    QVERIFY(run(download, Download::Phase::Apply));
    // The command is executed, but its answer and all requests for its result are lost.
    m_slave->script({Fault::LostAnswer, Fault::LostRequest, Fault::LostRequest, Fault::LostRequest});
    const auto unknown = download.advance(*m_client);
    QVERIFY(!unknown.has_value());
    QCOMPARE(unknown.error().link.kind, LinkErrorKind::OutcomeUnknown);
    if (!statusFirst)
        QCOMPARE(download.advance(*m_client), Download::Phase::AwaitActive);
    m_slave->reachCycleBoundary();
    QCOMPARE(pollStatus(download), Download::Phase::Active);
    QCOMPARE(m_client->exchangeStatus(0, 0)->generation, 8u);
}

void DownloadTest::cancelledWhileTransferring()
{
    Download download = make();
    QVERIFY(run(download, Download::Phase::Seal));
    QCOMPARE(download.cancel(*m_client), Download::Phase::Cancelled);
    QVERIFY(download.ended());
    QCOMPARE(download.advance(*m_client), Download::Phase::Cancelled);
    const auto status = m_client->exchangeStatus(1, 0);
    QCOMPARE(status->stagedState, StagedState::Empty);
    QCOMPARE(status->generation, 7u);
}

void DownloadTest::cancelledWhileArmed()
{
    Download download = make();
    QVERIFY(run(download, Download::Phase::AwaitActive));
    QCOMPARE(download.cancel(*m_client), Download::Phase::Cancelled);
    m_slave->reachCycleBoundary();
    QCOMPARE(m_client->exchangeStatus(1, 0)->generation, 7u);
}

void DownloadTest::refusedRowLeavesTheActiveProgram()
{
    m_slave->refuseRow(17);
    Download download = make();
    QVERIFY(!run(download, Download::Phase::Active));
    QCOMPARE(download.phase(), Download::Phase::Failed);
    QCOMPARE(m_client->exchangeStatus(1, 0)->generation, 7u);
}

void DownloadTest::differingRegisterIsNamed()
{
    Download download = make({ApplyMode::WhenStopped, 26, true});
    const auto damage = [this](unsigned bits) {
        m_slave->setRegister(stagedBankBase + 200, static_cast<std::uint16_t>(m_image[200] ^ bits));
    };
    tl::expected<Download::Phase, DownloadError> phase = download.phase();
    const auto verify = [&] {
        QVERIFY(run(download, Download::Phase::Verify));
        damage(1);
        do
            phase = download.advance(*m_client);
        while (phase && *phase == Download::Phase::Verify);
    };
    verify();
    QCOMPARE(phase, Download::Phase::Resuming); // the controller may have restarted
    damage(0);
    verify(); // it has not restarted
    QVERIFY(!phase.has_value());
    QCOMPARE(phase.error().kind, DownloadErrorKind::RowsDiffer);
    QCOMPARE(phase.error().offset, 200u);
    QCOMPARE(m_slave->commandsExecuted(), 0);
}

void DownloadTest::tooLongAnImageIsNotSent()
{
    m_identity.bankRegisters = static_cast<std::uint16_t>(m_image.size() - 1);
    const int before = m_slave->requests();
    Download download = make();
    const auto phase = download.advance(*m_client);
    QCOMPARE(phase.error().kind, DownloadErrorKind::ImageTooLong);
    QCOMPARE(phase.error().actual, static_cast<std::uint32_t>(m_image.size()));
    QCOMPARE(phase.error().expected, std::uint32_t{m_identity.bankRegisters});
    QCOMPARE(m_slave->requests(), before);
    m_identity.programKinds = 0;
    Download other = make();
    QCOMPARE(other.advance(*m_client).error().kind, DownloadErrorKind::KindNotSupported);
}

void DownloadTest::kindIsThatOfTheImage()
{
    m_identity.programKinds = 1u << static_cast<unsigned>(ProgramKind::PointCam);
    Download cutter = make();
    QCOMPARE(cutter.advance(*m_client).error().kind, DownloadErrorKind::KindNotSupported);
    setKind(ProgramKind::PointCam);
    Download cam = make();
    QVERIFY(cam.advance(*m_client).has_value());
}

void DownloadTest::withdrawnElsewhere()
{
    Download download = make();
    QVERIFY(run(download, Download::Phase::AwaitActive));
    QVERIFY(m_client->command(Command::CancelApply).has_value());
    const auto phase = pollStatus(download);
    QVERIFY(!phase.has_value());
    QCOMPARE(phase.error().kind, DownloadErrorKind::Withdrawn);
}

CAMPANEL_TEST(DownloadTest)

} // namespace test_download

#include "test_download.moc"
