// SPDX-License-Identifier: Apache-2.0
// The sentences for the errors of profile, modbus and program: what is wrong, by how much, and what to do.
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/doctor_sentences.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/panel/words/register_words.h"
#include "profile/cutter/limits.h"
#include "profile/intervals/intervals.h"
#include "profile/press/press.h"
#include "tests/profile/recipes.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QTest>

namespace test_sentences {

using namespace campanel;
using modbus::LineCondition;
using panel::ConnectionSentences;
using panel::DoctorSentences;
using panel::RefusalSentences;
using profile::Field;
using profile::Limit;
using profile::Refusal;

namespace {

bool isWhole(const QString& text)
{
    static const QRegularExpression place(QStringLiteral("%[0-9]"));
    return text.size() > 20 && !text.front().isLower() && text.endsWith(u'.') && !text.contains(place);
}

QString sentenceOf(const profile::test::Recipe& recipe)
{
    const auto solved = profile::solve(recipe.program, recipe.machine);
    return RefusalSentences::withSuggestions(solved ? profile::checkLimits(*solved).at(0) : solved.error());
}

} // namespace

class TestSentences : public QObject {
    Q_OBJECT

private slots:
    // "Knot 3 is only 0° after the previous knot", "at 90° must come after 90°".
    void numbersOfASentenceDiffer_data()
    {
        QTest::addColumn<double>("actual");
        QTest::addColumn<double>("allowed");
        QTest::addRow("a small difference") << 90.00004 << 90.00008;
        QTest::addRow("nearly nothing") << 0.00004 << 0.001;
        QTest::addRow("a large number") << 3000.0003 << 3000.0;
        QTest::addRow("a negative one") << -0.00002 << 0.0;
    }

    void numbersOfASentenceDiffer()
    {
        QFETCH(double, actual);
        QFETCH(double, allowed);
        // Sentences about whole numbers, or without the number.
        const QList<Limit> without{Limit::FieldRange,  Limit::NoMotion,     Limit::PinnedPair,
                                   Limit::LawUnknown,  Limit::RowCapacity,  Limit::TooFewPulses,
                                   Limit::KnotCount,   Limit::SegmentCount, Limit::TableRange,
                                   Limit::Reversal,    Limit::WrapJump,     Limit::SegmentMotion,
                                   Limit::DistanceSign};
        for (int i = 0; i <= static_cast<int>(Limit::RampTooLong); ++i) {
            Refusal refusal;
            refusal.limit = static_cast<Limit>(i);
            if (without.contains(refusal.limit))
                continue;
            refusal.field = Field::MaxMotorRpm;
            refusal.unit = "mm";
            refusal.lawParameter = refusal.limit == Limit::LawParameter ? "k" : "speed";
            refusal.index = 3;
            refusal.timeS = 0.5;
            refusal.angleDeg = 90;
            refusal.allowed = allowed;
            refusal.actual = actual;
            const QString one = RefusalSentences::refusal(refusal);
            refusal.actual = allowed;
            QVERIFY2(one != RefusalSentences::refusal(refusal), qPrintable(one));
        }
    }

    void aSmallDistanceIsNotZero()
    {
        Refusal refusal;
        refusal.limit = Limit::KnotSpacing;
        refusal.unit = "°";
        refusal.index = 2;
        refusal.actual = 0.0004;
        refusal.allowed = 0.1;
        QCOMPARE(RefusalSentences::refusal(refusal),
                 QStringLiteral("Knot 3 is only 0.0004° after the previous knot; the minimum is 0.1°."));
        refusal.limit = Limit::KnotOrder;
        refusal.actual = 89.99996;
        refusal.allowed = 90;
        QCOMPARE(RefusalSentences::refusal(refusal),
                 QStringLiteral("Knot 3 at 89.99996° must come after the previous knot at 90°."));
    }

