// SPDX-License-Identifier: Apache-2.0
// Where tests find the programs and the files of the source tree.
#pragma once

#include <QString>

namespace campanel::test {

// A program of the same build, such as "campanelctl".
[[nodiscard]] QString programPath(const char* name);

// A file or folder of the source tree, such as "modbus/REGISTERS.md".
[[nodiscard]] QString sourcePath(const char* name);

} // namespace campanel::test
