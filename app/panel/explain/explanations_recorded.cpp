// SPDX-License-Identifier: Apache-2.0
// Explains the statistics of the line and of the trends; see explanations.h.
#include "app/panel/explain/explanations.h"

#include "app/panel/maintenance/line_figures.h"
#include "app/panel/trends/trends.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

double secondsOf(std::chrono::nanoseconds time)
{
    return std::chrono::duration<double>(time).count();
}

double millisecondsOf(std::chrono::nanoseconds time)
{
    return 1000 * secondsOf(time);
}

// Returns the decimals of a mean of this quantity, as on the page.
int decimalsOf(int quantity)
{
    return quantity == Trends::Rate || quantity == Trends::Latency ? 1 : 2;
}

} // namespace

Explanation Explanations::wireShare() const
{
    const Format format;
    Explanation told;
    told.title = tr("Share of the wire's limit");
    told.value = Format::unknownText();
    told.meaning =
        tr("How much of the time that the exchanges took the frames themselves need at this baud "
           "rate, with the silences of the standard. At 100 % no master could ask faster; what is "
           "missing was spent waiting for the controller, the adapter or answers that never came.");
    told.formula = tr("time of the frames on the wire / time of the exchanges");
    const auto& report = m_figures.report();
    const auto share = report ? report->figures.wireShare() : std::nullopt;
    if (!share)
        return told;
    told.value = format.number(100 * *share, 1);
    told.unit = u"%"_s;
    told.numbers = tr("%1 s / %2 s")
                       .arg(format.number(secondsOf(report->figures.wireTime()), 2),
                            format.number(secondsOf(report->figures.spentTime()), 2));
    return told;
}

Explanation Explanations::answers(Quantity quantity) const
{
    const Format format;
    const auto& report = m_figures.report();
    const modbus::LatencyHistogram latency = report ? report->figures.latency() : modbus::LatencyHistogram();
    const bool isKnown = latency.count() > 0;
    const auto count = static_cast<double>(latency.count());
    Explanation told;
    told.value = Format::unknownText();
    const auto take = [&](std::chrono::microseconds time) {
        if (!isKnown)
            return;
        told.value = format.number(millisecondsOf(time), 1);
        told.unit = tr("ms");
    };
    if (quantity == AnswersLongest) {
        told.title = tr("Longest time of an answer");
        told.meaning =
            tr("From handing the question to the port to the last byte of its answer. One single answer, "
               "perhaps hours ago: the percentages say more about every day.");
        told.formula = tr("the longest since the count began");
        take(latency.maximum());
        return told;
    }
    const int percent = quantity == AnswersHalf ? 50 : quantity == Answers95 ? 95 : 99;
    told.title = quantity == AnswersHalf ? tr("Half of the answers came within")
                                         : tr("%1 % of the answers came within").arg(percent);
    told.meaning =
        quantity == AnswersHalf
            ? tr("From handing the question to the port to the last byte of its answer, both frames on the "
                 "wire included. Counted since the panel was started or Count from zero was pressed.")
            : tr("%1 of 100 answers took no longer than this.").arg(percent);
    told.formula = tr("all answers in the order of their times: the time of the one at %1 % of their number, "
                      "at most 6.25 % too high, never too low")
                       .arg(percent);
    take(latency.percentile(percent / 100.0));
    if (isKnown)
        told.numbers =
            tr("time of number %1 of %2")
                .arg(format.grouped(std::ceil(count * percent / 100.0), 0), format.grouped(count, 0));
    return told;
}

Explanation Explanations::answerAllowance() const
{
    const Format format;
    const auto& report = m_figures.report();
    Explanation told;
    told.title = tr("Allowed beyond wire time");
    told.value = Format::unknownText();
    told.meaning = tr("How long the panel waits for an answer, beyond what both frames need on the wire, "
                      "before it counts as missing. It follows what this controller and adapter need, and "
                      "doubles when nothing comes.");
    told.formula = tr("%1 × the time within which 99 % of the last answers began, from %2 to %3 ms")
                       .arg(modbus::AnswerAllowance::margin)
                       .arg(modbus::AnswerAllowance::shortest.count())
                       .arg(modbus::AnswerAllowance::longest.count());
    if (report && report->answerAllowance.count() > 0) {
        told.value = format.number(static_cast<double>(report->answerAllowance.count()), 0);
        told.unit = tr("ms");
    }
    return told;
}

