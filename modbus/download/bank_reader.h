// SPDX-License-Identifier: Apache-2.0
// Reads a range of registers, such as a bank or its header, with proof: one exchange per step, so that the
// status exchange can go on in between.
#pragma once

#include "modbus/line/rtu_client.h"

#include <cstdint>
#include <vector>

namespace campanel::modbus {

class BankReader {
public:
    // Reads `count` registers from `address`: stagedBankBase or activeBankBase for a bank.
    BankReader(std::uint16_t address, std::uint16_t count)
        : m_address(address)
        , m_count(count)
    {
    }

    // Performs one exchange. After an error the same step may be repeated. Returns true when everything has
    // been read.
    [[nodiscard]] tl::expected<bool, LinkError> advance(RtuClient& client);

    [[nodiscard]] bool complete() const { return m_registers.size() == m_count; }
    [[nodiscard]] double progress() const;
    [[nodiscard]] const std::vector<std::uint16_t>& registers() const { return m_registers; }

private:
    std::uint16_t m_address = 0;
    std::uint16_t m_count = 0;
    std::vector<std::uint16_t> m_registers;
};

} // namespace campanel::modbus
