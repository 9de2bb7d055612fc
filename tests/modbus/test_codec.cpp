// SPDX-License-Identifier: Apache-2.0
// Codec, CRC-32, blocks, bank header and wire times against known values.
#include "modbus/line/wire_time.h"
#include "modbus/map/bank_header.h"
#include "modbus/map/blocks.h"
#include "modbus/map/codec.h"
#include "modbus/map/crc32.h"
#include "modbus/map/io_status.h"
#include "modbus/map/jam_status.h"
#include "modbus/map/measure_status.h"
#include "modbus/map/order_status.h"
#include "modbus/map/packer_status.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace test_codec {

using namespace campanel::modbus;

class CodecTest : public QObject {
    Q_OBJECT

private slots:
    void crcCheckValue();
    void numbers_data();
    void numbers();
    void refusedNumbers_data();
    void refusedNumbers();
    void text_data();
    void text();
    void everyRawValueSurvivesItsPhysicalForm();
    void statusUnknownsAreEmpty();
    void statusKnowns();
    void ioHasWhatIsAvailable();
    void packerGroupIsOneReading();
    void lastBagNumbersEnd();
    void burnedBagsAndKnives();
    void jammedBagsAreScrap();
    void jamGroup();
    void orderStatusIsDecoded();
    void nothingKnownOfJams();
    void measurementIsDecoded();
    void wireTimes_data();
    void wireTimes();
};

void CodecTest::crcCheckValue()
{
    const std::string digits = "123456789";
    const std::vector<std::uint8_t> bytes(digits.begin(), digits.end());
    QCOMPARE(crc32(bytes), 0xCBF43926u);
    const std::vector<std::uint16_t> registers{0x3132, 0x3334, 0x3536, 0x3738};
    const std::vector<std::uint8_t> same(digits.begin(), digits.begin() + 8);
    QCOMPARE(crc32OfRegisters(registers), crc32(same));
}

void CodecTest::numbers_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("value");
    QTest::addColumn<QList<int>>("registers");
    QTest::newRow("u16 plain") << "status.tag" << 65535.0 << QList<int>{0xFFFF};
    QTest::newRow("u16 hundredths") << "status.master_angle" << 359.99 << QList<int>{35999};
    QTest::newRow("i16 negative thousandths") << "status.bag_deviation" << -0.141 << QList<int>{0xFF73};
    QTest::newRow("u32 high word first") << "status.bag_length" << 250.123 << QList<int>{0x0003, 0xD10B};
    QTest::newRow("i32 negative") << "status.axis_position" << -2.0 << QList<int>{0xFFFF, 0xFFFE};
    QTest::newRow("u32 largest") << "status.generation" << 4294967295.0 << QList<int>{0xFFFF, 0xFFFF};
    QTest::newRow("rounds to nearest") << "program.k3" << 1.6666667 << QList<int>{0x0019, 0x6E6B};
}

void CodecTest::numbers()
{
    QFETCH(QString, name);
    QFETCH(double, value);
    QFETCH(QList<int>, registers);
    const RegisterInfo& info = registerNamed(name.toStdString());
    std::vector<std::uint16_t> held(info.count);
    QVERIFY(RegisterWriter(held, info.address).physical(info, value).has_value());
    for (int i = 0; i < registers.size(); ++i)
        QCOMPARE(static_cast<int>(held[static_cast<std::size_t>(i)]), registers[i]);
    const double readBack = RegisterReader(held, info.address).physical(info);
    QVERIFY(std::abs(readBack - value) <= info.scale / 2);
}

void CodecTest::refusedNumbers_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("value");
    QTest::newRow("not a number") << "status.tag" << std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("infinite") << "program.bag_length" << std::numeric_limits<double>::infinity();
    QTest::newRow("negative in u16") << "status.tag" << -1.0;
    QTest::newRow("too large for u16") << "program.gear_numerator" << 65536.0;
    QTest::newRow("too large for u32 thousandths") << "program.bag_length" << 4294967.297;
    QTest::newRow("too small for i16 thousandths") << "status.bag_deviation" << -32.8;
    QTest::newRow("above a writable limit") << "parameter.ramp_time" << 10001.0;
    QTest::newRow("below a writable limit") << "parameter.ramp_time" << 49.0;
}

