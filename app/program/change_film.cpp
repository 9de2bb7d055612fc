// SPDX-License-Identifier: Apache-2.0
#include "app/program/change_film.h"

#include <algorithm>

namespace campanel::program {
namespace {

constexpr int goodBags = 2; // of a change that is drawn whole
constexpr int maxNextCuts = 64;

// Returns the film until a boundary is possible.
double slowingMm(const ChangeFilm& change, double speed)
{
    if (!(change.deceleration > 0))
        return 0;
    return std::max(0.0, (speed * speed - change.endSpeed * change.endSpeed) / (2 * change.deceleration));
}

// Adds the cuts of the new program behind the boundary as long as `isWanted`.
template <typename Condition>
void addNext(std::vector<FilmCut>& cuts, const ChangeFilm& change, double boundaryMm, Condition isWanted)
{
    for (int bag = 0; bag < maxNextCuts; ++bag) {
        const FilmCut cut{boundaryMm + change.endToCutMm + bag * change.toMm,
                          bag < change.scrap ? FilmCut::Kind::NextScrap : FilmCut::Kind::Next};
        if (!isWanted(cut, bag))
            return;
        cuts.push_back(cut);
    }
}

} // namespace

double cutShare(const SolvedProgram& solved)
{
    const auto& cycle = solved.cutter->cycle;
    return (cycle.tbS + cycle.tcS) / 2 / cycle.cycleTimeS;
}

ChangeFilm changeFilm(const SolvedProgram& from, const SolvedProgram& to, const ProgramChange& change,
                      const ChangePrice& price)
{
    ChangeFilm film;
    film.fromMm = from.cutter->cycle.bagLengthMm;
    film.toMm = to.cutter->cycle.bagLengthMm;
    film.cutToEndMm = (1 - cutShare(from)) * film.fromMm;
    film.endToCutMm = cutShare(to) * film.toMm;
    const double programSpeed = film.fromMm / from.cutter->cycle.cycleTimeS;
    film.fullSpeed = change.speedBefore * programSpeed;
    film.endSpeed = change.way == ChangeWay::LeavesLine ? 0 : change.shareBefore * programSpeed;
    if (change.slowingS > 0)
        film.deceleration = (film.fullSpeed - film.endSpeed) / change.slowingS;
    film.scrap = price.maxScrap;
    return film;
}

std::vector<FilmCut> cutsOverChange(const ChangeFilm& change, const std::vector<FilmCut>& present,
                                    double speed, double reachMm)
{
    if (present.empty() || !(change.fromMm > 0) || !(change.toMm > 0))
        return present;
    std::vector<FilmCut> cuts;
    const double earliestMm = slowingMm(change, speed);
    double lastMm = present.front().distanceMm - change.fromMm; // made already
    while (lastMm < reachMm && (lastMm + change.cutToEndMm <= 0 || lastMm + change.cutToEndMm < earliestMm)) {
        const FilmCut next =
            cuts.size() < present.size() ? present[cuts.size()] : FilmCut{lastMm + change.fromMm};
        cuts.push_back(next);
        lastMm = next.distanceMm;
    }
    addNext(cuts, change, lastMm + change.cutToEndMm,
            [reachMm](const FilmCut& cut, int) { return cut.distanceMm <= reachMm; });
    return cuts;
}

std::vector<FilmCut> cutsOfChange(const ChangeFilm& change)
{
    if (!(change.fromMm > 0) || !(change.toMm > 0))
        return {};
    std::vector<FilmCut> cuts{{change.fromMm}};
    const double earliestMm = slowingMm(change, change.fullSpeed);
    while (cuts.back().distanceMm + change.cutToEndMm < earliestMm)
        cuts.push_back({cuts.back().distanceMm + change.fromMm});
    addNext(cuts, change, cuts.back().distanceMm + change.cutToEndMm,
            [&change](const FilmCut&, int bag) { return bag < change.scrap + goodBags; });
    return cuts;
}

} // namespace campanel::program
