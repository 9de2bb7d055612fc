// SPDX-License-Identifier: Apache-2.0
// The database of bags and trends: a separate file, so that millions of bags are not copied with the recipes.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// Returns trends.sqlite. Not precious: a power cut loses the bags of the last seconds, which saves the flash
// the frequent syncs.
[[nodiscard]] const DatabaseFile& trendDatabase();

} // namespace campanel::store