void CodecTest::refusedNumbers()
{
    QFETCH(QString, name);
    QFETCH(double, value);
    const auto raw = toRaw(registerNamed(name.toStdString()), value);
    QVERIFY(!raw.has_value());
    const CodecError& error = raw.error();
    QVERIFY(error.registerName == name.toStdString());
    QVERIFY(!(error.value >= error.minimum && error.value <= error.maximum));
}

void CodecTest::text_data()
{
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("kept");
    QTest::newRow("empty") << ""
                           << "";
    QTest::newRow("odd length") << "Biscuit"
                                << "Biscuit";
    QTest::newRow("exactly 32 bytes") << QString(32, 'x') << QString(32, 'x');
    QTest::newRow("cut after 32 bytes") << QString(40, 'x') << QString(32, 'x');
    QTest::newRow("cut between characters") << QString::fromUtf8("饼干二百五十饼干二百五十") // 36 bytes
                                            << QString::fromUtf8("饼干二百五十饼干二百");
}

void CodecTest::text()
{
    QFETCH(QString, value);
    QFETCH(QString, kept);
    std::vector<std::uint16_t> bank(bankHeaderRegisters, 0xAAAA);
    RegisterWriter(bank, 0).text("program.recipe_name", value.toStdString());
    QCOMPARE(QString::fromStdString(RegisterReader(bank, 0).text("program.recipe_name")), kept);
    QCOMPARE(static_cast<int>(bank[47]), 0xAAAA);
}

void CodecTest::everyRawValueSurvivesItsPhysicalForm()
{
    for (const auto rows : {registers(), bankFields()}) {
        for (const RegisterInfo& info : rows) {
            if (info.type == RegisterType::Text || info.type == RegisterType::Block)
                continue;
            const bool wide = info.count == 2;
            const bool limited = info.access == Access::ReadWrite && info.maximum > info.minimum;
            const auto rawLimit = [&info](double limit) {
                return static_cast<std::int64_t>(std::llround(limit / info.scale));
            };
            const std::int64_t first = limited ? rawLimit(info.minimum) : 0;
            const std::int64_t last = limited ? rawLimit(info.maximum) : (wide ? 0x7FFFFFFF : 0x7FFF);
            for (std::int64_t raw = first; raw <= last; raw += 1 + (last / 997)) {
                const auto again = toRaw(info, toPhysical(info, raw));
                QVERIFY2(again.has_value(), info.name.data());
                QCOMPARE(*again, raw);
            }
        }
    }
}

void CodecTest::statusUnknownsAreEmpty()
{
    std::vector<std::uint16_t> block(statusRegisters, 0);
    block[4] = 1u << static_cast<unsigned>(WarningBit::NotHomed);
    block[2] = 99;
    const StatusBlock status = decodeStatus(block);
    QVERIFY(!status.state.has_value());
    QVERIFY(!status.activeCrc.has_value());
    QVERIFY(!status.savedCrc.has_value());
    QVERIFY(!status.masterAngleDeg.has_value());
    QVERIFY(!status.knifeAngleDeg.has_value());
    QVERIFY(!status.bagLengthMm.has_value());
    QVERIFY(!status.bagDeviationMm.has_value());
    QVERIFY(status.has(WarningBit::NotHomed));
    QVERIFY(!status.has(WarningBit::HeartbeatLost));
}

void CodecTest::statusKnowns()
{
    std::vector<std::uint16_t> block(statusRegisters, 0);
    RegisterWriter writer(block, statusAddress);
    const std::vector<std::pair<std::string_view, double>> values{{"status.state", 2},
                                                                  {"status.generation", 70000},
                                                                  {"status.active_crc", 0xDEADBEEF},
                                                                  {"status.master_angle", 180},
                                                                  {"status.bag_length", 250.05},
                                                                  {"status.bag_deviation", -0.05},
                                                                  {"status.following_error", -7},
                                                                  {"status.axis_position", -123456},
                                                                  {"status.knife_angle", 90.5}};
    for (const auto& [name, value] : values)
        QVERIFY2(writer.physical(name, value).has_value(), name.data());
    const StatusBlock status = decodeStatus(block);
    QCOMPARE(status.state, State::Running);
    QCOMPARE(status.generation, 70000u);
    QCOMPARE(status.activeCrc, 0xDEADBEEFu);
    QCOMPARE(status.masterAngleDeg, 180.0);
    QCOMPARE(status.bagLengthMm, 250.05);
    QCOMPARE(status.bagDeviationMm, -0.05);
    QCOMPARE(status.followingErrorPulses, std::int16_t{-7});
    QCOMPARE(status.axisPositionPulses, -123456);
    QCOMPARE(status.knifeAngleDeg, 90.5);
}

