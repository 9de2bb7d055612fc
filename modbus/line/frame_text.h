// SPDX-License-Identifier: Apache-2.0
// Decodes recorded frames: function, registers by name with their values, exceptions by name, and verdict.
#pragma once

#include "modbus/line/frame_log.h"
#include "modbus/map/register_values.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::modbus {

struct DecodedFrame {
    // Empty when the bytes are not a complete frame: incomplete, damaged, drained, none.
    std::optional<std::uint8_t> unit;
    std::optional<std::uint8_t> function; // without the exception flag
    std::optional<std::uint8_t> exception;
    std::optional<RegisterSpan> read;    // from the question
    std::optional<RegisterSpan> written; // from the question
    std::vector<NamedValue> values;      // written in a question, read in an answer
};

[[nodiscard]] DecodedFrame decodeFrame(const FrameRecord& record);

// Returns "read and write", empty for functions that this program does not use.
[[nodiscard]] std::string_view functionName(std::uint8_t function);
// Returns "sent", "answer", "dropped: answer to another question" ...
[[nodiscard]] std::string_view verdictText(FrameVerdict verdict);

// Returns "01 03 00 00".
[[nodiscard]] std::string hexBytes(std::span<const std::uint8_t> bytes);
// Returns one line without the time: "sent: unit 1, read and write, exchange.tag = 7, ...; read status.tag ..
// 40 registers".
[[nodiscard]] std::string frameSentence(const FrameRecord& record);
// Returns the text export. Each frame has a line with the seconds since `start` (default: the first frame),
// direction and sentence, and a line with its bytes.
[[nodiscard]] std::string framesText(std::span<const FrameRecord> records,
                                     std::optional<std::chrono::steady_clock::time_point> start = {});

} // namespace campanel::modbus