    void everyLimitHasASentence()
    {
        for (int i = 0; i <= static_cast<int>(Limit::RampTooLong); ++i) {
            Refusal refusal;
            refusal.limit = static_cast<Limit>(i);
            refusal.actual = 2;
            refusal.allowed = 1;
            refusal.unit = "mm";
            refusal.lawParameter = refusal.limit == Limit::LawParameter ? "k" : "speed";
            refusal.index = 3;
            for (const bool isTimed : {false, true}) {
                if (isTimed)
                    refusal.timeS = 0.5;
                for (const bool isAtAnAngle : {false, true}) {
                    refusal.angleDeg = isAtAnAngle ? std::optional(90.0) : std::nullopt;
                    const QString text = RefusalSentences::refusal(refusal);
                    QVERIFY2(
                        isWhole(text),
                        (std::string(profile::limitId(refusal.limit)) + ": " + text.toStdString()).c_str());
                }
            }
        }
    }

    void refusalsNameTheNearestValues()
    {
        profile::test::Recipe recipe = profile::test::checkRecipe(1100);
        QCOMPARE(sentenceOf(recipe),
                 "A bag of 1100.0 mm exceeds the knife stroke; with these ratios the maximum is 1077.1 mm. "
                 "Shorter ramps allow 60.0 bags/min. Nearest possible value: Bag length 1077.1 mm.");
        QCOMPARE(
            sentenceOf(profile::test::checkRecipe(5)),
            "Bag length would be 5.0 mm; the allowed range is 10.0 to 2000.0 mm. Nearest possible value: "
            "Bag length 10.0 mm.");
        QVERIFY(sentenceOf(profile::test::checkRecipe(250, 601)).startsWith("Rate would be 601.0 bags/min"));
        recipe = profile::test::checkRecipe();
        recipe.machine.timerBits = 8;
        recipe.machine.maxPulseFrequencyHz = 20000;
        QVERIFY(sentenceOf(recipe).endsWith("Nearest possible value: Timer width 9 bit."));
        recipe = profile::test::checkRecipe(250, 150);
        recipe.machine.maxKnifeAccelerationMmPerS2 = 11100;
        QCOMPARE(sentenceOf(recipe),
                 "Knife acceleration would reach 12.21 m/s² at 0.130 s (117°); the limit is 11.10 m/s². "
                 "Longer ramps allow 150.0 bags/min. "
                 "Nearest possible value: Rate 143.0 bags/min, or Bag length 261.6 mm.");
        recipe = profile::test::checkRecipe();
        recipe.program.k[1] = 5;
        QVERIFY(sentenceOf(recipe).contains("k2 is 5.00 and must be below 4.00."));
    }

    void rampsThatAreTooLongNameTheirTime()
    {
        profile::Machine slow;
        slow.maxAccelerationMmPerS2 = 79;
        QCOMPARE(
            RefusalSentences::refusal(profile::buildPressTable({}, slow).error()),
            "Approach speed needs a ramp of 1013 ms at maximum acceleration; the controller allows 1000 ms. "
            "Enter a lower speed or a higher acceleration.");
    }

    // The named error, as read by a person, can be kept.
    void intervalsNameAnErrorThatTheyKeep()
    {
        profile::MotionProfile motion;
        const profile::Law& law = *profile::findLaw(profile::LawId::Quintic);
        motion.addDisplacement(1, 600, law, profile::defaultParameters(law));
        const auto compile = [&](double error) {
            return profile::compileIntervals(motion, {}, error, profile::IntervalMode::Corrected);
        };
        const auto tight = compile(0.004);
        QVERIFY(!tight && tight.error().limit == Limit::SpeedError);
        const QString text = RefusalSentences::refusal(tight.error());
        const double named = text.section("not possible, but ", 1).section(u' ', 0, 0).toDouble();
        QVERIFY2(named > 0.004 && compile(named), qPrintable(text));
    }

    void valuesWithoutRoomInTheirRegister()
    {
        program::Recipe recipe;
        recipe.version = program::maxVersion + 1;
        QCOMPARE(
            RefusalSentences::program(program::buildProgram(recipe).error()),
            "program.recipe_version cannot be 65536; the allowed range is 0 to 65535. Enter another value.");
        const auto refused = modbus::toRaw(modbus::registerNamed("parameter.ramp_time"), 5);
        QCOMPARE(
            panel::RegisterWords::outOfRange(refused.error()),
            "parameter.ramp_time cannot be 5; the allowed range is 50 to 10000 ms. Enter another value.");
    }

