// SPDX-License-Identifier: Apache-2.0
// The client and the download against the real controller program, paced as on the wire.
#include "app/program/program_image.h"
#include "modbus/download/download.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QElapsedTimer>

namespace test_controller {

using namespace campanel;
using namespace campanel::modbus;
using campanel::test::ControllerProcess;

class ControllerTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void identityMatchesTheMap();
    void statusFollowsTheHeartbeat();
    void everyWritableParameterIsProven();
    void rangeWithoutRegisters();
    void downloadBecomesActive();
    void changeWhileRunning();
    void refusedTableLeavesTheActiveOne();
    void anotherPanelSeesWhatRuns();
    void machineDataChangesOnlyAtStandstill();

private:
    [[nodiscard]] tl::expected<StatusBlock, LinkError> status();
    [[nodiscard]] bool download(const std::vector<std::uint16_t>& image, ApplyMode mode);
    [[nodiscard]] bool waitFor(State state);

    std::unique_ptr<ControllerProcess> m_controller;
    std::unique_ptr<RtuClient> m_client;
    Identity m_identity;
    std::uint16_t m_heartbeat = 0;
    std::uint16_t m_session = 0;
    DownloadError m_failure; // of the last download
};

void ControllerTest::init()
{
    m_controller = std::make_unique<ControllerProcess>();
    LinkSettings settings;
    settings.port = m_controller->port().toStdString();
    settings.answerAllowance = std::chrono::milliseconds{500};
    m_client = std::make_unique<RtuClient>(settings);
    QVERIFY(m_client->open().has_value());
    const auto identity = m_client->identify();
    QVERIFY2(identity.has_value(), identity ? "" : describe(identity.error()).c_str());
    m_identity = *identity;
}

void ControllerTest::cleanup()
{
    m_client.reset();
    m_controller.reset();
}

tl::expected<StatusBlock, LinkError> ControllerTest::status()
{
    return m_client->exchangeStatus(++m_heartbeat, 0);
}

bool ControllerTest::waitFor(State state)
{
    QElapsedTimer timer;
    timer.start();
    constexpr qint64 longestMs = 20'000;
    while (timer.elapsed() < longestMs) {
        const auto now = status();
        if (now && now->state == state)
            return true;
    }
    return false;
}

bool ControllerTest::download(const std::vector<std::uint16_t>& image, ApplyMode mode)
{
    Download download(image, m_identity, {mode, ++m_session, true});
    while (!download.ended()) {
        const auto now = status();
        if (!now)
            continue;
        const auto noted = download.noteStatus(*now);
        const auto phase = download.advance(*m_client);
        for (const auto* outcome : {&noted, &phase}) {
            if (!*outcome)
                m_failure = outcome->error();
        }
    }
    return download.phase() == Download::Phase::Active;
}

void ControllerTest::identityMatchesTheMap()
{
    QCOMPARE(m_identity.bankRegisters, bankRegisters);
    QCOMPARE(m_identity.blockRegisters, blockRegisters);
    QCOMPARE(m_identity.rowCapacity, rowCapacity);
    QVERIFY(m_identity.supports(ProgramKind::RotaryCutter));
    QCOMPARE(m_identity.timerClockHz, 8'000'000u);
}

void ControllerTest::statusFollowsTheHeartbeat()
{
    const auto first = status();
    QVERIFY2(first.has_value(), first ? "" : describe(first.error()).c_str());
    QCOMPARE(first->heartbeat, m_heartbeat);
    QCOMPARE(first->state, State::Idle);
    QVERIFY(!first->activeCrc.has_value());
    const auto second = status();
    QVERIFY(static_cast<std::uint16_t>(second->linkRequests - first->linkRequests) == 1);
}

void ControllerTest::everyWritableParameterIsProven()
{
    int written = 0;
    for (const RegisterInfo& info : registers()) {
        if (!info.name.starts_with("parameter."))
            continue;
        for (const double value : {info.minimum, info.maximum, info.defaultValue}) {
            const auto outcome = m_client->writeParameter(info, value);
            QVERIFY2(outcome.has_value(), outcome ? "" : describe(outcome.error()).c_str());
        }
        ++written;
    }
    QVERIFY(written >= 6);
}

