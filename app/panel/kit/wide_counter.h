// SPDX-License-Identifier: Apache-2.0
// Counts on where a register of 32 bits wraps: the position of an axis that turns one way for ever.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>

namespace campanel::panel {

class WideCounter {
public:
    // Takes the register's present value: the lower 32 bits, with a sign.
    void note(std::int32_t value)
    {
        // A larger step is no motion: 2^30 pulses take 18 minutes at 1 MHz.
        constexpr std::int64_t maxStep = std::int64_t{1} << 30;
        const std::int64_t step = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) -
                                                            static_cast<std::uint32_t>(m_value));
        m_value = m_isKnown && std::abs(step) <= maxStep ? m_value + step : value;
        m_isKnown = true;
    }
    // The next value is taken as it is: after a restart or homing.
    void reset() { m_isKnown = false; }

    // Returns nothing before the first value.
    [[nodiscard]] std::optional<std::int64_t> value() const
    {
        return m_isKnown ? std::optional(m_value) : std::nullopt;
    }

private:
    std::int64_t m_value = 0;
    bool m_isKnown = false;
};

} // namespace campanel::panel
