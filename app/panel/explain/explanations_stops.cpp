// SPDX-License-Identifier: Apache-2.0
// Explains the effectiveness of the displayed shift; see explanations.h.
#include "app/panel/explain/explanations.h"

#include "app/panel/stops/stops.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr double msPerMinute = 60'000;

QString minutesText(double ms)
{
    return Format().number(ms / msPerMinute, 1);
}

} // namespace

Explanation Explanations::effectiveness(Topic quantity) const
{
    const Format format;
    const ShiftSummary& summary = m_stops.shift()->summary();
    const Production& production = summary.production;
    const panel::Oee& figures = m_stops.shift()->figures();
    const auto percent = [&](double share) { return format.number(100 * share, 1); };
    const auto isKnown = [](double value) { return std::isfinite(value); };
    Explanation explanation;
    explanation.unit = u"%"_s;
    switch (quantity) {
    case Availability:
        explanation.title = tr("Availability");
        explanation.value = percent(figures.availability);
        explanation.meaning =
            tr("Share of the planned time in which the machine ran. Planned time is the recorded time of the "
               "shift (%1 min) without planned stops (%2 min).")
                .arg(minutesText(static_cast<double>(summary.knownMs)),
                     minutesText(static_cast<double>(summary.plannedStopMs)));
        explanation.formula = tr("run time / planned time");
        if (isKnown(figures.availability))
            explanation.numbers = tr("%1 min / %2 min")
                                      .arg(minutesText(static_cast<double>(production.runMs)),
                                           minutesText(static_cast<double>(production.plannedMs)));
        break;
    case Performance:
        explanation.title = tr("Performance");
        explanation.value = percent(figures.performance);
        explanation.meaning = tr("Speed compared with the ideal rate: the fastest rate of each recipe, or "
                                 "the rate in Settings. "
                                 "A piece is a bag, a stroke or a cycle; a skipped cut takes the time of a "
                                 "piece. Waiting of up to "
                                 "%1 s is a loss of performance. At most 100 %.")
                                  .arg(MachineWatch::suspendedAfter.count());
        explanation.formula = tr("sum of pieces × ideal time per piece / run time");
        if (isKnown(figures.performance))
            explanation.numbers = tr("%1 min for %2 pieces / %3 min")
                                      .arg(minutesText(production.idealMs),
                                           format.grouped(static_cast<double>(production.pieces), 0),
                                           minutesText(static_cast<double>(production.runMs)));
        break;
    case Quality:
        explanation.title = tr("Quality");
        explanation.value = percent(figures.quality);
        explanation.meaning = tr("Share of good pieces. Not good: %1 out of tolerance, %2 start-up scrap, %3 "
                                 "skipped cuts.")
                                  .arg(production.outOfTolerance)
                                  .arg(production.startUpScrap)
                                  .arg(production.skipped);
        explanation.formula = tr("good pieces / pieces");
        if (isKnown(figures.quality))
            explanation.numbers = u"%1 / %2"_s.arg(
                format.grouped(static_cast<double>(production.pieces - production.rejects()), 0),
                format.grouped(static_cast<double>(production.pieces), 0));
        break;
    default:
        explanation.title = tr("Overall equipment effectiveness (OEE)");
        explanation.value = percent(figures.oee);
        explanation.meaning = tr("Good pieces at the ideal rate, as a share of the planned time.");
        explanation.formula = tr("availability × performance × quality");
        if (isKnown(figures.performance) && isKnown(figures.quality))
            explanation.numbers = u"%1 % × %2 % × %3 %"_s.arg(
                percent(figures.availability), percent(figures.performance), percent(figures.quality));
        break;
    }
    if (explanation.value == Format::unknownText())
        explanation.unit.clear();
    return explanation;
}

} // namespace campanel::panel
