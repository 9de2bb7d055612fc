// SPDX-License-Identifier: Apache-2.0
// The controller's RTU slave: frames, good and damaged ones, and writes to every register, while a program of
// any kind runs. Each answer must be a whole frame, and each pulse must lie in its slice.
#include "tests/controller/rig.h"
#include "tests/fuzz/fuzz_machine.h"

#include <algorithm>

namespace campanel::fuzz {
namespace {

using test::Registers;

// The most time that one input may pass, us.
constexpr std::uint64_t longestRunUs = 3'000'000;
constexpr std::uint16_t mostRegisters = 125;

void checkAnswer(const Bytes& answer)
{
    require(answer.empty() || answer.size() >= 5, "an answer has at least five bytes");
    require(answer.size() <= CTL_FRAME_BYTES, "an answer fits a frame");
    const Bytes content(answer.begin(), answer.end() - (answer.empty() ? 0 : 2));
    require(answer.empty() || test::frame(content) == answer, "an answer ends with its CRC-16");
}

// Returns an address of a group that can be written, or any.
std::uint16_t someAddress(InputReader& input)
{
    static constexpr std::uint16_t bases[]{CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT,
                                           CTL_REG_EXCHANGE_TAG,
                                           CTL_REG_COMMAND_COUNTER,
                                           CTL_REG_TRANSFER_SESSION,
                                           CTL_REG_READBACK_TAG,
                                           0};
    const std::uint8_t choice = input.byte();
    if (choice == 0xFF)
        return input.word();
    return static_cast<std::uint16_t>(bases[choice % std::size(bases)] + input.byte());
}

Registers someRegisters(InputReader& input)
{
    Registers values(static_cast<std::size_t>(1 + input.byte() % mostRegisters));
    for (std::uint16_t& value : values)
        value = input.word();
    return values;
}

Bytes request(InputReader& input)
{
    Bytes bytes{1};
    const auto append = [&bytes](std::uint16_t value) {
        bytes.push_back(static_cast<std::uint8_t>(value >> 8));
        bytes.push_back(static_cast<std::uint8_t>(value));
    };
    const auto appendValues = [&](const Registers& values) {
        append(static_cast<std::uint16_t>(values.size()));
        bytes.push_back(static_cast<std::uint8_t>(2 * values.size()));
        std::ranges::for_each(values, append);
    };
    switch (input.byte() % 4) {
    case 0:
        bytes.push_back(3);
        append(someAddress(input));
        append(static_cast<std::uint16_t>(input.word() % (mostRegisters + 2)));
        break;
    case 1:
        bytes.push_back(6);
        append(someAddress(input));
        append(input.word());
        break;
    case 2:
        bytes.push_back(16);
        append(someAddress(input));
        appendValues(someRegisters(input));
        break;
    default:
        bytes.push_back(23);
        append(someAddress(input));
        append(static_cast<std::uint16_t>(input.byte() % mostRegisters));
        append(someAddress(input));
        appendValues(someRegisters(input));
        break;
    }
    return test::frame(bytes);
}

void sendCommand(FuzzMachine& machine, InputReader& input)
{
    const std::uint16_t code = input.byte() % 24u;
    const std::uint16_t first = input.word();
    checkAnswer(machine.rig().exchange(
        machine.commandFrame(code, first, input.byte(), static_cast<std::uint32_t>(input.word()))));
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    InputReader input(bytes);
    FuzzMachine machine(input.byte());
    test::Rig& rig = machine.rig();
    if ((input.byte() & 1u) != 0)
        machine.installAndStart();
    const std::uint64_t endUs = rig.controller().nowUs() + longestRunUs;
    while (!input.isAtEnd() && rig.controller().nowUs() < endUs) {
        switch (input.byte() % 8) {
        case 0: {
            const auto raw = input.take(input.byte());
            checkAnswer(rig.exchange(Bytes(raw.begin(), raw.end())));
            break;
        }
        case 1: {
            const auto raw = input.take(input.byte());
            checkAnswer(rig.exchange(test::frame(Bytes(raw.begin(), raw.end()))));
            break;
        }
        case 2:
            ctl_receive_error(&rig.core(), rig.controller().nowUs());
            break;
        case 3:
            rig.run(input.word());
            break;
        case 4:
            rig.controller().machine().setInput(input.byte() % 16u, (input.byte() & 1u) != 0);
            break;
        case 5:
            sendCommand(machine, input);
            break;
        default:
            checkAnswer(rig.exchange(request(input)));
            break;
        }
    }
    rig.run(10'000);
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds;
    for (std::uint8_t kind = 0; kind < FuzzMachine::images(); ++kind) {
        seeds.push_back({kind, 1, 3, 0x20, 0, 5, CTL_COMMAND_STOP_AT_CYCLE_END, 0, 0, 0, 0, 0, 3, 0xFF, 0});
        seeds.push_back({kind, 0, 7, 2, 0, 5, 1, 0, 100, 7, 0, 5, 0, 0, 2, 5, 2, 3, 0x10, 0});
        seeds.push_back({kind, 1, 7, 3, 5, 0, 40, 1, 0, 2, 0, 1, 0, 1, 0, 0, 4, 1, 1, 3, 0x40, 0});
        seeds.push_back({kind, 1, 0, 8, 1, 3, 1, 0, 0, 40, 0x44, 0x28, 1, 6, 1, 3, 0, 0, 0, 19});
    }
    return seeds;
}

} // namespace campanel::fuzz
