// SPDX-License-Identifier: Apache-2.0
// One download on its way, from the request to its one end: steps, the wish to cancel, retries after a
// doubtful answer, and going on after a broken connection.
#pragma once

#include "app/link/link_values.h"

namespace campanel::link {

class DownloadJob {
public:
    DownloadJob(std::vector<std::uint16_t> bank, const modbus::Identity& controller, std::uint16_t session);

    // One exchange with the controller, or none while an armed change waits for the end of the cycle.
    void advance(modbus::RtuClient& client);
    void noteStatus(const modbus::StatusBlock& status);
    // Ends at once where nothing has been staged that would need the line, else with the next advance().
    void cancel(bool isConnected);
    void connectionLost();
    void connectionFound();

    [[nodiscard]] bool hasWork() const; // advance() would use the line
    [[nodiscard]] bool ended() const;
    [[nodiscard]] bool isPortLost() const { return m_isPortLost; } // the last advance() found the port gone
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
