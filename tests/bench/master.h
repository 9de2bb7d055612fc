// SPDX-License-Identifier: Apache-2.0
// A Modbus master for comparison: the two requests of a panel, written as in each library's documentation.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace campanel::bench {

// A master, 8N1, unit 1. Every call throws std::runtime_error without an answer.
class Master {
public:
    virtual ~Master() = default;
    // Writes, then reads (function 23).
    virtual std::vector<std::uint16_t> writeAndRead(std::uint16_t writeAddress,
                                                    std::span<const std::uint16_t> written,
                                                    std::uint16_t readAddress, std::uint16_t count) = 0;
    // Reads (function 3).
    virtual std::vector<std::uint16_t> read(std::uint16_t address, std::uint16_t count) = 0;
};

[[nodiscard]] std::unique_ptr<Master> plainMaster(const std::string& port, std::uint32_t baud); // libmodbus
// Returns QModbusRtuSerialClient; nothing when the benchmark was built without it.
[[nodiscard]] std::unique_ptr<Master> qtMaster(const std::string& port, std::uint32_t baud);

} // namespace campanel::bench
