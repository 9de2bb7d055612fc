// SPDX-License-Identifier: Apache-2.0
// The tables of the database, as the steps from each version to the next. A released step is never changed: a
// new one follows it.
#pragma once

#include <QStringList>

#include <vector>

namespace campanel::store {

[[nodiscard]] const std::vector<QStringList>& migrations();

} // namespace campanel::store
