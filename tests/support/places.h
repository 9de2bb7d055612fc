// SPDX-License-Identifier: Apache-2.0
// The paths of the programs and of the source tree for tests.
#pragma once

#include <QString>

namespace campanel::test {

// Returns the path of a program of the same build, such as "campanelctl".
[[nodiscard]] QString programPath(const char* name);

// Returns the path of a file or folder of the source tree, such as "modbus/REGISTERS.md".
[[nodiscard]] QString sourcePath(const char* name);

// Returns the file with the texts of a language of the same build, such as "zh_CN".
[[nodiscard]] QString languageFile(const char* code);

} // namespace campanel::test
