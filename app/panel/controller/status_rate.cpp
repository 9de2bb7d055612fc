// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/status_rate.h"

#include <algorithm>
#include <limits>

namespace campanel::panel {

using namespace std::chrono_literals;

namespace {

constexpr auto qualityWindow = 5s;
constexpr auto minTime = 1s;

} // namespace

void StatusRate::note(const link::StatusBatch& batch, link::SteadyTime now)
{
    m_batches.push_back({now, static_cast<int>(batch.samples.size()), batch.failedExchanges});
    while (m_batches.front().at < now - qualityWindow)
        m_batches.pop_front();
}

double StatusRate::perSecond(link::SteadyTime now) const
{
    if (m_batches.empty() || m_batches.front().at > now - minTime)
        return std::numeric_limits<double>::quiet_NaN();
    const auto begin = std::max(m_batches.front().at, now - qualityWindow);
    int good = 0;
    for (const Batch& batch : m_batches)
        good += batch.at > begin ? batch.good : 0;
    return good / std::chrono::duration<double>(now - begin).count();
}

int StatusRate::quality(link::SteadyTime now) const
{
    int good = 0;
    int failed = 0;
    for (const Batch& batch : m_batches) {
        if (batch.at > now - qualityWindow) {
            good += batch.good;
            failed += batch.failed;
        }
    }
    if (good == 0)
        return 0;
    const double share = static_cast<double>(failed) / (good + failed);
    if (failed == 0)
        return 4;
    if (share < 0.01)
        return 3;
    return share < 0.05 ? 2 : 1;
}

} // namespace campanel::panel
