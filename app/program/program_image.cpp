// SPDX-License-Identifier: Apache-2.0
// Builds and decodes program images.
#include "app/program/program_image.h"

#include "modbus/map/crc32.h"
#include "profile/cutter/limits.h"
#include "profile/laws/laws.h"

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

// Limits table values to 32 bits; the controller's limits refuse larger ones before.
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
    // The jaws meet in the middle of the synchronous segment.
    header.cutAngleDeg = (header.syncStartDeg + header.syncEndDeg) / 2;
    header.knifeRadiusMm = recipe.machine.knifeRadiusMm;
    header.knives = static_cast<std::uint32_t>(recipe.machine.knives);
    header.pulsesPerMotorRev = static_cast<std::uint32_t>(recipe.machine.pulsesPerMotorRev);
    header.gearNumerator = static_cast<std::uint32_t>(recipe.machine.gearNumerator);
    header.gearDenominator = static_cast<std::uint32_t>(recipe.machine.gearDenominator);
    header.pinned = pinnedBits(recipe.cutter());
    header.bagLengthMm = cycle.bagLengthMm;
    header.rateBagsPerMin = cycle.rateBagsPerMin;
    header.baseSpeedMmPerS = cycle.baseSpeedMmPerS;
    header.filmSpeedMmPerS = cycle.filmSpeedMmPerS;
    header.syncRatio = recipe.cutter().syncRatio;
    header.k = recipe.cutter().k;
    header.law = static_cast<std::uint16_t>(recipe.cutter().speedLaw);
    header.lawParameters = recipe.cutter().speedLawParameters;
    header.rampSlices = static_cast<std::uint32_t>(recipe.cutter().slicesPerRamp);
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

namespace {

tl::unexpected<ProgramRefusal> refuse(std::vector<profile::Refusal> limits)
{
    return tl::unexpected(ProgramRefusal{std::move(limits), std::nullopt});
}

// Completes a build with the registers.
tl::expected<ProgramImage, ProgramRefusal>
finished(ProgramImage image, tl::expected<std::vector<std::uint16_t>, modbus::CodecError> registers)
{
    if (!registers)
        return tl::unexpected(ProgramRefusal{{}, registers.error()});
    image.registers = std::move(*registers);
    image.crc = modbus::crc32OfRegisters(image.registers);
    return image;
}

tl::expected<ProgramImage, ProgramRefusal> buildCutter(ProgramImage image)
{
    auto table = profile::buildStepTable(image.cutter());
    if (!table)
        return refuse({table.error()});
    std::vector<modbus::TableRow> rows;
    rows.reserve(table->rows.size());
    for (const profile::StepRow& row : table->rows)
        rows.push_back({row.pulses, row.ticks});
    auto registers = modbus::encodeBank(headerOf(image.recipe, image.cutter(), *table), rows);
    image.table = std::move(*table);
    return finished(std::move(image), std::move(registers));
}

// The allowed speed error for the intervals of a move, as a share of its maximum speed. When rows of whole
// pulses cannot keep the first value, the smallest possible error up to the second one is used.
constexpr double intervalSpeedShare = 0.01;
constexpr double maxIntervalSpeedShare = 0.2;

tl::expected<AxisTable, profile::Refusal> intervalsOf(const SolvedProgram& solved)
{
    const auto compile = [&solved](double errorMmPerS) {
        return profile::compileIntervals(solved.motion, solved.machine, errorMmPerS,
                                         profile::IntervalMode::Corrected);
    };
    const double peak = solved.peaks.speedMmPerS;
    auto table = compile(intervalSpeedShare * peak);
    const bool isCoarse = !table && table.error().limit == profile::Limit::SpeedError;
    if (isCoarse && table.error().allowed <= maxIntervalSpeedShare * peak)
        table = compile(table.error().allowed);
    return table;
}

tl::expected<AxisTable, profile::Refusal> axisTable(const Recipe& recipe, const SolvedProgram& solved)
{
    if (const auto* press = std::get_if<profile::PressProgram>(&recipe.program))
        return profile::buildPressTable(*press, solved.machine);
    if (const auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
        return profile::buildCamTable(*cam, solved.machine);
    if (choice(recipe.program, Choice::Execution) ==
        static_cast<std::uint16_t>(profile::Execution::Intervals))
        return intervalsOf(solved);
    const auto intervals = static_cast<int>(value(recipe, profile::Field::CamPoints));
    return profile::buildCamTable(solved.motion, intervals, solved.machine, profile::CamUse::Once);
}

} // namespace

tl::expected<ProgramImage, ProgramRefusal> buildProgram(const Recipe& given)
{
    ProgramImage image;
    image.recipe = quantised(given);
    auto solved = solveProgram(image.recipe);
    if (!solved)
        return refuse({solved.error()});
    if (!solved->broken.empty())
        return refuse(std::move(solved->broken));
    image.solved = std::move(*solved);
    if (image.recipe.isCutter())
        return buildCutter(std::move(image));
    auto table = axisTable(image.recipe, image.solved);
    if (!table)
        return refuse({table.error()});
    auto registers = encodeAxisBank(image.recipe, *table);
    std::visit([&image](auto& rows) { image.table = std::move(rows); }, *table);
    return finished(std::move(image), std::move(registers));
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
        return "The controller's program has unknown pinned values (" + code + "). Download a recipe again.";
    case DecodeErrorKind::Law:
        return "The controller's program uses law " + code +
               ", which this version does not know. Update the panel's software.";
    case DecodeErrorKind::Choice:
        return "The controller's program has a choice with number " + code +
               ", which this version does not know. Update the panel's software.";
    }
    return {};
}

