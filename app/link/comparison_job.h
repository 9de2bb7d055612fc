// SPDX-License-Identifier: Apache-2.0
// The active bank read back, piece by piece, and compared with what was sent: one exchange a step, over a
// broken connection if need be. A program that changes meanwhile ends it, as pieces of two banks prove
// nothing.
#pragma once

#include "app/link/link_values.h"
#include "modbus/download/bank_reader.h"

#include <optional>
#include <vector>

namespace campanel::link {

class ComparisonJob {
public:
    // Empty `expected`: the bank's length is taken from its header, and its CRC-32 compared with the status.
    explicit ComparisonJob(std::vector<std::uint16_t> expected);

    // To be given every status block; the first one says which program is compared.
    void noteStatus(const modbus::StatusBlock& status);
    // One exchange.
    void advance(modbus::RtuClient& client);
    void cancel();
    void connectionLost();
    void connectionFound();

    [[nodiscard]] bool hasWork() const; // advance() would use the line
    [[nodiscard]] bool ended() const { return m_report.stage != ComparisonStage::Reading; }
    [[nodiscard]] bool isPortLost() const { return m_isPortLost; } // the last advance() found the port gone
    [[nodiscard]] const ComparisonReport& report() const { return m_report; }

private:
    void noteFailure(const modbus::LinkError& error);
    void beginRows();
    void compare();

    std::vector<std::uint16_t> m_expected;
    std::optional<modbus::BankReader> m_header; // only when nothing is expected
    std::optional<modbus::BankReader> m_bank;
    ComparisonReport m_report;
    int m_failuresInARow = 0;
    bool m_isProgramKnown = false;
    bool m_isPortLost = false;
};

} // namespace campanel::link
