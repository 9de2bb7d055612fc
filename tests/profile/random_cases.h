// SPDX-License-Identifier: Apache-2.0
// The number of seeded random programs in a test: ten thousand by default, or CAMPANEL_RANDOM_CASES (a
// million in the nightly tier).
#pragma once

#include <QtGlobal>

namespace campanel::test {

inline int randomCases(int usual = 10'000)
{
    const int asked = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES");
    return asked > 0 ? asked : usual;
}

} // namespace campanel::test
