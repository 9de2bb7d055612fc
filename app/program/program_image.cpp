// SPDX-License-Identifier: Apache-2.0
// Building and decoding of program images.
#include "app/program/program_image.h"

#include "modbus/crc32.h"
#include "profile/laws.h"
#include "profile/limits.h"

#include <algorithm>

namespace campanel::program {
namespace {

std::uint16_t pinnedBits(const profile::RotaryCutterProgram& program)
{
    unsigned bits = 0;
    for (std::size_t i = 0; i < pinnableFields.size(); ++i) {
        if (profile::isPinned(program, pinnableFields[i]))
            bits |= 1u << i;
    }
    return static_cast<std::uint16_t>(bits);
}

// Numbers of the table that do not fit 32 bits are carried on as the largest, which the controller's limits
// have refused long before.
std::uint32_t to32(std::int64_t value)
{
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, UINT32_MAX));
}

modbus::BankHeader headerOf(const Recipe& recipe, const profile::RotaryCutter& cutter,
                            const profile::StepTable& table)
{
    const profile::CycleNumbers& cycle = cutter.cycle;
    modbus::BankHeader header;
    header.cycleTicks = table.cycleTicks;
    header.cyclePulses = to32(table.pulses.whole);
    header.remainder = to32(table.pulses.remainder);
    header.divisor = to32(table.pulses.divisor);
    header.carryRow = static_cast<std::uint16_t>(table.carryRow);
    header.syncStartDeg = cutter.angleDegAt(cycle.tbS);
    header.syncEndDeg = cutter.angleDegAt(cycle.tcS);
    // The jaws meet in the middle of the stretch where they move with the film.
    header.cutAngleDeg = (header.syncStartDeg + header.syncEndDeg) / 2;
    header.knifeRadiusMm = recipe.machine.knifeRadiusMm;
    header.knives = static_cast<std::uint32_t>(recipe.machine.knives);
    header.pulsesPerMotorRev = static_cast<std::uint32_t>(recipe.machine.pulsesPerMotorRev);
    header.gearNumerator = static_cast<std::uint32_t>(recipe.machine.gearNumerator);
    header.gearDenominator = static_cast<std::uint32_t>(recipe.machine.gearDenominator);
    header.pinned = pinnedBits(recipe.program);
    header.bagLengthMm = cycle.bagLengthMm;
    header.rateBagsPerMin = cycle.rateBagsPerMin;
    header.baseSpeedMmPerS = cycle.baseSpeedMmPerS;
    header.filmSpeedMmPerS = cycle.filmSpeedMmPerS;
    header.syncRatio = recipe.program.syncRatio;
    header.k = recipe.program.k;
    header.law = static_cast<std::uint16_t>(recipe.program.speedLaw);
    header.lawParameters = recipe.program.speedLawParameters;
    header.rampSlices = static_cast<std::uint32_t>(recipe.program.slicesPerRamp);
    header.recipeVersion = static_cast<std::uint32_t>(recipe.version);
    header.recipeName = recipe.name;
    return header;
}

} // namespace

std::string describe(const ProgramRefusal& refusal)
{
    if (refusal.unstorable)
        return modbus::describe(*refusal.unstorable);
    std::string text;
    for (const profile::Refusal& limit : refusal.limits)
        text += (text.empty() ? "" : " ") + profile::describe(limit);
    return text;
}

tl::expected<ProgramImage, ProgramRefusal> buildProgram(const Recipe& given)
{
    ProgramImage image;
    image.recipe = quantised(given);
    auto cutter = profile::solve(image.recipe.program, image.recipe.machine);
    if (!cutter)
        return tl::unexpected(ProgramRefusal{{cutter.error()}, std::nullopt});
    if (auto broken = profile::checkLimits(*cutter); !broken.empty())
        return tl::unexpected(ProgramRefusal{std::move(broken), std::nullopt});
    auto table = profile::buildStepTable(*cutter);
    if (!table)
        return tl::unexpected(ProgramRefusal{{table.error()}, std::nullopt});
    std::vector<modbus::TableRow> rows;
    rows.reserve(table->rows.size());
    for (const profile::StepRow& row : table->rows)
        rows.push_back({row.pulses, row.ticks});
    auto registers = modbus::encodeBank(headerOf(image.recipe, *cutter, *table), rows);
    if (!registers)
        return tl::unexpected(ProgramRefusal{{}, registers.error()});
    image.registers = std::move(*registers);
    image.crc = modbus::crc32OfRegisters(image.registers);
    image.cutter = std::move(*cutter);
    image.table = std::move(*table);
    return image;
}

std::string describe(const DecodeError& error)
{
    const std::string code = std::to_string(error.code);
    switch (error.kind) {
    case DecodeErrorKind::Layout:
        return "The controller's program has layout " + code +
               ", which this version does not know. Update the panel's software.";
    case DecodeErrorKind::Kind:
        return "The controller runs a program of kind " + code +
               ", which this version cannot show. Update the panel's software.";
    case DecodeErrorKind::Pinned:
        return "The controller's program does not say which two inputs it was made from (" + code +
               "). Download a recipe again.";
    case DecodeErrorKind::Law:
        return "The controller's program uses speed law " + code +
               ", which this version does not know. Update the panel's software.";
    }
    return {};
}

tl::expected<Recipe, DecodeError> decodeProgram(std::span<const std::uint16_t> registers,
                                                const profile::Machine& limits)
{
    const auto refuse = [](DecodeErrorKind kind, int code) {
        return tl::unexpected(DecodeError{kind, code});
    };
    const modbus::BankHeader header = modbus::decodeBankHeader(registers);
    if (header.layout != static_cast<std::uint16_t>(modbus::TableLayout::StepTable))
        return refuse(DecodeErrorKind::Layout, header.layout);
    if (header.kind != modbus::ProgramKind::RotaryCutter)
        return refuse(DecodeErrorKind::Kind, static_cast<int>(header.kind));
    const auto* law = profile::findLaw(static_cast<profile::LawId>(header.law));
    if (law == nullptr)
        return refuse(DecodeErrorKind::Law, header.law);

    Recipe recipe;
    std::size_t pinned = 0;
    for (std::size_t i = 0; i < pinnableFields.size(); ++i) {
        if ((header.pinned & (1u << i)) != 0 && pinned++ < recipe.program.pinned.size())
            recipe.program.pinned[pinned - 1] = pinnableFields[i];
    }
    if (pinned != recipe.program.pinned.size())
        return refuse(DecodeErrorKind::Pinned, header.pinned);
    recipe.name = header.recipeName;
    recipe.version = static_cast<int>(header.recipeVersion);
    profile::RotaryCutterProgram& program = recipe.program;
    program.bagLengthMm = header.bagLengthMm;
    program.rateBagsPerMin = header.rateBagsPerMin;
    program.baseSpeedMmPerS = header.baseSpeedMmPerS;
    program.filmSpeedMmPerS = header.filmSpeedMmPerS;
    program.k = header.k;
    program.speedLaw = law->id;
    program.speedLawParameters = header.lawParameters;
    program.syncRatio = header.syncRatio;
    program.slicesPerRamp = static_cast<int>(header.rampSlices);
    recipe.machine = limits;
    recipe.machine.knifeRadiusMm = header.knifeRadiusMm;
    recipe.machine.knives = static_cast<int>(header.knives);
    recipe.machine.pulsesPerMotorRev = static_cast<int>(header.pulsesPerMotorRev);
    recipe.machine.gearNumerator = static_cast<int>(header.gearNumerator);
    recipe.machine.gearDenominator = static_cast<int>(header.gearDenominator);
    return recipe;
}

} // namespace campanel::program
