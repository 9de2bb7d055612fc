// SPDX-License-Identifier: Apache-2.0
// The panel's end of the line: owns the line and asks one question at a time. Every answer
// that is believed carries the question's own tag or counter. Use from one thread; every call blocks for at
// most the wire time of its frames plus the allowance, and after a doubtful answer for the time of draining.
#pragma once

#include "modbus/line/link_error.h"
#include "modbus/line/rtu_line.h"
#include "modbus/map/blocks.h"

#include <tl/expected.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::modbus {

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
    // Counts and records in `record`, which may be that of an earlier connection.
    explicit RtuClient(LinkSettings settings,
                       std::shared_ptr<LinkRecord> record = std::make_shared<LinkRecord>());
    ~RtuClient();
    RtuClient(const RtuClient&) = delete;
    RtuClient& operator=(const RtuClient&) = delete;

    [[nodiscard]] tl::expected<void, LinkError> open();
    void close();
    [[nodiscard]] const LinkSettings& settings() const { return m_line.settings(); }
    [[nodiscard]] const LinkRecord& record() const { return *m_record; }
    [[nodiscard]] bool isEchoing() const { return m_line.isEchoing(); }
    // What the next answer is allowed beyond wire time: follows what is measured.
    [[nodiscard]] std::chrono::milliseconds allowance() const { return m_line.allowance(); }

    // Whose device answers at `unit`: one read (function 3) of the identity block and nothing else, for who
    // is looking for a controller. Unproven, so only for showing; errors as of identify().
    [[nodiscard]] tl::expected<Identity, LinkError> probe(int unit);

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
    struct WindowRead { // one FC23
        std::uint16_t writeAddress = 0;
        std::span<const std::uint16_t> written;
        std::uint16_t readAddress = 0;
        std::uint16_t readCount = 0;
        std::chrono::milliseconds extraAllowance{0};
        bool isRepeatable = true;
    };
    using Registers = std::vector<std::uint16_t>;
    using Proof = std::function<bool(const Registers&)>;

    [[nodiscard]] LinkError error(LinkErrorKind kind, std::string request = {}, std::string detail = {},
                                  int code = 0) const;
    [[nodiscard]] tl::expected<Registers, LinkError>
    writeAndRead(const std::string& request, const WindowRead& window, const Proof& isMine);
    [[nodiscard]] tl::expected<Registers, LinkError> readPlain(const std::string& request,
                                                               std::uint16_t address, std::uint16_t count);
    [[nodiscard]] tl::expected<Identity, LinkError> identityIn(const Registers& registers) const;
    [[nodiscard]] tl::expected<CommandResult, LinkError> resolve(const std::string& request,
                                                                 std::uint16_t counter);

    std::shared_ptr<LinkRecord> m_record;
    RtuLine m_line;
    std::uint16_t m_tag = 0;
    std::optional<std::uint16_t> m_commandCounter; // of the controller's last command; empty until read
};

} // namespace campanel::modbus
