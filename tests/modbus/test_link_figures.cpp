// SPDX-License-Identifier: Apache-2.0
// The statistics of the line: percentiles, the strip of 24 hours, the measured allowance.
#include "modbus/line/answer_allowance.h"
#include "modbus/line/link_figures.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <random>

namespace test_link_figures {

using namespace campanel::modbus;
using namespace std::chrono_literals;
using std::chrono::microseconds;

namespace {

using WallTime = LinkFigures::WallTime;

constexpr WallTime atMinute(std::int64_t minute)
{
    return WallTime{std::chrono::minutes{minute}};
}

void answerAt(LinkFigures& figures, WallTime at, microseconds latency = 12ms)
{
    figures.noteRequest(19, false);
    figures.noteReceived(85);
    figures.noteAnswer(latency, 12'528us, 13ms, at);
}

} // namespace

class LinkFiguresTest : public QObject {
    Q_OBJECT

private slots:
    void percentilesAreWithinTheirResolution()
    {
        const unsigned seed = 4711;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::lognormal_distribution<double> spread(9.4, 1.0); // around 12 ms
        LatencyHistogram histogram;
        std::vector<std::int64_t> exact;
        for (int i = 0; i < 20000; ++i) {
            const auto us = std::clamp<std::int64_t>(std::llround(spread(random)), 64, 16'000'000);
            exact.push_back(us);
            histogram.note(microseconds{us});
        }
        std::ranges::sort(exact);
        for (const double share : {0.5, 0.95, 0.99, 1.0}) {
            const auto index = static_cast<std::size_t>(std::ceil(share * 20000)) - 1;
            const double ratio =
                static_cast<double>(histogram.percentile(share).count()) / static_cast<double>(exact[index]);
            QVERIFY2(ratio >= 1.0 && ratio <= 1.0625, qPrintable(QString::number(ratio)));
        }
        QCOMPARE(histogram.maximum().count(), exact.back());
    }

    void durationsBeyondTheBucketsAreCounted()
    {
        LatencyHistogram histogram;
        QCOMPARE(histogram.percentile(0.99), microseconds{0});
        histogram.note(1us);
        QCOMPARE(histogram.percentile(1.0), 1us);
        histogram.note(100s);
        QCOMPARE(histogram.percentile(1.0), microseconds{100s});
        QCOMPARE(histogram.count(), std::uint64_t{2});
    }

    void countsEveryClassOfErrorByItself()
    {
        LinkFigures figures;
        QVERIFY(!figures.wireShare());
        std::uint32_t times = 0;
        for (const LinkErrorKind kind : countedErrors) {
            ++times;
            for (std::uint32_t i = 0; i < times; ++i)
                figures.noteError(kind, 1ms, atMinute(100));
        }
        times = 0;
        for (const LinkErrorKind kind : countedErrors)
            QCOMPARE(figures.errors(kind), ++times);
        figures.noteError(LinkErrorKind::ValueRefused, 1ms, atMinute(100)); // never reached the line
        QCOMPARE(figures.errors(LinkErrorKind::ValueRefused), 0u);
        QCOMPARE(figures.strip().back().errors, figures.errors());
    }

    void wireShareIsNeedAgainstTimeSpent()
    {
        LinkFigures figures;
        answerAt(figures, atMinute(1));
        QCOMPARE(*figures.wireShare(), 12.528 / 13);
        figures.noteError(LinkErrorKind::NoAnswer, 13ms, atMinute(1));
        QCOMPARE(*figures.wireShare(), 12.528 / 26);
    }

    void stripHoldsADayAndForgetsWhatIsOlder()
    {
        LinkFigures figures;
        QVERIFY(figures.strip().empty());
        constexpr std::int64_t start = 29'000'000;
        for (std::int64_t minute = start; minute < start + 3 * LinkFigures::stripMinutes; minute += 2) {
            answerAt(figures, atMinute(minute), 12ms);
            answerAt(figures, atMinute(minute), 40ms);
        }
        const auto strip = figures.strip();
        QCOMPARE(strip.size(), std::size_t{LinkFigures::stripMinutes});
        for (std::size_t i = 0; i < strip.size(); ++i) {
            QCOMPARE(strip[i].minute, strip[0].minute + static_cast<std::int64_t>(i));
            QCOMPARE(strip[i].answers, (strip[i].minute - start) % 2 == 0 ? 2u : 0u);
        }
        QCOMPARE(strip.back().latencyMaxUs, 40'000u);
        QCOMPARE(strip.back().latencyP99Us, 40'000u);
        // A pause of more than a day clears everything earlier.
        answerAt(figures, atMinute(start + 10 * LinkFigures::stripMinutes));
        std::uint32_t answers = 0;
        for (const MinuteFigures& minute : figures.strip())
            answers += minute.answers;
        QCOMPARE(answers, 1u);
    }

    void controllersCountersGoOnOverWrappingAndRestart()
    {
        LinkFigures figures;
        StatusBlock status;
        status.linkRequests = 65'530;
        status.uptimeS = 100;
        figures.noteController(status);
        QCOMPARE(figures.controller()->requests, 0u);
        status.linkRequests = 10;
        status.linkCrcErrors = 2;
        figures.noteController(status);
        QCOMPARE(figures.controller()->requests, 16u);
        status.uptimeS = 1;
        status.linkRequests = 3;
        status.linkCrcErrors = 1;
        figures.noteController(status);
        QCOMPARE(figures.controller()->requests, 19u);
        QCOMPARE(figures.controller()->crcErrors, 3u);
    }

    void allowanceFollowsTheMeasuredTurnaround()
    {
        AnswerAllowance allowance(100ms);
        for (std::uint64_t i = 1; i < AnswerAllowance::minCount; ++i)
            allowance.noteTurnaround(1ms);
        QCOMPARE(allowance.value(), 100ms); // too few measurements
        for (int i = 0; i < 500; ++i)
            allowance.noteTurnaround(1ms);
        QCOMPARE(allowance.value(), AnswerAllowance::shortest);
        for (int i = 0; i < 500; ++i)
            allowance.noteTurnaround(40ms);
        QVERIFY(allowance.value() >= 120ms && allowance.value() <= 128ms);
        for (int i = 0; i < 500; ++i)
            allowance.noteTurnaround(1s);
        QCOMPARE(allowance.value(), AnswerAllowance::longest);
    }

    void allowanceGrowsWhenNothingComes()
    {
        AnswerAllowance allowance(100ms);
        for (int i = 0; i < 500; ++i)
            allowance.noteTurnaround(1ms);
        QCOMPARE(allowance.value(), 50ms);
        allowance.noteSilence();
        QCOMPARE(allowance.value(), 100ms);
        for (int i = 0; i < 10; ++i)
            allowance.noteSilence();
        QCOMPARE(allowance.value(), AnswerAllowance::longest);
        // The slow answers are now measured, and the allowance stays long enough.
        for (int i = 0; i < 500; ++i)
            allowance.noteTurnaround(90ms);
        QVERIFY(allowance.value() >= 270ms);
    }
};

CAMPANEL_TEST(LinkFiguresTest)

} // namespace test_link_figures

#include "test_link_figures.moc"
