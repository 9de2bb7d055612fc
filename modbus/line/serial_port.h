// SPDX-License-Identifier: Apache-2.0
// The claim on a device node: checks it before anything is changed, locks it for this process, and explains
// in a sentence why it is not available. libmodbus opens and configures the line itself.
#pragma once

#include "modbus/line/link_error.h"

#include <tl/expected.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace campanel::modbus {

// Owns a second descriptor of the port with the lock; released when destroyed, also by a killed process.
class PortClaim {
public:
    [[nodiscard]] static tl::expected<PortClaim, LinkError> take(const std::string& port);

    PortClaim() = default;
    PortClaim(PortClaim&& other) noexcept;
    PortClaim& operator=(PortClaim&& other) noexcept;
    PortClaim(const PortClaim&) = delete;
    PortClaim& operator=(const PortClaim&) = delete;
    ~PortClaim();

    // Refuses a later open() of the port by other programs.
    void excludeOthers() const;

private:
    explicit PortClaim(int descriptor)
        : m_descriptor(descriptor)
    {
    }

    int m_descriptor = -1;
};

enum class DrainResult : std::uint8_t { Quiet, StillBusy, Gone };

// Returns true when bytes can be read, or the port has hung up.
[[nodiscard]] bool hasInput(int descriptor);

// Reads and drops until nothing has come for `quiet`; stops after `longest`. `onDropped` receives the dropped
// bytes.
[[nodiscard]] DrainResult drain(int descriptor, std::chrono::milliseconds quiet,
                                std::chrono::milliseconds longest,
                                const std::function<void(std::span<const std::uint8_t>)>& onDropped);

} // namespace campanel::modbus
