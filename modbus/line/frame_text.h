// SPDX-License-Identifier: Apache-2.0
// Recorded frames read: function, registers by name with their values, exceptions by name, and what became of
// them.
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
    // Empty where the bytes are no whole frame: incomplete, damaged, drained, none.
    std::optional<std::uint8_t> unit;
    std::optional<std::uint8_t> function; // without the flag of exceptions
    std::optional<std::uint8_t> exception;
    std::optional<RegisterSpan> read;    // by the question
    std::optional<RegisterSpan> written; // by the question
    std::vector<NamedValue> values;      // written in a question, read in an answer
};

[[nodiscard]] DecodedFrame decodeFrame(const FrameRecord& record);

// "read and write", empty for functions that this program does not use.
[[nodiscard]] std::string_view functionName(std::uint8_t function);
// "sent", "answer", "dropped: answer to another question" ...
[[nodiscard]] std::string_view verdictText(FrameVerdict verdict);

// "01 03 00 00".
[[nodiscard]] std::string hexBytes(std::span<const std::uint8_t> bytes);
// One line without the time: "sent: unit 1, read and write, exchange.tag = 7, ...; read status.tag .. 40
// registers".
[[nodiscard]] std::string frameSentence(const FrameRecord& record);
// Text export: for each frame a line of seconds since `start` (without it the first frame), direction and
// sentence, and a line of its bytes.
[[nodiscard]] std::string framesText(std::span<const FrameRecord> records,
                                     std::optional<std::chrono::steady_clock::time_point> start = {});

} // namespace campanel::modbus
