// SPDX-License-Identifier: Apache-2.0
// A recipe, the operator's unit of work: name, version, the inputs of the program and the machine it is for.
#pragma once

#include "app/program/approved_windows.h"
#include "app/program/program_kinds.h"
#include "app/program/recipe_trims.h"

#include "profile/model/machine.h"
#include "profile/program/programs.h"

#include "modbus/map/blocks.h"

#include <cstddef>
#include <string>

namespace campanel::program {

// The maximum length of a name in bytes of UTF-8: it is stored with the program in the controller.
inline constexpr std::size_t longestNameBytes = 32;
inline constexpr int maxVersion = 65535;
// The maximum length of a code that a scanner reads, in bytes of UTF-8.
inline constexpr std::size_t maxCodeBytes = 64;

// The master that a recipe needs; Any: whatever the machine follows.
enum class RecipeMaster { Any, Clock, Encoder };

// The defaults are a bag of 250 mm at 60 bags/min with a knife of 60 mm.
struct Recipe {
    std::string name = "Biscuit 250";
    int version = 1;
    profile::Program program;
    profile::Machine machine;
    // The codes on paper, in UTF-8; the controller does not know them.
    std::string scanCode; // selects the recipe; empty: its name does
    std::string filmCode; // on the film reel that it needs; empty: any reel
    // The master of a program that follows one. The controller has a setting of its own.
    RecipeMaster master = RecipeMaster::Any;
    // The trims that an operator saved with a cutter. They come with its program, but are not part of it.
    Trims trims{};
    // The windows that a technician approved. The controller does not know them.
    ApprovedWindows windows{};

    [[nodiscard]] profile::ProgramKind kind() const { return profile::kindOf(program); }
    [[nodiscard]] bool isCutter() const { return kind() == profile::ProgramKind::RotaryCutter; }
    // Returns the inputs of a rotary cutter; the recipe must be one.
    [[nodiscard]] profile::RotaryCutterProgram& cutter()
    {
        return std::get<profile::RotaryCutterProgram>(program);
    }
    [[nodiscard]] const profile::RotaryCutterProgram& cutter() const
    {
        return std::get<profile::RotaryCutterProgram>(program);
    }
};

// Returns the text that selects the recipe when it is scanned.
[[nodiscard]] inline const std::string& codeOf(const Recipe& recipe)
{
    return recipe.scanCode.empty() ? recipe.name : recipe.scanCode;
}

[[nodiscard]] inline bool sameCodes(const Recipe& left, const Recipe& right)
{
    return left.scanCode == right.scanCode && left.filmCode == right.filmCode;
}

// Returns a new recipe of this kind with the machine of the paper that the kind comes from.
[[nodiscard]] Recipe defaultRecipe(profile::ProgramKind kind);

// Access inputs and machine data of any kind; `field` must be among those of the recipe's kind.
[[nodiscard]] bool isProgramField(const Recipe& recipe, profile::Field field);
// Returns true for an input that the controller stores with the program.
[[nodiscard]] bool isInController(const Recipe& recipe, profile::Field field);
// Returns true for a count; other fields without decimals are measures entered as whole numbers.
[[nodiscard]] bool isCount(const Recipe& recipe, profile::Field field);
[[nodiscard]] double value(const Recipe& recipe, profile::Field field);
void setValue(Recipe& recipe, profile::Field field, double value);

// Returns the inputs rounded to register values, so that recipe -> registers -> recipe -> registers is
// identical. A value that no register can hold is unchanged; buildProgram() refuses it. Unpinned cycle values
// become 0.
[[nodiscard]] Recipe quantised(const Recipe& recipe);

// Sets the ratios of a rotary cutter that were not set by hand, after any other change of the recipe.
void followRatios(Recipe& recipe);

// Returns the recipe with the gentlest ratios for its machine, as a person begins one.
[[nodiscard]] Recipe gentleRecipe(Recipe recipe);

// Returns the machine with the timer and table size of this controller, and its output stage as a limit.
[[nodiscard]] profile::Machine withController(const profile::Machine& machine,
                                              const modbus::Identity& controller);

} // namespace campanel::program