void CodecTest::ioHasWhatIsAvailable()
{
    std::vector<std::uint16_t> registers{0x000F, 0x0005, 0x0101, 0xFFFB, 0xFFFF, 0xFFFE, 0x0003, 9050};
    const IoStatus all = decodeIo(registers);
    QCOMPARE(all.level(InputBit::DriveAlarm), std::optional(true));
    QCOMPARE(all.level(InputBit::EmergencyStop), std::optional(false));
    QCOMPARE(all.level(InputBit::LimitForward), std::optional(true));
    QCOMPARE(all.level(OutputBit::Switch1), std::optional(true));
    QCOMPARE(all.level(OutputBit::Switch8), std::optional(false));
    QCOMPARE(all.level(OutputBit::DriveEnable), std::optional(true));
    QCOMPARE(all.torquePercent, std::optional(-0.5));
    QCOMPARE(all.torqueAngleDeg, std::optional(90.5));
    QCOMPARE(all.infeedPositionMm, std::optional(-0.002));
    QCOMPARE(all.infeedFollowingErrorMm, std::optional(0.003));
    QVERIFY(!all.isAxisKept && !all.isFilmKept && !all.isInfeedKept);
    // A controller of 1.5 has no further outputs.
    QVERIFY(!all.level(OutputBit::Ready) && !all.level(OutputBit::CoderPulse));
    QCOMPARE(std::size_t{ioRegisters(5)}, registers.size());
    QCOMPARE(ioRegisters(), std::uint16_t(ioRegisters(5) + 1));
    registers[2] = 0x8101;
    registers.push_back(0x0002);
    const IoStatus more = decodeIo(registers);
    QCOMPARE(more.level(OutputBit::Ready), std::optional(true));
    QCOMPARE(more.level(OutputBit::Request), std::optional(false));
    QCOMPARE(more.level(OutputBit::CoderPulse), std::optional(true));
    QCOMPARE(more.level(OutputBit::Switch1), std::optional(true));
    registers[0] = 0x0050;
    QVERIFY(decodeIo(registers).isAxisKept && !decodeIo(registers).isFilmKept);
    QVERIFY(decodeIo(registers).isInfeedKept);
    registers[0] = 0;
    QCOMPARE(decodeIo(registers), IoStatus());
    QVERIFY(!decodeIo(registers).level(InputBit::DriveAlarm));
}

// A panel reads as many registers of the film as the controller has.
void CodecTest::packerGroupIsOneReading()
{
    QCOMPARE(int{packerRegisters(5)}, 104);
    QVERIFY(packerRegisters() <= readbackRegisters);
}

// The number of a bag wraps after its 32 bits; a controller may say any.
void CodecTest::lastBagNumbersEnd()
{
    std::vector<std::uint16_t> registers(packerRegisters());
    const std::size_t at = registerNamed("packer.bag_number").address - packerAddress;
    registers[at] = 0xFFFF;
    registers[at + 1] = 0xFFFF;
    const PackerStatus packer = decodePacker(registers);
    QCOMPARE(packer.bags.size(), std::size_t{bagRecords});
    QCOMPARE(packer.bags.front().number, 0xFFFFFFFFu - bagRecords + 1);
    QCOMPARE(packer.bags.back().number, 0xFFFFFFFFu);
}

