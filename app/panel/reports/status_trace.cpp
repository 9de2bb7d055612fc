// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/status_trace.h"

#include "app/panel/kit/axis_position.h"
#include "app/store/files/csv.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

struct TraceLine {
    qint64 timeMs;
    const modbus::StatusBlock& status;
    AxisPosition position;
    std::chrono::duration<double, std::milli> latency;
};

const store::CsvColumns<TraceLine>& statusColumns()
{
    using Csv = store::CsvWriter;
    static const store::CsvColumns<TraceLine> all{
        {u"time_utc"_s, [](Csv& csv, const TraceLine& line) { csv.utc(line.timeMs); }},
        {u"state"_s,
         [](Csv& csv, const TraceLine& line) {
             line.status.state ? csv.text(QString::fromStdString(modbus::enumName(*line.status.state)))
                               : csv.empty();
         }},
        {u"fault_bits"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.faultBits); }},
        {u"warning_bits"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.warningBits); }},
        {u"generation"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.generation); }},
        {u"cycle"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.cycleCount); }},
        {u"master_deg"_s, [](Csv& csv, const TraceLine& line) { csv.number(line.status.masterAngleDeg, 3); }},
        {u"master_percent"_s,
         [](Csv& csv, const TraceLine& line) { csv.number(line.status.masterSpeedPercent, 2); }},
        {u"commanded_hz"_s,
         [](Csv& csv, const TraceLine& line) { csv.whole(line.status.commandedFrequencyHz); }},
        {u"actual_hz"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.actualFrequencyHz); }},
        {u"commanded_pulses"_s,
         [](Csv& csv, const TraceLine& line) { csv.whole(line.position.commandedPulses().value_or(0)); }},
        {u"position_pulses"_s,
         [](Csv& csv, const TraceLine& line) { csv.whole(line.position.actualPulses().value_or(0)); }},
        {u"following_error_pulses"_s,
         [](Csv& csv, const TraceLine& line) { csv.whole(line.status.followingErrorPulses); }},
        {u"knife_deg"_s, [](Csv& csv, const TraceLine& line) { csv.number(line.status.knifeAngleDeg, 3); }},
        {u"bag"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.bagCount); }},
        {u"bag_length_mm"_s, [](Csv& csv, const TraceLine& line) { csv.number(line.status.bagLengthMm, 3); }},
        {u"bag_deviation_mm"_s,
         [](Csv& csv, const TraceLine& line) { csv.number(line.status.bagDeviationMm, 3); }},
        {u"force_n"_s,
         [](Csv& csv, const TraceLine& line) {
             line.status.press ? csv.whole(line.status.press->forceN) : csv.empty();
         }},
        {u"uptime_s"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.uptimeS); }},
        {u"sample_ms"_s, [](Csv& csv, const TraceLine& line) { csv.whole(line.status.sampleTimeMs); }},
        {u"latency_ms"_s, [](Csv& csv, const TraceLine& line) { csv.number(line.latency.count(), 3); }}};
    return all;
}

} // namespace

bool StatusTrace::add(const link::StatusSample& sample)
{
    const bool wasFaulted = !m_latest.empty() && m_latest.back().status.faultBits != 0;
    m_latest.push_back(sample);
    while (sample.receivedAt - m_latest.front().receivedAt > length)
        m_latest.pop_front();
    const bool isFirst = !wasFaulted && sample.status.faultBits != 0;
    if (isFirst)
        m_beforeFault = m_latest;
    return isFirst;
}

QByteArray StatusTrace::csv(const std::deque<link::StatusSample>& samples, link::SteadyTime moment,
                            const QDateTime& timeOfDay)
{
    store::CsvTable<TraceLine> file(statusColumns());
    AxisPosition position;
    for (const link::StatusSample& sample : samples) {
        position.note(sample.status);
        const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(sample.receivedAt - moment);
        file.add({timeOfDay.toMSecsSinceEpoch() + since.count(), sample.status, position, sample.latency});
    }
    return file.bytes();
}

} // namespace campanel::panel
