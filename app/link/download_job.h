// SPDX-License-Identifier: Apache-2.0
// One download from the request to its single end: steps, cancellation, retries after a doubtful answer, and
// continuation after a broken connection.
#pragma once

#include "app/link/link_values.h"

namespace campanel::link {

class DownloadJob {
public:
    DownloadJob(std::vector<std::uint16_t> bank, const modbus::Identity& controller, std::uint16_t session);

    // Performs one exchange with the controller, or none while an armed change waits for the end of the
    // cycle.
    void advance(modbus::RtuClient& client);
    void noteStatus(const modbus::StatusBlock& status);
    // Ends at once when nothing is staged that needs the line, else with the next advance().
    void cancel(bool isConnected);
    void connectionLost();
    void connectionFound();

    [[nodiscard]] bool hasWork() const; // true when advance() would use the line
    [[nodiscard]] bool ended() const;
    [[nodiscard]] bool isPortLost() const { return m_isPortLost; } // during the last advance()
    [[nodiscard]] const DownloadReport& report() const { return m_report; }

private:
    using Step = tl::expected<modbus::Download::Phase, modbus::DownloadError>;

    void take(const Step& step);

    modbus::Download m_download;
    DownloadReport m_report;
    int m_failuresInARow = 0;
    bool m_isCancelWanted = false;
    bool m_isPortLost = false;
};

} // namespace campanel::link