// A bag at closed jaws is scrap; a controller before map 1.6 names no knife.
void CodecTest::burnedBagsAndKnives()
{
    std::vector<std::uint16_t> registers(packerRegisters());
    const auto put = [&registers](std::string_view name, std::uint16_t value, std::size_t at = 0) {
        registers[registerNamed(name).address - packerAddress + at] = value;
    };
    put("packer.bag_number", 1, 1);
    put("packer.bags", 1u << 8 | RegisterInfo::bitOf(BagBit::Burned), 4 + 3);
    put("packer.knife", 2);
    put("packer.threading", 1);
    const PackerStatus packer = decodePacker(registers);
    QVERIFY(packer.bags.back().isBurned && packer.bags.back().isScrap());
    QCOMPARE(packer.knife, std::optional(2));
    QVERIFY(packer.isThreading);
    registers.resize(packerRegisters(5));
    QVERIFY(!decodePacker(registers).knife && !decodePacker(registers).isThreading);
}

void CodecTest::jammedBagsAreScrap()
{
    std::vector<std::uint16_t> registers(packerRegisters());
    registers[registerNamed("packer.bag_number").address - packerAddress + 1] = 1;
    registers[registerNamed("packer.bags").address - packerAddress + 4 + 3] =
        1u << 8 | RegisterInfo::bitOf(BagBit::Jammed);
    const BagRecord bag = decodePacker(registers).bags.back();
    QVERIFY(bag.isJammed && bag.isScrap() && !bag.isBurned);
}

void CodecTest::jamGroup()
{
    std::vector<std::uint16_t> registers(jamRegisters);
    const auto put = [&registers](std::string_view name, int value, std::size_t at = 0) {
        registers[registerNamed(name).address - jamAddress + at] = static_cast<std::uint16_t>(value);
    };
    put("jam.state", static_cast<int>(JamState::Learning));
    put("jam.cycles_left", 7);
    put("jam.interval", 100);
    put("jam.number", 3);
    put("jam.source", static_cast<int>(JamSource::TorqueLimit));
    put("jam.angle", -1234);
    put("jam.torque", 875);
    put("jam.limit", 412);
    put("jam.run_on", 560);
    put("jam.residue_number", 1, 0);
    put("jam.residue_number", 2, 1);
    put("jam.residue", -25);
    put("jam.band_from", -4500);
    put("jam.band_to", 500);
    put("jam.expected", -120, 0);
    put("jam.width", 31, 0);
    put("jam.expected", 300, 31);
    put("jam.width", 62, 31);

    const JamStatus jam = decodeJam(registers);
    QCOMPARE(jam.state, std::optional(JamState::Learning));
    QCOMPARE(jam.cyclesLeft, 7);
    QCOMPARE(jam.intervalMs, std::optional(1.0));
    QCOMPARE(jam.jams, 3);
    QCOMPARE(jam.last, std::optional(JamStatus::Jam{JamSource::TorqueLimit, -12.34, 87.5, 41.2, 5.6}));
    QCOMPARE(jam.residueNumber, 0x00010002u);
    QCOMPARE(jam.residuePercent, std::optional(-0.25));
    // 50 degrees in 32 parts; those without a width are not learned.
    QCOMPARE(jam.band.size(), std::size_t{2});
    QCOMPARE(jam.band.front(), (JamStatus::Part{-45 + 50.0 / 64, -12.0, 3.1}));
    QCOMPARE(jam.band.back(), (JamStatus::Part{5 - 50.0 / 64, 30.0, 6.2}));
}

