// SPDX-License-Identifier: Apache-2.0
// The figures and rows of a simulated run.
#include "app/cli/simulate/simulate_figures.h"

#include "app/cli/report.h"
#include "modbus/map/protocol.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using controller::PackedBag;
using controller::PackingResult;
using modbus::BagBit;

// The distance from which a tracked cut has lost its phase.
constexpr double lostPhaseMm = 2.0;
// The distance of a cut from its print that a customer sees.
constexpr double farFromMarkMm = 0.4;

bool has(const PackedBag& bag, BagBit bit)
{
    return (bag.flags >> static_cast<unsigned>(bit) & 1u) != 0;
}

QByteArray skipCause(const PackedBag& bag)
{
    if (bag.lengths == 1)
        return {};
    return bag.skipCause == static_cast<std::uint16_t>(modbus::SkipCause::ProductTooLong) ? "product_too_long"
                                                                                          : "product_across";
}

QJsonObject alarmsObject(const PackingResult& result)
{
    QJsonObject alarms;
    for (const modbus::EnumInfo& each : modbus::enumerations()) {
        if (each.name != "WarningBit")
            continue;
        for (const modbus::EnumValue& bit : each.values) {
            if (bit.value >= static_cast<std::uint16_t>(modbus::WarningBit::MarksLost))
                alarms[fromView(bit.name)] = static_cast<qint64>(result.alarms[bit.value]);
        }
    }
    return alarms;
}

QJsonObject cutsObject(const PackingResult& result, std::uint32_t through, std::uint32_t phaseLost)
{
    const auto skips = [&result](modbus::SkipCause cause) {
        return static_cast<qint64>(result.skips[static_cast<std::size_t>(cause)]);
    };
    return {{u"skipped"_s, static_cast<qint64>(result.cutsSkipped)},
            {u"skipped_product_across"_s, skips(modbus::SkipCause::ProductAcross)},
            {u"skipped_product_too_long"_s, skips(modbus::SkipCause::ProductTooLong)},
            {u"skipped_unexplained"_s, static_cast<qint64>(result.skipsUnexplained)},
            {u"skipped_farthest_product_mm"_s, result.maxSkipGapMm},
            {u"through_product"_s, static_cast<qint64>(through)},
            {u"phase_lost"_s, static_cast<qint64>(phaseLost)},
            {u"corrections_limited"_s, static_cast<qint64>(result.correctionsLimited)}};
}

QJsonObject jamsObject(const controller::JamFigures& jams)
{
    return {{u"count"_s, static_cast<qint64>(jams.count)},
            {u"seen"_s, static_cast<qint64>(jams.seen)},
            {u"not_armed"_s, static_cast<qint64>(jams.notArmed)},
            {u"false"_s, static_cast<qint64>(jams.falsely)},
            {u"seen_degrees"_s, jams.meanSeenDegrees},
            {u"seen_degrees_largest"_s, jams.longestSeenDegrees},
            {u"seen_ms_largest"_s, jams.longestSeenMs},
            {u"run_on_degrees_largest"_s, jams.longestRunOnDegrees},
            {u"cut_through"_s, static_cast<qint64>(jams.cutThrough)},
            {u"largest_force_n"_s, jams.largestForceN}};
}

QJsonObject spreadObject(const Spread& spread)
{
    return {{u"mean"_s, orNull(spread.mean())},
            {u"standard_deviation"_s, orNull(spread.deviation())},
            {u"rms"_s, orNull(spread.rms())},
            {u"largest"_s, orNull(spread.largest())}};
}

} // namespace

void Spread::add(double value)
{
    ++m_count;
    const double from = value - m_mean;
    m_mean += from / m_count;
    m_squares += from * (value - m_mean);
    m_largest = std::max(m_largest, std::abs(value));
}

std::optional<double> Spread::mean() const
{
    return m_count > 0 ? std::optional(m_mean) : std::nullopt;
}

