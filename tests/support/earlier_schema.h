// SPDX-License-Identifier: Apache-2.0
// Databases as an earlier version of the program made them.
#pragma once

#include "app/store/database/database.h"

namespace campanel::test {

// Returns a database file that stops at this version of its schema.
template <const store::DatabaseFile& (*file)(), int version> store::DatabaseFile earlierSchema()
{
    store::DatabaseFile earlier = file();
    earlier.complete = nullptr;
    earlier.steps = []() -> const std::vector<QStringList>& {
        static const std::vector<QStringList> steps(file().steps().begin(), file().steps().begin() + version);
        return steps;
    };
    return earlier;
}

} // namespace campanel::test