void CodecTest::orderStatusIsDecoded()
{
    std::vector<std::uint16_t> registers(orderStatusRegisters);
    const auto put = [&registers](const char* name, std::uint16_t value, int part = 0) {
        const RegisterInfo* info = findRegister(name);
        QVERIFY(info != nullptr);
        registers.at(static_cast<std::size_t>(info->address - orderStatusAddress + part)) = value;
    };
    const std::string lot = "=1+1, L\xC3\xA4";
    put("order_status.state", static_cast<std::uint16_t>(OrderState::Active));
    put("order_status.number", 65535);
    put("order_status.action", static_cast<std::uint16_t>(OrderAction::Message));
    put("order_status.kept", 1);
    put("order_status.quantity", 0x000F);
    put("order_status.quantity", 0x4240, 1);
    put("order_status.good", 0x0001);
    put("order_status.rejected", 2, 1);
    put("order_status.empty", 3, 1);
    put("order_status.cut", 0x0001);
    put("order_status.cut", 6, 1);
    put("order_status.on_the_way", 1);
    const auto text = encodeOrderLot(lot);
    QVERIFY(text.has_value());
    QCOMPARE(text->at(0), std::uint16_t{0x3D31}); // "=1"
    std::ranges::copy(*text, registers.end() - orderLotRegisters);
    const OrderStatus expected{.state = OrderState::Active,
                               .number = 65535,
                               .action = OrderAction::Message,
                               .isKept = true,
                               .quantity = 1'000'000,
                               .good = 65536,
                               .rejected = 2,
                               .empty = 3,
                               .cut = 65542,
                               .onTheWay = 1,
                               .lot = lot};
    QVERIFY(decodeOrderStatus(registers) == expected);
    QCOMPARE(findRegister("order.lot")->address, orderLotAddress);
    // A lot that fills all registers has no end mark; a longer one is none.
    const std::string full(40, 'x');
    std::ranges::copy(*encodeOrderLot(full), registers.end() - orderLotRegisters);
    QVERIFY(decodeOrderStatus(registers).lot == full);
    QVERIFY(!encodeOrderLot(full + 'x'));
    registers[0] = 4; // of a later version
    QVERIFY(!decodeOrderStatus(registers).state);
}

void CodecTest::measurementIsDecoded()
{
    const std::vector<std::uint16_t> registers{2, 1, 5, 0, 0x000F, 0x9F05, 0, 650, 0x0012, 0x4F80, 0, 7};
    const MeasureStatus expected{MeasureState::Done, MeasuredAxis::Film, 5, Refusal::None, 10'237.49, 6.5,
                                 12'000.0, 7};
    QCOMPARE(decodeMeasure(registers), expected);
    QVERIFY(!decodeMeasure(std::vector<std::uint16_t>(measureRegisters)).bagPulses);
}

void CodecTest::nothingKnownOfJams()
{
    std::vector<std::uint16_t> registers(jamRegisters);
    QCOMPARE(decodeJam(registers).state, std::optional(JamState::Off));
    QVERIFY(!decodeJam(registers).intervalMs && !decodeJam(registers).last);
    QVERIFY(!decodeJam(registers).residuePercent && decodeJam(registers).band.empty());
    registers[0] = static_cast<std::uint16_t>(JamState::Armed) + 1; // of a later version
    QVERIFY(!decodeJam(registers).state);
}

void CodecTest::wireTimes_data()
{
    QTest::addColumn<unsigned>("baud");
    QTest::addColumn<char>("parity");
    QTest::addColumn<int>("stopBits");
    QTest::addColumn<double>("silenceUs");
    QTest::addColumn<double>("statusUs");
    // 106 characters, and the silence twice.
    QTest::newRow("115200 8N1") << 115200u << 'N' << 1 << 1750.0 << 12701.389;
    QTest::newRow("9600 8N1") << 9600u << 'N' << 1 << 3645.833 << 117708.333;
    QTest::newRow("19200 8E1") << 19200u << 'E' << 1 << 2005.208 << 64739.583;
    QTest::newRow("38400 8N2") << 38400u << 'N' << 2 << 1750.0 << 33864.583;
}

void CodecTest::wireTimes()
{
    QFETCH(unsigned, baud);
    QFETCH(char, parity);
    QFETCH(int, stopBits);
    QFETCH(double, silenceUs);
    QFETCH(double, statusUs);
    const LineSettings line{baud, static_cast<Parity>(parity), static_cast<std::uint8_t>(stopBits)};
    const auto microseconds = [](std::chrono::nanoseconds time) {
        return static_cast<double>(time.count()) / 1000.0;
    };
    QVERIFY(std::abs(microseconds(frameSilence(line)) - silenceUs) < 0.01);
    QVERIFY(std::abs(microseconds(pairTime(line, statusFrames)) - statusUs) < 0.01);
    // A download of one register more than a block needs a frame pair more.
    QCOMPARE(downloadTime(line, blockRegisters + 1) - downloadTime(line, blockRegisters),
             pairTime(line, transferFrames(1)));
}

CAMPANEL_TEST(CodecTest)

} // namespace test_codec

#include "test_codec.moc"
