// SPDX-License-Identifier: Apache-2.0
// The download: order, repetition, interruption, every check of the rows, apply and its refusals.
#include "rig.h"
#include "support/cam_image.h"
#include "support/interval_image.h"
#include "support/press_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>

namespace test_transfer {

using namespace campanel::test;

namespace {

BankImage goodBank()
{
    return camBank(10000, 1, 8'000'000);
}

Registers begin(Rig& rig, std::uint16_t session, std::size_t length, std::uint16_t kind = 1,
                std::uint16_t major = 1)
{
    return rig.transfer(session, CTL_TRANSFER_OPERATION_BEGIN, 0,
                        {kind, static_cast<std::uint16_t>(length), major});
}

Registers withDuration(Registers image, unsigned offset, std::uint16_t duration)
{
    image.at(offset) = duration;
    return image;
}

} // namespace

class TestTransfer : public QObject {
    Q_OBJECT

private slots:
    void wholeDownload();
    void beginRefusals();
    void blockRefusals();
    void blocksInAnyOrderAndResumed();
    void anotherSessionStartsAfresh();
    void sealNamesWhatIsMissing();
    void sealChecksEveryRow_data();
    void sealChecksEveryRow();
    void sealChecksTheAnnouncedKind();
    void sealComparesRowsWithTheInputs_data();
    void sealComparesRowsWithTheInputs();
    void sealComparesCyclesWithTheInputs_data();
    void sealComparesCyclesWithTheInputs();
    void maxTable();
    void activeBankReadsZeroBehindItsRows();
    void applyRefusals();
    void armedBankIsLockedUntilCancelled();
    void commandIsCarriedOutOnce();
    void singleRegistersCarryOutNothing_data();
    void singleRegistersCarryOutNothing();
    void shortPausesDoNotCrowd();
    void breakLeavesTheActiveProgram();
};

void TestTransfer::wholeDownload()
{
    Rig rig;
    const Registers image = goodBank().registers();
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_IDLE);
    QCOMPARE(rig.download(image), CTL_TRANSFER_RESULT_ACCEPTED);
    const Registers result = rig.read(CTL_REG_TRANSFER_RESULT_SESSION, 8);
    QCOMPARE(result[0], 1);
    QCOMPARE(result[5], (image.size() + CTL_BLOCK_REGISTERS - 1) / CTL_BLOCK_REGISTERS);
    QCOMPARE(static_cast<std::uint32_t>(result[6]) << 16 | result[7], crc32(image));
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_SEALED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_EMPTY);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 1u);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 100), Registers(image.begin(), image.begin() + 100));
}

void TestTransfer::beginRefusals()
{
    Rig rig;
    QCOMPARE(begin(rig, 0, 100)[3], CTL_TRANSFER_RESULT_WRONG_SESSION);
    QCOMPARE(begin(rig, 1, 100, 0)[3], CTL_TRANSFER_RESULT_KIND_NOT_SUPPORTED);
    QCOMPARE(begin(rig, 1, 100, CTL_PROGRAM_KIND_LAST + 1)[3], CTL_TRANSFER_RESULT_KIND_NOT_SUPPORTED);
    QCOMPARE(begin(rig, 1, 100, 1, 2)[3], CTL_TRANSFER_RESULT_WRONG_MAP_VERSION);
    QCOMPARE(begin(rig, 1, 64)[3], CTL_TRANSFER_RESULT_BAD_LENGTH);
    QCOMPARE(begin(rig, 1, CTL_BANK_REGISTERS + 1)[3], CTL_TRANSFER_RESULT_BAD_LENGTH);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BEGIN, 0, {1, 100}).at(3),
             CTL_TRANSFER_RESULT_BAD_LENGTH);
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_EMPTY);
    QCOMPARE(begin(rig, 1, 67)[3], CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_RECEIVING);
}