    void linkErrors()
    {
        modbus::LinkError error{modbus::LinkErrorKind::PortAbsent, "/dev/ttyUSB0", "status", "dialout", 7};
        for (int i = 0; i <= static_cast<int>(modbus::LinkErrorKind::ValueRefused); ++i) {
            error.kind = static_cast<modbus::LinkErrorKind>(i);
            QVERIFY2(isWhole(ConnectionSentences::error(error)), std::string(errorId(error.kind)).c_str());
        }
        error.kind = modbus::LinkErrorKind::PortNotPermitted;
        QVERIFY(ConnectionSentences::error(error).contains("group \"dialout\""));
        error.detail.clear(); // a folder on the way to the port
        QVERIFY(isWhole(ConnectionSentences::error(error)) &&
                !ConnectionSentences::error(error).contains("\"\""));
        error.detail = "dialout";
        error.kind = modbus::LinkErrorKind::WrongIdentity;
        QVERIFY(ConnectionSentences::error(error).contains("dialout is 7."));
        error.kind = modbus::LinkErrorKind::ValueRefused;
        error.limits = modbus::toRaw(modbus::registerNamed("parameter.ramp_time"), 5).error();
        QVERIFY(ConnectionSentences::error(error).contains("50 to 10000 ms"));
    }

    void exceptionsSayWhatToDo_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("advice");
        QTest::newRow("illegal function") << 1 << "Check that it is a CamPanel controller.";
        QTest::newRow("illegal address") << 2 << "Check that it is a CamPanel controller.";
        QTest::newRow("device failure") << 4 << "Restart the device.";
        QTest::newRow("acknowledged") << 5 << "Wait, or restart the device.";
        QTest::newRow("busy") << 6 << "Wait, or restart the device.";
        QTest::newRow("memory") << 8 << "Restart the device.";
        QTest::newRow("gateway path") << 10 << "Check the unit number, and the line behind the gateway.";
        QTest::newRow("gateway target") << 11 << "Check the unit number, and the line behind the gateway.";
    }

