// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/oee.h"

#include <algorithm>

namespace campanel::panel {

std::int64_t Production::rejects() const
{
    return std::min(pieces, outOfTolerance + startUpScrap + skipped);
}

Oee oeeOf(const Production& production)
{
    Oee oee;
    if (production.plannedMs <= 0)
        return oee;
    oee.availability = static_cast<double>(production.runMs) / static_cast<double>(production.plannedMs);
    if (production.runMs > 0) {
        oee.rawPerformance = production.idealMs / static_cast<double>(production.runMs);
        oee.performance = oee.rawPerformance > 1 ? 1 : oee.rawPerformance;
    }
    if (production.pieces > 0)
        oee.quality = static_cast<double>(production.pieces - production.rejects()) /
                      static_cast<double>(production.pieces);
    const bool isNothingMade = production.runMs <= 0 || production.pieces <= 0;
    oee.oee = isNothingMade ? 0 : oee.availability * oee.performance * oee.quality;
    return oee;
}

} // namespace campanel::panel
