// SPDX-License-Identifier: Apache-2.0
// Recipe files: any bytes are read or refused with a sentence. What is read is written and read back the
// same, and is solved or refused.
#include "app/program/solved_program.h"
#include "app/store/recipes/recipe_json.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/support/random_recipe.h"

#include <cmath>

namespace campanel::fuzz {

void runTarget(std::span<const std::uint8_t> bytes)
{
    const QByteArray json(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    const auto recipe = store::fromJson(json, QStringLiteral("recipe.json"));
    if (!recipe) {
        require(!store::FileErrorText::describe(recipe.error()).isEmpty(), "a refusal has a sentence");
        return;
    }
    const QByteArray written = store::toJson(*recipe);
    const auto back = store::fromJson(written, QStringLiteral("recipe.json"));
    require(back.has_value(), "a recipe that was written is read");
    require(store::toJson(*back) == written, "a recipe comes back as it was written");
    const auto solved = program::solveProgram(program::quantised(*recipe));
    require(!solved || std::isfinite(solved->cycleS()), "a cycle has a time");
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds;
    test::RandomRecipes random(1);
    for (int kind = 1; kind <= static_cast<int>(profile::ProgramKind::SegmentCam); ++kind) {
        const auto programKind = static_cast<profile::ProgramKind>(kind);
        for (const auto& recipe : {program::defaultRecipe(programKind), random.around(programKind)}) {
            const QByteArray json = store::toJson(recipe);
            seeds.push_back(bytesOf({json.constData(), static_cast<std::size_t>(json.size())}));
        }
    }
    return seeds;
}

} // namespace campanel::fuzz