void TestTransfer::blockRefusals()
{
    Rig rig;
    const Registers full(CTL_BLOCK_REGISTERS, 0);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 0, full).at(3), CTL_TRANSFER_RESULT_NOT_RECEIVING);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_SEAL, 0, {}).at(3), CTL_TRANSFER_RESULT_NOT_RECEIVING);
    begin(rig, 1, 184); // blocks of 116 and 68
    QCOMPARE(rig.transfer(2, CTL_TRANSFER_OPERATION_BLOCK, 0, full).at(3), CTL_TRANSFER_RESULT_WRONG_SESSION);
    QCOMPARE(rig.transfer(2, CTL_TRANSFER_OPERATION_SEAL, 0, {}).at(3), CTL_TRANSFER_RESULT_WRONG_SESSION);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 2, full).at(3), CTL_TRANSFER_RESULT_BAD_BLOCK);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 0xFFFF, full).at(3),
             CTL_TRANSFER_RESULT_BAD_BLOCK);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 1, full).at(3), CTL_TRANSFER_RESULT_BAD_LENGTH);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 0, Registers(68, 0)).at(3),
             CTL_TRANSFER_RESULT_BAD_LENGTH);
    QCOMPARE(rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 1, Registers(68, 0)).at(3),
             CTL_TRANSFER_RESULT_ACCEPTED);
}

void TestTransfer::blocksInAnyOrderAndResumed()
{
    Rig rig;
    const Registers image = camBank(10000, 1, 8'000'000, 100).registers(); // 364 registers: 4 blocks
    const auto send = [&](std::uint16_t block) {
        const std::size_t first = block * std::size_t{CTL_BLOCK_REGISTERS};
        const std::size_t last = std::min(image.size(), first + CTL_BLOCK_REGISTERS);
        return rig.transfer(5, CTL_TRANSFER_OPERATION_BLOCK, block,
                            Registers(image.begin() + static_cast<std::ptrdiff_t>(first),
                                      image.begin() + static_cast<std::ptrdiff_t>(last)));
    };
    begin(rig, 5, image.size());
    QCOMPARE(send(3).at(5), 0);
    QCOMPARE(send(0).at(5), 1);
    QCOMPARE(send(0).at(5), 1);
    QCOMPARE(begin(rig, 5, image.size()).at(5), 1); // after an interruption the same transfer continues
    QCOMPARE(send(1).at(5), 2);
    QCOMPARE(send(2).at(5), 4);
    const Registers sealed = rig.transfer(5, CTL_TRANSFER_OPERATION_SEAL, 0, {});
    QCOMPARE(sealed[3], CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.transfer(5, CTL_TRANSFER_OPERATION_SEAL, 0, {}), sealed);
    QCOMPARE(send(2).at(3), CTL_TRANSFER_RESULT_NOT_RECEIVING);
}

void TestTransfer::anotherSessionStartsAfresh()
{
    Rig rig;
    const Registers image = goodBank().registers();
    QCOMPARE(rig.download(image, 3), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(begin(rig, 4, image.size()).at(5), 0);
    QCOMPARE(rig.transfer(4, CTL_TRANSFER_OPERATION_SEAL, 0, {}).at(3), CTL_TRANSFER_RESULT_BLOCKS_MISSING);
}

void TestTransfer::sealNamesWhatIsMissing()
{
    Rig rig;
    begin(rig, 1, 301); // three blocks
    rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, 0, Registers(CTL_BLOCK_REGISTERS, 0));
    const Registers result = rig.transfer(1, CTL_TRANSFER_OPERATION_SEAL, 0, {});
    QCOMPARE(result[3], CTL_TRANSFER_RESULT_BLOCKS_MISSING);
    QCOMPARE(result[5], 1);
}

