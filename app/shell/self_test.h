// SPDX-License-Identifier: Apache-2.0
// Tries this installation: every QML file compiles, and every page opens without a warning.
#pragma once

namespace campanel::shell {

// Writes each fault to stderr and one line with the counts to stdout. Uses no controller and none of the
// user's data. Returns the exit code for main().
[[nodiscard]] int selfTest();

} // namespace campanel::shell
