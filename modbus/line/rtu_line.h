// SPDX-License-Identifier: Apache-2.0
// One exchange of frames on the line, and a record of everything that passed. libmodbus opens and configures
// the port, and builds and sends the questions. Answers are read here, because libmodbus silently drops the
// bytes of an invalid answer. Keeps the silence between frames and one deadline for a whole answer; drains
// after every doubt. Use it from one thread.
#pragma once

#include "modbus/line/answer_allowance.h"
#include "modbus/line/answer_reader.h"
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
    // The time beyond the wire time until enough answers were measured: work, adapters, scheduling. It is the
    // promised maximum; a controller that is always late could not be connected otherwise.
    std::chrono::milliseconds answerAllowance = AnswerAllowance::longest;
    bool isAllowanceMeasured = true; // follows the turnaround, see AnswerAllowance
};

// The counters and the record; may outlive the line, so that they continue after a reconnection.
struct LinkRecord {
    LinkFigures figures;
    FrameLog frames;
    std::chrono::milliseconds allowance{0}; // for the next answer, beyond wire time; 0: no port is open
};

struct Question {
    std::string name;              // for errors: "status"
    std::vector<std::uint8_t> pdu; // function and data; unit and CRC-16 are added
    FramePair frames;              // lengths of question and answer
    std::uint16_t readAddress = 0;
    std::uint16_t readCount = 0;
    std::chrono::milliseconds extraAllowance{0};
    bool isRepeatable = true; // can be repeated without side effects: counts as a retry after its own failure
};

class RtuLine {
public:
    using Bytes = std::vector<std::uint8_t>;
    using Proof = AnswerReader::Proof;

    // `record` must live as long as the line.
    RtuLine(LinkSettings settings, LinkRecord& record);
    ~RtuLine();
    RtuLine(const RtuLine&) = delete;
    RtuLine& operator=(const RtuLine&) = delete;

    [[nodiscard]] tl::expected<void, LinkError> open();
    void close();
    [[nodiscard]] bool isOpen() const { return m_context != nullptr; }
    [[nodiscard]] const LinkSettings& settings() const { return m_settings; }
    // Sets the unit of the next questions, 1..247.
    void setUnit(int unit) { m_settings.unit = unit; }

    // Returns the data of the answer, proven. Drops an answer with another unit, function or length, or one
    // that `isMine` rejects; the error is ForeignAnswer. Bytes before and between the answers are skipped;
    // bytes behind are an error until the line is known for them.
    [[nodiscard]] tl::expected<Bytes, LinkError> ask(const Question& question, const Proof& isMine);

    // Returns true when the adapter echoes what the panel sends, as some RS-485 adapters do. The echo is
    // removed from the answers.
    [[nodiscard]] bool isEchoing() const { return m_isEchoing; }

    // Returns the allowance of the next answer beyond wire time.
    [[nodiscard]] std::chrono::milliseconds allowance() const { return m_allowance.value(); }

private:
    using Clock = std::chrono::steady_clock;
    struct ContextDeleter {
        void operator()(modbus_t* context) const;
    };
    enum class Input { Bytes, Nothing, Gone };

    [[nodiscard]] LinkError error(LinkErrorKind kind, std::string request = {}, std::string detail = {},
                                  int code = 0) const;
    // Returns the frame that was sent.
    [[nodiscard]] tl::expected<Bytes, LinkError> send(const Question& question);
    [[nodiscard]] static Input waitForInput(int descriptor, Clock::time_point deadline);
    [[nodiscard]] Input readInput(AnswerReader& reader, Clock::time_point deadline);
    [[nodiscard]] AnswerReader::Piece receive(AnswerReader& reader, Clock::time_point deadline);
    [[nodiscard]] AnswerReader::Piece receiveAnswer(const Question& question, AnswerReader& reader,
                                                    Clock::time_point deadline);
    [[nodiscard]] bool endsWithSilence(AnswerReader& reader, Clock::time_point completeAt);
    [[nodiscard]] LinkError fail(const Question& question, const AnswerReader::Piece& piece,
                                 Clock::time_point startedAt);
    enum class Drain { Opening, Unasked, Doubt };
    void drainLine(Drain reason = Drain::Doubt);

    LinkSettings m_settings;
    LinkRecord& m_record;
    AnswerAllowance m_allowance;
    PortClaim m_claim;
    std::unique_ptr<modbus_t, ContextDeleter> m_context;
    Clock::time_point m_lineFreeAt;
    bool m_isEchoing = false;
    std::optional<std::string> m_failedRequest; // last one, if it failed and may be repeated
};

} // namespace campanel::modbus
