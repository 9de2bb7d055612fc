// SPDX-License-Identifier: Apache-2.0
// The pseudo-terminal on which the controller serves. It stays open while panels open and close it, because
// the controller also holds the far end.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace campanel::controller {

class PseudoTerminal {
public:
    // Opens a pseudo-terminal. The error says what failed and why.
    [[nodiscard]] static tl::expected<PseudoTerminal, std::string> open();
    PseudoTerminal(PseudoTerminal&& other) noexcept;
    PseudoTerminal& operator=(PseudoTerminal&&) = delete;
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;
    ~PseudoTerminal();

    [[nodiscard]] const std::string& path() const { return m_path; }
    // Returns a descriptor that becomes readable when there are bytes from the panel, and when a panel closed
    // the far end.
    [[nodiscard]] int descriptor() const { return m_master; }
    [[nodiscard]] int closeWatch() const { return m_watch; }

    [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
    // Writes bytes; unread bytes are lost, as on a wire.
    void write(std::span<const std::uint8_t> bytes);
    // Removes the exclusive access after a panel has closed the port; it would otherwise remain until the end
    // of the controller.
    void afterClose();

private:
    PseudoTerminal() = default;

    int m_master = -1;
    int m_slave = -1;
    int m_watch = -1;
    std::string m_path;
};

} // namespace campanel::controller
