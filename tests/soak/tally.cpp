// SPDX-License-Identifier: Apache-2.0
#include "tally.h"

#include <algorithm>

namespace campanel::soak {

void Tally::add(const Tally& other)
{
    exchanges += other.exchanges;
    faults += other.faults;
    believed += other.believed;
    wrong += other.wrong;
    repeated += other.repeated;
    mixed += other.mixed;
    hangs += other.hangs;
    for (const auto& [kind, count] : other.errors)
        errors[kind] += count;
    for (const auto& [kind, count] : other.work)
        work[kind] += count;
    replugMs.insert(replugMs.end(), other.replugMs.begin(), other.replugMs.end());
    restartMs.insert(restartMs.end(), other.restartMs.begin(), other.restartMs.end());
    longestCallMs = std::max(longestCallMs, other.longestCallMs);
    findings.insert(findings.end(), other.findings.begin(), other.findings.end());
}

} // namespace campanel::soak
