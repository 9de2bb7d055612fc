// SPDX-License-Identifier: Apache-2.0
// The answer among other bytes: it is found wherever it stands, and no other bytes are ever believed.
#include "modbus/line/answer_reader.h"
#include "modbus/line/crc16.h"
#include "modbus/map/function_codes.h"
#include "tests/profile/random_cases.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <random>

namespace test_answer_reader {

using namespace campanel::modbus;
using Bytes = std::vector<std::uint8_t>;

namespace {

constexpr std::uint8_t unit = 1;

Bytes withCrc(Bytes frame)
{
    const std::uint16_t crc = crc16(frame);
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    return frame;
}

Bytes operator+(Bytes left, const Bytes& right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

// A question for registers and its right answer. The first register of the answer is the tag.
struct Exchange {
    Bytes question;
    Bytes answer;
    AnswerForm form;
    AnswerReader::Proof isMine;
};

Exchange exchangeOf(std::uint8_t function, const std::vector<std::uint16_t>& registers)
{
    const auto count = static_cast<std::uint8_t>(registers.size());
    Exchange exchange;
    exchange.question =
        withCrc({unit, function, 0x01, 0x00, 0x00, count, 0x02, 0x00, 0x00, 0x01, 0x02,
                 static_cast<std::uint8_t>(registers[0] >> 8), static_cast<std::uint8_t>(registers[0])});
    exchange.answer = {unit, function, static_cast<std::uint8_t>(2 * count)};
    for (const std::uint16_t value : registers)
        exchange.answer = std::move(exchange.answer) +
                          Bytes{static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
    exchange.answer = withCrc(std::move(exchange.answer));
    exchange.form = {unit, function, exchange.answer.size()};
    exchange.isMine = [tag = registers[0], count](std::span<const std::uint8_t> data) {
        const auto answered = answeredRegisters(data);
        return answered.size() == count && answered[0] == tag;
    };
    return exchange;
}

Exchange someExchange()
{
    return exchangeOf(functionWriteAndRead, {0x1234, 7, 0, 0xFFFF, 0x0117, 42});
}

// The owner of the line sees of the bytes: the last piece, the skipped ones, and those behind.
struct Read {
    FrameVerdict verdict = FrameVerdict::Silence;
    Bytes frame;
    std::size_t skipped = 0;
    std::size_t behind = 0;
    bool isEchoing = false;
};

// Reads until the answer has come or the bytes end, in pieces of random size.
Read readFrom(const Exchange& exchange, const Bytes& line, unsigned seed = 1)
{
    std::minstd_rand random(seed);
    AnswerReader reader(exchange.question, exchange.form, exchange.isMine);
    Read read;
    const auto take = [&read](const AnswerReader::Piece& piece) {
        if (read.verdict == FrameVerdict::Foreign && piece.verdict == FrameVerdict::Silence)
            return true; // only a late answer came
        read.verdict = piece.verdict;
        read.frame.assign(piece.frame.begin(), piece.frame.end());
        read.skipped += piece.strays.size();
        return piece.verdict != FrameVerdict::Foreign;
    };
    std::size_t at = 0;
    const auto give = [&](std::size_t count) {
        const std::size_t given = std::min({count, line.size() - at, reader.space().size()});
        std::copy_n(line.begin() + static_cast<std::ptrdiff_t>(at), given, reader.space().begin());
        reader.take(given);
        at += given;
        return given > 0;
    };
    for (bool hasEnded = false; !hasEnded;) {
        if (const auto piece = reader.next())
            hasEnded = take(*piece);
        else if (!give(1 + random() % 40))
            hasEnded = take(reader.rest());
    }
    while (give(line.size())) {
    }
    read.behind = reader.unread().size();
    read.isEchoing = reader.isEchoing();
    return read;
}

// Damages a frame or puts bytes around it. What CRC-16 surely finds is left to the other kinds: it lets one
// of 65536 frames pass in which more than two bytes in a row were replaced, here and in any other master.
class Disturber {
public:
    explicit Disturber(unsigned seed)
        : m_random(seed)
    {
    }

    Bytes garbage(std::size_t most)
    {
        const std::size_t count = below(most + 1);
        const std::size_t kind = below(4);
        Bytes bytes(count, kind == 0 ? std::uint8_t{0x00} : std::uint8_t{0xFF});
        if (kind >= 2)
            std::ranges::generate(bytes, [this] { return static_cast<std::uint8_t>(m_random()); });
        if (kind == 3 && count >= 3) // begins like an answer
            std::ranges::copy(std::array<std::uint8_t, 3>{unit, functionWriteAndRead, 12}, bytes.begin());
        return bytes;
    }

    void damage(Bytes& frame)
    {
        const std::size_t at = below(frame.size());
        const auto place = frame.begin() + static_cast<std::ptrdiff_t>(at);
        switch (below(5)) {
        case 0: // truncated
            frame.resize(at);
            break;
        case 1: // bytes lost
            frame.erase(place, place + static_cast<std::ptrdiff_t>(
                                           std::min<std::size_t>(1 + below(8), frame.size() - at)));
            break;
        case 2: { // bytes put in
            const Bytes inside = garbage(8);
            frame.insert(place, inside.begin(), inside.end());
            break;
        }
        case 3: // up to three bits
            for (std::size_t i = 0; i <= below(3); ++i)
                frame[below(frame.size())] ^= static_cast<std::uint8_t>(1u << below(8));
            break;
        default: // two bytes in a row
            frame[at] = static_cast<std::uint8_t>(m_random());
            if (at + 1 < frame.size())
                frame[at + 1] = static_cast<std::uint8_t>(m_random());
            break;
        }
    }

    std::size_t below(std::size_t count) { return m_random() % count; }
    std::uint16_t word() { return static_cast<std::uint16_t>(m_random()); }

private:
    std::mt19937 m_random;
};

} // namespace

class AnswerReaderTest : public QObject {
    Q_OBJECT

private slots:
    void foundWhereverItStands_data()
    {
        QTest::addColumn<Bytes>("before");
        QTest::addColumn<Bytes>("behind");
        const Exchange exchange = someExchange();
        const Bytes late = withCrc({unit, 3, 2, 0, 5});
        QTest::newRow("alone") << Bytes{} << Bytes{};
        QTest::newRow("a zero before") << Bytes{0x00} << Bytes{};
        QTest::newRow("FF before") << Bytes{0xFF} << Bytes{};
        QTest::newRow("zeros behind") << Bytes{} << Bytes{0, 0, 0, 0};
        QTest::newRow("both") << Bytes{0xF8, 0x00} << Bytes{0x55, 0xAA};
        QTest::newRow("its own unit before") << Bytes{unit} << Bytes{unit};
        QTest::newRow("its own beginning before") << Bytes{unit, functionWriteAndRead, 12} << Bytes{};
        QTest::newRow("the beginning of a long frame before") << Bytes{unit, 3, 0xF0} << Bytes{};
        QTest::newRow("the first half of itself")
            << Bytes(exchange.answer.begin(), exchange.answer.begin() + 8) << Bytes{};
        QTest::newRow("an echo") << exchange.question << Bytes{};
        QTest::newRow("garbage, an echo, garbage")
            << Bytes{0x00} + exchange.question + Bytes{0xFF} << Bytes{};
        QTest::newRow("a late answer") << late << Bytes{};
        QTest::newRow("garbage, a late answer, garbage") << Bytes{0x00} + late + Bytes{0x80, 0x00} << Bytes{};
        QTest::newRow("400 bytes of noise") << Bytes(400, 0xFE) << Bytes(200, 0xFE);
    }

    void foundWhereverItStands()
    {
        QFETCH(const Bytes, before);
        QFETCH(const Bytes, behind);
        const Exchange exchange = someExchange();
        for (unsigned seed = 1; seed <= 50; ++seed) {
            const Read read = readFrom(exchange, before + exchange.answer + behind, seed);
            QCOMPARE(read.verdict, FrameVerdict::Answer);
            QCOMPARE(read.frame, exchange.answer);
            QCOMPARE(read.behind, behind.size());
        }
    }

    void theSkippedBytesAreCounted()
    {
        const Exchange exchange = someExchange();
        const Read read = readFrom(exchange, Bytes{0x00, 0xFF} + exchange.question + Bytes{0x80} +
                                                 exchange.answer + Bytes{0x00});
        QCOMPARE(read.skipped, std::size_t{3});
        QCOMPARE(read.behind, std::size_t{1});
        QVERIFY(read.isEchoing);
    }

    void whatIsNoAnswerIsNamed_data()
    {
        QTest::addColumn<Bytes>("line");
        QTest::addColumn<int>("verdict");
        const Exchange exchange = someExchange();
        const auto row = [](const char* tag, const Bytes& line, FrameVerdict verdict) {
            QTest::newRow(tag) << line << static_cast<int>(verdict);
        };
        Bytes damaged = exchange.answer;
        damaged[5] ^= 0x10;
        const auto withUnit = [&](std::uint8_t other) {
            Bytes frame(exchange.answer.begin(), exchange.answer.end() - 2);
            frame[0] = other;
            return withCrc(frame);
        };
        Bytes withTag(exchange.answer.begin(), exchange.answer.end() - 2);
        withTag[4] ^= 1;
        row("silence", {}, FrameVerdict::Silence);
        row("noise", {0xFF, 0x00, 0xF8}, FrameVerdict::Malformed);
        row("half", {exchange.answer.begin(), exchange.answer.begin() + 8}, FrameVerdict::Incomplete);
        row("damaged", damaged, FrameVerdict::BadChecksum);
        row("damaged after a zero", Bytes{0} + damaged, FrameVerdict::BadChecksum);
        row("another unit", withUnit(2), FrameVerdict::Foreign);
        row("another tag", withCrc(withTag), FrameVerdict::Foreign);
        row("exception", withCrc({unit, functionWriteAndRead | exceptionFlag, 6}), FrameVerdict::Exception);
        row("exception after FF", Bytes{0xFF} + withCrc({unit, functionWriteAndRead | exceptionFlag, 6}),
            FrameVerdict::Exception);
        row("exception of another function", withCrc({unit, 3 | exceptionFlag, 6}), FrameVerdict::Foreign);
    }

    void whatIsNoAnswerIsNamed()
    {
        QFETCH(const Bytes, line);
        QFETCH(const int, verdict);
        for (unsigned seed = 1; seed <= 50; ++seed)
            QCOMPARE(static_cast<int>(readFrom(someExchange(), line, seed).verdict), verdict);
    }

    // An answer whose data contains a whole exception: bytes of it must not end the waiting.
    void framesInsideTheAnswerAreNotTaken()
    {
        const Bytes inside = withCrc({unit, functionWriteAndRead | exceptionFlag, 2});
        const Exchange exchange =
            exchangeOf(functionWriteAndRead, {9, static_cast<std::uint16_t>(inside[0] << 8 | inside[1]),
                                              static_cast<std::uint16_t>(inside[2] << 8 | inside[3]),
                                              static_cast<std::uint16_t>(inside[4] << 8), 3});
        for (unsigned seed = 1; seed <= 200; ++seed)
            QCOMPARE(readFrom(exchange, exchange.answer, seed).frame, exchange.answer);
    }

    // Garbage before, behind, between and in the frames; lost, truncated and late ones. An answer with bytes
    // behind is not believed on a line that is not known for them.
    void noOtherBytesAreBelieved()
    {
        constexpr unsigned seed = 20261127;
        qInfo("seed %u", seed);
        Disturber disturber(seed);
        const int cases = campanel::test::randomCases();
        int wrong = 0;
        int right = 0;
        int intact = 0;
        int found = 0;
        for (int i = 0; i < cases; ++i) {
            std::vector<std::uint16_t> registers(1 + disturber.below(45));
            std::ranges::generate(registers, [&] { return disturber.word(); });
            const Exchange exchange = exchangeOf(functionWriteAndRead, registers);
            registers[0] = static_cast<std::uint16_t>(registers[0] + 1);
            Bytes late = exchangeOf(functionWriteAndRead, registers).answer;
            Bytes answer = exchange.answer;
            const bool isIntact = disturber.below(2) == 0;
            if (!isIntact)
                disturber.damage(disturber.below(4) == 0 ? late : answer);
            const Bytes between = disturber.below(2) == 0 ? late + disturber.garbage(12) : Bytes();
            const Bytes line = disturber.garbage(12) + between + answer + disturber.garbage(12);
            const Read read = readFrom(exchange, line, static_cast<unsigned>(i) + 1);
            intact += isIntact ? 1 : 0;
            if (read.verdict != FrameVerdict::Answer)
                continue;
            found += isIntact ? 1 : 0;
            right += read.frame == exchange.answer ? 1 : 0;
            wrong += read.frame != exchange.answer && read.behind == 0 ? 1 : 0;
        }
        qInfo("%d cases, %d answers right, %d of %d undamaged ones found", cases, right, found, intact);
        QCOMPARE(wrong, 0);
        QVERIFY2(found >= intact - intact / 1000, "undamaged answers are found");
    }
};

CAMPANEL_TEST(AnswerReaderTest)

} // namespace test_answer_reader

#include "test_answer_reader.moc"
