// SPDX-License-Identifier: Apache-2.0
// A board with less than the panel may expect: what it announces, and what it refuses.
#include "base/ctl_crc.h"
#include "rig.h"
#include "tests/support/interval_image.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_board_bounds {

using namespace campanel::test;

class TestBoardBounds : public QObject {
    Q_OBJECT

private slots:
    void smallerBankIsAnnouncedAndKept();
    void fewerRowsAreAnnouncedAndKept();
    void layoutsCanBeLeftOut();
    void shortRowsInARowAreRefused();
    void longAnswersAreSummedUpInPieces();
};

void TestBoardBounds::smallerBankIsAnnouncedAndKept()
{
    Rig rig;
    const Registers image = camBank(10'000, 1, 1'600'000).registers();
    rig.core().board.config.bank_registers = static_cast<std::uint16_t>(image.size());
    QCOMPARE(rig.read(CTL_REG_IDENTITY_BANK_REGISTERS, 1).at(0), image.size());
    QCOMPARE(rig.download(image), CTL_TRANSFER_RESULT_ACCEPTED);
    rig.core().board.config.bank_registers = static_cast<std::uint16_t>(image.size() - 1);
    QCOMPARE(rig.read(CTL_REG_IDENTITY_BANK_REGISTERS, 1).at(0), image.size() - 1);
    const Registers begun = rig.transfer(
        2, CTL_TRANSFER_OPERATION_BEGIN, 0,
        {image.at(CTL_OFFSET_BANK_KIND), static_cast<std::uint16_t>(image.size()), CTL_MAP_MAJOR});
    QCOMPARE(begun.at(3), CTL_TRANSFER_RESULT_BAD_LENGTH);
}

void TestBoardBounds::fewerRowsAreAnnouncedAndKept()
{
    Rig rig;
    rig.core().board.config.row_capacity = 39;
    QCOMPARE(rig.read(CTL_REG_IDENTITY_ROW_CAPACITY, 1).at(0), 39);
    QCOMPARE(rig.download(camBank(10'000, 1, 1'600'000, 40).registers()), CTL_TRANSFER_RESULT_BAD_HEADER);
    QCOMPARE(rig.download(camBank(10'000, 1, 1'600'000, 38).registers(), 2), CTL_TRANSFER_RESULT_ACCEPTED);
}

void TestBoardBounds::layoutsCanBeLeftOut()
{
    Rig rig;
    const Registers intervals = trapezoidMove().registers();
    QCOMPARE(rig.download(intervals), CTL_TRANSFER_RESULT_ACCEPTED);
    const unsigned all = rig.read(CTL_REG_IDENTITY_TABLE_LAYOUTS, 1).at(0);
    QVERIFY((all >> CTL_TABLE_LAYOUT_INTERVALS & 1u) != 0);
    rig.core().board.config.table_layouts =
        static_cast<std::uint16_t>(all & ~(1u << CTL_TABLE_LAYOUT_INTERVALS));
    QCOMPARE(rig.read(CTL_REG_IDENTITY_TABLE_LAYOUTS, 1).at(0), rig.core().board.config.table_layouts);
    QCOMPARE(rig.download(intervals, 2), CTL_TRANSFER_RESULT_BAD_HEADER);
    QCOMPARE(rig.download(camBank(10'000, 1, 1'600'000).registers(), 3), CTL_TRANSFER_RESULT_ACCEPTED);
}

// Sixteen rows in a slice at most: a window of fifteen may not be shorter than a slice, over the boundary of
// the cycle too.
void TestBoardBounds::shortRowsInARowAreRefused()
{
    Rig rig;
    constexpr std::uint32_t slice = 2000; // ticks
    BankImage bank;
    for (int i = 0; i < 40; ++i)
        bank.rows.push_back({1, 40'000});
    bank.pulsesPerMotorRev = bank.cyclePulses();
    rig.core().board.config.max_rows_per_slice = 16;
    QCOMPARE(rig.download(bank.registers()), CTL_TRANSFER_RESULT_ACCEPTED);
    for (const unsigned at : {10u, 33u}) { // the second one goes on behind the boundary
        BankImage crowded = bank;
        for (unsigned i = 0; i < 15; ++i)
            crowded.rows[(at + i) % 40] = {1, slice / 15};
        rig.core().board.config.max_rows_per_slice = 16;
        QCOMPARE(rig.download(crowded.registers(), 2), CTL_TRANSFER_RESULT_BAD_ROW);
        rig.core().board.config.max_rows_per_slice = 0;
        QCOMPARE(rig.download(crowded.registers(), 3), CTL_TRANSFER_RESULT_ACCEPTED);
    }
}

// 255 bytes at 96 a call; meanwhile a newer request takes its place.
void TestBoardBounds::longAnswersAreSummedUpInPieces()
{
    Rig rig;
    rig.core().board.config.work_registers = 24;
    const Bytes longest = frame({1, 3, CTL_REG_ACTIVE >> 8, CTL_REG_ACTIVE & 0xFF, 0, 125});
    const Bytes shortest = frame({1, 3, 0, 0, 0, 1});
    const auto ask = [&](const Bytes& request) {
        ctl_receive(&rig.core(), request.data(), request.size(), rig.controller().nowUs());
        rig.run(2000);
    };
    Bytes answer(CTL_FRAME_BYTES);
    ask(longest);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{255});
    QCOMPARE(ctl_crc16(answer.data(), 255), std::uint16_t{0});
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    ask(longest);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    ask(shortest);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{7});
    QCOMPARE(ctl_crc16(answer.data(), 7), std::uint16_t{0});
}

CAMPANEL_TEST(TestBoardBounds)

} // namespace test_board_bounds

#include "test_board_bounds.moc"
