// SPDX-License-Identifier: Apache-2.0
// How many seeded random programs a test tries: ten thousand unless it says otherwise, or what
// CAMPANEL_RANDOM_CASES says (a million, in the nightly tier).
#pragma once

#include <QtGlobal>

namespace campanel::test {

inline int randomCases(int usual = 10'000)
{
    const int asked = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES");
    return asked > 0 ? asked : usual;
}

} // namespace campanel::test
