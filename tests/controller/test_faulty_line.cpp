// SPDX-License-Identifier: Apache-2.0
// Every fault of the line on simulated time, with a controller that answers at once: what both sides receive,
// byte by byte.
#include "fault_bench.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <bit>

namespace test_faulty_line {

using namespace campanel::controller;
using namespace campanel::test;

namespace {

FrameBytes joined(std::initializer_list<FrameBytes> parts)
{
    FrameBytes all;
    for (const FrameBytes& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

int differentBits(const FrameBytes& one, const FrameBytes& other)
{
    int bits = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        bits += std::popcount(static_cast<unsigned>(one[i] ^ other.at(i)));
    return bits;
}

} // namespace

class TestFaultyLine : public QObject {
    Q_OBJECT

private slots:
    void lostAndRepeatedFrames_data();
    void lostAndRepeatedFrames();
    void requestInTwoPieces();
    void lateAnswersComeInTheirOwnTime();
    void lateRequestsKeepTheirOrder();
    void damagedAnswers();
    void damagedRequests();
    void foreignAnswersHaveARightChecksum();
    void gapsLastAsLongAsTheyShould();
    void noiseFollowsTheAnswer();
    void busyThenWorksAgain();
    void silenceEnds();
    void secondMasterIsHeard_data();
    void secondMasterIsHeard();
    void wrongBaudGarblesBothWays();
    void unplugged_data();
    void unplugged();
    void restartLosesWhatIsUnderWay();
    void newRulesEndWhatIsUnderWay_data();
    void newRulesEndWhatIsUnderWay();
    void identityIsThatOfTheRule();
    void ruleDecidesWhen_data();
    void ruleDecidesWhen();
    void sameSeedSameFaults();
};

void TestFaultyLine::lostAndRepeatedFrames_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("heard");
    QTest::addColumn<int>("questions");
    QTest::addColumn<int>("replies");
    QTest::newRow("none") << QByteArray("") << 1 << 0 << 1;
    QTest::newRow("lost request") << QByteArray("lost-request") << 0 << 0 << 0;
    QTest::newRow("lost answer") << QByteArray("lost-answer") << 1 << 0 << 0;
    QTest::newRow("request twice") << QByteArray("duplicate-request") << 2 << 0 << 2;
    QTest::newRow("answer twice") << QByteArray("duplicate-answer") << 1 << 0 << 2;
    QTest::newRow("echo") << QByteArray("echo") << 1 << 1 << 1;
}

void TestFaultyLine::lostAndRepeatedFrames()
{
    QFETCH(QByteArray, script);
    QFETCH(int, heard);
    QFETCH(int, questions);
    QFETCH(int, replies);
    for (const bool paced : {true, false}) {
        Bench bench(script.constData(), {9600, 'N', 1, paced});
        FrameBytes expected;
        for (int i = 0; i < questions; ++i)
            expected = joined({expected, question});
        for (int i = 0; i < replies; ++i)
            expected = joined({expected, reply});
        QVERIFY(bench.exchange() == expected);
        QVERIFY(bench.m_heard == std::vector<FrameBytes>(static_cast<std::size_t>(heard), question));
    }
}

// Between the pieces the line is silent for less than 3.5 characters; the time of the second one is not
// silence.
void TestFaultyLine::requestInTwoPieces()
{
    for (const std::uint32_t baud : {9600u, 115200u}) {
        const LineSettings settings{baud, 'N', 1, true};
        Bench bench("", settings);
        const FrameBytes request = framed(FrameBytes(60, 1));
        const FrameBytes first(request.begin(), request.begin() + 3);
        bench.ask(first);
        bench.runTo(3 * characterNs(settings) + frameGapNs(settings) / 2);
        bench.ask(FrameBytes(request.begin() + 3, request.end()));
        bench.runTo(bench.m_nowNs + 200 * ms);
        QVERIFY(bench.m_heard == std::vector<FrameBytes>{request});
    }
}

void TestFaultyLine::lateAnswersComeInTheirOwnTime()
{
    Bench punctual("");
    punctual.exchange();
    Bench bench("timeout 60; late times=2.5 limit=1");
    bench.exchange(100 * ms);
    QVERIFY(bench.m_panel.empty());
    bench.ask(); // its answer comes at once: the late one overtakes nothing
    bench.runTo(300 * ms);
    QVERIFY(bench.m_panel == joined({reply, reply}));
    QCOMPARE(bench.m_panelTimes.at(reply.size()) - punctual.m_panelTimes.front(), 150 * ms);
    QCOMPARE(bench.m_panelTimes.front() - punctual.m_panelTimes.front(), 100 * ms);
}

void TestFaultyLine::lateRequestsKeepTheirOrder()
{
    Bench bench("timeout 60; late times=2 part=request limit=1");
    bench.ask();
    bench.runTo(100 * ms);
    QVERIFY(bench.m_heard.empty());
    bench.ask(framed({1, 3, 0, 0, 0, 4})); // waits behind it, without silence between both
    bench.runTo(300 * ms);
    QVERIFY(bench.m_heard == std::vector<FrameBytes>{joined({question, framed({1, 3, 0, 0, 0, 4})})});
}

void TestFaultyLine::damagedAnswers()
{
    const FrameBytes shortened = Bench("truncate").exchange();
    QVERIFY(!shortened.empty() && shortened.size() < reply.size());
    QVERIFY(std::equal(shortened.begin(), shortened.end(), reply.begin()));
    const FrameBytes flipped = Bench("corrupt bits=5").exchange();
    QCOMPARE(flipped.size(), reply.size());
    QCOMPARE(differentBits(flipped, reply), 5);
    QVERIFY(!hasRightCrc(flipped));
    const FrameBytes longer = Bench("trailing bytes=4").exchange();
    QCOMPARE(longer.size(), reply.size() + 4);
    QVERIFY(std::equal(reply.begin(), reply.end(), longer.begin()));
    // The checksum never matches by chance.
    Bench bench("corrupt bits=4");
    for (int i = 0; i < 2000; ++i)
        QVERIFY(!hasRightCrc(bench.exchange(50 * ms)));
}

void TestFaultyLine::damagedRequests()
{
    for (const char* script : {"truncate part=request", "corrupt part=request", "trailing part=request",
                               "noise part=request bytes=2"}) {
        Bench bench(script);
        QVERIFY2(bench.exchange().empty(), script);
        QCOMPARE(bench.m_heard.size(), std::size_t{1});
        QVERIFY2(!hasRightCrc(bench.m_heard[0]), script);
    }
}

void TestFaultyLine::foreignAnswersHaveARightChecksum()
{
    for (const char* script : {"wrong-unit", "wrong-function", "wrong-count", "exception code=4"}) {
        Bench bench(script);
        for (int i = 0; i < 200; ++i) {
            const FrameBytes answer = bench.exchange(60 * ms);
            QVERIFY2(hasRightCrc(answer), script);
            QVERIFY2(answer != reply, script);
        }
    }
    QVERIFY(Bench("exception code=4").exchange() == framed({1, 0x83, 4}));
    QCOMPARE(Bench("wrong-unit").exchange().size(), reply.size());
    const FrameBytes counted = Bench("wrong-count").exchange();
    QCOMPARE(int{counted.at(2)}, static_cast<int>(counted.size()) - 5);
}

void TestFaultyLine::gapsLastAsLongAsTheyShould()
{
    const std::int64_t characterNsNow = characterNs(slow);
    Bench within("gap characters=2 part=request"); // below 3.5: still one frame
    QVERIFY(within.exchange() == reply);
    QVERIFY(within.m_heard == std::vector<FrameBytes>{question});
    Bench beyond("gap characters=5 part=request");
    QVERIFY(beyond.exchange().empty());
    QCOMPARE(beyond.m_heard.size(), std::size_t{2});
    QVERIFY(joined({beyond.m_heard[0], beyond.m_heard[1]}) == question);
    Bench answer("gap characters=5");
    QVERIFY(answer.exchange() == reply);
    std::int64_t longestNs = 0;
    for (std::size_t i = 1; i < answer.m_panelTimes.size(); ++i)
        longestNs = std::max(longestNs, answer.m_panelTimes[i] - answer.m_panelTimes[i - 1]);
    QCOMPARE(longestNs, 6 * characterNsNow); // the silence, then the byte
}

void TestFaultyLine::noiseFollowsTheAnswer()
{
    Bench bench("noise bytes=5 after=20");
    const FrameBytes heard = bench.exchange();
    QCOMPARE(heard.size(), reply.size() + 5);
    QVERIFY(std::equal(reply.begin(), reply.end(), heard.begin()));
    QVERIFY(bench.m_panelTimes.at(reply.size()) - bench.m_panelTimes.at(reply.size() - 1) >= 20 * ms);
}

void TestFaultyLine::busyThenWorksAgain()
{
    Bench bench("busy answers=2 limit=1");
    QVERIFY(bench.exchange() == framed({1, 0x83, 6}));
    QVERIFY(bench.exchange() == framed({1, 0x83, 6}));
    QVERIFY(bench.m_heard.empty());
    QVERIFY(bench.exchange() == reply);
}

void TestFaultyLine::silenceEnds()
{
    Bench bench("silence time=250 limit=1");
    for (int i = 0; i < 3; ++i)
        QVERIFY(bench.exchange().empty());
    QVERIFY(bench.m_heard.empty());
    QVERIFY(bench.exchange() == reply);
}

void TestFaultyLine::secondMasterIsHeard_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("own");
    QTest::newRow("before") << QByteArray("second-master when=before limit=1") << 1;
    QTest::newRow("after") << QByteArray("second-master when=after limit=1") << 0;
}

void TestFaultyLine::secondMasterIsHeard()
{
    QFETCH(QByteArray, script);
    QFETCH(int, own);
    for (const bool paced : {true, false}) {
        Bench bench(script.constData(), {9600, 'N', 1, paced});
        const FrameBytes heard = bench.exchange(1000 * ms);
        QCOMPARE(bench.m_heard.size(), std::size_t{2});
        QVERIFY(bench.m_heard.at(static_cast<std::size_t>(own)) == question);
        const FrameBytes& foreign = bench.m_heard.at(static_cast<std::size_t>(1 - own));
        QVERIFY(hasRightCrc(foreign));
        QVERIFY(foreign != question);
        QCOMPARE(int{foreign.at(5)}, 3); // as many registers, so the answer looks like the panel's
        QVERIFY(heard == (own == 1 ? joined({foreign, reply, reply}) : joined({reply, foreign, reply})));
    }
}

void TestFaultyLine::wrongBaudGarblesBothWays()
{
    Bench bench("wrong-baud time=250 limit=1");
    for (int i = 0; i < 3; ++i)
        QVERIFY(bench.exchange().empty());
    QVERIFY(!bench.m_heard.empty());
    for (const FrameBytes& frame : bench.m_heard)
        QVERIFY(!hasRightCrc(frame));
    QVERIFY(bench.exchange() == reply);
    Bench answers("wrong-baud part=answer time=50");
    const FrameBytes heard = answers.exchange();
    QVERIFY(!heard.empty() && heard != reply);
    QVERIFY(answers.m_heard == std::vector<FrameBytes>{question});
}

void TestFaultyLine::unplugged_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("heard");
    QTest::addColumn<int>("panelBytes");
    QTest::newRow("idle") << QByteArray("unplug when=idle time=300 port=/tmp/new limit=1") << 1
                          << static_cast<int>(reply.size());
    QTest::newRow("request") << QByteArray("unplug when=request time=300 port=/tmp/new limit=1") << 0 << 0;
    QTest::newRow("answer") << QByteArray("unplug when=answer time=300 port=/tmp/new limit=1") << 1
                            << static_cast<int>(reply.size() / 2);
}

