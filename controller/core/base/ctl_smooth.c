/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_smooth.h"

int64_t ctl_smooth_at(int64_t amount, uint64_t x)
{
    const uint64_t x2 = x * x >> CTL_SMOOTH_BITS;
    const uint64_t share = 3u * x2 - 2u * (x2 * x >> CTL_SMOOTH_BITS);
    const uint64_t size = (uint64_t)(amount < 0 ? -amount : amount);
    const int64_t result = (int64_t)((size >> 8u) * share >> (CTL_SMOOTH_BITS - 8u)) +
                           (int64_t)((size & 0xFFu) * share >> CTL_SMOOTH_BITS);
    return amount < 0 ? -result : result;
}

int64_t ctl_smooth_share(int64_t amount, uint64_t part, uint64_t whole)
{
    return part == whole ? amount : ctl_smooth_at(amount, (part << CTL_SMOOTH_BITS) / whole);
}
