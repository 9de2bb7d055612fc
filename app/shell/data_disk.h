// SPDX-License-Identifier: Apache-2.0
// Tells why the boot has put a folder in memory in the place of the disk for the data.
#pragma once

#include <QString>

namespace campanel::shell {

// Returns the reason, one line of at most 200 characters without a full stop; empty when the disk is there.
// The boot of the image writes the file, see packaging/card/.
[[nodiscard]] QString diskLost(const QString& file = QStringLiteral("/run/campanel-no-data"));

} // namespace campanel::shell
