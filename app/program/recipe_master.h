// SPDX-License-Identifier: Apache-2.0
// The master of a recipe against that of the machine: clock or encoder. Moves and the press have none.
#pragma once

#include "app/program/recipe.h"

#include <array>
#include <optional>
#include <string_view>

namespace campanel::program {

// The master of the machine by its settings.
struct MachineMaster {
    bool followsEncoder = false;
    bool hasInput = false; // the controller has one for an encoder
};

enum class MasterRefusal {
    None,
    NoInput,      // the machine is to follow an encoder that it cannot count
    CannotFollow, // no encoder can lead this program
    NeedsInput,   // the recipe is for an encoder, the controller has no input for one
    NeedsEncoder, // the recipe is for an encoder, the machine follows the clock
    NeedsClock    // the recipe is for the clock, an encoder leads the machine
};

// The keys of recipe files, in the order of RecipeMaster.
inline constexpr std::array<std::string_view, 3> masterKeys{"any", "clock", "encoder"};
[[nodiscard]] std::optional<RecipeMaster> masterByKey(std::string_view key);

// Returns true for a program whose cycles follow a master.
[[nodiscard]] bool hasMaster(const Recipe& recipe);
// Returns why this machine cannot execute the recipe with its master.
[[nodiscard]] MasterRefusal masterRefusal(const Recipe& recipe, const MachineMaster& machine);

} // namespace campanel::program