using Change = std::function<void(Registers&)>;
void TestTransfer::sealChecksEveryRow_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<int>("result");
    QTest::addColumn<int>("detail");
    const auto header = [](const char* tag, unsigned offset, std::uint16_t value, unsigned detail) {
        QTest::newRow(tag) << Change([=](Registers& image) { image.at(offset) = value; })
                           << int{CTL_TRANSFER_RESULT_BAD_HEADER} << static_cast<int>(detail);
    };
    // Row 20 (125 pulses at the least) gets other pulses and ticks.
    const auto row = [](const char* tag, std::uint16_t pulses, std::uint32_t ticks, unsigned result,
                        int detail) {
        QTest::newRow(tag) << Change([=](Registers& image) {
            image.at(64 + 60) = pulses;
            image.at(64 + 61) = static_cast<std::uint16_t>(ticks >> 16);
            image.at(64 + 62) = static_cast<std::uint16_t>(ticks & 0xFFFFu);
        }) << static_cast<int>(result)
                           << detail;
    };
    QTest::newRow("untouched") << Change([](Registers&) {}) << int{CTL_TRANSFER_RESULT_ACCEPTED} << 0;
    header("layout", CTL_OFFSET_BANK_LAYOUT, 0, CTL_OFFSET_BANK_LAYOUT);
    header("layout of other kinds", CTL_OFFSET_BANK_LAYOUT, CTL_TABLE_LAYOUT_CAM_POINTS,
           CTL_OFFSET_BANK_KIND);
    header("kind", CTL_OFFSET_BANK_KIND, 0, CTL_OFFSET_BANK_KIND);
    header("fewer rows", CTL_OFFSET_BANK_ROW_COUNT, 39, CTL_OFFSET_BANK_ROW_COUNT);
    header("more rows", CTL_OFFSET_BANK_ROW_COUNT, 41, CTL_OFFSET_BANK_ROW_COUNT);
    header("no rows", CTL_OFFSET_BANK_ROW_COUNT, 0, CTL_OFFSET_BANK_ROW_COUNT);
    header("divisor 0", CTL_OFFSET_BANK_DIVISOR + 1, 0, CTL_OFFSET_BANK_DIVISOR);
    header("remainder = divisor", CTL_OFFSET_BANK_REMAINDER + 1, 1, CTL_OFFSET_BANK_REMAINDER);
    header("carry row", CTL_OFFSET_BANK_CARRY_ROW, 40, CTL_OFFSET_BANK_CARRY_ROW);
    header("cut angle", CTL_OFFSET_BANK_CUT_ANGLE, 36001, CTL_OFFSET_BANK_CUT_ANGLE);
    header("sync start", CTL_OFFSET_BANK_SYNC_START, 36001, CTL_OFFSET_BANK_SYNC_START);
    header("sync end", CTL_OFFSET_BANK_SYNC_END, 36001, CTL_OFFSET_BANK_SYNC_END);
    header("no knives", CTL_OFFSET_PROGRAM_KNIVES, 0, CTL_OFFSET_PROGRAM_KNIVES);
    header("no pulses", CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV + 1, 0,
           CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV);
    header("absurd pulses", CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV, 0xFFFF,
           CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV);
    header("no gear numerator", CTL_OFFSET_PROGRAM_GEAR_NUMERATOR, 0, CTL_OFFSET_PROGRAM_GEAR_NUMERATOR);
    header("no gear denominator", CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR, 0,
           CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR);
    row("no time", 10, 0, CTL_TRANSFER_RESULT_BAD_ROW, 20);
    row("pause without time", 0, 0, CTL_TRANSFER_RESULT_BAD_ROW, 20);
    row("too fast", 10, 399, CTL_TRANSFER_RESULT_BAD_ROW, 20);
    row("too slow", 2, 2 * 65535 + 1, CTL_TRANSFER_RESULT_BAD_ROW, 20);
    row("just fast enough", 10, 400, CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_TICKS);
    row("just slow enough", 4, 4 * 65535, CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_TICKS);
    row("a pause", 0, 200'000, CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_PULSES);
    QTest::newRow("carry leaves no room") << Change([](Registers& image) {
        image.at(CTL_OFFSET_BANK_DIVISOR + 1) = 3;
        image.at(CTL_OFFSET_BANK_REMAINDER + 1) = 1;
        image.at(64 + 60) = 5000; // 40 ticks per pulse; one pulse more is too fast
    }) << int{CTL_TRANSFER_RESULT_BAD_ROW} << 20;
    header("radius 0", CTL_OFFSET_PROGRAM_KNIFE_RADIUS + 1, 0, CTL_OFFSET_PROGRAM_KNIFE_RADIUS);
    // K Z / N differs from the sum of the rows: the knife would slip from bag to bag.
    const auto slips = [](const char* tag, unsigned offset, std::uint16_t value) {
        QTest::newRow(tag) << Change([=](Registers& image) { image.at(offset) = value; })
                           << int{CTL_TRANSFER_RESULT_BAD_SUM}
                           << int{CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV};
    };
    slips("another gear", CTL_OFFSET_PROGRAM_GEAR_NUMERATOR, 5);
    slips("another gear denominator", CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR, 3);
    slips("more knives", CTL_OFFSET_PROGRAM_KNIVES, 65535);
    slips("one pulse less a revolution", CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV + 1, 9999);
    QTest::newRow("a cycle of one tick") << Change([](Registers& image) {
        image = BankImage{.rows = {{0, 1}}}.registers();
    }) << int{CTL_TRANSFER_RESULT_BAD_HEADER}
                                         << int{CTL_OFFSET_BANK_CYCLE_TICKS};
}

