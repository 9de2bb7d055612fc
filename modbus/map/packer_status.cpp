// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/packer_status.h"

#include "modbus/map/codec.h"

#include <algorithm>
#include <cassert>

namespace campanel::modbus {
namespace {

constexpr std::uint16_t nothing = 0x8000;
constexpr double mmPerStep = 0.1; // resolution of the picture of the film
constexpr double mmPerUm = 0.001;
constexpr std::uint32_t registersPerBag = 4;
constexpr int minForPitch = 2;
constexpr int minForScatter = 3;

class PackerReader : public RegisterReader {
public:
    explicit PackerReader(std::span<const std::uint16_t> registers)
        : RegisterReader(registers, packerAddress)
        , m_registers(registers)
    {
    }

    [[nodiscard]] double number(std::string_view name) const { return physical(registerNamed(name)); }
    [[nodiscard]] std::span<const std::uint16_t> block(std::string_view name) const
    {
        const RegisterInfo& info = registerNamed(name);
        return m_registers.subspan(info.address - packerAddress, info.count);
    }

private:
    std::span<const std::uint16_t> m_registers;
};

bool hasBit(std::uint16_t flags, BagBit bit)
{
    return (unsigned{flags} >> static_cast<unsigned>(bit) & 1u) != 0;
}

double signedUm(std::uint16_t value)
{
    return static_cast<std::int16_t>(value) * mmPerUm;
}

// Returns the distance without the flag bit.
double distanceMm(std::uint16_t value)
{
    return static_cast<std::int16_t>(value & 0xFFFEu) * mmPerStep;
}

bool isSpecial(std::uint16_t value)
{
    return (value & 1u) != 0;
}

std::vector<BagRecord> bagsOf(std::span<const std::uint16_t> ring, std::uint32_t newest)
{
    std::vector<BagRecord> bags;
    for (std::uint32_t back = std::min<std::uint32_t>(newest, bagRecords); back != 0; --back) {
        const std::uint32_t number = newest - (back - 1);
        const auto record = ring.subspan(registersPerBag * (number % bagRecords), registersPerBag);
        const std::uint16_t flags = record[3];
        bags.push_back(
            {number, signedUm(record[0]), signedUm(record[1]), signedUm(record[2]),
             static_cast<int>(flags >> bagLengthsFrom & maxBagLengths), hasBit(flags, BagBit::Tracked),
             hasBit(flags, BagBit::MarkMissed), hasBit(flags, BagBit::ProductAcross),
             hasBit(flags, BagBit::Empty), hasBit(flags, BagBit::ChangeOver), hasBit(flags, BagBit::StartUp),
             hasBit(flags, BagBit::Burned), hasBit(flags, BagBit::Jammed), hasBit(flags, BagBit::Taken)});
    }
    return bags;
}

void readView(const PackerReader& reader, PackerStatus& status)
{
    for (const std::uint16_t value : reader.block("packer.cuts")) {
        if (value != nothing)
            status.cuts.push_back({distanceMm(value), isSpecial(value)});
    }
    for (const std::uint16_t value : reader.block("packer.seen_marks")) {
        if (value != nothing)
            status.seenMarks.push_back({distanceMm(value), isSpecial(value)});
    }
    const auto products = reader.block("packer.seen_products");
    for (std::size_t i = 0; i + 1 < products.size(); i += 2) {
        if (products[i] != nothing)
            status.seenProducts.push_back({distanceMm(products[i]), distanceMm(products[i + 1])});
    }
}

} // namespace

std::uint16_t packerRegisters(std::uint16_t minor)
{
    unsigned end = packerAddress;
    for (const RegisterInfo& row : registers()) {
        if (row.name.starts_with("packer.") && row.minor <= minor)
            end = static_cast<unsigned>(row.address) + row.count;
    }
    return static_cast<std::uint16_t>(end - packerAddress);
}

PackerStatus decodePacker(std::span<const std::uint16_t> registers)
{
    assert(registers.size() <= packerRegisters());
    const PackerReader reader(registers);
    PackerStatus status;
    const std::uint32_t markState = reader.u32("packer.mark_state");
    if (markState <= static_cast<std::uint32_t>(MarkState::Tracking))
        status.markState = static_cast<MarkState>(markState);
    status.markErrorMm = reader.number("packer.mark_error");
    status.markPitchMm = reader.number("packer.mark_pitch");
    status.phaseCorrectionMm = reader.number("packer.phase_correction");
    status.lengthCorrectionMm = reader.number("packer.length_correction");
    status.lastMarkMm = reader.number("packer.last_mark");
    status.filmFollowingErrorMm = reader.number("packer.film_following_error");
    status.marks = reader.u32("packer.marks");
    status.marksMissing = reader.u32("packer.marks_missing");
    status.marksFalse = reader.u32("packer.marks_false");
    status.products = reader.u32("packer.products");
    status.cutsSkipped = reader.u32("packer.cuts_skipped");
    status.emptyBags = reader.u32("packer.empty_bags");
    status.filmSavedM = reader.number("packer.film_saved");
    status.lastSkip = static_cast<SkipCause>(reader.u32("packer.last_skip"));
    status.skipsInARow = static_cast<std::uint16_t>(reader.u32("packer.skips_in_a_row"));
    status.correctionsLimited = reader.u32("packer.corrections_limited");
    status.filmAngleDeg = reader.number("packer.film_angle");
    status.knifeGate = static_cast<GateState>(reader.u32("packer.knife_gate"));
    status.filmGate = static_cast<GateState>(reader.u32("packer.film_gate"));
    status.teachMarks = static_cast<int>(reader.u32("packer.teach_marks"));
    if (status.teachMarks >= minForPitch)
        status.teachPitchMm = reader.number("packer.teach_pitch");
    if (status.teachMarks >= minForScatter)
        status.teachScatterMm = reader.number("packer.teach_scatter");
    status.marksWaiting = static_cast<int>(reader.u32("packer.marks_wait"));
    status.bagNumber = reader.u32("packer.bag_number");
    status.bags = bagsOf(reader.block("packer.bags"), status.bagNumber);
    status.filmPositionUm = reader.u32("packer.film_position");
    if (registers.size() == packerRegisters()) {
        status.knife = static_cast<int>(reader.u32("packer.knife"));
        status.isThreading = reader.u32("packer.threading") != 0;
    }
    readView(reader, status);
    return status;
}

} // namespace campanel::modbus
