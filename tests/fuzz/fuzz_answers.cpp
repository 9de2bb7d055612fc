// SPDX-License-Identifier: Apache-2.0
// The client's answer reader: any bytes in any pieces after any question, and whatever passes as an answer is
// decoded, wherever it stands. A frame with a wrong CRC-16, of another unit, function or length never passes.
#include "modbus/line/answer_reader.h"
#include "modbus/line/crc16.h"
#include "modbus/line/frame_text.h"
#include "modbus/line/wire_time.h"
#include "modbus/map/bank_header.h"
#include "modbus/map/blocks.h"
#include "modbus/map/io_status.h"
#include "modbus/map/packer_status.h"
#include "modbus/map/register_values.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <array>

namespace campanel::fuzz {
namespace {

using namespace campanel::modbus;

struct Asked {
    Bytes sent;
    AnswerForm form;
    std::uint16_t address = 0;
    std::uint16_t count = 0;
};

Bytes withCrc(Bytes frame)
{
    const std::uint16_t crc = crc16(frame);
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    return frame;
}

// Returns one of the questions of the panel.
Asked askedBy(std::uint8_t choice)
{
    struct Block {
        std::uint16_t address;
        std::uint16_t count;
    };
    static const std::array blocks{Block{identityAddress, identityRegisters},
                                   Block{statusAddress, std::uint16_t{statusRegisters}},
                                   Block{0x0210, commandResultRegisters},
                                   Block{0x0318, transferResultRegisters},
                                   Block{packerAddress, packerRegisters()},
                                   Block{ioAddress, ioRegisters()},
                                   Block{0x2000, 64}};
    const Block& block = blocks[choice % blocks.size()];
    const auto high = [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); };
    const auto low = [](std::uint16_t value) { return static_cast<std::uint8_t>(value & 0xFFu); };
    Asked asked{{1, 3, high(block.address), low(block.address), high(block.count), low(block.count)},
                {1, 3, 5u + 2u * block.count},
                block.address,
                block.count};
    if ((choice & 0x80u) != 0) { // written and read
        asked.sent[1] = 23;
        asked.form.function = 23;
        for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{0x05, 0x00, 0x00, 0x03, 0x06, 0x12,
                                                                           0x34, 0x12, 0x35, 0x00, 0x01})
            asked.sent.push_back(byte);
    } else if ((choice & 0x40u) != 0) { // written
        asked.sent[1] = 16;
        asked.form = {1, 16, 8};
        for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{0x02, 0x12, 0x34})
            asked.sent.push_back(byte);
    }
    asked.sent = withCrc(asked.sent);
    return asked;
}

void decode(const Asked& asked, std::span<const std::uint8_t> data)
{
    const std::vector<std::uint16_t> registers = answeredRegisters(data);
    if (registers.size() != asked.count)
        return;
    switch (asked.address) {
    case identityAddress: {
        const Identity identity = decodeIdentity(registers);
        (void)impossibleValue(identity);
        (void)identity.firmwareVersion();
        break;
    }
    case statusAddress:
        (void)decodeStatus(registers);
        break;
    case 0x0210:
        (void)decodeCommandResult(registers);
        break;
    case 0x0318:
        (void)decodeTransferAnswer(registers);
        break;
    case packerAddress: {
        const PackerStatus packer = decodePacker(registers);
        require(packer.bags.size() <= bagRecords, "no more bags than the ring has");
        break;
    }
    case ioAddress:
        (void)decodeIo(registers);
        break;
    default:
        (void)listSpan(registers);
        (void)bankLength(registers);
        break;
    }
    for (const NamedValue& value : namedValues(asked.address, registers))
        (void)(value.name() + value.text());
}

// Shows the bytes as the recorder of frames does.
void show(const Asked& asked, std::span<const std::uint8_t> bytes, FrameVerdict verdict)
{
    FrameRecord record;
    record.verdict = verdict;
    record.readAddress = asked.address;
    record.readCount = asked.count;
    record.length = static_cast<std::uint16_t>(std::min(bytes.size(), FrameRecord::maxBytes));
    std::ranges::copy(bytes.first(record.length), record.data.begin());
    (void)framesText(std::span(&record, 1));
}

