// SPDX-License-Identifier: Apache-2.0
// The database of bags and trends: a file of its own, so that millions of bags are not copied with the
// recipes.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// trends.sqlite. Not precious: what a power cut takes are the bags of the last seconds, and a machine that
// writes all day spares its flash the syncs.
[[nodiscard]] const DatabaseFile& trendDatabase();

} // namespace campanel::store
