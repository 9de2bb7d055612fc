// SPDX-License-Identifier: Apache-2.0
// The storage of the simulated board that survives a power loss: two slots of bytes, erased to 0xFF.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::controller {

class FlashDevice {
public:
    virtual ~FlashDevice() = default;
    // Return false when the device failed. Bytes that were never written read 0xFF.
    [[nodiscard]] virtual bool read(std::uint32_t slot, std::uint32_t offset,
                                    std::span<std::uint8_t> bytes) = 0;
    [[nodiscard]] virtual bool erase(std::uint32_t slot) = 0;
    [[nodiscard]] virtual bool write(std::uint32_t slot, std::uint32_t offset,
                                     std::span<const std::uint8_t> bytes) = 0;
};

} // namespace campanel::controller
