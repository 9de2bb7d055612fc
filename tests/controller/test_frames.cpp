// SPDX-License-Identifier: Apache-2.0
// The RTU slave: known frames, exceptions, broadcast, damaged and random frames.
#include "base/ctl_crc.h"
#include "base/ctl_limits.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstring>
#include <random>

namespace test_frames {

using namespace campanel::test;

namespace {

// Returns the memory that a write would change.
std::string memoryOf(const ctl_core& core)
{
    return std::string(reinterpret_cast<const char*>(&core.written), sizeof core.written) +
           std::string(reinterpret_cast<const char*>(core.command_result), sizeof core.command_result) +
           std::string(reinterpret_cast<const char*>(core.banks.bank), sizeof core.banks.bank);
}

Bytes hex(const char* text)
{
    const QByteArray bytes = QByteArray::fromHex(text);
    return Bytes(bytes.begin(), bytes.end());
}

} // namespace

class TestFrames : public QObject {
    Q_OBJECT

private slots:
    void knownChecksums();
    void knownFrames_data();
    void knownFrames();
    void refusals_data();
    void refusals();
    void ignoresOtherUnits();
    void executesBroadcastsWithoutAnAnswer();
    void endsAFrameOnlyAfterTheSilence();
    void noiseBeforeARequestEndsWithTheSilence_data();
    void noiseBeforeARequestEndsWithTheSilence();
    void countsErrors();
    void readWriteWritesFirst();
    void refusedReadWriteChangesNothing();
    void longestFrames();
    void randomFramesChangeNothing();
    void randomRequestsKeepTheParametersValid();
};

// Values of the CRC catalogues and of the Modbus serial line specification (02 07 -> 41 12).
void TestFrames::knownChecksums()
{
    const Bytes digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    QCOMPARE(ctl_crc16(digits.data(), digits.size()), std::uint16_t{0x4B37});
    QCOMPARE(~ctl_crc32_bytes(CTL_CRC32_START, digits.data(), digits.size()), 0xCBF43926u);
    const Bytes specified{0x02, 0x07};
    QCOMPARE(ctl_crc16(specified.data(), specified.size()), std::uint16_t{0x1241});
}

void TestFrames::knownFrames_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<QString>("answer");
    QTest::newRow("read device type") << "010300000001840a"
                                      << "010302ca3d2f35";
    QTest::newRow("write heartbeat timeout") << "010600800bb88f60"
                                             << "010600800bb88f60";
    QTest::newRow("unknown function") << "010741e2"
                                      << "0187018230";
    QTest::newRow("another unit") << "1103006b00037687"
                                  << "";
}

void TestFrames::knownFrames()
{
    QFETCH(QString, request);
    QFETCH(QString, answer);
    Rig rig;
    const Bytes raw = hex(request.toLatin1());
    QCOMPARE(rig.exchange(raw), hex(answer.toLatin1()));
}

void TestFrames::refusals_data()
{
    QTest::addColumn<QString>("content");
    QTest::addColumn<int>("exception");
    QTest::newRow("function 1") << "010100000001" << 1;
    QTest::newRow("function 4") << "010400000001" << 1;
    QTest::newRow("function 43") << "012b0e0100" << 1;
    QTest::newRow("read hole") << "010300500001" << 2;
    QTest::newRow("read into hole") << "010300100010" << 2;
    QTest::newRow("read none") << "010300000000" << 3;
    QTest::newRow("read 126") << "01034000007e" << 3;
    QTest::newRow("read past the end") << "0103ffff0002" << 2;
    QTest::newRow("read without count") << "01030000" << 3;
    QTest::newRow("write identity") << "010600000001" << 2;
    QTest::newRow("write status") << "010601020003" << 2;
    QTest::newRow("write active bank") << "010640000001" << 2;
    QTest::newRow("write staged bank") << "010680000001" << 2;
    QTest::newRow("write result") << "010602300001" << 2;
    QTest::newRow("write hole") << "010602100001" << 2;
    QTest::newRow("heartbeat timeout too short") << "010600800001" << 3;
    QTest::newRow("lost action unknown") << "010600810002" << 3;
    QTest::newRow("jog keys unknown") << "010602020004" << 3;
    QTest::newRow("write 0") << "01100200000000" << 3;
    QTest::newRow("write byte count") << "011002000001030001" << 3;
    QTest::newRow("write cut short") << "0110020000020400010002"
                                        "00"
                                     << 3;
    QTest::newRow("write beyond the group") << "0110020300020400000000" << 2;
    QTest::newRow("read-write none") << "0117010000000200000102"
                                        "0001"
                                     << 3;
    QTest::newRow("read-write wrong size") << "01170100000102000001"
                                              "0400010001"
                                           << 3;
}

