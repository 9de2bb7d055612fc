// SPDX-License-Identifier: Apache-2.0
// Brings the QML modules into a test program.
#include "app/shell/qml_modules.h"
