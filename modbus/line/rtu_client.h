// SPDX-License-Identifier: Apache-2.0
// The panel's end of the line: owns the line and asks one question at a time. Every accepted answer contains
// the question's own tag or counter. Use it from one thread. Every call blocks for at most the wire time of
// its frames plus the allowance, and after a doubtful answer for the time of draining.
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
    std::string lot = {}; // of OrderStart, UTF-8, at most 2 x orderLotRegisters bytes
};

struct TransferFrame {
    std::uint16_t session = 0;
    TransferOperation operation = TransferOperation::None;
    std::uint16_t block = 0;
    std::span<const std::uint16_t> data; // at most blockRegisters
};

class RtuClient {
public:
    // The time of a command in pieces at most: flash is erased and written.
    static constexpr std::chrono::milliseconds flashAllowance{2000};

    // Counts and records in `record`, which may belong to an earlier connection.
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
    // Returns the allowance of the next answer beyond wire time, which follows the measurements.
    [[nodiscard]] std::chrono::milliseconds allowance() const { return m_line.allowance(); }

    // Reads the identity block of the device at `unit` (function 3) and nothing else, for the search of a
    // controller. Unproven, so only for display; errors as of identify().
    [[nodiscard]] tl::expected<Identity, LinkError> probe(int unit);

    // Reads the identity before anything is written, so that a foreign device is not changed; refuses another
    // device type or map major version.
    [[nodiscard]] tl::expected<Identity, LinkError> identify();

    // Performs the periodic exchange: sends heartbeat, held jog bits and the permit (PermitBit), receives the
    // status block. A controller that was not identified, or whose map has no permit, gets the first two
    // only.
    [[nodiscard]] tl::expected<StatusBlock, LinkError>
    exchangeStatus(std::uint16_t heartbeat, std::uint16_t jogBits, std::uint16_t permitBits = 0);

    // Reads 1..readbackRegisters registers with an answer that identifies the question.
    [[nodiscard]] tl::expected<std::vector<std::uint16_t>, LinkError> readProven(std::uint16_t address,
                                                                                 std::uint16_t count);

    // Sends the command once. When the answer is doubtful, reads the last result instead of repeating the
    // command; the error is then CommandLost (not received) or OutcomeUnknown (resolve later with
    // findResult()). A refusal by the controller is a result, not an error; so is CommandStatus::Busy of a
    // command that the controller carries out in pieces.
    [[nodiscard]] tl::expected<CommandResult, LinkError> begin(Command code,
                                                               const CommandArguments& arguments = {});

    // The same, and waits for the end of a command in pieces. Use begin() where other exchanges must go on.
    [[nodiscard]] tl::expected<CommandResult, LinkError> command(Command code,
                                                                 const CommandArguments& arguments = {});

    // Returns the present result of the command with `counter`; empty when the controller's last command was
    // another one.
    [[nodiscard]] tl::expected<std::optional<CommandResult>, LinkError> readResult(std::uint16_t counter);

    // The same, and waits for the end of a command in pieces for as long as flash takes; then the error is
    // OutcomeUnknown.
    [[nodiscard]] tl::expected<std::optional<CommandResult>, LinkError> findResult(std::uint16_t counter);

    // Sends one frame of a download; the answer belongs to this frame (session, operation and block are
    // compared).
    [[nodiscard]] tl::expected<TransferAnswer, LinkError> transfer(const TransferFrame& frame);
    // Reads the answer to the last transfer frame that the controller received.
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
    [[nodiscard]] tl::expected<void, LinkError> writeOrderLot(std::string_view lot);
    using FindResult = tl::expected<std::optional<CommandResult>, LinkError> (RtuClient::*)(std::uint16_t);
    [[nodiscard]] tl::expected<CommandResult, LinkError> resolve(Command code, std::uint16_t counter,
                                                                 FindResult find);

    std::shared_ptr<LinkRecord> m_record;
    RtuLine m_line;
    std::uint16_t m_tag = 0;
    bool m_hasPermit = false;                      // of the identified controller's map
    std::optional<std::uint16_t> m_commandCounter; // controller's last command; empty until read
};

} // namespace campanel::modbus
