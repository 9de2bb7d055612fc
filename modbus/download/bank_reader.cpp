// SPDX-License-Identifier: Apache-2.0
// Reads a bank in pieces.
#include "modbus/download/bank_reader.h"

#include <algorithm>

namespace campanel::modbus {

tl::expected<bool, LinkError> BankReader::advance(RtuClient& client)
{
    if (complete())
        return true;
    const auto left = static_cast<std::uint16_t>(m_count - m_registers.size());
    const auto piece = client.readProven(static_cast<std::uint16_t>(m_address + m_registers.size()),
                                         std::min(left, readbackRegisters));
    if (!piece)
        return tl::unexpected(piece.error());
    m_registers.insert(m_registers.end(), piece->begin(), piece->end());
    return complete();
}

double BankReader::progress() const
{
    return m_count == 0 ? 1.0 : static_cast<double>(m_registers.size()) / m_count;
}

} // namespace campanel::modbus