void TestFrames::refusals()
{
    QFETCH(QString, content);
    QFETCH(int, exception);
    Rig rig;
    const std::string before = memoryOf(rig.core());
    const Bytes request = hex(content.toLatin1());
    const auto function = static_cast<std::uint8_t>(request[1] | 0x80u);
    QCOMPARE(rig.exchange(frame(request)), frame({1, function, static_cast<std::uint8_t>(exception)}));
    QVERIFY(memoryOf(rig.core()) == before);
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_EXCEPTIONS), 1);
}

void TestFrames::ignoresOtherUnits()
{
    Rig rig;
    const std::string before = memoryOf(rig.core());
    for (int unit = 2; unit < 256; ++unit)
        QVERIFY(rig.exchange(frame({static_cast<std::uint8_t>(unit), 6, 2, 0, 0, 9})).empty());
    QVERIFY(memoryOf(rig.core()) == before);
}

void TestFrames::executesBroadcastsWithoutAnAnswer()
{
    Rig rig;
    QVERIFY(rig.exchange(frame({0, 6, 2, 0, 0x12, 0x34})).empty());
    QCOMPARE(rig.status(CTL_REG_STATUS_TAG), 0x1234);
}

void TestFrames::endsAFrameOnlyAfterTheSilence()
{
    Rig rig;
    const Bytes request = frame({1, 3, 0, 0, 0, 1});
    // In two halves 1.5 ms apart it is one frame ...
    ctl_receive(&rig.core(), request.data(), 3, rig.controller().nowUs());
    rig.run(1500);
    ctl_receive(&rig.core(), request.data() + 3, request.size() - 3, rig.controller().nowUs());
    Bytes answer(CTL_FRAME_BYTES);
    rig.run(1500);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    rig.run(250);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{7});
    // ... 1.75 ms apart it is two bad ones, also without a call in between.
    ctl_receive(&rig.core(), request.data(), 3, rig.controller().nowUs());
    ctl_receive(&rig.core(), request.data() + 3, request.size() - 3, rig.controller().nowUs() + 1750);
    rig.run(4000);
    QCOMPARE(ctl_take_answer(&rig.core(), answer.data()), std::size_t{0});
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_FRAME_ERRORS), 1);
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_CRC_ERRORS), 1);
}

// Bytes before a request spoil it when they touch it; 3.5 characters of silence part them. The next request
// is answered in either case.
void TestFrames::noiseBeforeARequestEndsWithTheSilence_data()
{
    QTest::addColumn<Bytes>("noise");
    QTest::newRow("a zero") << Bytes{0x00};
    QTest::newRow("FF") << Bytes{0xFF};
    QTest::newRow("its own unit") << Bytes{0x01};
    QTest::newRow("the beginning of a request") << Bytes{1, 16, 0x02, 0x00, 0x00, 0x7B};
    QTest::newRow("a whole buffer") << Bytes(256, 0xF8);
    QTest::newRow("more than a buffer") << Bytes(700, 0x00);
}

void TestFrames::noiseBeforeARequestEndsWithTheSilence()
{
    QFETCH(const Bytes, noise);
    Rig rig;
    const Bytes request = frame({1, 3, 0, 0, 0, 1});
    const auto receive = [&rig](const Bytes& bytes) {
        ctl_receive(&rig.core(), bytes.data(), bytes.size(), rig.controller().nowUs());
    };
    receive(noise);
    rig.run(2000);
    QCOMPARE(rig.exchange(request).size(), std::size_t{7});
    receive(noise);
    QVERIFY(rig.exchange(request).empty());
    QCOMPARE(rig.exchange(request).size(), std::size_t{7});
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_CRC_ERRORS) + rig.status(CTL_REG_STATUS_LINK_FRAME_ERRORS), 2);
}

void TestFrames::countsErrors()
{
    Rig rig;
    Bytes bad = frame({1, 3, 0, 0, 0, 1});
    bad.back() = static_cast<std::uint8_t>(bad.back() ^ 1u);
    QVERIFY(rig.exchange(bad).empty());
    QVERIFY(rig.exchange({1, 3}).empty());
    QVERIFY(rig.exchange(Bytes(257, 1)).empty());
    QVERIFY(rig.exchange(Bytes(3000, 1)).empty());
    ctl_receive_error(&rig.core(), rig.controller().nowUs());
    QVERIFY(rig.exchange(frame({1, 3, 0, 0, 0, 1})).empty());
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_CRC_ERRORS), 1);
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_FRAME_ERRORS), 4);
    QCOMPARE(rig.status(CTL_REG_STATUS_LINK_REQUESTS), 2);
}

