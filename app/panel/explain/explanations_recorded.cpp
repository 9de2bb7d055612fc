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
    Explanation explanation;
    explanation.title = tr("Line utilization");
    explanation.value = Format::unknownText();
    explanation.meaning =
        tr("Time of the frames on the wire at this baud rate, with the silent intervals of the "
           "standard, divided by the communication time. At 100 % no master could poll faster; "
           "the rest is time spent waiting for controller and adapter.");
    explanation.formula = tr("time of the frames on the wire / communication time");
    const auto& report = m_figures.report();
    const auto share = report ? report->figures.wireShare() : std::nullopt;
    if (!share)
        return explanation;
    explanation.value = format.number(100 * *share, 1);
    explanation.unit = u"%"_s;
    explanation.numbers = tr("%1 s / %2 s")
                              .arg(format.number(secondsOf(report->figures.wireTime()), 2),
                                   format.number(secondsOf(report->figures.spentTime()), 2));
    return explanation;
}

Explanation Explanations::answers(Topic quantity) const
{
    const Format format;
    const auto& report = m_figures.report();
    const modbus::LatencyHistogram latency = report ? report->figures.latency() : modbus::LatencyHistogram();
    const bool isKnown = latency.count() > 0;
    const auto count = static_cast<double>(latency.count());
    Explanation explanation;
    explanation.value = Format::unknownText();
    const auto take = [&](std::chrono::microseconds time) {
        if (!isKnown)
            return;
        explanation.value = format.number(millisecondsOf(time), 1);
        explanation.unit = tr("ms");
    };
    if (quantity == AnswersLongest) {
        explanation.title = tr("Maximum response time");
        explanation.meaning =
            tr("Time from sending the request to the last byte of the response. This is one single response, "
               "perhaps hours ago: the percentages describe normal operation better.");
        explanation.formula = tr("maximum since the last reset of the counters");
        take(latency.maximum());
        return explanation;
    }
    const int percent = quantity == AnswersHalf ? 50 : quantity == Answers95 ? 95 : 99;
    explanation.title = quantity == AnswersHalf ? tr("50 % of responses within")
                                                : tr("%1 % of responses within").arg(percent);
    explanation.meaning =
        quantity == AnswersHalf
            ? tr("Time from sending the request to the last byte of the response, both frames on the wire "
                 "included. Counted since the start of the panel or the last reset of the counters.")
            : tr("%1 of 100 responses took at most this time.").arg(percent);
    explanation.formula =
        tr("all responses sorted by time: value at %1 % of their number, up to 6.25 % too high, "
           "never too low")
            .arg(percent);
    take(latency.percentile(percent / 100.0));
    if (isKnown)
        explanation.numbers =
            tr("time of response %1 of %2")
                .arg(format.grouped(std::ceil(count * percent / 100.0), 0), format.grouped(count, 0));
    return explanation;
}

Explanation Explanations::answerAllowance() const
{
    const Format format;
    const auto& report = m_figures.report();
    Explanation explanation;
    explanation.title = tr("Response timeout");
    explanation.value = Format::unknownText();
    explanation.meaning =
        tr("Waiting time for a response, in addition to both frames on the wire. The panel adapts "
           "this time to controller and adapter, and doubles it without a response.");
    explanation.formula = tr("%1 × the time in which 99 % of the last responses started, from %2 to %3 ms")
                              .arg(modbus::AnswerAllowance::margin)
                              .arg(modbus::AnswerAllowance::shortest.count())
                              .arg(modbus::AnswerAllowance::longest.count());
    if (report && report->answerAllowance.count() > 0) {
        explanation.value = format.number(static_cast<double>(report->answerAllowance.count()), 0);
        explanation.unit = tr("ms");
    }
    return explanation;
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
    mean.setMeasure(average, decimals, decimals, unit);
    mean.meaning = tr("Mean of all values recorded in the displayed time (n = %1).").arg(values);
    mean.formula = tr("sum of the values / n");
    mean.numbers = u"%1 / %2"_s.arg(format.grouped(average * count, decimals), values);
    QVariantList explanation{QVariant::fromValue(mean)};

    const double deviation = found.value(u"scatter"_s).toDouble();
    Explanation scatter;
    scatter.title = tr("Standard deviation");
    scatter.setMeasure(deviation, decimals, decimals, std::isfinite(deviation) ? unit : QString());
    scatter.meaning = tr("About two thirds of the values are closer to the mean than this value.");
    scatter.formula = tr("√(sum of (value − mean)² / (n − 1))");
    if (std::isfinite(deviation))
        scatter.numbers =
            u"√(%1 / (%2 − 1))"_s.arg(format.compact(deviation * deviation * (count - 1), 2, 4), values);
    explanation << QVariant::fromValue(scatter);

    Explanation ends;
    ends.title = tr("Minimum and maximum");
    ends.value = tr("%1 … %2", "lowest, highest")
                     .arg(format.amount(found.value(u"low"_s).toDouble(), decimals, unit),
                          format.amount(found.value(u"high"_s).toDouble(), decimals, unit));
    ends.unit = Units::of(unit).unit;
    ends.meaning = tr("Minimum and maximum are single values. The curve shows the mean of each column, the "
                      "pale band its minimum and maximum.");
    ends.formula = tr("minimum … maximum of the n values");
    explanation << QVariant::fromValue(ends);

    if (quantity > Trends::Deviation)
        return explanation;
    const double share = found.value(u"within"_s).toDouble();
    Explanation within;
    within.title = tr("Within the tolerance");
    within.value = format.number(100 * share, 1);
    within.unit = u"%"_s;
    within.meaning = tr("Each bag is compared with the tolerance that was valid at its production.");
    within.formula = tr("bags with a deviation within the tolerance / n");
    within.numbers = u"%1 / %2"_s.arg(format.grouped(std::round(share * count), 0), values);
    return explanation << QVariant::fromValue(within);
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
    Explanation explanation;
    explanation.title = tr("Mean at the cursor");
    explanation.setMeasure(values[1], decimals, decimals, trendUnit(quantity));
    explanation.meaning =
        tr("One column of the curves covers %1. At the cursor the minimum was %2, the maximum %3.")
            .arg(width, format.amount(values[0], decimals, trendUnit(quantity)),
                 format.amount(values[2], decimals, trendUnit(quantity)));
    explanation.formula = tr("sum of the column's values / number of values");
    return {QVariant::fromValue(explanation)};
}

QString Explanations::trendUnit(int quantity)
{
    switch (quantity) {
    case Trends::Rate:
        return tr("bags/min");
    case Trends::Latency:
        return tr("ms");
    case Trends::JamResidue:
        return u"%"_s;
    default:
        return u"mm"_s;
    }
}

} // namespace campanel::panel
