// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/shift_summary.h"

#include "app/panel/kit/numbers.h"

#include <QMap>

#include <algorithm>
#include <array>
#include <tuple>

namespace campanel::panel {

using store::StateInterval;
using store::StopRow;

namespace {

constexpr std::size_t barColumns = 480; // one minute of a shift of eight hours
constexpr std::size_t states = 8;
constexpr double msPerMinute = 60'000;

static_assert(static_cast<std::size_t>(StateInterval::State::Suspended) + 1 == states);

void addProduction(Production& production, const StateInterval& each)
{
    production.pieces += each.pieces + each.skipped;
    production.outOfTolerance += each.outOfTolerance;
    production.startUpScrap += each.startUpScrap;
    production.skipped += each.skipped;
    const qint64 cycles = each.pieces + each.skipped;
    if (cycles > 0)
        production.idealMs +=
            each.idealPerMin > 0 ? static_cast<double>(cycles) * msPerMinute / each.idealPerMin : unknown;
    if (store::produces(each.state))
        production.runMs += each.durationMs;
}

// Returns the stretches of the states that fill most of each column.
QList<BarStretch> barOf(const QList<StateInterval>& intervals, const Shift& shift)
{
    std::array<std::array<double, states>, barColumns> filled{};
    const double columnMs = static_cast<double>(shift.durationMs()) / barColumns;
    for (const StateInterval& each : intervals) {
        const double begin = static_cast<double>(each.beginMs - shift.beginMs) / columnMs;
        const double end = begin + static_cast<double>(each.durationMs) / columnMs;
        for (auto i = static_cast<std::size_t>(begin); i < barColumns && static_cast<double>(i) < end; ++i) {
            const auto left = static_cast<double>(i);
            filled[i][static_cast<std::size_t>(each.state)] +=
                std::min(end, left + 1) - std::max(begin, left);
        }
    }
    QList<BarStretch> bar;
    constexpr double share = 1.0 / barColumns;
    for (std::size_t i = 0; i < barColumns; ++i) {
        const auto most = std::ranges::max_element(filled[i]);
        if (*most <= 0)
            continue;
        const auto state = static_cast<StateInterval::State>(most - filled[i].begin());
        const double from = static_cast<double>(i) * share;
        const bool isNext = !bar.isEmpty() && bar.last().state == state &&
                            from - bar.last().from - bar.last().width < share / 2;
        if (isNext)
            bar.last().width += share;
        else
            bar << BarStretch{from, share, state};
    }
    return bar;
}

QList<ReasonShare> reasonsOf(const QList<ShiftStop>& stops, qint64 shortMs)
{
    QMap<std::tuple<QString, bool, bool>, ReasonShare> shares;
    for (const ShiftStop& stop : stops) {
        const bool isShort = stop.answer.reason.isEmpty() && stop.durationMs <= shortMs;
        ReasonShare& share = shares[{stop.answer.reason, isShort, stop.answer.isPlanned}];
        share.reason = stop.answer.reason;
        share.isShort = isShort;
        share.isPlanned = stop.answer.isPlanned;
        share.durationMs += stop.durationMs;
        ++share.count;
    }
    QList<ReasonShare> sorted = shares.values();
    std::ranges::stable_sort(sorted, std::greater(), &ReasonShare::durationMs);
    return sorted;
}

} // namespace

ShiftSummary summarize(const store::StopLog::Span& span, const Shift& shift, qint64 shortMs)
{
    ShiftSummary summary;
    summary.shift = shift;
    QMap<qint64, StopRow> answers;
    for (const StopRow& each : span.stops)
        answers.insert(each.id, each);
    QMap<qint64, qsizetype> places; // of stops in the list
    for (const StateInterval& each : span.intervals) {
        summary.knownMs += each.durationMs;
        summary.isClockDoubtful = summary.isClockDoubtful || each.isClockDoubtful;
        addProduction(summary.production, each);
        const QString program = each.program + QStringLiteral(" v") + QString::number(each.version);
        if (store::produces(each.state) && !each.program.isEmpty() && !summary.programs.contains(program))
            summary.programs << program;
        if (each.stop == 0)
            continue;
        const StopRow answer = answers.value(each.stop);
        (answer.isPlanned ? summary.plannedStopMs : summary.stopMs) += each.durationMs;
        const auto place = places.find(each.stop);
        if (place == places.end()) {
            places.insert(each.stop, summary.stops.size());
            summary.stops << ShiftStop{each.stop,  each.beginMs, each.durationMs,
                                       each.state, answer,       each.isClockDoubtful};
        } else {
            summary.stops[*place].durationMs += each.durationMs;
        }
    }
    if (!shift.isWorking) { // nothing was planned
        summary.plannedStopMs = summary.knownMs;
        summary.stopMs = 0;
    }
    summary.production.plannedMs = summary.knownMs - summary.plannedStopMs;
    summary.bar = barOf(span.intervals, shift);
    summary.reasons = reasonsOf(summary.stops, shortMs);
    return summary;
}

} // namespace campanel::panel
