// SPDX-License-Identifier: Apache-2.0
// A recipe: the operator's unit of work. Name, version, the inputs of the program and the machine it is for.
#pragma once

#include "app/program/program_kinds.h"

#include "profile/model/machine.h"
#include "profile/program/programs.h"

#include "modbus/map/blocks.h"

#include <array>
#include <cstddef>
#include <string>

namespace campanel::program {

// A name travels with the program into the controller; it has room for this many bytes of UTF-8.
inline constexpr std::size_t longestNameBytes = 32;
inline constexpr int largestVersion = 65535;

// The defaults are a bag of 250 mm at 60 a minute with a knife of 60 mm.
struct Recipe {
    std::string name = "Biscuit 250";
    int version = 1;
    profile::Program program;
    profile::Machine machine;

    [[nodiscard]] profile::ProgramKind kind() const { return profile::kindOf(program); }
    [[nodiscard]] bool isCutter() const { return kind() == profile::ProgramKind::RotaryCutter; }
    // The inputs of a rotary cutter; the recipe must be one.
    [[nodiscard]] profile::RotaryCutterProgram& cutter()
    {
        return std::get<profile::RotaryCutterProgram>(program);
    }
    [[nodiscard]] const profile::RotaryCutterProgram& cutter() const
    {
        return std::get<profile::RotaryCutterProgram>(program);
    }
};

// A recipe of this kind to begin with: the machine of the paper that the kind comes from.
[[nodiscard]] Recipe defaultRecipe(profile::ProgramKind kind);

// Of these four, two are pinned; in the order of the bits of program.pinned.
inline constexpr std::array pinnableFields{profile::Field::BagLength, profile::Field::Rate,
                                           profile::Field::BaseSpeed, profile::Field::FilmSpeed};

// Inputs and data of the machine of any kind; `field` must be among those of the recipe's kind.
[[nodiscard]] bool isProgramField(const Recipe& recipe, profile::Field field);
[[nodiscard]] double value(const Recipe& recipe, profile::Field field);
void setValue(Recipe& recipe, profile::Field field, double value);

// The inputs as the registers hold them, so that recipe -> registers -> recipe -> registers is identical. A
// value that no register can hold is left as it is; buildProgram() refuses it. Unpinned cycle values become
// 0.
[[nodiscard]] Recipe quantised(const Recipe& recipe);

// The machine with the timer and table size of this controller, and its output stage as a limit.
[[nodiscard]] profile::Machine withController(const profile::Machine& machine,
                                              const modbus::Identity& controller);

} // namespace campanel::program