void TestFrames::readWriteWritesFirst()
{
    Rig rig;
    const Registers block = rig.readWrite(CTL_REG_STATUS_TAG, 40, CTL_REG_EXCHANGE_TAG, {0xBEEF, 7, 0});
    QCOMPARE(block.size(), std::size_t{40});
    QCOMPARE(block[0], 0xBEEF);
    QCOMPARE(block[1], 7);
}

void TestFrames::refusedReadWriteChangesNothing()
{
    Rig rig;
    const std::string before = memoryOf(rig.core());
    QVERIFY(rig.readWrite(0x0050, 1, CTL_REG_EXCHANGE_TAG, {1, 2, 0}).empty());
    QVERIFY(rig.readWrite(CTL_REG_STATUS_TAG, 1, CTL_REG_EXCHANGE_TAG, {1, 2, 4}).empty());
    QVERIFY(memoryOf(rig.core()) == before);
}

void TestFrames::longestFrames()
{
    Rig rig;
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 125).size(), std::size_t{125});
    const Registers whole(4 + CTL_BLOCK_REGISTERS, 0);
    QCOMPARE(rig.write(CTL_REG_TRANSFER_SESSION, whole), 0);
    QCOMPARE(rig.readWrite(CTL_REG_TRANSFER_RESULT_SESSION, 8, CTL_REG_TRANSFER_SESSION, whole).size(),
             std::size_t{8});
}

void TestFrames::randomFramesChangeNothing()
{
    constexpr std::uint64_t seed = 20240501;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    Rig rig;
    const std::string before = memoryOf(rig.core());
    std::uint64_t nowUs = rig.controller().nowUs();
    for (int i = 0; i < 100'000; ++i) {
        Bytes raw(1 + random() % 300);
        for (std::uint8_t& byte : raw)
            byte = static_cast<std::uint8_t>(random());
        if (i % 2 == 0) { // looks like a write for this unit; only the CRC-16 is wrong
            raw = {1,
                   16,
                   2,
                   0,
                   0,
                   1,
                   2,
                   static_cast<std::uint8_t>(random()),
                   static_cast<std::uint8_t>(random())};
            raw = frame(raw);
            raw[random() % raw.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
        }
        nowUs += 2000;
        ctl_receive(&rig.core(), raw.data(), raw.size(), nowUs);
    }
    rig.controller().runTo(nowUs + 2000);
    QVERIFY(memoryOf(rig.core()) == before);
    QCOMPARE(rig.core().motion.state, CTL_STATE_IDLE);
}

void TestFrames::randomRequestsKeepTheParametersValid()
{
    constexpr std::uint64_t seed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    Rig rig;
    const std::uint8_t functions[] = {3, 6, 16, 23};
    const std::uint16_t bases[] = {0x0000, 0x0080, 0x0100, 0x0200, 0x0220,
                                   0x0240, 0x0300, 0x4000, 0x8000, 0xFFFE};
    std::uint64_t nowUs = rig.controller().nowUs();
    int answered = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::uint8_t function = functions[random() % 4];
        const auto address = static_cast<std::uint16_t>(bases[random() % 10] + random() % 12);
        const std::size_t count = 1 + random() % 12;
        const auto high = static_cast<std::uint8_t>(address >> 8);
        const auto low = static_cast<std::uint8_t>(address & 0xFF);
        Bytes content{1, function, high, low, 0, static_cast<std::uint8_t>(function == 6 ? random() : count)};
        if (function == 23)
            content.insert(content.end(),
                           {2, static_cast<std::uint8_t>(random() % 5), 0, static_cast<std::uint8_t>(count)});
        if (function >= 16) {
            content.push_back(static_cast<std::uint8_t>(2 * count));
            for (std::size_t byte = 0; byte < 2 * count; ++byte)
                content.push_back(random() % 3 == 0 ? static_cast<std::uint8_t>(random()) : std::uint8_t{0});
        }
        const Bytes raw = frame(content);
        nowUs += 2000;
        ctl_receive(&rig.core(), raw.data(), raw.size(), nowUs);
        ctl_receive_silence(&rig.core(), nowUs + 1750);
        Bytes answer(CTL_FRAME_BYTES);
        answered += ctl_take_answer(&rig.core(), answer.data()) > 0 ? 1 : 0;
        QVERIFY(ctl_parameters_valid(rig.core().written.parameter));
    }
    QCOMPARE(answered, 100'000);
}

CAMPANEL_TEST(TestFrames)

} // namespace test_frames

#include "test_frames.moc"
