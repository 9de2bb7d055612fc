// SPDX-License-Identifier: Apache-2.0
// The data that survives a power loss: program, parameters, generation; a power cut at any byte leaves the
// older slot.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_flash {

using namespace campanel::test;

namespace {

BankImage bankNumber(std::uint32_t number)
{
    BankImage bank = camBank(10000, 1, 8'000'000, 8);
    bank.bagLengthUm = 100'000 + number;
    return bank;
}

std::uint16_t saveNumber(Rig& rig, std::uint32_t number)
{
    const BankImage bank = bankNumber(number);
    rig.install(bank);
    return rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers()));
}

// Returns the result registers.
Registers sendSave(Rig& rig, std::uint16_t counter, std::uint32_t crc)
{
    return rig.readWrite(CTL_REG_RESULT_COUNTER, 4, CTL_REG_COMMAND_COUNTER,
                         {counter, CTL_COMMAND_SAVE_TO_FLASH, 0, 0, static_cast<std::uint16_t>(crc >> 16),
                          static_cast<std::uint16_t>(crc & 0xFFFFu)});
}

// Saves on a slow board, with a flash that is busy until runUntilSaved().
void beginSaveInPieces(Rig& rig, std::uint32_t crc)
{
    rig.core().board.config.work_registers = 48;
    rig.core().board.port.flash_progress = [](void*) { return CTL_FLASH_BUSY; };
    sendSave(rig, 101, crc);
    rig.run(20'000);
    QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4)[2], CTL_COMMAND_STATUS_BUSY);
    QVERIFY(rig.core().flash.saving.busy);
}

void runUntilSaved(Rig& rig)
{
    rig.core().board.port.flash_progress = [](void*) { return CTL_FLASH_DONE; };
    rig.run(500'000);
    QVERIFY(!rig.core().flash.saving.busy);
}

// An asynchronous flash that fails after some answers; what it was writing then is damaged.
MemoryFlash* failingFlash = nullptr;
int answersUntilFailure = 0;

ctl_flash_progress failLater(void* /*context*/)
{
    if (answersUntilFailure-- != 0)
        return CTL_FLASH_DONE;
    Bytes& slot = failingFlash->contents[1];
    if (!slot.empty())
        slot.back() ^= 1;
    return CTL_FLASH_FAILED;
}

} // namespace

class TestFlash : public QObject {
    Q_OBJECT

private slots:
    void blankFlash();
    void savedProgramComesBack();
    void unsavedProgramDoesNot();
    void newestOfMany();
    void powerCutAtEveryByte();
    void everyDamagedByteIsNoticed();
    void flashFailureIsReported();
    void secondSaveJoinsTheRunningOne();
    void secondSaveWithAWrongSumIsRefused();
    void secondSaveOfSomethingElseFollows();
    void asynchronousFlashFailsHalfWay();
    void savingWhileRunning();
    void maxCamThroughFlash();
    void slotsOfOtherVersions_data();
    void slotsOfOtherVersions();
};

void TestFlash::blankFlash()
{
    Rig rig;
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_IDLE);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), 0u);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_FLASH_SLOT_INVALID) == 0);
}

void TestFlash::savedProgramComesBack()
{
    MemoryFlash flash;
    const Registers image = bankNumber(1).registers();
    {
        Rig rig({}, &flash);
        rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 1234);
        QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
        QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc32(image));
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc32(image));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 1u);
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 88), image);
    QCOMPARE(rig.status(CTL_REG_PARAMETER_RAMP_TIME), 1234);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
}

void TestFlash::unsavedProgramDoesNot()
{
    MemoryFlash flash;
    {
        Rig rig({}, &flash);
        QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
        rig.install(bankNumber(2));
        QVERIFY(rig.statusWide(CTL_REG_STATUS_SAVED_CRC) != rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC));
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(bankNumber(1).registers()));
}

void TestFlash::newestOfMany()
{
    MemoryFlash flash;
    for (std::uint32_t number = 1; number <= 5; ++number) {
        Rig rig({}, &flash);
        QCOMPARE(saveNumber(rig, number), CTL_REFUSAL_NONE);
        QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), number);
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(bankNumber(5).registers()));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 5u);
}

