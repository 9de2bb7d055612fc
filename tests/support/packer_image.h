// SPDX-License-Identifier: Apache-2.0
// The group `packer` as registers, written by name.
#pragma once

#include "modbus/map/packer_status.h"

#include <cmath>
#include <vector>

namespace campanel::test {

class PackerImage {
public:
    // `value` in the register's unit.
    void set(const char* name, double value)
    {
        const modbus::RegisterInfo& info = *modbus::findRegister(name);
        const auto raw = static_cast<std::uint32_t>(std::llround(value / info.scale));
        if (info.count == 2)
            setRaw(name, 0, static_cast<std::uint16_t>(raw >> 16U));
        setRaw(name, info.count - 1U, static_cast<std::uint16_t>(raw & 0xFFFFU));
    }
    // One register of an array.
    void setRaw(const char* name, std::size_t index, std::uint16_t value)
    {
        m_registers[modbus::findRegister(name)->address - modbus::packerAddress + index] = value;
    }
    void addBag(double markErrorMm)
    {
        ++m_bag;
        set("packer.bag_number", m_bag);
        const std::size_t at = modbus::findRegister("packer.bags")->address - modbus::packerAddress +
                               4U * (m_bag % modbus::bagRecords);
        m_registers[at + 1] = static_cast<std::uint16_t>(std::lround(markErrorMm * 1000));
        m_registers[at + 3] =
            static_cast<std::uint16_t>(1U << 8U | 1U << static_cast<unsigned>(modbus::BagBit::Tracked));
    }
    [[nodiscard]] const std::vector<std::uint16_t>& registers() const { return m_registers; }

private:
    std::vector<std::uint16_t> m_registers = std::vector<std::uint16_t>(modbus::packerRegisters());
    std::uint32_t m_bag = 0;
};

} // namespace campanel::test