    void exceptionsSayWhatToDo()
    {
        QFETCH(int, code);
        QFETCH(QString, advice);
        const modbus::LinkError error{modbus::LinkErrorKind::Exception, "/dev/ttyUSB0", "identity", {}, code};
        const QString text = ConnectionSentences::error(error);
        QVERIFY2(isWhole(text) && text.endsWith(advice), qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("(Modbus exception %1)").arg(code)));
        modbus::LineFinding finding;
        finding.condition = LineCondition::Refused;
        finding.port = "/dev/ttyUSB0";
        finding.code = code;
        QCOMPARE(DoctorSentences::finding(finding), text);
    }

    void adapterIsPromisedToBeFoundOnlyByItsSerialNumber()
    {
        link::LinkReport report;
        report.simulated = false;
        report.state = link::LinkState::Lost;
        report.portName = QStringLiteral("/dev/ttyUSB0");
        report.error = modbus::LinkError{modbus::LinkErrorKind::PortGone, "/dev/ttyUSB0", {}, {}, 0};
        QVERIFY(ConnectionSentences::connection(report, {}).contains("into the same socket"));
        report.hasSerialNumber = true;
        QVERIFY(ConnectionSentences::connection(report, {}).contains("under any name"));
    }

    void lostLineSaysWhatWasReceived_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* tag, modbus::LinkErrorKind kind, int code, const char* words) {
            QTest::newRow(tag) << static_cast<int>(kind) << code << QString::fromLatin1(words);
        };
        using Kind = modbus::LinkErrorKind;
        row("silence", Kind::NoAnswer, 0, "no response on /dev/ttyUSB0");
        row("damaged", Kind::BadChecksum, 0, "Invalid data on /dev/ttyUSB0");
        row("stray bytes", Kind::BadFrame, 2, "Check the bias resistors");
        row("another master", Kind::ForeignAnswer, 0, "Check for another master");
        row("busy", Kind::Exception, 6, "is busy");
        row("gateway", Kind::Exception, 11, "The gateway on /dev/ttyUSB0");
    }

    void lostLineSaysWhatWasReceived()
    {
        QFETCH(int, kind);
        QFETCH(int, code);
        QFETCH(QString, words);
        link::LinkReport report;
        report.simulated = false;
        report.state = link::LinkState::Lost;
        report.portName = QStringLiteral("/dev/ttyUSB0");
        report.error =
            modbus::LinkError{static_cast<modbus::LinkErrorKind>(kind), "/dev/ttyUSB0", "status", {}, code};
        const QDateTime at(QDate(2026, 1, 2), QTime(3, 4, 5));
        const QString text = ConnectionSentences::connection(report, at);
        QVERIFY2(isWhole(text) && text.contains(words) && text.startsWith("No connection since 03:04:05"),
                 qPrintable(text));
    }

    void failedDownloadsSayThatTheProgramIsUnchanged()
    {
        modbus::DownloadError error;
        error.transfer.result = modbus::TransferResult::BadRow;
        error.transfer.detail = 17;
        error.refusal = modbus::Refusal::NotStandstill;
        for (int i = 0; i <= static_cast<int>(modbus::DownloadErrorKind::Withdrawn); ++i) {
            error.kind = static_cast<modbus::DownloadErrorKind>(i);
            const QString text = ConnectionSentences::error(error);
            QVERIFY2(isWhole(text) && text.contains("unchanged"), qPrintable(text));
        }
        error.kind = modbus::DownloadErrorKind::ImageTooLong;
        error.actual = 6232;
        error.expected = 4096;
        QVERIFY(ConnectionSentences::error(error).startsWith(
            "The table needs 6232 registers, the controller has 4096;"));
        error.kind = modbus::DownloadErrorKind::IntervalsNotSupported;
        QVERIFY(ConnectionSentences::error(error).endsWith("Choose cam points."));
        error.kind = modbus::DownloadErrorKind::TransferRefused;
        QVERIFY(ConnectionSentences::error(error).contains("Row 17 of the table"));
        error.kind = modbus::DownloadErrorKind::CommandRefused;
        QVERIFY(ConnectionSentences::error(error).contains("standstill"));
    }

    void findingsOfTheDoctor()
    {
        modbus::LineFinding finding;
        finding.bytesSeen = 10;
        finding.group = "dialout";
        finding.detail = "not enough memory";
        finding.holders = {{1234, "screen"}};
        const auto sentence = [&finding](LineCondition condition) {
            finding.condition = condition;
            return DoctorSentences::finding(finding);
        };
        for (int i = 0; i <= static_cast<int>(LineCondition::PortGone); ++i) {
            QVERIFY2(isWhole(sentence(static_cast<LineCondition>(i))), QByteArray::number(i));
            QVERIFY(!DoctorSentences::condition(finding.condition).isEmpty());
        }
        QVERIFY(sentence(LineCondition::EchoOnly).contains("echoes"));
        QVERIFY(sentence(LineCondition::Garbage).contains("Check baud rate, parity"));
        QVERIFY(sentence(LineCondition::NoBytes).contains("power"));
        QVERIFY(sentence(LineCondition::PortNotPermitted).contains("group \"dialout\""));
        QVERIFY(sentence(LineCondition::PortBusy).contains("screen (process 1234)"));
        QVERIFY(!sentence(LineCondition::Controller).contains("stray bytes"));
        finding.strayBytes = 3;
        QVERIFY(
            sentence(LineCondition::Controller).contains("stray bytes to the responses (3). Check the bias"));
        finding.strayBytes = 0;
        finding.latencyTimerMs = 16;
        QVERIFY(sentence(LineCondition::Controller).contains("delays data by 16 ms"));
        finding.latencyTimerMs = 1;
        QVERIFY(!sentence(LineCondition::Controller).contains("latency"));
        QCOMPARE(DoctorSentences::settings({9600, modbus::Parity::Even, 1}, 7), "9600 baud, 8E1, unit 7");
    }
};

CAMPANEL_TEST(TestSentences)

} // namespace test_sentences

#include "test_sentences.moc"