void TestFaultyLine::unplugged()
{
    QFETCH(QByteArray, script);
    QFETCH(int, heard);
    QFETCH(int, panelBytes);
    Bench bench(script.constData());
    QCOMPARE(static_cast<int>(bench.exchange(1000 * ms).size()), panelBytes);
    QCOMPARE(static_cast<int>(std::ranges::count(bench.m_heard, question)), heard);
    QCOMPARE(bench.m_events.size(), std::size_t{2});
    QVERIFY(bench.m_events[0].second.kind == LineEvent::Kind::Unplug);
    QVERIFY(bench.m_events[1].second.kind == LineEvent::Kind::Plug);
    QCOMPARE(bench.m_events[1].second.port, std::string("/tmp/new"));
    QCOMPARE(bench.m_events[1].first - bench.m_events[0].first, 300 * ms);
    QVERIFY(bench.exchange() == reply);
}

void TestFaultyLine::restartLosesWhatIsUnderWay()
{
    Bench bench("restart time=200 limit=1");
    QVERIFY(bench.exchange(150 * ms).empty());
    QVERIFY(bench.m_heard.empty());
    bench.runTo(200 * ms);
    QCOMPARE(bench.m_events.size(), std::size_t{1});
    QVERIFY(bench.m_events[0].second.kind == LineEvent::Kind::Restart);
    QCOMPARE(bench.m_events[0].first, 200 * ms);
    QVERIFY(bench.exchange() == reply);
}

