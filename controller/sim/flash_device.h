// SPDX-License-Identifier: Apache-2.0
// The storage of the simulated board that survives a power loss: two slots of bytes, erased to 0xFF, and
// small records that are replaced whole.
#pragma once

#include "base/ctl_port.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::controller {

class FlashDevice {
public:
    static constexpr std::size_t maxRecordBytes = CTL_KEPT_BYTES;

    virtual ~FlashDevice() = default;
    // Return false when the device failed. Bytes that were never written read 0xFF.
    [[nodiscard]] virtual bool read(std::uint32_t slot, std::uint32_t offset,
                                    std::span<std::uint8_t> bytes) = 0;
    [[nodiscard]] virtual bool erase(std::uint32_t slot) = 0;
    [[nodiscard]] virtual bool write(std::uint32_t slot, std::uint32_t offset,
                                     std::span<const std::uint8_t> bytes) = 0;
    // Returns true when the device has such records.
    [[nodiscard]] virtual bool keeps() const { return false; }
    // A power cut at any moment leaves the new record or the one before. Returns false when the device
    // failed.
    [[nodiscard]] virtual bool keep(std::uint32_t /*record*/, std::span<const std::uint8_t> /*bytes*/)
    {
        return false;
    }
    // Reads at most bytes.size() of it; returns its size, 0 when there is none.
    [[nodiscard]] virtual std::size_t kept(std::uint32_t /*record*/, std::span<std::uint8_t> /*bytes*/)
    {
        return 0;
    }
};

} // namespace campanel::controller
