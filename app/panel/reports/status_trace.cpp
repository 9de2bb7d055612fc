// SPDX-License-Identifier: Apache-2.0
#include "app/panel/reports/status_trace.h"

#include "app/panel/controller/axis_position.h"
#include "app/store/files/csv.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

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
    store::CsvWriter csv(
        u"time_utc,state,fault_bits,warning_bits,generation,cycle,master_deg,master_percent,commanded_hz,"
        "actual_hz,commanded_pulses,position_pulses,following_error_pulses,knife_deg,bag,bag_length_mm,"
        "bag_deviation_mm,force_n,uptime_s,sample_ms,latency_ms",
        {});
    AxisPosition position;
    for (const link::StatusSample& sample : samples) {
        const modbus::StatusBlock& status = sample.status;
        position.note(status);
        const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(sample.receivedAt - moment);
        csv.utc(timeOfDay.toMSecsSinceEpoch() + since.count());
        status.state ? csv.text(QString::fromStdString(modbus::enumName(*status.state))) : csv.empty();
        csv.whole(status.faultBits).whole(status.warningBits).whole(status.generation);
        csv.whole(status.cycleCount).number(status.masterAngleDeg, 3).number(status.masterSpeedPercent, 2);
        csv.whole(status.commandedFrequencyHz).whole(status.actualFrequencyHz);
        csv.whole(position.commandedPulses().value_or(0)).whole(position.actualPulses().value_or(0));
        csv.whole(status.followingErrorPulses).number(status.knifeAngleDeg, 3).whole(status.bagCount);
        csv.number(status.bagLengthMm, 3).number(status.bagDeviationMm, 3);
        status.press ? csv.whole(status.press->forceN) : csv.empty();
        csv.whole(status.uptimeS).whole(status.sampleTimeMs);
        csv.number(std::chrono::duration<double, std::milli>(sample.latency).count(), 3).endLine();
    }
    return csv.bytes();
}

} // namespace campanel::panel
