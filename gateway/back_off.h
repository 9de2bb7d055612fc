// SPDX-License-Identifier: Apache-2.0
// Pauses that grow after each failure, and are short again after a success.
#pragma once

#include <algorithm>

namespace campanel::gateway {

class BackOff {
public:
    explicit constexpr BackOff(int firstMs)
        : m_firstMs(firstMs)
        , m_nextMs(firstMs)
    {
    }

    // Returns the pause after a failure, at most this one. The next one is twice as long.
    int next(int maxMs)
    {
        const int pauseMs = std::min(m_nextMs, maxMs);
        m_nextMs = 2 * pauseMs;
        return pauseMs;
    }
    void reset() { m_nextMs = m_firstMs; }

private:
    int m_firstMs;
    int m_nextMs;
};

} // namespace campanel::gateway
