// SPDX-License-Identifier: Apache-2.0
#include "app/program/change_price.h"

#include "app/program/change_film.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace campanel::program {
namespace {

// The controller's own figures.
constexpr double fastShare = 10;   // of a bag: a cut moves by so much towards its mark while it aligns
constexpr double firstShare = 50;  // of a bag: the first cut is planned onto a mark that is so near
constexpr double firstTime = 5;    // of a cycle: the time that this needs before the sealing window
constexpr int maxSearchCycles = 4; // two marks one bag apart, and the cut that was planned meanwhile
constexpr int maxCycles = 60;
constexpr int places = 40;      // of the marks, over a bag
constexpr double scatterMm = 6; // by which products lie off their places

// The film as it passes the knife: its place is 0 at the boundary between the two programs.
class Film {
public:
    Film(double fromMm, double toMm, double cutShareFrom, double cutShareTo,
         const PriceParameters& parameters)
        : m_parameters(parameters)
        , m_bagMm(toMm)
        , m_cutMm(cutShareTo * toMm)
        , m_lastCutMm((cutShareFrom - 1) * fromMm)
    {
        m_limitMm = parameters.phaseLimitMm > 0 ? parameters.phaseLimitMm : toMm / fastShare;
        const auto laidBags = std::floor(parameters.layDistanceMm / fromMm) + 1;
        for (int i = 0; i < laidBags && hasProducts(); ++i)
            m_products.push_back(m_lastCutMm + (i + 0.5) * fromMm);
    }

    struct Run {
        int cycles = 0; // to the end of the first bag that counts
        int scrap = 0;
        int skipped = 0;
        double longestBagMm = 0;
    };
    // Cuts until a bag counts. The marks are found after so many cycles, -1: they never were lost, and lie so
    // far from the cuts.
    Run run(int searchCycles, double offMm)
    {
        Run run;
        bool isTracked = searchCycles < 0;
        bool wasTracked = isTracked;
        bool isSkipping = false;
        while (run.cycles < maxCycles) {
            if (!isTracked && run.cycles >= searchCycles)
                isTracked = align(offMm);
            const bool isAcross = isBlocked(isTracked, isSkipping);
            if (hasProducts())
                m_products.push_back(m_cutMm + layMm());
            ++run.cycles;
            if (isAcross) {
                ++run.skipped;
            } else {
                if (isSkipping)
                    run.longestBagMm = std::max(run.longestBagMm, m_cutMm - m_lastCutMm);
                m_lastCutMm = m_cutMm;
                if (wasTracked && run.scrap > 0) // the first bag is of both programs
                    return run;
                ++run.scrap;
                wasTracked = isTracked;
            }
            isSkipping = isAcross;
            m_cutMm += m_bagMm;
        }
        return run;
    }

private:
    [[nodiscard]] bool hasProducts() const { return m_parameters.hasAntiCut && m_parameters.productMm > 0; }
    [[nodiscard]] double layMm() const
    {
        return std::floor(m_parameters.layDistanceMm / m_bagMm) * m_bagMm + m_bagMm / 2;
    }
    // Moves the next cut towards its mark; returns true when it is there.
    bool align(double& offMm)
    {
        const bool isReached = std::abs(offMm) <= m_limitMm;
        const double step = isReached ? offMm : std::clamp(offMm, -m_bagMm / fastShare, m_bagMm / fastShare);
        offMm -= step;
        m_cutMm += step;
        return isReached;
    }
    // A knife that stands open keeps clear of where the cut may still be shifted to.
    [[nodiscard]] bool isBlocked(bool isTracked, bool isOpen) const
    {
        const double shift = !isOpen ? 0 : isTracked ? m_limitMm : m_bagMm / fastShare;
        const double reach = m_parameters.productMm / 2 + scatterMm + m_parameters.clearanceMm + shift;
        return std::ranges::any_of(m_products,
                                   [&](double middle) { return std::abs(middle - m_cutMm) <= reach; });
    }

    const PriceParameters& m_parameters;
    double m_bagMm;
    double m_cutMm; // place of the next cut
    double m_lastCutMm;
    double m_limitMm = 0;
    std::vector<double> m_products; // their middles
};

// Returns true when the cuts go on in register: the first one already meets its mark.
bool keepsRegister(double fromMm, double toMm, double movedMm, double engageShare, bool tracksMarks)
{
    return !tracksMarks ||
           (fromMm == toMm && std::abs(movedMm) <= toMm / firstShare && engageShare >= 1 / firstTime);
}

// The sealing window of the cut, as shares of the cycle.
struct Window {
    double engage = 0;
    double cut = 0;

    explicit Window(const SolvedProgram& solved)
        : engage(solved.cutter->cycle.tbS / solved.cutter->cycle.cycleTimeS)
        , cut(cutShare(solved))
    {
    }
};

} // namespace

ChangePrice changePrice(const SolvedProgram& from, const SolvedProgram& to, const ProgramChange& change,
                        const PriceParameters& parameters)
{
    const double fromMm = from.cutter->cycle.bagLengthMm;
    const double toMm = to.cutter->cycle.bagLengthMm;
    const Window before(from);
    const Window behind(to);
    const double movedMm = (behind.cut - before.cut) * toMm;
    const bool isKept = keepsRegister(fromMm, toMm, movedMm, behind.engage, parameters.tracksMarks);
    // Marks of the same bags are known; those of others are searched for, and may be anywhere.
    const bool isSearched = !isKept && fromMm != toMm;
    ChangePrice price;
    price.minScrap = maxCycles;
    int slowest = 0;
    for (int search = isSearched ? 1 : 0; search <= (isSearched ? maxSearchCycles : 0); ++search) {
        for (int place = 0; place <= (isSearched ? places : 0); ++place) {
            const double offMm = isSearched ? (static_cast<double>(place) / places - 0.5) * toMm : -movedMm;
            Film film(fromMm, toMm, before.cut, behind.cut, parameters);
            const Film::Run run = film.run(isKept ? -1 : search, offMm);
            price.minScrap = std::min(price.minScrap, run.scrap);
            price.maxScrap = std::max(price.maxScrap, run.scrap);
            price.maxSkipped = std::max(price.maxSkipped, run.skipped);
            price.longestBagMm = std::max(price.longestBagMm, run.longestBagMm);
            slowest = std::max(slowest, run.cycles);
        }
    }
    price.maxSeconds = from.cycleS() / change.speedBefore + change.timeS + change.productWaitS +
                       slowest * to.cycleS() / change.speedBehind;
    return price;
}

} // namespace campanel::program