std::optional<double> Spread::deviation() const
{
    return m_count > 1 ? std::optional(std::sqrt(m_squares / (m_count - 1))) : std::nullopt;
}

std::optional<double> Spread::rms() const
{
    return m_count > 0 ? std::optional(std::sqrt(m_mean * m_mean + m_squares / m_count)) : std::nullopt;
}

std::optional<double> Spread::largest() const
{
    return m_count > 0 ? std::optional(m_largest) : std::nullopt;
}

void PackingFigures::add(const PackedBag& bag)
{
    m_throughProduct += bag.throughProduct ? 1u : 0u;
    m_withJoined += bag.lengths == 1 && bag.products > 1 ? 1u : 0u;
    m_scrap += has(bag, BagBit::StartUp) ? 1u : 0u;
    m_phaseLost += has(bag, BagBit::Tracked) && std::abs(bag.markErrorMm) > lostPhaseMm ? 1u : 0u;
    if (!bag.isSettled)
        return;
    m_length.add(bag.deviationMm);
    m_mark.add(bag.markErrorMm);
    m_farFromMark += std::abs(bag.markErrorMm) > farFromMarkMm ? 1u : 0u;
    if (std::abs(bag.deviationMm) <= m_toleranceMm)
        return;
    m_outside += 1;
    m_lastOutside = bag.number;
    if (m_firstOutside == 0)
        m_firstOutside = bag.number;
}

std::optional<double> PackingFigures::shareWithin() const
{
    if (m_length.count() == 0)
        return std::nullopt;
    return 1.0 - static_cast<double>(m_outside) / m_length.count();
}

std::optional<double> PackingFigures::shareFarFromMark() const
{
    if (m_mark.count() == 0)
        return std::nullopt;
    return static_cast<double>(m_farFromMark) / m_mark.count();
}

QJsonObject PackingFigures::object(const PackingResult& result, double cpuS) const
{
    const auto bagNumber = [](std::uint32_t number) {
        return number == 0 ? QJsonValue(QJsonValue::Null) : QJsonValue(static_cast<qint64>(number));
    };
    return {{u"bags"_s, static_cast<qint64>(result.bags)},
            {u"bags_before_settled"_s, static_cast<qint64>(result.bags - m_length.count())},
            {u"bags_start_up_scrap"_s, static_cast<qint64>(m_scrap)},
            {u"simulated_s"_s, result.timeS},
            {u"cpu_s"_s, cpuS},
            {u"times_real"_s, cpuS > 0 ? QJsonValue(std::round(result.timeS / cpuS)) : QJsonValue()},
            {u"deviation_mm"_s, spreadObject(m_length)},
            {u"mark_error_mm"_s, spreadObject(m_mark)},
            {u"cuts_past_0.4_mm"_s, static_cast<qint64>(m_farFromMark)},
            {u"tolerance"_s, QJsonObject{{u"mm"_s, m_toleranceMm},
                                         {u"share_within"_s, orNull(shareWithin())},
                                         {u"bags_outside"_s, static_cast<qint64>(m_outside)},
                                         {u"first_outside"_s, bagNumber(m_firstOutside)},
                                         {u"last_outside"_s, bagNumber(m_lastOutside)}}},
            {u"cuts"_s, cutsObject(result, m_throughProduct, m_phaseLost)},
            {u"marks"_s, QJsonObject{{u"followed"_s, static_cast<qint64>(result.marks)},
                                     {u"missing"_s, static_cast<qint64>(result.marksMissing)},
                                     {u"false"_s, static_cast<qint64>(result.marksFalse)}}},
            {u"products"_s, static_cast<qint64>(result.products)},
            {u"bags_with_joined_products"_s, static_cast<qint64>(m_withJoined)},
            {u"empty_bags"_s, static_cast<qint64>(result.emptyBags)},
            {u"film_saved_m"_s, result.filmSavedM},
            {u"largest_following_error_pulses"_s, result.maxFollowingErrorPulses},
            {u"starts"_s, static_cast<qint64>(result.starts)},
            {u"stops"_s, static_cast<qint64>(result.stops)},
            {u"jams"_s, jamsObject(result.jams)},
            {u"power_cuts"_s,
             QJsonObject{{u"count"_s, static_cast<qint64>(result.powerCuts)},
                         {u"film_to_first_good_cut_mm"_s, result.meanFilmToGoodMm},
                         {u"film_to_first_good_cut_largest_mm"_s, result.longestFilmToGoodMm},
                         {u"bags_start_up"_s, static_cast<qint64>(result.startUpBags)},
                         {u"bags_off_by_0.5_mm_unmarked"_s, static_cast<qint64>(result.offUnmarked)}}},
            {u"jaws_closed_on_standing_film"_s,
             QJsonObject{{u"longest_s"_s, result.longestClosedS},
                         {u"stops_past_1_s"_s, static_cast<qint64>(result.burns)}}},
            {u"alarms"_s, alarmsObject(result)}};
}

