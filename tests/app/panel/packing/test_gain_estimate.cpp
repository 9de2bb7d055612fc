// SPDX-License-Identifier: Apache-2.0
// The suggested gains, from marks followed by the controller's own tracker: slip and sensor noise are
// recovered.
#include "app/panel/packing/gain_estimate.h"
#include "ctl_registers.h"
#include "packer/ctl_marks.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_gain_estimate {

using campanel::panel::GainEstimate;
using campanel::panel::GainSuggestion;

namespace {

constexpr double bagMm = 250.0;
constexpr double unitsPerMm = 25600.0;

struct Film {
    double slipMm = 0.0;
    double sensorMm = 0.0;
    double stretchMm = 0.0; // per bag, changing slowly along the reel
    int missingEvery = 0;
};

// Passes marks through the controller's tracker; the estimate gets `shown` in a row, then misses one.
GainEstimate follow(const Film& film, int marks, double phaseGain, unsigned seed, int shown = 1'000'000)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    ctl_mark_settings settings{};
    settings.nominal = std::llround(bagMm * unitsPerMm);
    settings.distance = std::llround(900 * unitsPerMm);
    settings.window = std::llround(6 * unitsPerMm);
    settings.jump = std::llround(1.5 * unitsPerMm);
    settings.max_difference = settings.nominal / 50;
    settings.phase_gain = static_cast<std::uint32_t>(std::lround(1000 * phaseGain));
    settings.length_gain = 100;
    settings.missing_limit = 5;
    ctl_marks tracker{};
    ctl_marks_search(&tracker, &settings, 0);
    GainEstimate estimate;
    double placeMm = 10;
    for (int mark = 0; mark < marks; ++mark) {
        placeMm += bagMm + film.stretchMm * std::sin(mark / 320.0) + film.slipMm * normal(random);
        const bool isMissing = film.missingEvery > 0 && mark % film.missingEvery == film.missingEvery - 1;
        const double seenMm = placeMm + film.sensorMm * normal(random);
        if (isMissing)
            continue;
        ctl_marks_see(&tracker, std::llround(seenMm * unitsPerMm));
        ctl_marks_drop(&tracker, std::llround((seenMm + 1) * unitsPerMm));
        if (tracker.state < CTL_MARK_STATE_ALIGNING || mark % (shown + 1) == shown)
            continue;
        estimate.take({tracker.followed, tracker.missing, static_cast<double>(tracker.error) / unitsPerMm,
                       static_cast<double>(tracker.pitch) / unitsPerMm},
                      settings.phase_gain / 1000.0);
    }
    return estimate;
}

// Returns the gain of the steady Kalman filter for a random walk with measurement noise.
double bestGain(double slipMm, double sensorMm)
{
    const double q = slipMm * slipMm;
    const double r = sensorMm * sensorMm;
    const double p = (q + std::sqrt(q * q + 4 * q * r)) / 2;
    return p / (p + r);
}

} // namespace

class TestGainEstimate : public QObject {
    Q_OBJECT

private slots:
    void findsSlipAndSensorAgain_data()
    {
        QTest::addColumn<double>("slipMm");
        QTest::addColumn<double>("sensorMm");
        QTest::addColumn<double>("phaseGain");
        QTest::newRow("as the simulation") << 0.03 << 0.05 << 0.25;
        QTest::newRow("whatever the controller works with") << 0.03 << 0.05 << 0.6;
        QTest::newRow("a calm film") << 0.01 << 0.08 << 0.25;
        QTest::newRow("a good sensor") << 0.06 << 0.04 << 0.1;
    }
    void findsSlipAndSensorAgain()
    {
        QFETCH(double, slipMm);
        QFETCH(double, sensorMm);
        QFETCH(double, phaseGain);
        constexpr int films = 40;
        double gains = 0;
        double slips = 0;
        double sensors = 0;
        for (unsigned seed = 1; seed <= films; ++seed) {
            const GainEstimate estimate = follow({slipMm, sensorMm, 0.5}, 400, phaseGain, seed);
            const auto suggestion = estimate.suggestion();
            QVERIFY(suggestion.has_value());
            QVERIFY(suggestion->phaseGain >= 0.1 && suggestion->phaseGain <= 0.6);
            gains += suggestion->phaseGain / films;
            slips += suggestion->slipMm / films;
            sensors += suggestion->sensorMm / films;
        }
        const double best = std::clamp(bestGain(slipMm, sensorMm), 0.1, 0.6);
        qInfo("gain %.3f (best %.3f), slip %.3f mm, sensor %.3f mm", gains, best, slips, sensors);
        QVERIFY(std::abs(gains - best) < 0.07);
        QVERIFY(std::abs(slips - slipMm) < 0.3 * slipMm);
        QVERIFY(std::abs(sensors - sensorMm) < 0.1 * sensorMm);
    }

