// SPDX-License-Identifier: Apache-2.0
// Where the cuts of a change of program are drawn before they are made.
#include "app/program/change_film.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_change_film {

using namespace campanel::program;
using Kind = FilmCut::Kind;
using Cuts = std::vector<FilmCut>;

namespace {

// From 250 to 200 mm, cut in the middle of the cycle; 1250 mm/s, down to 625 mm/s in 0.4 s: 375 mm.
ChangeFilm slowing()
{
    return {.fromMm = 250,
            .toMm = 200,
            .cutToEndMm = 125,
            .endToCutMm = 100,
            .fullSpeed = 1250,
            .endSpeed = 625,
            .deceleration = 1562.5,
            .scrap = 2};
}

ChangeFilm even()
{
    ChangeFilm film = slowing();
    film.endSpeed = film.fullSpeed;
    film.deceleration = 0;
    return film;
}

const Cuts present{{100}, {350, Kind::Skipped}, {600}, {850}};

} // namespace

class TestChangeFilm : public QObject {
    Q_OBJECT

private slots:
    // The end of the cycle that has the last cut, 25 mm behind the knife, is over; the next one is 225 mm
    // ahead.
    void theNextEndOfACycleIsTheBoundary()
    {
        QCOMPARE(cutsOverChange(even(), present, 1250, 800),
                 (Cuts{{100}, {325, Kind::NextScrap}, {525, Kind::NextScrap}, {725, Kind::Next}}));
    }

    // The last cut was 100 mm ago, so that its cycle ends 25 mm ahead.
    void theFirstCutMayBeOfTheNextProgram()
    {
        const Cuts soon{{150}, {400}};
        QCOMPARE(cutsOverChange(even(), soon, 1250, 400),
                 (Cuts{{125, Kind::NextScrap}, {325, Kind::NextScrap}}));
    }

    void slowingDownTakesFilm()
    {
        // 375 mm are needed at full speed, 137.8 mm at 908 mm/s, none at the speed of the boundary.
        const Cuts fast = cutsOverChange(slowing(), present, 1250, 900);
        QCOMPARE(fast, (Cuts{{100}, {350, Kind::Skipped}, {575, Kind::NextScrap}, {775, Kind::NextScrap}}));
        QCOMPARE(cutsOverChange(slowing(), present, 908, 400), (Cuts{{100}, {325, Kind::NextScrap}}));
        QCOMPARE(cutsOverChange(slowing(), present, 625, 400), (Cuts{{100}, {325, Kind::NextScrap}}));
    }

    void cutsBeyondTheKnownOnesGoOn()
    {
        ChangeFilm film = slowing();
        film.deceleration /= 3;
        const Cuts cuts = cutsOverChange(film, {{100}}, 1250, 1600);
        QCOMPARE(cuts.size(), 7u);
        QCOMPARE(cuts[4], (FilmCut{1100, Kind::Present}));
        QCOMPARE(cuts[5], (FilmCut{1325, Kind::NextScrap}));
    }

    void theWholeChangeEndsWithTwoGoodBags()
    {
        QCOMPARE(cutsOfChange(slowing()), (Cuts{{250},
                                                {475, Kind::NextScrap},
                                                {675, Kind::NextScrap},
                                                {875, Kind::Next},
                                                {1075, Kind::Next}}));
        QCOMPARE(cutsOfChange({}), Cuts{});
    }
};

CAMPANEL_TEST(TestChangeFilm)

} // namespace test_change_film

#include "test_change_film.moc"