void check(const Asked& asked, const AnswerReader::Piece& piece)
{
    show(asked, piece.frame, piece.verdict);
    const auto frame = piece.frame;
    if (piece.verdict == FrameVerdict::Exception)
        require(endsWithCrc16(frame) && frame[0] == 1 && frame[1] == (asked.form.function | 0x80u) &&
                    frame.size() == 5,
                "an exception is of the expected form");
    if (piece.verdict != FrameVerdict::Answer)
        return;
    require(endsWithCrc16(frame) && frame[0] == 1 && frame[1] == asked.form.function &&
                frame.size() == asked.form.bytes,
            "an answer is of the expected form");
    decode(asked, frame.subspan(2, frame.size() - 4));
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    InputReader input(bytes);
    const Asked asked = askedBy(input.byte());
    const std::uint8_t manner = input.byte();
    const std::size_t step = 1u + manner % 32u;
    const auto raw = input.rest();
    Bytes line((manner & 0x40u) != 0 ? asked.sent : Bytes()); // an adapter that echoes
    line.insert(line.end(), raw.begin(), raw.end());
    if ((manner & 0x80u) != 0) // no checksum is guessed by chance
        line = withCrc(line);
    const AnswerReader::Proof isMine = [](std::span<const std::uint8_t>) { return true; };
    AnswerReader reader(asked.sent, asked.form, isMine);
    show(asked, line, FrameVerdict::Drained);
    show(asked, line, FrameVerdict::Sent);
    std::size_t at = 0;
    std::size_t told = 0;
    for (bool hasEnded = false; !hasEnded;) {
        auto piece = reader.next();
        const std::size_t count = std::min({piece ? 0 : step, line.size() - at, reader.space().size()});
        std::copy_n(line.begin() + static_cast<std::ptrdiff_t>(at), count, reader.space().begin());
        reader.take(count);
        at += count;
        if (!piece && count > 0)
            continue;
        if (!piece)
            piece = reader.rest();
        told += piece->strays.size() + piece->frame.size();
        check(asked, *piece);
        hasEnded = piece->verdict != FrameVerdict::Foreign && piece->verdict != FrameVerdict::Exception &&
                   piece->verdict != FrameVerdict::Answer;
    }
    require(told + (reader.isEchoing() ? asked.sent.size() : 0) == at, "every byte is told once");
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds;
    for (std::uint8_t block = 0; block < 7; ++block) {
        for (const unsigned how : {0u, 0x40u, 0x80u}) {
            const auto choice = static_cast<std::uint8_t>(block | how);
            const Asked asked = askedBy(choice);
            Bytes answer{1, asked.form.function};
            if (how != 0x40u) {
                answer.push_back(static_cast<std::uint8_t>(2 * asked.count));
                for (unsigned i = 0; i < 2u * asked.count; ++i)
                    answer.push_back(static_cast<std::uint8_t>((i & 1u) != 0 ? i : 0));
            } else {
                answer.insert(answer.end(), asked.sent.begin() + 2, asked.sent.begin() + 6);
            }
            Bytes seed{choice, static_cast<std::uint8_t>(how == 0 ? 0x9Fu : 0xC7u)};
            seed.insert(seed.end(), answer.begin(), answer.end());
            seeds.push_back(seed);
        }
    }
    seeds.push_back({1, 0x8F, 1, 0x83, 6});
    // Bytes of a line without bias before and behind the beginning of an answer.
    seeds.push_back({1, 0x8F, 0x00, 1, 0x83, 6});
    seeds.push_back({1, 0x8F, 0xFF, 0x00, 1, 3, 80, 1, 0x83, 6, 0, 0});
    return seeds;
}

} // namespace campanel::fuzz
