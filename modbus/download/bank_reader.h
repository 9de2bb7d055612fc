// SPDX-License-Identifier: Apache-2.0
// Reads a run of registers, such as a bank or its header, in proven pieces: one exchange a step, so that the
// status exchange can go on in between.
#pragma once

#include "modbus/line/rtu_client.h"

#include <cstdint>
#include <vector>

namespace campanel::modbus {

class BankReader {
public:
    // `count` registers from `address`: stagedBankBase or activeBankBase for a bank.
    BankReader(std::uint16_t address, std::uint16_t count)
        : m_address(address)
        , m_count(count)
    {
    }

    // One exchange. After an error the same step may be tried again. True when everything has been read.
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
