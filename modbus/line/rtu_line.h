// SPDX-License-Identifier: Apache-2.0
// One exchange of frames on the line, and a record of everything that passed. libmodbus opens and sets the
// port, and frames and sends the questions; answers are read here, because libmodbus throws away, without a
// word, the bytes of an answer that it does not like. Keeps the silence between frames and one deadline for a
// whole answer; drains after every doubt. Use from one thread.
#pragma once

#include "modbus/line/answer_allowance.h"
#include "modbus/line/frame_log.h"
#include "modbus/line/link_error.h"
#include "modbus/line/link_figures.h"
#include "modbus/line/serial_port.h"
#include "modbus/line/wire_time.h"

#include <modbus/modbus.h>
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

struct LinkSettings {
    std::string port; // device path
    LineSettings line;
    int unit = 1; // 1..247
    // Beyond the wire time, until enough answers were measured: work, adapters, scheduling. As long as is
    // promised, or a controller that is always late would never be connected to.
    std::chrono::milliseconds answerAllowance = AnswerAllowance::longest;
    bool isAllowanceMeasured = true; // follows the turnaround, see AnswerAllowance
};

// What is counted and recorded; may outlive the line, so that it goes on over a reconnection.
struct LinkRecord {
    LinkFigures figures;
    FrameLog frames;
    std::chrono::milliseconds allowance{0}; // of the next answer, beyond wire time; 0: no port is open
};

struct Question {
    std::string name;              // for errors: "status"
    std::vector<std::uint8_t> pdu; // function and data; unit and CRC-16 are added
    FramePair frames;              // lengths of question and answer
    std::uint16_t readAddress = 0;
    std::uint16_t readCount = 0;
    std::chrono::milliseconds extraAllowance{0};
    bool isRepeatable = true; // asked again without harm: counted as a retry when it follows its own failure
};

class RtuLine {
public:
    using Bytes = std::vector<std::uint8_t>;
    // Whether the data of an answer (what follows the function) belongs to its question.
    using Proof = std::function<bool(std::span<const std::uint8_t>)>;

    // `record` must live as long as the line.
    RtuLine(LinkSettings settings, LinkRecord& record);
    ~RtuLine();
    RtuLine(const RtuLine&) = delete;
    RtuLine& operator=(const RtuLine&) = delete;

    [[nodiscard]] tl::expected<void, LinkError> open();
    void close();
    [[nodiscard]] bool isOpen() const { return m_context != nullptr; }
    [[nodiscard]] const LinkSettings& settings() const { return m_settings; }
    // Of the following questions, 1..247.
    void setUnit(int unit) { m_settings.unit = unit; }

    // The data of the answer, proven. An answer of another unit, function or length, or one that `isMine`
    // does not take, is dropped, and the error is ForeignAnswer.
    [[nodiscard]] tl::expected<Bytes, LinkError> ask(const Question& question, const Proof& isMine);

    // The adapter returns what the panel sends, as some for RS-485 do. The echo is taken off the answers.
    [[nodiscard]] bool isEchoing() const { return m_isEchoing; }

    // What the next answer is allowed beyond wire time.
    [[nodiscard]] std::chrono::milliseconds allowance() const { return m_allowance.value(); }

private:
    using Clock = std::chrono::steady_clock;
    struct ContextDeleter {
        void operator()(modbus_t* context) const;
    };
    struct Received;

    [[nodiscard]] LinkError error(LinkErrorKind kind, std::string request = {}, std::string detail = {},
                                  int code = 0) const;
    // Returns the frame that was sent.
    [[nodiscard]] tl::expected<Bytes, LinkError> send(const Question& question);
    [[nodiscard]] Received receive(std::span<const std::uint8_t> sent, Clock::time_point deadline);
    [[nodiscard]] FrameVerdict judge(const Question& question, const Received& received,
                                     const Proof& isMine) const;
    [[nodiscard]] LinkError fail(const Question& question, FrameVerdict verdict, const Received& received,
                                 Clock::time_point startedAt);
    enum class Drain { Opening, Doubt };
    void drainLine(Drain reason = Drain::Doubt);

    LinkSettings m_settings;
    LinkRecord& m_record;
    AnswerAllowance m_allowance;
    PortClaim m_claim;
    std::unique_ptr<modbus_t, ContextDeleter> m_context;
    Clock::time_point m_lineFreeAt;
    bool m_isEchoing = false;
    std::optional<std::string> m_failedRequest; // the last one, when it failed and may be repeated
};

} // namespace campanel::modbus
