// SPDX-License-Identifier: Apache-2.0
// The simulated board's flash as files in a directory, one for each slot and one for each record. Saved data
// survives the end of this process at any moment. After a power loss of the computer at least the save before
// the last one is on its disk.
#pragma once

#include "flash_device.h"

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace campanel::controller {

class FileFlash final : public FlashDevice {
public:
    // Creates the directory; only one controller at a time may use it. The error says what failed and what to
    // do.
    [[nodiscard]] static tl::expected<FileFlash, std::string> open(const std::filesystem::path& directory);
    FileFlash(FileFlash&& other) noexcept;
    FileFlash& operator=(FileFlash&&) = delete;
    FileFlash(const FileFlash&) = delete;
    FileFlash& operator=(const FileFlash&) = delete;
    ~FileFlash() override;

    [[nodiscard]] bool read(std::uint32_t slot, std::uint32_t offset, std::span<std::uint8_t> bytes) override;
    [[nodiscard]] bool erase(std::uint32_t slot) override;
    [[nodiscard]] bool write(std::uint32_t slot, std::uint32_t offset,
                             std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] bool keeps() const override { return true; }
    [[nodiscard]] bool keep(std::uint32_t record, std::span<const std::uint8_t> bytes) override;
    [[nodiscard]] std::size_t kept(std::uint32_t record, std::span<std::uint8_t> bytes) override;

private:
    FileFlash() = default;

    std::array<int, 2> m_slots{-1, -1};
    std::array<int, CTL_KEPT_RECORDS> m_records{-1, -1, -1};
    std::array<std::uint32_t, CTL_KEPT_RECORDS> m_sequences{}; // of their newest contents
    int m_lock = -1;
};

// Returns $XDG_STATE_HOME/campanel, or ~/.local/state/campanel.
[[nodiscard]] std::filesystem::path defaultStateDirectory();

} // namespace campanel::controller
