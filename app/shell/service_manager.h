// SPDX-License-Identifier: Apache-2.0
// What the panel tells the service manager that started it: systemd's notification protocol, see
// sd_notify(3). A datagram each; written out here, because libsystemd would cost every start its loading.
// Without a service manager nothing happens.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace campanel::panel {

class ServiceManager {
public:
    // Takes what the environment says and removes it there: programs that the panel starts are not asked.
    ServiceManager();

    [[nodiscard]] bool isThere() const { return !m_address.empty(); }
    // So often at least it wants to hear "WATCHDOG=1"; empty: never.
    [[nodiscard]] std::optional<std::chrono::microseconds> watchdogPeriod() const { return m_watchdogPeriod; }

    // "READY=1", "WATCHDOG=1", "STOPPING=1". What cannot be delivered is lost: who wants it misses it in
    // time.
    void tell(std::string_view state) const;

private:
    std::string m_address; // a path; with '@' in front one without a file
    std::optional<std::chrono::microseconds> m_watchdogPeriod;
};

} // namespace campanel::panel