namespace {

tl::unexpected<DecodeError> unknown(DecodeErrorKind kind, int code)
{
    return tl::unexpected(DecodeError{kind, code});
}

tl::expected<Recipe, DecodeError> decodeCutter(const modbus::BankHeader& header,
                                               const profile::Machine& limits)
{
    const auto* law = profile::findLaw(static_cast<profile::LawId>(header.law));
    if (law == nullptr)
        return unknown(DecodeErrorKind::Law, header.law);
    Recipe recipe;
    profile::RotaryCutterProgram& program = recipe.cutter();
    std::size_t pinned = 0;
    for (std::size_t i = 0; i < pinnableFields.size(); ++i) {
        if ((header.pinned & (1u << i)) != 0 && pinned++ < program.pinned.size())
            program.pinned[pinned - 1] = pinnableFields[i];
    }
    if (pinned != program.pinned.size())
        return unknown(DecodeErrorKind::Pinned, header.pinned);
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

bool isKnownLayout(profile::ProgramKind kind, modbus::TableLayout layout)
{
    using modbus::TableLayout;
    using profile::ProgramKind;
    switch (kind) {
    case ProgramKind::RotaryCutter:
        return layout == TableLayout::StepTable;
    case ProgramKind::PositionMove:
    case ProgramKind::SpeedMove:
        return layout == TableLayout::CamPoints || layout == TableLayout::Intervals;
    case ProgramKind::PointCam:
        return layout == TableLayout::CamPoints;
    case ProgramKind::Press:
        return layout == TableLayout::PressStages;
    }
    return false;
}

// Returns the first invalid choice of the kind.
std::optional<DecodeError> wrongChoice(const Recipe& recipe)
{
    for (const Choice each : kindInfo(recipe.kind()).choices) {
        const std::uint16_t code = choice(recipe.program, each);
        if (each == Choice::Law) {
            const auto* law = profile::findLaw(static_cast<profile::LawId>(code));
            if (law == nullptr || !isLawOf(recipe.kind(), *law))
                return DecodeError{DecodeErrorKind::Law, code};
            continue;
        }
        const auto options = choiceInfo(recipe.kind(), each).options;
        if (std::ranges::find(options, code, &ChoiceOption::code) == options.end())
            return DecodeError{DecodeErrorKind::Choice, code};
    }
    return std::nullopt;
}

} // namespace

tl::expected<Recipe, DecodeError> decodeProgram(std::span<const std::uint16_t> registers,
                                                std::span<const std::uint16_t> knots,
                                                const profile::Machine& limits)
{
    const modbus::BankHeader header = modbus::decodeBankHeader(registers);
    const auto code = static_cast<std::uint16_t>(header.kind);
    if (code == 0 || code > kinds().size())
        return unknown(DecodeErrorKind::Kind, code);
    const auto kind = static_cast<profile::ProgramKind>(code);
    if (!isKnownLayout(kind, static_cast<modbus::TableLayout>(header.layout)))
        return unknown(DecodeErrorKind::Layout, header.layout);
    auto recipe = kind == profile::ProgramKind::RotaryCutter
                      ? decodeCutter(header, limits)
                      : tl::expected<Recipe, DecodeError>(defaultRecipe(kind));
    if (!recipe)
        return recipe;
    recipe->name = header.recipeName;
    recipe->version = static_cast<int>(header.recipeVersion);
    if (recipe->isCutter())
        return recipe;
    recipe->machine = limits;
    decodeAxisHeader(registers, knots, *recipe);
    if (const auto wrong = wrongChoice(*recipe))
        return tl::unexpected(*wrong);
    return recipe;
}

} // namespace campanel::program