QVariantList Explanations::ofTrend(int lane) const
{
    const QVariantList statistics = m_trends.statistics();
    if (lane < 0 || lane >= statistics.size() || lane >= m_trends.chosen().size())
        return {};
    const QVariantMap found = statistics[lane].toMap();
    const double count = found.value(u"count"_s).toDouble();
    if (!(count > 0))
        return {};
    const Format format;
    const int quantity = m_trends.chosen()[lane];
    const int decimals = decimalsOf(quantity);
    const double average = found.value(u"mean"_s).toDouble();
    const QString values = format.grouped(count, 0);
    const QString unit = trendUnit(quantity);

    Explanation mean;
    mean.title = tr("Mean");
    mean.value = format.number(average, decimals);
    mean.unit = unit;
    mean.meaning = tr("Of all values recorded in the time that is shown (n = %1).").arg(values);
    mean.formula = tr("sum of the values / n");
    mean.numbers = u"%1 / %2"_s.arg(format.grouped(average * count, decimals), values);
    QVariantList told{QVariant::fromValue(mean)};

    const double deviation = found.value(u"scatter"_s).toDouble();
    Explanation scatter;
    scatter.title = tr("Scatter");
    scatter.value = format.number(deviation, decimals);
    scatter.unit = std::isfinite(deviation) ? unit : QString();
    scatter.meaning =
        tr("Standard deviation: about two thirds of the values are closer to the mean than this.");
    scatter.formula = tr("√(sum of (value − mean)² / (n − 1))");
    if (std::isfinite(deviation))
        scatter.numbers =
            u"√(%1 / (%2 − 1))"_s.arg(format.compact(deviation * deviation * (count - 1), 2, 4), values);
    told << QVariant::fromValue(scatter);

    Explanation ends;
    ends.title = tr("Lowest and highest");
    ends.value = tr("%1 … %2", "lowest, highest")
                     .arg(format.number(found.value(u"low"_s).toDouble(), decimals),
                          format.number(found.value(u"high"_s).toDouble(), decimals));
    ends.unit = unit;
    ends.meaning =
        tr("Single values. The curve is the mean of each column, the pale band around it goes from "
           "the lowest to the highest value of that column.");
    ends.formula = tr("the lowest … the highest of the n values");
    told << QVariant::fromValue(ends);

    if (quantity > Trends::Deviation)
        return told;
    const double share = found.value(u"within"_s).toDouble();
    Explanation within;
    within.title = tr("Within the tolerance");
    within.value = format.number(100 * share, 1);
    within.unit = u"%"_s;
    within.meaning = tr("Each bag is judged by the tolerance that held when it was made.");
    within.formula = tr("bags whose deviation is not above the tolerance / n");
    within.numbers = u"%1 / %2"_s.arg(format.grouped(std::round(share * count), 0), values);
    return told << QVariant::fromValue(within);
}

QVariantList Explanations::ofTrendCursor(int lane, const QList<double>& values) const
{
    if (lane < 0 || lane >= m_trends.chosen().size() || values.size() != 3 || !std::isfinite(values[1]))
        return {};
    constexpr qint64 msPerSecond = 1000;
    constexpr qint64 msPerMinute = 60'000;
    constexpr qint64 msPerHour = 3'600'000;
    const Format format;
    const int quantity = m_trends.chosen()[lane];
    const int decimals = decimalsOf(quantity);
    const qint64 columnMs = m_trends.columnMs();
    const QString width = columnMs >= msPerHour     ? tr("%1 h").arg(columnMs / msPerHour)
                          : columnMs >= msPerMinute ? tr("%1 min").arg(columnMs / msPerMinute)
                                                    : tr("%1 s").arg(columnMs / msPerSecond);
    Explanation told;
    told.title = tr("Mean at the cursor");
    told.value = format.number(values[1], decimals);
    told.unit = trendUnit(quantity);
    told.meaning =
        tr("The curves are drawn in columns of %1 each. In the one at the cursor the lowest value was "
           "%2, the highest %3.")
            .arg(width, format.number(values[0], decimals), format.number(values[2], decimals));
    told.formula = tr("sum of the column's values / their number");
    return {QVariant::fromValue(told)};
}

QString Explanations::trendUnit(int quantity)
{
    switch (quantity) {
    case Trends::Rate:
        return tr("bags/min");
    case Trends::Latency:
        return tr("ms");
    default:
        return tr("mm");
    }
}

} // namespace campanel::panel