void ControllerTest::rangeWithoutRegisters()
{
    QCOMPARE(m_client->readProven(0x1000, 4).error().kind, LinkErrorKind::RangeNotReadable);
    QVERIFY(status().has_value());
}

void ControllerTest::downloadBecomesActive()
{
    const auto image = program::buildProgram(program::Recipe{});
    QVERIFY(image.has_value());
    QVERIFY2(download(image->registers, ApplyMode::WhenStopped),
             QByteArray::number(static_cast<int>(m_failure.kind)));
    const auto now = status();
    QCOMPARE(now->activeCrc, image->crc);
    QCOMPARE(now->generation, 1u);
    QCOMPARE(now->state, State::Ready);
    BankReader reader(activeBankBase, static_cast<std::uint16_t>(image->registers.size()));
    while (!reader.complete())
        QVERIFY(reader.advance(*m_client).has_value());
    QVERIFY(reader.registers() == image->registers);
}

void ControllerTest::changeWhileRunning()
{
    program::Recipe recipe;
    recipe.cutter().rateBagsPerMin = 120;
    QVERIFY2(download(program::buildProgram(recipe)->registers, ApplyMode::WhenStopped),
             QByteArray::number(static_cast<int>(m_failure.kind)));
    const auto started = m_client->command(Command::Start);
    QVERIFY(started.has_value() && started->done());
    QVERIFY(waitFor(State::Running));
    recipe.cutter().bagLengthMm = 260;
    const auto image = program::buildProgram(recipe);
    QVERIFY2(download(image->registers, ApplyMode::NextCycle),
             QByteArray::number(static_cast<int>(m_failure.kind)));
    const auto now = status();
    QCOMPARE(now->generation, 2u);
    QCOMPARE(now->activeCrc, image->crc);
    QCOMPARE(now->state, State::Running);
    const auto stopped = m_client->command(Command::StopAtCycleEnd);
    QVERIFY(stopped.has_value() && stopped->done());
    QVERIFY(waitFor(State::Ready));
    QCOMPARE(status()->masterAngleDeg, 0.0);
}

void ControllerTest::refusedTableLeavesTheActiveOne()
{
    const auto image = program::buildProgram(program::Recipe{});
    QVERIFY(download(image->registers, ApplyMode::WhenStopped));
    auto wrong = image->registers;
    wrong[bankHeaderRegisters] = 60000; // more pulses than the row's ticks allow
    QVERIFY(!download(wrong, ApplyMode::WhenStopped));
    QCOMPARE(m_failure.transfer.result, TransferResult::BadRow);
    QCOMPARE(m_failure.transfer.detail, std::uint16_t{0});
    QCOMPARE(status()->activeCrc, image->crc);
    QCOMPARE(status()->generation, 1u);
}

void ControllerTest::anotherPanelSeesWhatRuns()
{
    program::Recipe recipe;
    recipe.name = "饼干 250";
    recipe.version = 12;
    QVERIFY(download(program::buildProgram(recipe)->registers, ApplyMode::WhenStopped));
    const LinkSettings settings = m_client->settings();
    m_client.reset();
    RtuClient other(settings);
    QVERIFY(other.open().has_value());
    QVERIFY(other.identify().has_value());
    const auto header = other.readProven(activeBankBase, bankHeaderRegisters);
    QVERIFY(header.has_value());
    const auto shown = program::decodeProgram(*header, {}, profile::Machine{});
    QVERIFY(shown.has_value());
    QCOMPARE(shown->name, recipe.name);
    QCOMPARE(shown->version, 12);
    QCOMPARE(shown->cutter().bagLengthMm, 250.0);
}

void ControllerTest::machineDataChangesOnlyAtStandstill()
{
    QVERIFY(download(program::buildProgram(program::Recipe{})->registers, ApplyMode::WhenStopped));
    QVERIFY(m_client->command(Command::Start)->done());
    QVERIFY(waitFor(State::Running));
    program::Recipe other;
    other.machine.knifeRadiusMm = 61;
    QVERIFY(!download(program::buildProgram(other)->registers, ApplyMode::NextCycle));
    QCOMPARE(m_failure.refusal, modbus::Refusal::MachineDataDiffers);
    QCOMPARE(status()->generation, 1u);
    QVERIFY(m_client->command(Command::StopNow)->done());
}

CAMPANEL_TEST(ControllerTest)

} // namespace test_controller

#include "test_controller.moc"
