// SPDX-License-Identifier: Apache-2.0
// The panel's end of the line: owns the one libmodbus context and asks one question at a time. Every answer
// that is believed carries the question's own tag or counter. Use from one thread; every call blocks for at
// most the wire time of its frames plus the allowance, and after a doubtful answer for the time of draining.
#pragma once

#include "modbus/blocks.h"
#include "modbus/link_error.h"
#include "modbus/serial_port.h"
#include "modbus/wire_time.h"

#include <modbus/modbus.h>
#include <tl/expected.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::modbus {

struct LinkSettings {
    std::string port; // device path
    LineSettings line;
    int unit = 1;                                   // 1..247
    std::chrono::milliseconds answerAllowance{100}; // beyond the wire time: work, adapters, scheduling
};

struct CommandArguments {
    std::uint16_t argument0 = 0;
    std::uint16_t argument1 = 0;
    std::uint32_t argument2 = 0;
};

struct TransferFrame {
    std::uint16_t session = 0;
    TransferOperation operation = TransferOperation::None;
    std::uint16_t block = 0;
    std::span<const std::uint16_t> data; // at most blockRegisters
};

class RtuClient {
public:
    explicit RtuClient(LinkSettings settings);
    ~RtuClient();
    RtuClient(const RtuClient&) = delete;
    RtuClient& operator=(const RtuClient&) = delete;

    [[nodiscard]] tl::expected<void, LinkError> open();
    void close();
    [[nodiscard]] const LinkSettings& settings() const { return m_settings; }

    // Reads before it writes anything, so that a foreign device is left alone; refuses another device type or
    // map major version.
    [[nodiscard]] tl::expected<Identity, LinkError> identify();

    // The periodic exchange: heartbeat and held jog bits out, status block in.
    [[nodiscard]] tl::expected<StatusBlock, LinkError> exchangeStatus(std::uint16_t heartbeat,
                                                                      std::uint16_t jogBits);

    // 1..readbackRegisters registers whose answer names the question.
    [[nodiscard]] tl::expected<std::vector<std::uint16_t>, LinkError> readProven(std::uint16_t address,
                                                                                 std::uint16_t count);

    // Sends the command once. When the answer is doubtful, asks for the last result instead of repeating: the
    // error is then CommandLost (not received) or OutcomeUnknown (resolve later with findResult()). A refusal
    // by the controller is a result, not an error.
    [[nodiscard]] tl::expected<CommandResult, LinkError> command(Command code,
                                                                 CommandArguments arguments = {});

    // The result of the command that carried `counter`; empty when another one was the controller's last.
    [[nodiscard]] tl::expected<std::optional<CommandResult>, LinkError> findResult(std::uint16_t counter);

    // One frame of a download; the answer is that of this frame (session, operation and block compared).
    [[nodiscard]] tl::expected<TransferAnswer, LinkError> transfer(const TransferFrame& frame);
    // The answer to the last transfer frame that the controller received.
    [[nodiscard]] tl::expected<TransferAnswer, LinkError> readTransferResult();

    // Writes one writable value (function 16) and proves it by reading back.
    [[nodiscard]] tl::expected<void, LinkError> writeParameter(const RegisterInfo& info, double physical);

private:
    struct ContextDeleter {
        void operator()(modbus_t* context) const;
    };
    struct WindowRead { // one FC23
        std::uint16_t writeAddress = 0;
        std::span<const std::uint16_t> written;
        std::uint16_t readAddress = 0;
        std::uint16_t readCount = 0;
        std::chrono::milliseconds extraAllowance{0};
    };

    [[nodiscard]] LinkError error(LinkErrorKind kind, std::string request = {}, std::string detail = {},
                                  int code = 0) const;
    [[nodiscard]] tl::expected<std::vector<std::uint16_t>, LinkError> writeAndRead(const std::string& request,
                                                                                   const WindowRead& window);
    [[nodiscard]] tl::expected<std::vector<std::uint16_t>, LinkError>
    readPlain(const std::string& request, std::uint16_t address, std::uint16_t count);
    [[nodiscard]] tl::expected<void, LinkError> prepare(const std::string& request, const FramePair& frames,
                                                        std::chrono::milliseconds extraAllowance);
    [[nodiscard]] LinkError failed(const std::string& request, int errorNumber);
    [[nodiscard]] LinkError dropForeign(const std::string& request);
    void drainLine();
    [[nodiscard]] tl::expected<CommandResult, LinkError> resolve(const std::string& request,
                                                                 std::uint16_t counter);

    LinkSettings m_settings;
    PortClaim m_claim;
    std::unique_ptr<modbus_t, ContextDeleter> m_context;
    std::chrono::steady_clock::time_point m_lineFreeAt;
    std::uint16_t m_tag = 0;
    std::optional<std::uint16_t> m_commandCounter; // of the controller's last command; empty until read
};

} // namespace campanel::modbus
