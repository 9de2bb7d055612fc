// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/frame_text.h"

#include "modbus/line/crc16.h"
#include "modbus/line/link_error.h"
#include "modbus/map/function_codes.h"
#include "modbus/map/register_document.h"

#include <algorithm>
#include <cstdio>

namespace campanel::modbus {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::uint16_t word(Bytes bytes, std::size_t at)
{
    return static_cast<std::uint16_t>((bytes[at] << 8) | bytes[at + 1]);
}

std::vector<std::uint16_t> words(Bytes bytes)
{
    std::vector<std::uint16_t> result(bytes.size() / 2);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = word(bytes, 2 * i);
    return result;
}

void appendValues(std::vector<NamedValue>& values, std::uint16_t address,
                  std::span<const std::uint16_t> registers)
{
    for (NamedValue& value : namedValues(address, registers))
        values.push_back(std::move(value));
}

// Read-back windows and transfers contain registers of other addresses: they get the names of those.
void appendWindow(std::vector<NamedValue>& values, std::uint16_t address,
                  std::span<const std::uint16_t> registers)
{
    constexpr std::size_t readbackEcho = 3;
    constexpr std::size_t transferHead = 4;
    static const std::uint16_t readback = findSpan("readback_result.tag")->address;
    static const std::uint16_t transfer = findSpan("transfer.session")->address;
    const bool isReadback = address == readback && registers.size() > readbackEcho;
    const bool isBlock = address == transfer && registers.size() > transferHead &&
                         registers[1] == static_cast<std::uint16_t>(TransferOperation::Block);
    const std::size_t head = isReadback ? readbackEcho : isBlock ? transferHead : registers.size();
    appendValues(values, address, registers.first(head));
    if (isReadback)
        appendValues(values, registers[1], registers.subspan(head));
    if (isBlock)
        appendValues(values, static_cast<std::uint16_t>(stagedBankBase + registers[2] * blockRegisters),
                     registers.subspan(head));
}

void decodeQuestion(Bytes data, DecodedFrame& frame)
{
    constexpr std::size_t writeHead = 5;
    constexpr std::size_t writeAndReadHead = 9;
    if (frame.function == functionRead && data.size() == 4)
        frame.read = RegisterSpan{word(data, 0), word(data, 2)};
    if (frame.function == functionWrite && data.size() >= writeHead) {
        frame.written = RegisterSpan{word(data, 0), word(data, 2)};
        appendWindow(frame.values, frame.written->address, words(data.subspan(writeHead)));
    }
    if (frame.function == functionWriteAndRead && data.size() >= writeAndReadHead) {
        frame.read = RegisterSpan{word(data, 0), word(data, 2)};
        frame.written = RegisterSpan{word(data, 4), word(data, 6)};
        appendWindow(frame.values, frame.written->address, words(data.subspan(writeAndReadHead)));
    }
}

std::string spanText(const RegisterSpan& span)
{
    const auto rows = registers();
    const auto row = std::ranges::find_if(rows, [&](const RegisterInfo& info) {
        return info.address <= span.address && span.address < info.address + info.count;
    });
    std::string text = std::to_string(span.count);
    text.append(span.count == 1 ? " register" : " registers")
        .append(" from ")
        .append(hexAddress(span.address));
    if (row != rows.end())
        text.append(" (").append(row->name).append(")");
    return text;
}

} // namespace

DecodedFrame decodeFrame(const FrameRecord& record)
{
    DecodedFrame frame;
    const Bytes bytes = record.bytes();
    if (record.verdict == FrameVerdict::Drained || record.verdict == FrameVerdict::Stray ||
        !endsWithCrc16(bytes))
        return frame;
    frame.unit = bytes[0];
    frame.function = static_cast<std::uint8_t>(bytes[1] & ~exceptionFlag);
    const Bytes data = bytes.subspan(2, bytes.size() - 4);
    if (record.isSent()) {
        decodeQuestion(data, frame);
    } else if ((bytes[1] & exceptionFlag) != 0) {
        frame.exception = data.empty() ? std::uint8_t{0} : data[0];
    } else if (record.verdict == FrameVerdict::Answer && record.readCount > 0 && !data.empty()) {
        frame.read = RegisterSpan{record.readAddress, record.readCount};
        appendWindow(frame.values, record.readAddress, words(data.subspan(1)));
    }
    return frame;
}

std::string_view functionName(std::uint8_t function)
{
    switch (function) {
    case functionRead:
        return "read";
    case functionWrite:
        return "write";
    case functionWriteAndRead:
        return "read and write";
    default:
        return {};
    }
}

std::string_view verdictText(FrameVerdict verdict)
{
    switch (verdict) {
    case FrameVerdict::Sent:
        return "sent";
    case FrameVerdict::Answer:
        return "answer";
    case FrameVerdict::Exception:
        return "exception";
    case FrameVerdict::Foreign:
        return "dropped: response to another request";
    case FrameVerdict::BadChecksum:
        return "dropped: wrong checksum";
    case FrameVerdict::Malformed:
        return "dropped: invalid frame";
    case FrameVerdict::Incomplete:
        return "dropped: incomplete frame";
    case FrameVerdict::Silence:
        return "response timeout";
    case FrameVerdict::Stray:
        return "skipped: stray bytes";
    case FrameVerdict::Drained:
        return "dropped: no request pending";
    case FrameVerdict::PortGone:
        return "port removed";
    }
    return {};
}

std::string hexBytes(Bytes bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes) {
        char digits[4];
        std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(byte));
        text.append(text.empty() ? "" : " ").append(digits);
    }
    return text;
}

std::string frameSentence(const FrameRecord& record)
{
    const DecodedFrame frame = decodeFrame(record);
    std::string text(verdictText(record.verdict));
    if (!frame.unit)
        return record.length == 0 ? text
                                  : text.append(", ").append(std::to_string(record.length)).append(" bytes");
    text.append(": unit ").append(std::to_string(*frame.unit));
    const std::string_view function = functionName(*frame.function);
    text.append(", ").append(function.empty() ? "function " + std::to_string(*frame.function)
                                              : std::string(function));
    if (frame.exception)
        text.append(", ")
            .append(std::to_string(*frame.exception))
            .append(" ")
            .append(exceptionName(*frame.exception));
    if (record.isSent() && frame.read)
        text.append(", wants ").append(spanText(*frame.read));
    if (frame.written)
        text.append(", writes ").append(spanText(*frame.written));
    for (const NamedValue& value : frame.values)
        text.append(", ").append(value.name()).append(" = ").append(value.text());
    return text;
}

std::string framesText(std::span<const FrameRecord> records,
                       std::optional<std::chrono::steady_clock::time_point> start)
{
    std::string text;
    for (const FrameRecord& record : records) {
        const std::chrono::duration<double> since = record.at - start.value_or(records.front().at);
        char head[48];
        std::snprintf(head, sizeof head, "%12.6f %s ", since.count(), record.isSent() ? ">" : "<");
        text.append(head).append(frameSentence(record)).append("\n");
        if (record.length > 0)
            text.append("               ").append(hexBytes(record.bytes())).append("\n");
    }
    return text;
}

} // namespace campanel::modbus