    void lengthGainFollowsThePhaseGain()
    {
        const auto suggestion = follow({0.03, 0.05}, 300, 0.25, 5).suggestion();
        QVERIFY(suggestion.has_value());
        const double phase = suggestion->phaseGain;
        QVERIFY(std::abs(suggestion->lengthGain - std::clamp(phase * phase / (2 - phase), 0.02, 0.2)) <
                1e-12);
    }

    void gainsStayWithinTheirLimits()
    {
        const auto wild = follow({0.3, 0.01}, 300, 0.25, 5).suggestion();
        QVERIFY(wild.has_value());
        QCOMPARE(wild->phaseGain, 0.6);
        const auto calm = follow({0.0005, 0.2}, 300, 0.25, 5).suggestion();
        QVERIFY(calm.has_value());
        QVERIFY(calm->phaseGain >= 0.1 && calm->phaseGain < 0.2);
        QCOMPARE(calm->lengthGain, 0.02);
    }

    void enoughBagsAreNeeded()
    {
        const GainEstimate few = follow({0.03, 0.05}, 151, 0.25, 3); // two to find the marks, one to start
        QCOMPARE(few.bags(), 149);
        QVERIFY(!few.suggestion());
        const GainEstimate enough = follow({0.03, 0.05}, 152, 0.25, 3);
        QCOMPARE(enough.bags(), 150);
        QVERIFY(enough.suggestion());
        // Slip alone is certain earlier.
        const GainEstimate certain = follow({0.1, 0.001}, 122, 0.25, 3);
        QCOMPARE(certain.bags(), 120);
        const auto suggestion = certain.suggestion();
        QVERIFY(suggestion);
        QVERIFY(suggestion->margin <= 0.1);
    }

    // A film that does not change gets the same suggestion at each number of bags, within its margin.
    void theMarginIsTheScatter()
    {
        constexpr int films = 60;
        int within = 0;
        for (unsigned seed = 1; seed <= films; ++seed) {
            const auto suggestion = follow({0.03, 0.05}, 200, 0.25, seed).suggestion();
            QVERIFY(suggestion);
            within +=
                std::abs(suggestion->phaseGain - bestGain(0.03, 0.05)) <= 2 * suggestion->margin ? 1 : 0;
        }
        qInfo("%d of %d within two margins", within, films);
        QVERIFY(within >= 0.85 * films);
    }

    void marksThatWereNotToldAreLeftOut()
    {
        const GainEstimate estimate = follow({0.03, 0.05, 0, 23}, 600, 0.25, 8, 40);
        const auto suggestion = estimate.suggestion();
        QVERIFY(suggestion.has_value());
        QVERIFY(estimate.bags() <= GainEstimate::maxBags);
        QVERIFY2(suggestion->slipMm < 0.06 && suggestion->sensorMm < 0.07, "a gap was taken for slip");
        // Every second one: no two in a row.
        QCOMPARE(follow({0.03, 0.05}, 600, 0.25, 8, 1).bags(), 0);
    }

    void theSameMarkCountsOnce()
    {
        GainEstimate estimate;
        for (std::uint32_t mark = 0; mark < 30; ++mark) {
            for (int again = 0; again < 3; ++again)
                estimate.take({mark, 0, 0.01, 250}, 0.25);
        }
        QCOMPARE(estimate.bags(), 29);
        estimate.clear();
        QCOMPARE(estimate.bags(), 0);
    }
};

CAMPANEL_TEST(TestGainEstimate)

} // namespace test_gain_estimate

#include "test_gain_estimate.moc"
