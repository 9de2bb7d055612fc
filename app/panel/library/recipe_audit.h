// SPDX-License-Identifier: Apache-2.0
// The audit entries of changes of the recipes, in stable words.
#pragma once

#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"

#include <optional>

namespace campanel::panel {

// Returns an entry of the differing values, by their keys in the recipe's file: "version 3: bag_length_mm
// 250" to "version 4: bag_length_mm 260". `before`: the newest earlier version, empty for a new recipe.
// `signer` signed the recipe; empty: nobody.
[[nodiscard]] store::AuditEntry recipeSaved(const std::optional<store::RecipeVersion>& before,
                                            const store::RecipeVersion& kept, const QString& signer);

} // namespace campanel::panel