QJsonObject masterObject(const PackingResult& result, const controller::ShaftOptions& shaft)
{
    const auto lag = [](const controller::Lag& each) {
        return QJsonObject{{u"mean"_s, each.meanMm}, {u"largest"_s, each.largestMm}};
    };
    return {{u"counts_per_revolution"_s, static_cast<qint64>(shaft.counts)},
            {u"ripple"_s, shaft.ripple},
            {u"ripple_hz"_s, shaft.rippleHz},
            {u"stops"_s, static_cast<qint64>(result.shaftStops)},
            {u"command_lag_mm"_s, lag(result.lag.commands)},
            {u"film_lag_mm"_s, lag(result.lag.film)}};
}

store::CsvWriter bagRows()
{
    return {u"bag,time_s,length_mm,lengths,deviation_mm,mark_error_mm,tracked,mark_missed,products,empty,"
            "through_product,at_speed,settled,skip_cause,skip_gap_mm,start",
            {}};
}

void addBag(store::CsvWriter& csv, const PackedBag& bag)
{
    csv.whole(bag.number).number(bag.timeS, 4).number(bag.lengthMm, 3).whole(bag.lengths);
    csv.number(bag.deviationMm, 3).number(bag.markErrorMm, 4).whole(has(bag, BagBit::Tracked));
    csv.whole(has(bag, BagBit::MarkMissed)).whole(bag.products).whole(has(bag, BagBit::Empty));
    csv.whole(bag.throughProduct)
        .whole(bag.atSpeed)
        .whole(bag.isSettled)
        .text(QString::fromLatin1(skipCause(bag)));
    bag.lengths > 1 ? csv.number(bag.skipGapMm, 3) : csv.empty();
    csv.whole(bag.start).endLine();
}

QJsonObject bagObject(const PackedBag& bag)
{
    const bool skipped = bag.lengths > 1;
    return {{u"bag"_s, static_cast<qint64>(bag.number)},
            {u"time_s"_s, bag.timeS},
            {u"length_mm"_s, bag.lengthMm},
            {u"lengths"_s, static_cast<qint64>(bag.lengths)},
            {u"deviation_mm"_s, bag.deviationMm},
            {u"mark_error_mm"_s, bag.markErrorMm},
            {u"tracked"_s, has(bag, BagBit::Tracked)},
            {u"mark_missed"_s, has(bag, BagBit::MarkMissed)},
            {u"products"_s, bag.products},
            {u"empty"_s, has(bag, BagBit::Empty)},
            {u"through_product"_s, bag.throughProduct},
            {u"at_speed"_s, bag.atSpeed},
            {u"settled"_s, bag.isSettled},
            {u"skip_cause"_s, skipped ? QJsonValue(QString::fromLatin1(skipCause(bag))) : QJsonValue()},
            {u"skip_gap_mm"_s, skipped ? QJsonValue(bag.skipGapMm) : QJsonValue()},
            {u"start"_s, static_cast<qint64>(bag.start)}};
}

} // namespace campanel::cli