void TestTransfer::sealChecksEveryRow()
{
    QFETCH(Change, change);
    QFETCH(int, result);
    QFETCH(int, detail);
    Rig rig;
    Registers image = goodBank().registers();
    change(image);
    QCOMPARE(rig.download(image, 1, CTL_PROGRAM_KIND_ROTARY_CUTTER), result);
    const Registers answer = rig.read(CTL_REG_TRANSFER_RESULT_SESSION, 8);
    QCOMPARE(answer[4], detail);
    const bool accepted = result == CTL_TRANSFER_RESULT_ACCEPTED;
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE),
             accepted ? CTL_STAGED_STATE_SEALED : CTL_STAGED_STATE_RECEIVING);
    QCOMPARE(answer[6] != 0 || answer[7] != 0, accepted);
    if (!accepted)
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NOTHING_SEALED);
}

void TestTransfer::sealChecksTheAnnouncedKind()
{
    Rig rig;
    QCOMPARE(rig.download(goodBank().registers(), 1, CTL_PROGRAM_KIND_POINT_CAM),
             CTL_TRANSFER_RESULT_BAD_HEADER);
    QCOMPARE(rig.read(CTL_REG_TRANSFER_RESULT_SESSION, 8)[4], CTL_OFFSET_BANK_KIND);
}

