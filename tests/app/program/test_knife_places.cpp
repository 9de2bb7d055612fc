// SPDX-License-Identifier: Apache-2.0
// Where knives cut that are not evenly spaced, found in the lengths of made-up bags.
#include "app/program/knife_places.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <vector>

namespace test_knife_places {

using campanel::program::KnifePlaces;

class TestKnifePlaces : public QObject {
    Q_OBJECT

private:
    // Bags of 0.032 mm scatter, whose mean length is off, too.
    static KnifePlaces learned(const std::vector<double>& placesMm, int bags, unsigned seed,
                               double offMm = 0.01)
    {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, 0.032);
        const auto knives = placesMm.size();
        KnifePlaces places(static_cast<int>(knives));
        for (int i = 1; i <= bags; ++i) {
            const std::size_t knife = static_cast<std::size_t>(i) % knives;
            const std::size_t before = (knife + knives - 1) % knives;
            places.take(static_cast<int>(knife) + 1,
                        placesMm[knife] - placesMm[before] + offMm + noise(random));
        }
        return places;
    }

private slots:
    // 0.1 mm in 200 bags, with a margin that is true: of 300 runs some two thirds are within it.
    void aTenthInTwoHundredBags_data()
    {
        QTest::addColumn<QList<double>>("places");
        QTest::newRow("2 knives") << QList<double>{0, 0.1};
        QTest::newRow("3 knives") << QList<double>{0, 0.1, 0};
        QTest::newRow("4 knives") << QList<double>{0, -0.1, 0.05, 0.1};
    }
    void aTenthInTwoHundredBags()
    {
        QFETCH(QList<double>, places);
        const std::vector<double> placesMm(places.begin(), places.end());
        int within = 0;
        int all = 0;
        for (unsigned seed = 1; seed <= 300; ++seed) {
            const KnifePlaces found = learned(placesMm, 200, seed);
            for (int knife = 2; knife <= found.knives(); ++knife) {
                const auto place = found.place(knife);
                QVERIFY(place);
                const double error = place->mm - placesMm[static_cast<std::size_t>(knife - 1)];
                QVERIFY2(std::abs(error) < 0.03, qPrintable(QString::number(error)));
                within += std::abs(error) < place->marginMm ? 1 : 0;
                ++all;
            }
            const auto offered = found.offered(2, 0.0);
            QVERIFY(offered && std::abs(*offered - placesMm[1]) < 0.03);
        }
        QVERIFY2(within > all * 60 / 100 && within < all * 76 / 100,
                 qPrintable(QStringLiteral("%1 of %2").arg(within).arg(all)));
    }

    void offersNothing()
    {
        QVERIFY(!learned({0, 0.1}, 2 * KnifePlaces::minBags - 2, 1).offered(2, 0.0)); // too few bags
        QVERIFY(!learned({0}, 400, 1).offered(1, 0.0));                               // one knife
        QVERIFY(!learned({0, 0.1}, 400, 1).offered(3, 0.0));                          // no such knife
        for (unsigned seed = 1; seed <= 300; ++seed)
            QVERIFY(!learned({0, 0}, 400, seed).offered(2, 0.0));
    }

    // The learned place adds to the one that is entered.
    void addsToWhatIsEntered()
    {
        const auto offered = learned({0, 0.06}, 400, 7).offered(2, 0.04);
        QVERIFY(offered && std::abs(*offered - 0.1) < 0.015);
    }
};

CAMPANEL_TEST(TestKnifePlaces)

} // namespace test_knife_places

#include "test_knife_places.moc"