void TestFlash::powerCutAtEveryByte()
{
    MemoryFlash before;
    std::size_t bytes = 0;
    {
        Rig rig({}, &before);
        QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
        QCOMPARE(saveNumber(rig, 2), CTL_REFUSAL_NONE);
        MemoryFlash measured = before;
        measured.written = 0;
        Rig again({}, &measured);
        QCOMPARE(saveNumber(again, 3), CTL_REFUSAL_NONE);
        bytes = measured.written;
    }
    QVERIFY(bytes > 170);
    for (std::size_t cut = 0; cut <= bytes; ++cut) {
        MemoryFlash flash = before;
        {
            Rig rig({}, &flash);
            flash.bytesUntilPowerCut = cut;
            const std::uint16_t refusal = saveNumber(rig, 3);
            QCOMPARE(refusal, cut < bytes ? CTL_REFUSAL_FLASH_FAILED : CTL_REFUSAL_NONE);
            flash.bytesUntilPowerCut.reset();
        }
        Rig rig({}, &flash);
        const std::uint32_t expected = crc32(bankNumber(cut < bytes ? 2 : 3).registers());
        QCOMPARE(rig.core().banks.active_crc, expected);
        QCOMPARE(rig.core().flash.saved_crc, expected);
        QVERIFY(ctl_active_bank_intact(&rig.core().banks));
        // The next save goes to the broken slot and works.
        QCOMPARE(saveNumber(rig, 4), CTL_REFUSAL_NONE);
        Rig after({}, &flash);
        QCOMPARE(after.core().banks.active_crc, crc32(bankNumber(4).registers()));
    }
}

void TestFlash::everyDamagedByteIsNoticed()
{
    MemoryFlash saved;
    {
        Rig rig({}, &saved);
        QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
    }
    const std::size_t size = saved.contents[0].size();
    QVERIFY(size > 170);
    for (std::size_t i = 0; i < size; ++i) {
        MemoryFlash flash = saved;
        flash.contents[0][i] ^= 0x10;
        Rig rig({}, &flash);
        QVERIFY(!rig.core().banks.has_active);
        QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_FLASH_SLOT_INVALID) != 0);
    }
}

void TestFlash::flashFailureIsReported()
{
    MemoryFlash flash;
    Rig rig({}, &flash);
    QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
    const std::uint32_t saved = rig.statusWide(CTL_REG_STATUS_SAVED_CRC);
    flash.bytesUntilPowerCut = 10;
    QCOMPARE(saveNumber(rig, 2), CTL_REFUSAL_FLASH_FAILED);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), saved);
}

// A save in pieces is under way. A second command for the same bank joins it.
void TestFlash::secondSaveJoinsTheRunningOne()
{
    MemoryFlash flash;
    Rig rig({}, &flash);
    rig.install(bankNumber(1));
    const std::uint32_t crc = crc32(bankNumber(1).registers());
    beginSaveInPieces(rig, crc);
    const std::size_t written = flash.written;
    const Registers second = sendSave(rig, 102, crc);
    QCOMPARE(second[0], 102);
    QCOMPARE(second[2], CTL_COMMAND_STATUS_BUSY);
    runUntilSaved(rig);
    QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4),
             (Registers{102, CTL_COMMAND_SAVE_TO_FLASH, CTL_COMMAND_STATUS_DONE, CTL_REFUSAL_NONE}));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc);
    QVERIFY(flash.contents[1].empty() && flash.written > written); // one save, not two
}

void TestFlash::secondSaveWithAWrongSumIsRefused()
{
    MemoryFlash flash;
    Rig rig({}, &flash);
    rig.install(bankNumber(1));
    const std::uint32_t crc = crc32(bankNumber(1).registers());
    beginSaveInPieces(rig, crc);
    QCOMPARE(
        sendSave(rig, 102, crc + 1),
        (Registers{102, CTL_COMMAND_SAVE_TO_FLASH, CTL_COMMAND_STATUS_REFUSED, CTL_REFUSAL_WRONG_CHECKSUM}));
    runUntilSaved(rig);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc); // the first save has ended all the same
    QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4)[2], CTL_COMMAND_STATUS_REFUSED);
}

