// SPDX-License-Identifier: Apache-2.0
// The record of the line: it contains every byte, also dropped ones, and can be decoded as text.
#include "modbus/line/crc16.h"
#include "modbus/line/frame_text.h"
#include "modbus/line/rtu_client.h"
#include "modbus/map/codec.h"
#include "scripted_slave.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

namespace test_frames {

using namespace campanel::modbus;
using campanel::test::Fault;
using campanel::test::ScriptedSlave;

namespace {

FrameRecord recordOf(FrameVerdict verdict, const std::vector<std::uint8_t>& bytes)
{
    FrameLog log(1);
    log.add(verdict, bytes);
    return log.since(0).front();
}

QString sentenceOf(const FrameRecord& record)
{
    return QString::fromStdString(frameSentence(record));
}

} // namespace

class FramesTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_slave = std::make_unique<ScriptedSlave>();
        LinkSettings settings;
        settings.port = m_slave->port();
        settings.answerAllowance = std::chrono::milliseconds{400};
        m_client = std::make_unique<RtuClient>(settings);
        QVERIFY(m_client->open().has_value());
    }

    void ringKeepsTheLatestAndCountsOn()
    {
        FrameLog log(4);
        QVERIFY(log.since(0).empty());
        for (std::uint8_t i = 1; i <= 10; ++i)
            log.add(FrameVerdict::Drained, std::array{i});
        const auto kept = log.since(0);
        QCOMPARE(kept.size(), std::size_t{4});
        for (std::size_t i = 0; i < kept.size(); ++i) {
            QCOMPARE(kept[i].number, std::uint64_t{7 + i});
            QCOMPARE(kept[i].bytes().front(), static_cast<std::uint8_t>(7 + i));
        }
        QCOMPARE(log.since(9).size(), std::size_t{1});
        QVERIFY(log.since(10).empty());
    }

    void longNoiseBecomesSeveralRecords()
    {
        FrameLog log(8);
        std::vector<std::uint8_t> noise(600, 0x55);
        noise.back() = 0xAA;
        log.add(FrameVerdict::Drained, noise);
        const auto kept = log.since(0);
        QCOMPARE(kept.size(), std::size_t{3});
        QCOMPARE(kept[2].length, std::uint16_t{600 - 2 * 256});
        QCOMPARE(kept[2].bytes().back(), std::uint8_t{0xAA});
    }

    void statusExchangeReadsInWords()
    {
        m_slave->setRegister(registerNamed("status.state").address,
                             static_cast<std::uint16_t>(State::Running));
        m_slave->setRegister(registerNamed("status.master_angle").address, 1234);
        QVERIFY(m_client->exchangeStatus(77, 1).has_value());
        const auto frames = m_client->record().frames.since(0);
        QCOMPARE(frames.size(), std::size_t{2});
        QVERIFY(frames[0].isSent());
        QCOMPARE(
            frames[0].length,
            std::uint16_t{writeReadFrames(3, statusRegisters).requestBytes}); // no permit: not identified
        const QString question = sentenceOf(frames[0]);
        QVERIFY2(question.contains("read and write, wants 40 registers from 0x0100 (status.tag)"),
                 qPrintable(question));
        QVERIFY2(question.contains("exchange.heartbeat = 77, exchange.jog = Forward"), qPrintable(question));
        QCOMPARE(frames[1].verdict, FrameVerdict::Answer);
        QCOMPARE(frames[1].length, std::uint16_t{statusFrames.answerBytes});
        const QString answer = sentenceOf(frames[1]);
        QVERIFY2(answer.contains("status.state = Running"), qPrintable(answer));
        QVERIFY2(answer.contains("status.master_angle = 12.34 deg"), qPrintable(answer));
    }

    void readBackHasTheNamesOfWhatWasRead()
    {
        m_slave->setRegister(registerNamed("parameter.ramp_time").address, 800);
        const auto span = *findSpan("parameter.ramp_time");
        QVERIFY(m_client->readProven(span.address, span.count).has_value());
        const QString answer = sentenceOf(m_client->record().frames.since(0).back());
        QVERIFY2(answer.endsWith("parameter.ramp_time = 800 ms"), qPrintable(answer));
    }

    void everyDoubtIsRecordedWithItsBytes_data()
    {
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("verdict");
        QTest::addColumn<int>("length");
        const auto row = [](const char* tag, Fault fault, FrameVerdict verdict, int length) {
            QTest::newRow(tag) << static_cast<int>(fault) << static_cast<int>(verdict) << length;
        };
        row("request lost", Fault::LostRequest, FrameVerdict::Silence, 0);
        row("wrong CRC", Fault::BadChecksum, FrameVerdict::BadChecksum, statusFrames.answerBytes);
        row("truncated", Fault::Truncated, FrameVerdict::Incomplete, statusFrames.answerBytes / 2);
        row("exception", Fault::Exception2, FrameVerdict::Exception, 5);
    }

    void everyDoubtIsRecordedWithItsBytes()
    {
        QFETCH(int, fault);
        QFETCH(int, verdict);
        QFETCH(int, length);
        m_slave->script({static_cast<Fault>(fault)});
        QVERIFY(!m_client->exchangeStatus(1, 0).has_value());
        const FrameRecord last = m_client->record().frames.since(0).back();
        QCOMPARE(static_cast<int>(last.verdict), verdict);
        QCOMPARE(static_cast<int>(last.length), length);
        const LinkFigures& figures = m_client->record().figures;
        QCOMPARE(figures.requests(), std::uint64_t{1});
        QCOMPARE(figures.answers(), std::uint64_t{0});
        QCOMPARE(figures.receivedBytes(), static_cast<std::uint64_t>(length));
        QCOMPARE(figures.drains(), std::uint64_t{1});
        // A repetition is a retry.
        QVERIFY(m_client->exchangeStatus(2, 0).has_value());
        QCOMPARE(m_client->record().figures.retries(), std::uint64_t{1});
        QVERIFY(m_client->exchangeStatus(3, 0).has_value());
        QCOMPARE(m_client->record().figures.retries(), std::uint64_t{1});
    }

    void lateAnswerIsShownAsDropped()
    {
        m_slave->script({Fault::LateAnswer});
        QVERIFY(!m_client->exchangeStatus(1, 0).has_value());
        QVERIFY(m_client->exchangeStatus(2, 0).has_value());
        std::vector<FrameVerdict> verdicts;
        for (const FrameRecord& record : m_client->record().frames.since(0))
            verdicts.push_back(record.verdict);
        const std::vector<FrameVerdict> expected{FrameVerdict::Sent, FrameVerdict::Silence,
                                                 FrameVerdict::Sent, FrameVerdict::Foreign,
                                                 FrameVerdict::Answer};
        QCOMPARE(verdicts, expected);
        const QString text = QString::fromStdString(framesText(m_client->record().frames.since(0)));
        QVERIFY(text.contains("dropped: response to another request: unit 1, read and write"));
        QVERIFY(text.contains("response timeout"));
        QCOMPARE(m_client->record().figures.errors(LinkErrorKind::ForeignAnswer), 0u);
        QCOMPARE(m_client->record().figures.droppedBytes(),
                 static_cast<std::uint64_t>(statusFrames.answerBytes));
    }

    void commandIsNeverARetry()
    {
        QVERIFY(m_client->exchangeStatus(1, 0).has_value());
        m_slave->script({Fault::LostRequest});
        QVERIFY(!m_client->command(Command::Start).has_value());
        QVERIFY(m_client->command(Command::Start).has_value());
        QCOMPARE(m_client->record().figures.retries(), std::uint64_t{0});
        QCOMPARE(m_slave->commandsExecuted(), 1);
    }

    void bytesThatAreNoFrameAreNotDecoded()
    {
        QVERIFY(!decodeFrame(recordOf(FrameVerdict::Drained, {1, 3, 2, 0, 5, 0x78, 0x47})).unit);
        QVERIFY(!decodeFrame(recordOf(FrameVerdict::BadChecksum, {1, 3, 2, 0, 5, 0, 0})).unit);
        QCOMPARE(sentenceOf(recordOf(FrameVerdict::Malformed, {0xFF, 0xFE, 0xFD})),
                 QString("dropped: invalid frame, 3 bytes"));
        QCOMPARE(sentenceOf(recordOf(FrameVerdict::Silence, {})), QString("response timeout"));
        std::vector<std::uint8_t> exception{1, 0x97, 2};
        const std::uint16_t crc = crc16(exception);
        exception.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
        exception.push_back(static_cast<std::uint8_t>(crc >> 8));
        QCOMPARE(sentenceOf(recordOf(FrameVerdict::Exception, exception)),
                 QString("exception: unit 1, read and write, 2 illegal register address"));
    }

    void namedValuesCoverEveryRegisterOnce()
    {
        const std::vector<std::uint16_t> registers(0x400, 0);
        for (const std::uint16_t base : {std::uint16_t{0}, activeBankBase, stagedBankBase}) {
            std::size_t at = base;
            for (const NamedValue& value : namedValues(base, registers)) {
                QCOMPARE(std::size_t{value.address}, at);
                at += value.count;
                QVERIFY(!value.text().empty() && !value.name().empty());
            }
            QCOMPARE(at, base + registers.size());
        }
        QCOMPARE(findSpan("bank.row_count")->address,
                 activeBankBase + registerNamed("bank.row_count").address);
        QVERIFY(!findSpan("no.such"));
    }

    void namedValuesGoBeyondTheLastAddress()
    {
        const std::vector<std::uint16_t> registers{1, 2, 3, 4};
        std::vector<std::int64_t> raw;
        for (const NamedValue& value : namedValues(0xFFFE, registers))
            raw.push_back(value.raw);
        QCOMPARE(raw, (std::vector<std::int64_t>{1, 2, 3, 4}));
    }

    void namedValuesDependOnTheProgram()
    {
        std::vector<std::uint16_t> status(statusRegisters, 0);
        const auto names = [&status] {
            QStringList result;
            for (const NamedValue& value : namedValues(statusAddress, status))
                result << QString::fromStdString(value.name());
            return result;
        };
        status[registerNamed("status.program_kind").address - statusAddress] =
            static_cast<std::uint16_t>(ProgramKind::Press);
        QVERIFY(names().contains("status.press_force") && !names().contains("status.bag_length"));
        status[registerNamed("status.program_kind").address - statusAddress] =
            static_cast<std::uint16_t>(ProgramKind::RotaryCutter);
        QVERIFY(names().contains("status.bag_length") && !names().contains("status.press_force"));
        // A damaged word whose lowest bits are those of a kind.
        status[registerNamed("status.program_kind").address - statusAddress] =
            32 + static_cast<std::uint16_t>(ProgramKind::Press);
        QVERIFY(!names().contains("status.bag_length") && !names().contains("status.press_force"));
    }

private:
    std::unique_ptr<ScriptedSlave> m_slave;
    std::unique_ptr<RtuClient> m_client;
};

CAMPANEL_TEST(FramesTest)

} // namespace test_frames

#include "test_frames.moc"