void TestFaultyLine::newRulesEndWhatIsUnderWay_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("event"); // future event, -1: none
    QTest::newRow("silence") << QByteArray("silence time=1e8") << -1;
    QTest::newRow("wrong baud") << QByteArray("wrong-baud time=1e8 limit=1") << -1;
    QTest::newRow("unplugged") << QByteArray("unplug when=idle time=1e8")
                               << static_cast<int>(LineEvent::Kind::Plug);
    QTest::newRow("restart") << QByteArray("restart time=1e8") << static_cast<int>(LineEvent::Kind::Restart);
}

void TestFaultyLine::newRulesEndWhatIsUnderWay()
{
    QFETCH(QByteArray, script);
    QFETCH(int, event);
    Bench bench(script.constData());
    bench.exchange(200 * ms);
    bench.m_events.clear();
    bench.m_line.setScript({}, bench.m_nowNs);
    bench.runTo(bench.m_nowNs + 1 * ms);
    QCOMPARE(bench.m_events.size(), std::size_t{event < 0 ? 0u : 1u});
    if (event >= 0)
        QCOMPARE(static_cast<int>(bench.m_events[0].second.kind), event);
    QVERIFY(bench.exchange() == reply);
}

void TestFaultyLine::identityIsThatOfTheRule()
{
    QVERIFY(Bench("map-version major=7 minor=9").exchange() == framed({1, 3, 6, 0xCA, 0x3D, 0, 7, 0, 9}));
    QVERIFY(Bench("device-type type=258").exchange() == framed({1, 3, 6, 1, 2, 0, 1, 0, 1}));
    // The same registers through the read-back window: tag 5, two from address 0.
    Bench bench("map-version major=7");
    bench.m_reply = framed({1, 23, 10, 0, 5, 0, 0, 0, 2, 0xCA, 0x3D, 0, 1});
    bench.ask(framed({1, 23, 3, 0x10, 0, 5, 3, 0, 0, 3, 6, 0, 5, 0, 0, 0, 2}));
    bench.runTo(100 * ms);
    QVERIFY(bench.m_panel == framed({1, 23, 10, 0, 5, 0, 0, 0, 2, 0xCA, 0x3D, 0, 7}));
    // Other requests are unchanged.
    Bench other("map-version major=7");
    other.ask(framed({1, 3, 0, 3, 0, 3}));
    other.runTo(100 * ms);
    QVERIFY(other.m_panel == reply);
}

