// SPDX-License-Identifier: Apache-2.0
// The pseudo-terminal on which the controller is served. It outlives every panel that opens and closes it:
// the controller keeps the far end open too.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace campanel::controller {

class PseudoTerminal {
public:
    // The error says what failed and why.
    [[nodiscard]] static tl::expected<PseudoTerminal, std::string> open();
    PseudoTerminal(PseudoTerminal&& other) noexcept;
    PseudoTerminal& operator=(PseudoTerminal&&) = delete;
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;
    ~PseudoTerminal();

    [[nodiscard]] const std::string& path() const { return m_path; }
    // Readable when there are bytes from the panel, and when someone closed the far end.
    [[nodiscard]] int descriptor() const { return m_master; }
    [[nodiscard]] int closeWatch() const { return m_watch; }

    [[nodiscard]] std::size_t read(std::span<std::uint8_t> bytes);
    // Bytes that nobody reads are lost, as on a wire.
    void write(std::span<const std::uint8_t> bytes);
    // A panel has closed the port: lift its exclusive access, which would otherwise last as long as the
    // controller.
    void afterClose();

private:
    PseudoTerminal() = default;

    int m_master = -1;
    int m_slave = -1;
    int m_watch = -1;
    std::string m_path;
};

} // namespace campanel::controller
