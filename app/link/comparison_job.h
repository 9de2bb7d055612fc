// SPDX-License-Identifier: Apache-2.0
// Reads the active bank back and compares it with the downloaded registers: one exchange per step, also
// across a broken connection. A change of the program ends the comparison, because pieces of two banks prove
// nothing.
#pragma once

#include "app/link/link_values.h"
#include "modbus/download/bank_reader.h"

#include <optional>
#include <vector>

namespace campanel::link {

class ComparisonJob {
public:
    // Starts a comparison. With an empty `expected` the length comes from the bank's header, and the CRC-32
    // is compared with the status.
    explicit ComparisonJob(std::vector<std::uint16_t> expected);

    // Handles every status block; the first one identifies the compared program.
    void noteStatus(const modbus::StatusBlock& status);
    // Performs one exchange.
    void advance(modbus::RtuClient& client);
    void cancel();
    void connectionLost();
    void connectionFound();

    [[nodiscard]] bool hasWork() const; // true when advance() would use the line
    [[nodiscard]] bool ended() const { return m_report.stage != ComparisonStage::Reading; }
    [[nodiscard]] bool isPortLost() const { return m_isPortLost; } // during the last advance()
    [[nodiscard]] const ComparisonReport& report() const { return m_report; }

private:
    void noteFailure(const modbus::LinkError& error);
    void beginRows();
    void compare();

    std::vector<std::uint16_t> m_expected;
    std::optional<modbus::BankReader> m_header; // only when `expected` is empty
    std::optional<modbus::BankReader> m_bank;
    ComparisonReport m_report;
    int m_failuresInARow = 0;
    bool m_isProgramKnown = false;
    bool m_isPortLost = false;
};

} // namespace campanel::link
