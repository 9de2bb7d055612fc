// SPDX-License-Identifier: Apache-2.0
// How many seeded random programs a test tries: ten thousand, or what CAMPANEL_RANDOM_CASES says
// (tests/random-programs).
#pragma once

#include <QtGlobal>

namespace campanel::test {

inline int randomCases()
{
    constexpr int usual = 10'000;
    const int asked = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES");
    return asked > 0 ? asked : usual;
}

} // namespace campanel::test
