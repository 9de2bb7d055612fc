// SPDX-License-Identifier: Apache-2.0
// The fewest straight lines through a channel: parabolas with a known number; steps and closed gates; random
// channels against a grid search, which may not find fewer.
#include "profile/intervals/link_path.h"
#include "random_cases.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

namespace test_link_path {

using namespace campanel::profile::detail;

namespace {

// Returns how far the path leaves the channel at any gate; the knots between two gates are compared with the
// walls there.
double outside(const std::vector<Gate>& channel, const std::vector<PathPoint>& path)
{
    const auto speedAt = [&](double time) {
        std::size_t i = 1;
        while (i + 1 < path.size() && path[i].timeS < time)
            ++i;
        const PathPoint& a = path[i - 1];
        const PathPoint& b = path[i];
        return b.timeS > a.timeS
                   ? a.speedHz + (b.speedHz - a.speedHz) * (time - a.timeS) / (b.timeS - a.timeS)
                   : b.speedHz;
    };
    double worst = 0;
    for (const Gate& gate : channel) {
        const double speed = speedAt(gate.timeS);
        worst = std::max({worst, gate.lowerHz - speed, speed - gate.upperHz});
    }
    for (const PathPoint& knot : path) {
        for (std::size_t i = 1; i < channel.size(); ++i) {
            const Gate& a = channel[i - 1];
            const Gate& b = channel[i];
            if (knot.timeS < a.timeS || knot.timeS > b.timeS || b.timeS == a.timeS)
                continue;
            const double x = (knot.timeS - a.timeS) / (b.timeS - a.timeS);
            worst = std::max({worst, a.lowerHz + (b.lowerHz - a.lowerHz) * x - knot.speedHz,
                              knot.speedHz - a.upperHz - (b.upperHz - a.upperHz) * x});
        }
    }
    return worst;
}

// Returns the fewest lines between knots on a grid: at the gates and half-way between them, on levels of the
// channel.
int minOnGrid(const std::vector<Gate>& channel)
{
    constexpr int levels = 12;
    std::vector<Gate> columns;
    for (std::size_t i = 0; i < channel.size(); ++i) {
        if (i > 0)
            columns.push_back({(channel[i - 1].timeS + channel[i].timeS) / 2,
                               (channel[i - 1].lowerHz + channel[i].lowerHz) / 2,
                               (channel[i - 1].upperHz + channel[i].upperHz) / 2});
        columns.push_back(channel[i]);
    }
    const auto value = [&](std::size_t column, int level) {
        const Gate& gate = columns[column];
        return gate.lowerHz + (gate.upperHz - gate.lowerHz) * level / levels;
    };
    const auto fits = [&](std::size_t i, int from, std::size_t j, int to) {
        for (std::size_t c = i + 1; c < j; ++c) {
            const double x = (columns[c].timeS - columns[i].timeS) / (columns[j].timeS - columns[i].timeS);
            const double speed = value(i, from) + (value(j, to) - value(i, from)) * x;
            if (speed < columns[c].lowerHz || speed > columns[c].upperHz)
                return false;
        }
        return true;
    };
    std::vector<std::vector<int>> least(columns.size(), std::vector<int>(levels + 1, 1000));
    least[0].assign(levels + 1, 0);
    for (std::size_t j = 1; j < columns.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            for (int from = 0; from <= levels; ++from) {
                for (int to = 0; to <= levels; ++to) {
                    int& best = least[j][static_cast<std::size_t>(to)];
                    const int before = least[i][static_cast<std::size_t>(from)];
                    if (before + 1 < best && fits(i, from, j, to))
                        best = before + 1;
                }
            }
        }
    }
    return *std::ranges::min_element(least.back());
}

} // namespace

class TestLinkPath : public QObject {
    Q_OBJECT

private slots:
    void parabola_data();
    void parabola();
    void straightIsOne();
    void steps();
    void nothing();
    void randomChannels();
};