// The program, or a parameter, has changed since the first save began: it is saved after the first one. With
// and without the check of the bank in pieces.
void TestFlash::secondSaveOfSomethingElseFollows()
{
    for (const std::uint16_t registers : {std::uint16_t{0}, std::uint16_t{48}}) {
        for (const std::uint32_t number : {1u, 2u}) {
            MemoryFlash flash;
            Rig rig({}, &flash);
            rig.install(bankNumber(1));
            beginSaveInPieces(rig, crc32(bankNumber(1).registers()));
            rig.core().board.config.work_registers = 0; // a seal in one piece
            if (number == 2)
                rig.install(bankNumber(2).registers(), 2);
            rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 1234);
            rig.core().board.config.work_registers = registers;
            const std::uint32_t crc = crc32(bankNumber(number).registers());
            QCOMPARE(sendSave(rig, 77, crc)[2], CTL_COMMAND_STATUS_BUSY);
            runUntilSaved(rig);
            QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4),
                     (Registers{77, CTL_COMMAND_SAVE_TO_FLASH, CTL_COMMAND_STATUS_DONE, CTL_REFUSAL_NONE}));
            QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc);
            Rig after({}, &flash);
            QCOMPARE(after.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc);
            QCOMPARE(after.status(CTL_REG_PARAMETER_RAMP_TIME), 1234);
        }
    }
}

// The flash works by itself and reports its failure only later: at its erase, and at every piece.
void TestFlash::asynchronousFlashFailsHalfWay()
{
    const std::uint32_t first = crc32(bankNumber(1).registers());
    const std::uint32_t second = crc32(bankNumber(2).registers());
    for (int answers = 0;; ++answers) {
        MemoryFlash flash;
        {
            Rig rig({}, &flash);
            QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
            rig.install(bankNumber(2));
            answersUntilFailure = answers;
            failingFlash = &flash;
            rig.core().board.port.flash_progress = failLater;
            rig.core().board.config.work_registers = 48;
            Registers result = sendSave(rig, 99, second);
            QCOMPARE(result[2], CTL_COMMAND_STATUS_BUSY);
            rig.run(500'000);
            result = rig.read(CTL_REG_RESULT_COUNTER, 4);
            const bool isSaved = answersUntilFailure >= 0;
            QCOMPARE(result[2], isSaved ? CTL_COMMAND_STATUS_DONE : CTL_COMMAND_STATUS_REFUSED);
            QCOMPARE(result[3], isSaved ? CTL_REFUSAL_NONE : CTL_REFUSAL_FLASH_FAILED);
            QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), isSaved ? second : first);
            if (isSaved) {
                QVERIFY(answers > 5);
                return;
            }
        }
        Rig rig({}, &flash); // power comes back: the older program
        QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), first);
    }
}

// A slot as another version wrote it: its magic, and its number of parameters where it has one.
void TestFlash::slotsOfOtherVersions_data()
{
    QTest::addColumn<int>("lastOfMagic");
    QTest::addColumn<bool>("hasCount");
    QTest::addColumn<int>("parameters");
    QTest::newRow("map 1.1") << int{'2'} << false << 10;
    QTest::newRow("map 1.2") << int{'3'} << false << 38;
    QTest::newRow("an older one") << int{'4'} << true << 12;
    QTest::newRow("map 1.4") << int{'4'} << true << 85;
    QTest::newRow("map 1.5") << int{'4'} << true << int{CTL_GROUP_PARAMETER};
    QTest::newRow("without trims") << int{'5'} << true << int{CTL_GROUP_PARAMETER};
    QTest::newRow("fewer parameters") << int{'6'} << true << 85;
    QTest::newRow("a newer one") << int{'6'} << true << int{CTL_GROUP_PARAMETER} + 3;
}