void TestTransfer::sealComparesRowsWithTheInputs_data()
{
    QTest::addColumn<Registers>("image");
    QTest::addColumn<unsigned>("offset");
    const Registers move = quinticMove(20'000, 50, 8'000'000).registers();
    QTest::newRow("position move by cam points") << move << unsigned{CTL_OFFSET_POSITION_MOVE_DISTANCE};
    QTest::newRow("position move by intervals")
        << trapezoidMove().registers() << unsigned{CTL_OFFSET_POSITION_MOVE_DISTANCE};
    QTest::newRow("backwards") << trapezoidMove(true).registers()
                               << unsigned{CTL_OFFSET_POSITION_MOVE_DISTANCE};
    const Registers press = PressImage().registers();
    QTest::newRow("end of approach") << press << unsigned{CTL_OFFSET_PRESS_APPROACH_POSITION};
    QTest::newRow("end of probing") << press << unsigned{CTL_OFFSET_PRESS_PROBE_END};
    QTest::newRow("end of pressing") << press << unsigned{CTL_OFFSET_PRESS_PRESS_POSITION};
}

// 100 mm a revolution of 10,000 pulses: a pulse is 10 um.
void TestTransfer::sealComparesRowsWithTheInputs()
{
    QFETCH(Registers, image);
    QFETCH(unsigned, offset);
    Rig rig;
    const std::uint32_t lengthUm = std::uint32_t{image.at(offset)} << 16 | image.at(offset + 1);
    const auto sealed = [&](std::uint32_t um) {
        image.at(offset) = static_cast<std::uint16_t>(um >> 16);
        image.at(offset + 1) = static_cast<std::uint16_t>(um & 0xFFFFu);
        return rig.download(image, 1);
    };
    QCOMPARE(sealed(lengthUm + 11), CTL_TRANSFER_RESULT_BAD_SUM);
    QCOMPARE(rig.read(CTL_REG_TRANSFER_RESULT_SESSION, 8)[4], offset);
    QCOMPARE(sealed(lengthUm - 11), CTL_TRANSFER_RESULT_BAD_SUM);
    QCOMPARE(sealed(0u - lengthUm), CTL_TRANSFER_RESULT_BAD_SUM);
    QCOMPARE(sealed(lengthUm), CTL_TRANSFER_RESULT_ACCEPTED);
}

void TestTransfer::sealComparesCyclesWithTheInputs_data()
{
    QTest::addColumn<Registers>("image");
    QTest::addColumn<unsigned>("offset");
    QTest::addColumn<quint32>("value");
    QTest::addColumn<int>("result");
    QTest::addColumn<unsigned>("detail");
    const auto row = [](const QByteArray& name, const Registers& image, unsigned offset, quint32 value,
                        int result, unsigned detail = 0) {
        QTest::newRow(name.constData()) << image << offset << value << result << detail;
    };
    const auto bad = [&](const char* name, const Registers& image, unsigned offset, quint32 value) {
        row(name, image, offset, value, CTL_TRANSFER_RESULT_BAD_SUM, offset);
    };
    CamImage cam = sineCam(10'000.0, 800.0, 100, 8'000'000);
    cam.knots = 5;
    const Registers points = cam.registers();
    constexpr int good = CTL_TRANSFER_RESULT_ACCEPTED;
    row("1 s a cycle, 60 r/min, 100 mm", points, CTL_OFFSET_CAM_SLAVE_SCALE, 1000, good);
    bad("0.1 mm more", points, CTL_OFFSET_CAM_SLAVE_SCALE, 1001);
    bad("as far backwards", points, CTL_OFFSET_CAM_SLAVE_SCALE, 0u - 1000);
    bad("farthest", points, CTL_OFFSET_CAM_SLAVE_SCALE, 0x80000000u);
    bad("1 us longer", points, CTL_OFFSET_CAM_MASTER_RATIO, 1'000'001);
    bad("1 us shorter", points, CTL_OFFSET_CAM_MASTER_RATIO, 999'999);
    bad("longest", points, CTL_OFFSET_CAM_MASTER_RATIO, 0xFFFFFFFFu);
    row("largest stretch", points, CTL_OFFSET_CAM_MASTER_SCALE, 0xFFFFFFFFu, CTL_TRANSFER_RESULT_BAD_SUM,
        CTL_OFFSET_CAM_MASTER_RATIO);
    row("no stretch", points, CTL_OFFSET_CAM_MASTER_SCALE, 0, CTL_TRANSFER_RESULT_BAD_SUM,
        CTL_OFFSET_CAM_MASTER_RATIO);
    cam.masterRate = 0;
    row("standing master", cam.registers(), CTL_OFFSET_CAM_SLAVE_SCALE, 1000, CTL_TRANSFER_RESULT_BAD_SUM,
        CTL_OFFSET_CAM_MASTER_RATE);

    // 0 to 200 mm/s in about 0.5 s: 50.12 mm. No slower than 100.1 mm/s on average, no faster than 100.3.
    for (const bool backwards : {false, true}) {
        const Registers ramp = rampAndHold(backwards).registers();
        const unsigned faster = CTL_OFFSET_SPEED_MOVE_END_SPEED;
        const unsigned slower = CTL_OFFSET_SPEED_MOVE_START_SPEED;
        const auto speed = [backwards](quint32 umPerS) { return backwards ? 0u - umPerS : umPerS; };
        const auto name = [backwards](const char* text) {
            return QByteArray(text) + (backwards ? ", backwards" : "");
        };
        row(name("speed within"), ramp, faster, speed(101'000), good);
        row(name("too slow an end"), ramp, faster, speed(99'000), CTL_TRANSFER_RESULT_BAD_SUM,
            backwards ? slower : faster);
        row(name("too fast a start"), ramp, slower, speed(101'000), CTL_TRANSFER_RESULT_BAD_SUM,
            backwards ? faster : slower);
    }
    const Registers move = speedMove(20'000, 50, 4'000'000).registers(); // 50 mm
    bad("distance not kept",
        withDuration(move, CTL_OFFSET_SPEED_MOVE_DURATION, CTL_MOVE_DURATION_OVER_DISTANCE),
        CTL_OFFSET_SPEED_MOVE_DISTANCE, 50'011);
    row("distance kept", withDuration(move, CTL_OFFSET_SPEED_MOVE_DURATION, CTL_MOVE_DURATION_OVER_DISTANCE),
        CTL_OFFSET_SPEED_MOVE_DISTANCE, 50'010, good);
    bad("speed's time not kept",
        withDuration(move, CTL_OFFSET_SPEED_MOVE_DURATION, CTL_MOVE_DURATION_GIVEN_TIME),
        CTL_OFFSET_SPEED_MOVE_TIME, 500'001);
    const Registers position = withDuration(quinticMove(20'000, 50, 8'000'000).registers(),
                                            CTL_OFFSET_POSITION_MOVE_DURATION, CTL_MOVE_DURATION_GIVEN_TIME);
    bad("time not kept", position, CTL_OFFSET_POSITION_MOVE_TIME, 999'999);
    row("time kept", position, CTL_OFFSET_POSITION_MOVE_TIME, 1'000'000, good);
}

void TestTransfer::sealComparesCyclesWithTheInputs()
{
    QFETCH(Registers, image);
    QFETCH(unsigned, offset);
    QFETCH(quint32, value);
    QFETCH(int, result);
    QFETCH(unsigned, detail);
    image.at(offset) = static_cast<std::uint16_t>(value >> 16);
    image.at(offset + 1) = static_cast<std::uint16_t>(value & 0xFFFFu);
    Rig rig;
    QCOMPARE(int{rig.download(image, 1)}, result);
    if (result != CTL_TRANSFER_RESULT_ACCEPTED)
        QCOMPARE(unsigned{rig.read(CTL_REG_TRANSFER_RESULT_SESSION, 8)[4]}, detail);
}

// A shorter program in a bank that held a longer one: what is left of that one is not shown.
void TestTransfer::activeBankReadsZeroBehindItsRows()
{
    Rig rig;
    const Registers shorter = camBank(10'000, 1, 1'600'000, 20).registers();
    rig.install(camBank(10'000, 1, 1'600'000, 60).registers(), 1);
    rig.install(camBank(10'000, 1, 1'600'000, 40).registers(), 2);
    rig.install(shorter, 3); // over the first one
    const auto size = static_cast<std::uint16_t>(shorter.size());
    QCOMPARE(rig.read(static_cast<std::uint16_t>(CTL_ACTIVE_BANK_BASE + size - 3u), 6),
             (Registers{shorter.at(size - 3u), shorter.at(size - 2u), shorter.at(size - 1u), 0, 0, 0}));
}

void TestTransfer::maxTable()
{
    Rig rig;
    const Registers image = camBank(1'000'000, 1, 80'000'000, CTL_ROW_CAPACITY).registers();
    QCOMPARE(rig.download(image), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE + static_cast<std::uint16_t>(image.size()) - 100, 100),
             Registers(image.end() - 100, image.end()));
}

void TestTransfer::applyRefusals()
{
    Rig rig;
    const Registers image = goodBank().registers();
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NOTHING_SEALED);
    rig.download(image, 9);
    QCOMPARE(rig.apply(image, 2, 9), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED, 8), CTL_REFUSAL_WRONG_SESSION);
    QCOMPARE(rig.command(CTL_COMMAND_APPLY_STAGED, 0, 9, crc32(image) ^ 1u), CTL_REFUSAL_WRONG_CHECKSUM);
    QCOMPARE(rig.command(CTL_COMMAND_CANCEL_APPLY), CTL_REFUSAL_NOT_ARMED);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 0u);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 9), CTL_REFUSAL_NONE); // at standstill: at once
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 1u);
}

void TestTransfer::armedBankIsLockedUntilCancelled()
{
    Rig rig;
    rig.install(camBank(10000, 1, 16'000'000));
    rig.command(CTL_COMMAND_START);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
    rig.run(300'000);
    const Registers image = goodBank().registers();
    QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED, 2), CTL_REFUSAL_NOT_STANDSTILL);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_ARMED);
    QCOMPARE(begin(rig, 3, 100).at(3), CTL_TRANSFER_RESULT_STATE_REFUSES);
    QCOMPARE(rig.command(CTL_COMMAND_CANCEL_APPLY), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_SEALED);
    rig.run(5'000'000);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_GENERATION), 1u);
    Registers other = image;
    other[CTL_OFFSET_PROGRAM_KNIFE_RADIUS + 1] = 1;
    QCOMPARE(rig.download(other, 4), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(other, CTL_APPLY_MODE_NEXT_CYCLE, 4), CTL_REFUSAL_MACHINE_DATA_DIFFERS);
}

void TestTransfer::commandIsCarriedOutOnce()
{
    Rig rig;
    const Registers command{42, CTL_COMMAND_SET_CLOCK, 0, 0, 1, 0};
    QCOMPARE(rig.write(CTL_REG_COMMAND_COUNTER, command), 0);
    rig.run(3'000'000);
    QCOMPARE(rig.write(CTL_REG_COMMAND_COUNTER, command), 0);
    QCOMPARE(rig.statusWide(CTL_REG_CLOCK_UNIX_TIME), 65536u + 3u);
    QCOMPARE(rig.status(CTL_REG_STATUS_COMMAND_COUNTER), 42);
    rig.write(CTL_REG_COMMAND_COUNTER, {43, CTL_COMMAND_START});
    QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4),
             (Registers{43, CTL_COMMAND_START, CTL_COMMAND_STATUS_REFUSED, CTL_REFUSAL_NO_ACTIVE_PROGRAM}));
    QCOMPARE(rig.command(CTL_COMMAND_NONE), CTL_REFUSAL_UNKNOWN_COMMAND);
}

void TestTransfer::singleRegistersCarryOutNothing_data()
{
    QTest::addColumn<bool>("ascending");
    QTest::newRow("counter first") << true;
    QTest::newRow("counter last") << false;
}

// The code of another command would be executed in one order, half a command in the other.
void TestTransfer::singleRegistersCarryOutNothing()
{
    QFETCH(bool, ascending);
    Rig rig;
    rig.install(goodBank());
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.write(CTL_REG_COMMAND_CODE, {CTL_COMMAND_START});
    std::uint16_t counter = rig.read(CTL_REG_RESULT_COUNTER, 1).at(0);
    for (const unsigned code : {CTL_COMMAND_STOP_AT_CYCLE_END, CTL_COMMAND_START, CTL_COMMAND_HOME}) {
        ++counter;
        if (ascending)
            rig.write(CTL_REG_COMMAND_COUNTER, {counter});
        rig.write(CTL_REG_COMMAND_CODE, {static_cast<std::uint16_t>(code)});
        if (!ascending)
            rig.write(CTL_REG_COMMAND_COUNTER, {counter});
        const Registers result = rig.read(CTL_REG_RESULT_COUNTER, 4);
        QCOMPARE(result[0], counter);
        QCOMPARE(result[3], CTL_REFUSAL_COMMAND_INCOMPLETE);
        QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
    }
}

void TestTransfer::shortPausesDoNotCrowd()
{
    Rig rig;
    BankImage bank = goodBank();
    bank.rows.push_back({0, 1});
    QCOMPARE(rig.download(bank.registers(), 1), CTL_TRANSFER_RESULT_ACCEPTED);
    bank.rows.push_back({0, 39});
    QCOMPARE(rig.download(bank.registers(), 2), CTL_TRANSFER_RESULT_BAD_ROW);
    bank.rows.back().ticks = 40;
    QCOMPARE(rig.download(bank.registers(), 3), CTL_TRANSFER_RESULT_ACCEPTED);
}

void TestTransfer::breakLeavesTheActiveProgram()
{
    Rig rig;
    rig.install(goodBank());
    const std::uint32_t crc = rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC);
    const Registers active = rig.read(CTL_ACTIVE_BANK_BASE, 120);
    begin(rig, 7, 184);
    rig.transfer(7, CTL_TRANSFER_OPERATION_BLOCK, 0, Registers(CTL_BLOCK_REGISTERS, 0xFFFF));
    rig.run(3'000'000);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc);
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 120), active);
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 0);
}

CAMPANEL_TEST(TestTransfer)

} // namespace test_transfer

#include "test_transfer.moc"
