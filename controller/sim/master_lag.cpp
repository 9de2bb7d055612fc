// SPDX-License-Identifier: Apache-2.0
#include "master_lag.h"

#include <algorithm>
#include <cmath>

namespace campanel::controller {

void Lag::take(double mm, std::uint64_t number)
{
    meanMm += (mm - meanMm) / static_cast<double>(number);
    largestMm = std::max(largestMm, std::abs(mm));
}

void MasterLag::take(const ctl_core& core, Machine& machine, const MachineOptions& options)
{
    const ctl_master& master = core.master;
    if (!master.leads || master.clutch.state != CTL_CLUTCH_ON)
        return;
    const ctl_gear& gear = master.gear;
    const double ticksPerCount = static_cast<double>(gear.numerator) / static_cast<double>(gear.denominator);
    const double trueCounts =
        machine.shaft().positionMm() / options.shaft.revolutionMm * options.shaft.counts;
    const double counted = static_cast<double>(gear.ticks) +
                           static_cast<double>(gear.remainder) / static_cast<double>(gear.denominator);
    const double behind = counted + (trueCounts - static_cast<double>(gear.count)) * ticksPerCount +
                          static_cast<double>(master.clutch.offset - master.line);
    const double mmPerTick = options.shaft.revolutionMm / options.shaft.counts / ticksPerCount;
    const double following =
        static_cast<double>(core.packer.film_at - machine.filmEncoder()) / 256.0 / options.filmPulses;
    ++samples;
    commands.take(behind * mmPerTick, samples);
    film.take(behind * mmPerTick + following * options.filmFeedMm, samples);
}

} // namespace campanel::controller