void TestLinkPath::parabola_data()
{
    QTest::addColumn<int>("lines");
    for (const int lines : {1, 2, 3, 7, 20})
        QTest::addRow("%d", lines) << lines;
}

// v = t^2 for 1 s: a line of duration h keeps within e when h^2 <= 8 e, so 1/h lines touch both walls
// exactly.
void TestLinkPath::parabola()
{
    QFETCH(int, lines);
    constexpr int gates = 4000;
    for (const double share : {1.001, 0.999}) {
        const double error = share / (8.0 * lines * lines);
        std::vector<Gate> channel;
        for (int i = 0; i <= gates; ++i) {
            const double t = static_cast<double>(i) / gates;
            channel.push_back({t, t * t - error, t * t + error});
        }
        const auto path = minLinks(channel, 100);
        QVERIFY(path);
        QCOMPARE(static_cast<int>(path->size()) - 1, share > 1 ? lines : lines + 1);
        QVERIFY(outside(channel, *path) < 1e-12);
        QVERIFY(!minLinks(channel, path->size() - 2));
    }
}

void TestLinkPath::straightIsOne()
{
    const std::vector<Gate> channel{{0, 1, 1}, {1, 2.9, 3.1}, {2, 5, 5}};
    const auto path = minLinks(channel, 5);
    QVERIFY(path && path->size() == 2);
    QCOMPARE(path->front().speedHz, 1.0);
    QCOMPARE(path->back().speedHz, 5.0);
}

// A step of the walls that a line can pass, and one that it cannot.
void TestLinkPath::steps()
{
    std::vector<Gate> channel{{0, 0, 1}, {1, 0, 1}, {1, 0.8, 1.8}, {2, 0.8, 1.8}};
    const auto path = minLinks(channel, 5);
    QVERIFY(path);
    QVERIFY(outside(channel, *path) < 1e-12);
    channel[2].lowerHz = channel[3].lowerHz = 1.1;
    QVERIFY(!minLinks(channel, 5));
}

void TestLinkPath::nothing()
{
    QVERIFY(!minLinks({}, 5));
    const std::vector<Gate> shut{{0, 0, 1}, {1, 2, 1}};
    QVERIFY(!minLinks(shut, 5));
    const std::vector<Gate> open{{0, 0, 1}, {1, 0, 1}};
    QVERIFY(!minLinks(open, 0));
    const std::vector<Gate> point{{0, 2, 4}};
    const auto path = minLinks(point, 1);
    QVERIFY(path && path->size() == 2 && path->front().speedHz == 3);
}

void TestLinkPath::randomChannels()
{
    constexpr unsigned seed = 77;
    const int cases = std::max(100, campanel::test::randomCases() / 50);
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int equal = 0;
    for (int i = 0; i < cases; ++i) {
        std::vector<Gate> channel;
        const double width = uniform(0.05, 1);
        double time = 0;
        double middle = 0;
        for (int g = 0; g < 12; ++g) {
            channel.push_back({time, middle - width * uniform(0.2, 1), middle + width * uniform(0.2, 1)});
            time += uniform(0.1, 1);
            middle += uniform(-1, 1);
        }
        const auto path = minLinks(channel, 100);
        QVERIFY2(path, qPrintable(QString::number(i)));
        QVERIFY2(outside(channel, *path) < 1e-9, qPrintable(QString::number(i)));
        const int links = static_cast<int>(path->size()) - 1;
        const int onGrid = minOnGrid(channel);
        QVERIFY2(links <= onGrid,
                 qPrintable(QStringLiteral("case %1: %2, %3 on the grid").arg(i).arg(links).arg(onGrid)));
        equal += links == onGrid ? 1 : 0;
    }
    qInfo("as few on the grid in %d of %d", equal, cases);
    QVERIFY(equal * 2 > cases);
}

CAMPANEL_TEST(TestLinkPath)

} // namespace test_link_path

#include "test_link_path.moc"