void TestFlash::slotsOfOtherVersions()
{
    QFETCH(int, lastOfMagic);
    QFETCH(bool, hasCount);
    QFETCH(int, parameters);
    MemoryFlash flash;
    flash.hasRecords = false;
    {
        Rig rig({}, &flash);
        rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 1234);
        rig.setParameter(CTL_REG_PARAMETER_SWITCH8_LEAD, 77);
        rig.setParameter(CTL_REG_PARAMETER_PERMIT_NEEDED, 1);
        rig.setParameter(CTL_REG_MASTER_ENGAGE, 75);
        rig.setParameter(CTL_REG_HAND_PRODUCT, 1500);
        rig.setParameter(CTL_REG_SIGNAL_ORDER_HORN, CTL_SIGNAL_MODE_ON);
        QCOMPARE(saveNumber(rig, 1), CTL_REFUSAL_NONE);
    }
    auto& bytes = flash.contents[0];
    Registers slot;
    for (std::size_t i = 0; i + 1 < bytes.size() - 4; i += 2)
        slot.push_back(static_cast<std::uint16_t>(bytes[i] << 8 | bytes[i + 1]));
    constexpr int head = 7;
    constexpr int now = CTL_GROUP_PARAMETER;
    slot[1] = static_cast<std::uint16_t>('M' << 8 | lastOfMagic);
    slot[head - 1] = static_cast<std::uint16_t>(parameters);
    const bool hasMaster = lastOfMagic >= '5';
    const bool hasTrims = lastOfMagic >= '6';
    const auto master = slot.begin() + head + now; // its number and its registers; then trims and signals
    const auto trims = master + 1 + CTL_GROUP_MASTER;
    if (!hasTrims)
        slot.erase(hasMaster ? trims : master, trims + 1 + CTL_TRIMS + 1 + CTL_GROUP_SIGNAL);
    const auto end = slot.begin() + head + now;
    if (parameters < now)
        slot.erase(slot.begin() + head + parameters, end);
    else
        slot.insert(end, static_cast<std::size_t>(parameters - now), std::uint16_t{7});
    if (!hasCount)
        slot.erase(slot.begin() + head - 1);
    const std::uint32_t crc = crc32(slot);
    slot.push_back(static_cast<std::uint16_t>(crc >> 16));
    slot.push_back(static_cast<std::uint16_t>(crc & 0xFFFFu));
    bytes.clear();
    for (const std::uint16_t each : slot) {
        bytes.push_back(static_cast<std::uint8_t>(each >> 8));
        bytes.push_back(static_cast<std::uint8_t>(each & 0xFFu));
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(bankNumber(1).registers()));
    QCOMPARE(rig.status(CTL_REG_PARAMETER_RAMP_TIME), 1234);
    constexpr int lead = CTL_REG_PARAMETER_SWITCH8_LEAD - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT;
    QCOMPARE(rig.status(CTL_REG_PARAMETER_SWITCH8_LEAD), parameters > lead ? 77 : 0);
    QCOMPARE(rig.status(CTL_REG_PARAMETER_PERMIT_NEEDED), parameters < now ? 0 : 1);
    QCOMPARE(rig.status(CTL_REG_MASTER_ENGAGE), hasMaster ? 75 : 50);
    QCOMPARE(rig.status(CTL_REG_HAND_PRODUCT), hasTrims ? 1500 : 0);
    QCOMPARE(rig.status(CTL_REG_SIGNAL_ORDER_HORN), hasTrims ? 1 : 0);
    QCOMPARE(rig.status(CTL_REG_PARAMETER_DRIVE_ENABLE), CTL_DRIVE_ENABLE_ON);
    QCOMPARE(saveNumber(rig, 2), CTL_REFUSAL_NONE);
    Rig after({}, &flash);
    QCOMPARE(after.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(bankNumber(2).registers()));
}

void TestFlash::savingWhileRunning()
{
    MemoryFlash flash;
    Rig rig({}, &flash);
    const BankImage bank = bankNumber(1);
    rig.install(bank);
    rig.command(CTL_COMMAND_START);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
    QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers())), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestFlash::maxCamThroughFlash()
{
    CamImage cam = sineCam(5000.0, 1000.0, CTL_CAM_POINT_CAPACITY - 1, 8'000'000);
    cam.kind = CTL_PROGRAM_KIND_SEGMENT_CAM;
    cam.segments = CTL_SEGMENT_CAPACITY;
    const Registers image = cam.registers();
    QCOMPARE(image.size(), std::size_t{CTL_BANK_REGISTERS});
    MemoryFlash flash;
    {
        Rig rig({}, &flash);
        QCOMPARE(rig.download(image), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
        QCOMPARE(rig.read(static_cast<std::uint16_t>(CTL_ACTIVE_BANK_BASE + CTL_BANK_REGISTERS - 100), 100),
                 Registers(image.end() - 100, image.end()));
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(image)), CTL_REFUSAL_NONE);
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_SAVED_CRC), crc32(image));
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 100), Registers(image.begin(), image.begin() + 100));
    rig.start();
    rig.run(5'000'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded(), std::int64_t{5000} * rig.core().motion.cycle_count);
}

CAMPANEL_TEST(TestFlash)

} // namespace test_flash

#include "test_flash.moc"
