// SPDX-License-Identifier: Apache-2.0
// The port that panels open: a pseudo-terminal that can be unplugged and plugged in again, and the symbolic
// link to it.
#pragma once

#include "pseudo_terminal.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace campanel::controller {

class ServedPort {
public:
    // Sets the path of the symbolic link; empty for none.
    explicit ServedPort(std::filesystem::path link);
    ServedPort(const ServedPort&) = delete;
    ServedPort& operator=(const ServedPort&) = delete;
    ~ServedPort();

    // Opens a new pseudo-terminal and points the symbolic link `link` to it; empty: the previous path. The
    // error says what failed and what to do. Does nothing when it is plugged in.
    [[nodiscard]] tl::expected<void, std::string> plug(const std::filesystem::path& link = {});
    // Closes the pseudo-terminal; a program that has it open gets a hang-up.
    void unplug();

    // Returns the path of the pseudo-terminal, empty while unplugged.
    [[nodiscard]] std::string path() const;
    // Returns a descriptor that becomes readable when there are bytes from the panel, and when a panel closed
    // the far end; -1 while unplugged.
    [[nodiscard]] int descriptor() const;
    [[nodiscard]] int closeWatch() const;

    [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
    void write(std::span<const std::uint8_t> bytes);
    void afterClose();

private:
    [[nodiscard]] bool makeLink();
    void removeLink();

    std::filesystem::path m_link;
    bool m_isLinkMade = false;
    std::optional<PseudoTerminal> m_terminal;
};

} // namespace campanel::controller
