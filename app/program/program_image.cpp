// SPDX-License-Identifier: Apache-2.0
// Builds and decodes program images.
#include "app/program/program_image.h"

#include "modbus/map/crc32.h"
#include "profile/cam/point_cam.h"
#include "profile/cutter/limits.h"
#include "profile/laws/laws.h"
#include "profile/segments/segment_cam.h"

#include <algorithm>

namespace campanel::program {
std::string describe(const ProgramRefusal& refusal)
{
    if (refusal.unstorable)
        return std::string(refusal.unstorable->registerName) + ' ' +
               std::to_string(refusal.unstorable->value);
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

// The allowed speed error for the intervals of a move, as a share of its maximum speed. When rows of whole
// pulses cannot keep the first value, the smallest possible error up to the second one is used.
constexpr double intervalSpeedShare = 0.01;
constexpr double maxIntervalSpeedShare = 0.2;

using Built = tl::expected<Table, profile::Refusal>;

Built intervalsOf(const SolvedProgram& solved)
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

// Builds the table of each kind of program.
struct TableBuilder {
    const SolvedProgram& solved;

    Built operator()(const profile::RotaryCutterProgram&) const
    {
        return profile::buildStepTable(solved.cutter.value());
    }
    Built operator()(const profile::PressProgram& press) const
    {
        return profile::buildPressTable(press, solved.machine);
    }
    template <typename P> Built operator()(const P& program) const
    {
        if constexpr (std::is_base_of_v<profile::CamMaster, P>)
            return profile::buildCamTable(program, solved.machine);
        else
            return tableOfMove(program);
    }
    template <typename Move> [[nodiscard]] Built tableOfMove(const Move& move) const
    {
        if (move.execution == profile::Execution::Intervals)
            return intervalsOf(solved);
        return profile::buildCamTable(solved.motion, move.camPoints, solved.machine, profile::CamUse::Once);
    }
};

} // namespace

tl::expected<ProgramImage, ProgramRefusal> buildProgram(const Recipe& given)
{
    Recipe wanted = quantised(given);
    auto solved = solveProgram(wanted);
    if (!solved)
        return refuse({solved.error()});
    return buildProgram(std::move(wanted), std::move(*solved));
}

tl::expected<ProgramImage, ProgramRefusal> buildProgram(Recipe quantised, SolvedProgram solved)
{
    if (!solved.broken.empty())
        return refuse(std::move(solved.broken));
    ProgramImage image;
    image.recipe = std::move(quantised);
    image.solved = std::move(solved);
    auto table = std::visit(TableBuilder{image.solved}, image.recipe.program);
    if (!table)
        return refuse({table.error()});
    auto registers = encodeBank(image.recipe, image.solved, *table);
    if (!registers)
        return tl::unexpected(ProgramRefusal{{}, registers.error()});
    image.table = std::move(*table);
    image.registers = std::move(*registers);
    image.crc = modbus::crc32OfRegisters(image.registers);
    return image;
}

namespace {

tl::unexpected<DecodeError> unknown(DecodeErrorKind kind, int code)
{
    return tl::unexpected(DecodeError{kind, code});
}

// Returns the first invalid choice of the kind.
std::optional<DecodeError> wrongChoice(const Recipe& recipe)
{
    for (const ChoiceInfo& each : kindInfo(recipe.kind()).choices) {
        const std::uint16_t code = choice(recipe.program, each.choice);
        if (each.choice == Choice::Law) {
            const auto* law = profile::findLaw(static_cast<profile::LawId>(code));
            if (law == nullptr || !isLawOf(recipe.kind(), *law))
                return DecodeError{DecodeErrorKind::Law, code};
            continue;
        }
        if (std::ranges::find(each.options, code, &ChoiceOption::code) == each.options.end())
            return DecodeError{DecodeErrorKind::Choice, code};
    }
    return std::nullopt;
}

} // namespace

tl::expected<Recipe, DecodeError> decodeProgram(std::span<const std::uint16_t> registers,
                                                std::span<const std::uint16_t> list,
                                                const profile::Machine& limits)
{
    const modbus::RegisterReader header(registers, 0);
    const std::uint16_t code = header.u16("bank.kind");
    if (code == 0 || code > kinds().size())
        return unknown(DecodeErrorKind::Kind, code);
    const auto kind = static_cast<profile::ProgramKind>(code);
    const std::uint16_t layout = header.u16("bank.layout");
    const auto layouts = kindInfo(kind).layouts;
    if (std::ranges::find(layouts, static_cast<modbus::TableLayout>(layout)) == layouts.end())
        return unknown(DecodeErrorKind::Layout, layout);
    Recipe recipe = defaultRecipe(kind);
    recipe.machine = limits;
    const bool isPinned = decodeBank(registers, list, recipe);
    if (const auto wrong = wrongChoice(recipe))
        return tl::unexpected(*wrong);
    if (!isPinned)
        return unknown(DecodeErrorKind::Pinned, header.u16("program.pinned"));
    return recipe;
}

} // namespace campanel::program
