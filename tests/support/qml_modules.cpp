// SPDX-License-Identifier: Apache-2.0
// Brings the QML modules into a test program.
#include "app/main/qml_modules.h"
