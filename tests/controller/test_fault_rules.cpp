// SPDX-License-Identifier: Apache-2.0
// The language of fault scripts: valid rules, and the sentences for errors.
#include "fault_rules.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_fault_rules {

using namespace campanel::controller;

class TestFaultRules : public QObject {
    Q_OBJECT

private slots:
    void everyWordHasItsDefaults_data();
    void everyWordHasItsDefaults();
    void pairsAreTaken();
    void statementsShareALine();
    void seedAndTimeoutAreInherited();
    void wrongLinesAreNamed_data();
    void wrongLinesAreNamed();
};

void TestFaultRules::everyWordHasItsDefaults_data()
{
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind <= static_cast<int>(FaultKind::DeviceType); ++kind)
        QTest::newRow(std::string(faultWord(static_cast<FaultKind>(kind))).c_str()) << kind;
}

void TestFaultRules::everyWordHasItsDefaults()
{
    QFETCH(int, kind);
    const auto script = parseFaultScript(faultWord(static_cast<FaultKind>(kind)));
    QVERIFY2(script.has_value(), script ? "" : script.error().c_str());
    QCOMPARE(script->rules.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(script->rules[0].kind), kind);
    QCOMPARE(script->rules[0].every, 1u);
    QVERIFY(script->rules[0].limit > 1'000'000);
}

void TestFaultRules::pairsAreTaken()
{
    const auto script =
        parseFaultScript("late times=2.5 part=request probability=0.25 limit=7 from=10 until=2.5e3\n"
                         "unplug when=answer time=300 port=/tmp/other every=9\n"
                         "map-version major=3 minor=4\n"
                         "second-master when=before\n");
    QVERIFY2(script.has_value(), script ? "" : script.error().c_str());
    QCOMPARE(script->rules.size(), std::size_t{4});
    const FaultRule& late = script->rules[0];
    QCOMPARE(late.times, 2.5);
    QVERIFY(late.part == FaultPart::Request);
    QCOMPARE(late.every, 0u);
    QCOMPARE(late.probability, 0.25);
    QCOMPARE(late.limit, std::uint64_t{7});
    QCOMPARE(late.fromNs, std::int64_t{10'000'000});
    QCOMPARE(late.untilNs, std::int64_t{2'500'000'000});
    const FaultRule& unplug = script->rules[1];
    QVERIFY(unplug.when == FaultMoment::Answer);
    QCOMPARE(unplug.timeNs, std::int64_t{300'000'000});
    QCOMPARE(unplug.port, std::string("/tmp/other"));
    QCOMPARE(unplug.every, 9u);
    QCOMPARE(script->rules[2].major, std::uint16_t{3});
    QCOMPARE(script->rules[2].minor, std::uint16_t{4});
    QVERIFY(script->rules[3].when == FaultMoment::Before);
}

void TestFaultRules::statementsShareALine()
{
    const auto script =
        parseFaultScript("# all of it\n\nlate every=3; lost-answer every=5 # two\n clear ;echo\n");
    QVERIFY2(script.has_value(), script ? "" : script.error().c_str());
    QCOMPARE(script->rules.size(), std::size_t{1}); // 'clear' removed the two before it
    QVERIFY(script->rules[0].kind == FaultKind::Echo);
    QVERIFY(parseFaultScript("clear")->rules.empty());
}

void TestFaultRules::seedAndTimeoutAreInherited()
{
    const auto first = parseFaultScript("seed 9; timeout 40");
    QVERIFY(first.has_value());
    QCOMPARE(first->seed, std::uint64_t{9});
    QCOMPARE(first->timeoutNs, std::int64_t{40'000'000});
    const auto second = parseFaultScript("echo", *first);
    QCOMPARE(second->seed, std::uint64_t{9});
    QCOMPARE(second->timeoutNs, std::int64_t{40'000'000});
    QCOMPARE(second->rules.size(), std::size_t{1});
}

void TestFaultRules::wrongLinesAreNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("sentence");
    QTest::newRow("unknown fault") << QByteArray("late\n\nlost")
                                   << QByteArray("line 3: there is no fault 'lost'");
    QTest::newRow("foreign key") << QByteArray("lost-answer bits=3")
                                 << QByteArray(
                                        "line 1: 'lost-answer' does not take 'bits'; it takes probability");
    QTest::newRow("unknown key") << QByteArray("late when=now") << QByteArray("'late' does not take 'when'");
    QTest::newRow("no value") << QByteArray("late times")
                              << QByteArray("'times' is wrong: times is a number");
    QTest::newRow("not a number") << QByteArray("late times=2x") << QByteArray("'times=2x' is wrong");
    QTest::newRow("probability") << QByteArray("late probability=1.5") << QByteArray("a number from 0 to 1");
    QTest::newRow("not finite") << QByteArray("late times=nan") << QByteArray("'times=nan' is wrong");
    QTest::newRow("every 0") << QByteArray("echo every=0") << QByteArray("a whole number from 1");
    QTest::newRow("part") << QByteArray("truncate part=all") << QByteArray("answer, request or both");
    QTest::newRow("moment of another")
        << QByteArray("unplug when=before") << QByteArray("'when=before' is wrong");
    QTest::newRow("seed") << QByteArray("seed x") << QByteArray("'seed' takes one whole number");
    QTest::newRow("two seeds") << QByteArray("seed 1 2") << QByteArray("'seed' takes one whole number");
    QTest::newRow("time-out") << QByteArray("echo; timeout")
                              << QByteArray("line 1: 'timeout' takes one time in ms");
}

void TestFaultRules::wrongLinesAreNamed()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, sentence);
    const auto script = parseFaultScript(text.toStdString());
    QVERIFY(!script.has_value());
    QVERIFY2(script.error().starts_with("line "), script.error().c_str());
    QVERIFY2(QByteArray::fromStdString(script.error()).contains(sentence), script.error().c_str());
}

CAMPANEL_TEST(TestFaultRules)

} // namespace test_fault_rules

#include "test_fault_rules.moc"
