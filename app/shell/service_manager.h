// SPDX-License-Identifier: Apache-2.0
// Notifies the service manager that started the panel, by systemd's protocol, see sd_notify(3). One datagram
// per state; implemented here, because loading libsystemd would delay every start. Without a service manager
// nothing happens.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace campanel::shell {

class ServiceManager {
public:
    // Reads and removes the environment variables: child processes must not notify.
    ServiceManager();

    [[nodiscard]] bool isThere() const { return !m_address.empty(); }
    // Returns the maximum time between two "WATCHDOG=1"; empty: not requested.
    [[nodiscard]] std::optional<std::chrono::microseconds> watchdogPeriod() const { return m_watchdogPeriod; }

    // Sends "READY=1", "WATCHDOG=1" or "STOPPING=1". An undeliverable datagram is lost; the service manager
    // notices a missing one by its timeout.
    void notify(std::string_view state) const;

private:
    std::string m_address; // a path; with '@' in front an abstract address
    std::optional<std::chrono::microseconds> m_watchdogPeriod;
};

} // namespace campanel::shell
