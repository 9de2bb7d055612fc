// SPDX-License-Identifier: Apache-2.0
#include "app/panel/trends/trend_recorder.h"

#include "app/panel/controller/controller.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"

#include <QDateTime>

#include <cmath>

namespace campanel::panel {

namespace {

using store::TrendQuantity;

constexpr qint64 msPerSecond = 1000;
constexpr std::size_t maxParts = 600 * store::trendQuantities;
constexpr qsizetype maxBags = 600 * 5;

bool turns(const modbus::StatusBlock& status)
{
    return status.state == modbus::State::Running || status.state == modbus::State::Stopping;
}

} // namespace

TrendRecorder::TrendRecorder(Controller& controller, Settings& settings, DatabaseService& records)
    : m_controller(controller)
    , m_settings(settings)
    , m_records(records)
    , m_clock(&QDateTime::currentMSecsSinceEpoch)
{
    // Connected after the controller, which handles the signal first.
    connect(&controller.link(), &link::Link::statusReceived, this, &TrendRecorder::takeStatus);
    connect(controller.packing(), &PackingLine::bagRecorded, this, &TrendRecorder::takeBag);
    connect(&controller, &Controller::programChanged, this, [this] {
        m_isNextOfTwoPrograms = true;
        m_worstFollowingMm.reset();
    });
}

TrendRecorder::Batch TrendRecorder::take()
{
    Batch batch;
    batch.bags = std::exchange(m_bags, {});
    for (const auto& [place, bucket] : std::exchange(m_parts, {}))
        batch.parts << store::TrendPart{place.first, place.second, bucket};
    return batch;
}

void TrendRecorder::addResidue(double percent)
{
    add(TrendQuantity::JamResidue, m_clock(), percent);
}

void TrendRecorder::takeStatus(const link::StatusBatch& batch)
{
    const qint64 nowMs = m_clock();
    for (const link::StatusSample& sample : batch.samples) {
        if (sample.latency.count() > 0)
            add(TrendQuantity::Latency, nowMs,
                std::chrono::duration<double, std::milli>(sample.latency).count());
        noteMotion(sample.status, nowMs);
        noteBag(sample.status);
    }
}

void TrendRecorder::noteMotion(const modbus::StatusBlock& status, qint64 nowMs)
{
    const auto& program = m_controller.program();
    if (!program || program->generation != status.generation || program->crc != status.activeCrc)
        return;
    const double rate = turns(status) ? program->rateBagsPerMin * status.masterSpeedPercent / 100 : 0;
    if (std::isfinite(program->rateBagsPerMin) && program->rateBagsPerMin > 0)
        add(TrendQuantity::Rate, nowMs, rate);
    if (!turns(status) || !(program->pulsesPerMm > 0))
        return;
    const double errorMm = status.followingErrorPulses / program->pulsesPerMm;
    add(TrendQuantity::FollowingError, nowMs, errorMm);
    if (!m_worstFollowingMm || std::abs(errorMm) > std::abs(*m_worstFollowingMm))
        m_worstFollowingMm = errorMm;
}

void TrendRecorder::noteBag(const modbus::StatusBlock& status)
{
    const std::optional<std::uint32_t> before = std::exchange(m_bagCount, status.bagCount);
    if (m_controller.packing()->recordsBags() || before == m_bagCount || !before)
        return;
    if (!status.bagLengthMm || !status.bagDeviationMm)
        return;
    store::Bag bag;
    bag.setLengthMm = *status.bagLengthMm - *status.bagDeviationMm;
    bag.deviationMm = *status.bagDeviationMm;
    add(bag);
}

void TrendRecorder::takeBag(const modbus::BagRecord& record)
{
    if (record.isScrap()) {
        m_isNextOfTwoPrograms = false;
        return;
    }
    store::Bag bag;
    bag.setLengthMm = m_controller.active().bagLengthMm;
    bag.lengths = std::max(1, record.lengths);
    bag.deviationMm = record.deviationMm;
    if (record.isTracked)
        bag.markErrorMm = record.markErrorMm;
    bag.flags = static_cast<quint8>(
        (record.isTracked ? store::Bag::Tracked : 0) | (record.isMarkMissed ? store::Bag::MarkMissed : 0) |
        (record.isProductAcross ? store::Bag::ProductAcross : 0) | (record.isEmpty ? store::Bag::Empty : 0));
    add(bag);
}

void TrendRecorder::add(store::Bag bag)
{
    bag.followingErrorMm = std::exchange(m_worstFollowingMm, std::nullopt);
    if (std::exchange(m_isNextOfTwoPrograms, false) || !std::isfinite(bag.setLengthMm))
        return;
    bag.timeMs = m_clock();
    bag.clock = m_records.clockState();
    bag.programName = m_controller.active().name;
    bag.programVersion =
        std::isfinite(m_controller.active().version) ? static_cast<int>(m_controller.active().version) : 0;
    const double rate = m_controller.live().rateBagsPerMin;
    if (std::isfinite(rate))
        bag.rateBagsPerMin = rate;
    // A bag of several lengths counts by one of them: otherwise it would flatten the curve of all others.
    const bool isWithin = std::abs(bag.deviationMm) <= m_settings.bagToleranceMm();
    add(TrendQuantity::BagLength, bag.timeMs, bag.setLengthMm + bag.deviationMm, isWithin);
    add(TrendQuantity::Deviation, bag.timeMs, bag.deviationMm, isWithin);
    if (bag.markErrorMm)
        add(TrendQuantity::MarkError, bag.timeMs, *bag.markErrorMm);
    m_bags << bag;
    if (m_bags.size() > maxBags)
        m_bags.removeFirst();
}

void TrendRecorder::add(TrendQuantity quantity, qint64 nowMs, double value, bool isWithin)
{
    const qint64 second = nowMs / msPerSecond;
    m_parts[{second, quantity}].add(value, isWithin);
    // Parts ahead of the clock were collected before the clock was set back.
    if (m_parts.size() > maxParts)
        m_parts.erase(m_parts.rbegin()->first.first > second ? std::prev(m_parts.end()) : m_parts.begin());
}

} // namespace campanel::panel
