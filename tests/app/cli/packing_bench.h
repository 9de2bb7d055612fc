// SPDX-License-Identifier: Apache-2.0
// Runs of the simulated packing machine with programs built like the panel's.
#pragma once

#include "app/program/program_image.h"
#include "packing_run.h"
#include "profile/cutter/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace campanel::test {

// The set lengths of the paper's Table 2, mm.
inline constexpr std::array paperLengthsMm{100.0, 125.0, 150.0, 175.0, 200.0, 220.0, 249.0, 277.0,
                                           300.0, 319.0, 353.0, 386.0, 400.0, 434.0, 460.0};

inline program::ProgramImage cutterAt(double lengthMm, double rate)
{
    program::Recipe recipe = program::defaultRecipe(profile::ProgramKind::RotaryCutter);
    recipe.cutter().pinned = {profile::Field::BagLength, profile::Field::Rate};
    program::setValue(recipe, profile::Field::BagLength, lengthMm);
    program::setValue(recipe, profile::Field::Rate, rate);
    auto image = program::buildProgram(recipe);
    if (!image)
        throw std::runtime_error(program::describe(image.error()));
    return std::move(*image);
}

// Returns the maximum rate, up to 300 bags/min.
inline double fastestRate(double lengthMm)
{
    const auto fastest = profile::fastestRate(cutterAt(lengthMm, 60).cutter());
    return std::floor(std::min(300.0, fastest.value().rateBagsPerMin));
}

struct Packed {
    std::vector<controller::PackedBag> bags;
    controller::PackingResult result;

    [[nodiscard]] bool anyThroughProduct() const
    {
        return std::ranges::any_of(bags, &controller::PackedBag::throughProduct);
    }
    [[nodiscard]] std::uint32_t emptyBags() const
    {
        return static_cast<std::uint32_t>(std::ranges::count_if(
            bags, [](const auto& bag) { return (bag.flags & 1u << CTL_BAG_BIT_EMPTY) != 0; }));
    }
};

using Change = std::function<void(controller::PackingJob& job)>;

inline Packed pack(const program::ProgramImage& image, std::uint32_t bags, const Change& change = {})
{
    controller::PackingJob job;
    job.bank = image.registers;
    job.bags = bags;
    if (change)
        change(job);
    Packed packed;
    packed.result =
        runPacking(job, [&packed](const controller::PackedBag& bag) { packed.bags.push_back(bag); });
    return packed;
}

inline void set16(controller::PackingJob& job, std::uint32_t address, std::uint16_t value)
{
    job.parameters.push_back({address, {value}});
}

inline void set32(controller::PackingJob& job, std::uint32_t address, std::uint32_t value)
{
    job.parameters.push_back(
        {address, {static_cast<std::uint16_t>(value >> 16), static_cast<std::uint16_t>(value & 0xFFFF)}});
}

} // namespace campanel::test
