// SPDX-License-Identifier: Apache-2.0
#include "app/program/recipe_master.h"

#include <algorithm>

namespace campanel::program {

std::optional<RecipeMaster> masterByKey(std::string_view key)
{
    const auto found = std::ranges::find(masterKeys, key);
    return found == masterKeys.end() ? std::nullopt
                                     : std::optional(static_cast<RecipeMaster>(found - masterKeys.begin()));
}

bool hasMaster(const Recipe& recipe)
{
    return recipe.isCutter() || profile::camMaster(recipe.program) != nullptr;
}

MasterRefusal masterRefusal(const Recipe& recipe, const MachineMaster& machine)
{
    if (!hasMaster(recipe))
        return MasterRefusal::None;
    if (recipe.master == RecipeMaster::Encoder && !machine.hasInput)
        return MasterRefusal::NeedsInput;
    if (recipe.master == RecipeMaster::Encoder && !machine.followsEncoder)
        return MasterRefusal::NeedsEncoder;
    if (!machine.followsEncoder)
        return MasterRefusal::None;
    if (recipe.master == RecipeMaster::Clock)
        return MasterRefusal::NeedsClock;
    if (!machine.hasInput)
        return MasterRefusal::NoInput;
    // As the controller: a master that turns in reverse by its program would never engage.
    const profile::CamMaster* cam = profile::camMaster(recipe.program);
    return cam != nullptr && cam->masterRateRevPerMin < 0 ? MasterRefusal::CannotFollow : MasterRefusal::None;
}

} // namespace campanel::program
