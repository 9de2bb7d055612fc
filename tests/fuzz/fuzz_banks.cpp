// SPDX-License-Identifier: Apache-2.0
// Transfer of banks with arbitrary header and rows, then start, a change of program on the way, and slices:
// what is not refused must run without end of the program, within each slice's pulses, and its steps within a
// ceiling.
#include "tests/fuzz/fuzz_machine.h"

#include <algorithm>

namespace campanel::fuzz {
namespace {

using test::Registers;

constexpr std::uint64_t sliceUs = CTL_SLICE_US;
// The slices of one program.
constexpr std::uint64_t mostSlices = 4'000;

// Changes registers of a good bank: (offset, value) pairs, the number of them first; rows may repeat or go.
Registers changedBank(InputReader& input)
{
    Registers bank = FuzzMachine::image(input.byte());
    const std::uint8_t shape = input.byte();
    if ((shape & 3u) == 1 &&
        bank.size() > CTL_BANK_HEADER_REGISTERS) { // cut off, or longer than its header says
        bank.resize(CTL_BANK_HEADER_REGISTERS + input.word() % 128u);
    } else if ((shape & 3u) == 2) {
        const std::size_t copies = 1u + input.byte() % 8u;
        const Registers rows(bank.begin() + CTL_BANK_HEADER_REGISTERS, bank.end());
        for (std::size_t copy = 0; copy < copies && bank.size() + rows.size() <= CTL_BANK_REGISTERS; ++copy)
            bank.insert(bank.end(), rows.begin(), rows.end());
    }
    for (unsigned changes = input.byte() % 32u; changes != 0; --changes) {
        const std::size_t at = input.word() % bank.size();
        // Small differences keep most checks content; any value goes as well.
        const std::uint8_t how = input.byte();
        bank[at] = (how & 1u) != 0 ? input.word() : static_cast<std::uint16_t>(bank[at] + input.byte() - 128);
    }
    return bank;
}

// Sends a bank; returns true when the controller would run it.
bool send(test::Rig& rig, const Registers& bank, std::uint16_t session)
{
    return rig.download(bank, session) == CTL_TRANSFER_RESULT_ACCEPTED;
}

void checkVerdict(const Registers& registers)
{
    static ctl_bank bank;
    std::ranges::fill(bank.registers, std::uint16_t{0});
    std::ranges::copy(registers, bank.registers);
    const ctl_config config = test::benchConfig();
    const auto length = static_cast<std::uint32_t>(registers.size());
    const ctl_verdict whole = ctl_bank_check(&bank, &config, length);
    ctl_row_check check{};
    ctl_verdict pieces{CTL_TRANSFER_RESULT_BUSY, 0};
    for (unsigned turns = 0; pieces.result == CTL_TRANSFER_RESULT_BUSY; ++turns) {
        require(turns <= CTL_BANK_REGISTERS, "a check in pieces ends");
        pieces = ctl_bank_check_some(&bank, &config, length, &check, 8);
    }
    require(whole.result == pieces.result && whole.detail == pieces.detail,
            "a check in pieces says the same as a whole one");
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    InputReader input(bytes);
    FuzzMachine machine(0);
    test::Rig& rig = machine.rig();
    const std::uint8_t manner = input.byte();
    const Registers first = changedBank(input);
    checkVerdict(first);
    if (!send(rig, first, 1))
        return;
    (void)rig.apply(first, CTL_APPLY_MODE_WHEN_STOPPED, 1);
    (void)rig.command(CTL_COMMAND_START);
    rig.run(sliceUs * (1u + input.word() % mostSlices));
    if ((manner & 1u) != 0) {
        const Registers second = changedBank(input);
        if (send(rig, second, 2))
            (void)rig.apply(second, input.byte() % 4u, 2);
        rig.run(sliceUs * (1u + input.word() % mostSlices));
    }
    (void)rig.command((manner & 2u) != 0 ? CTL_COMMAND_STOP_AT_CYCLE_END : CTL_COMMAND_STOP_NOW);
    rig.run(sliceUs * (1u + input.word() % mostSlices));
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds;
    for (std::uint8_t kind = 0; kind < FuzzMachine::images(); ++kind) {
        seeds.push_back({1, kind, 0, 0, 0x0F, 0xA0, kind, 0, 1, 0, 16, 0, 129, 1, 0x0F, 0xA0, 0x0F, 0xA0});
        seeds.push_back({2, kind, 2, 1, 2, 0, 2, 1, 0, 40, 0, 66, 0, 127, 0x0F, 0xA0, 0x07, 0xD0});
        seeds.push_back({3, kind, 0, 0, 0x0F, 0xA0, static_cast<std::uint8_t>(kind + 1), 0, 0, 0, 0x0F, 0xA0,
                         0x0F, 0xA0});
    }
    return seeds;
}

} // namespace campanel::fuzz