void TestFaultyLine::ruleDecidesWhen_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QByteArray>("pattern"); // x: lost
    QTest::newRow("always") << QByteArray("lost-answer") << QByteArray("xxxxxxxx");
    QTest::newRow("every third") << QByteArray("lost-answer every=3") << QByteArray("..x..x..");
    QTest::newRow("limit") << QByteArray("lost-answer every=2 limit=2") << QByteArray(".x.x....");
    QTest::newRow("window") << QByteArray("lost-answer from=150 until=450") << QByteArray("..xxx...");
    QTest::newRow("never") << QByteArray("lost-answer probability=0") << QByteArray("........");
    QTest::newRow("two rules") << QByteArray("lost-request every=4; lost-answer every=6")
                               << QByteArray("...x.x.x");
}

void TestFaultyLine::ruleDecidesWhen()
{
    QFETCH(QByteArray, script);
    QFETCH(QByteArray, pattern);
    Bench bench(script.constData());
    QByteArray seen;
    for (int i = 0; i < pattern.size(); ++i)
        seen.append(bench.exchange(100 * ms).empty() ? 'x' : '.');
    QCOMPARE(seen, pattern);
    QCOMPARE(bench.m_line.applied(), static_cast<std::uint64_t>(pattern.count('x')));
    bench.m_line.setScript({}, bench.m_nowNs);
    QVERIFY(bench.exchange() == reply);
    QCOMPARE(bench.m_line.applied(), std::uint64_t{0});
}

void TestFaultyLine::sameSeedSameFaults()
{
    const auto run = [](const char* script) {
        Bench bench(script);
        std::vector<FrameBytes> all;
        for (int i = 0; i < 300; ++i)
            all.push_back(bench.exchange(60 * ms));
        return all;
    };
    constexpr auto script =
        "seed 5; corrupt probability=0.2; lost-answer probability=0.1; truncate probability=0.1";
    const auto first = run(script);
    QVERIFY(first == run(script));
    QVERIFY(first !=
            run("seed 6; corrupt probability=0.2; lost-answer probability=0.1; truncate probability=0.1"));
    const auto lost = std::ranges::count(first, FrameBytes{});
    QVERIFY2(lost > 10 && lost < 50, qPrintable(QString::number(lost))); // 0.8 * 0.1 of 300
}

CAMPANEL_TEST(TestFaultyLine)

} // namespace test_faulty_line

#include "test_faulty_line.moc"
