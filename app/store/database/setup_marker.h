// SPDX-License-Identifier: Apache-2.0
// A small file beside the main database that records if the panel has PINs. Without it a deleted or emptied
// database would look like a new panel, where everybody has all rights.
#pragma once

#include <QString>

namespace campanel::store {

// Unknown: the file is missing or damaged.
enum class SetUp { Unknown, WithoutPins, WithPins };

[[nodiscard]] QString setupMarkerPath(const QString& databasePath);
[[nodiscard]] SetUp readSetupMarker(const QString& databasePath);
// Writes the file when its content changes. Returns false on failure.
[[nodiscard]] bool writeSetupMarker(const QString& databasePath, SetUp setUp);
// Returns true when a file beside the database shows that it existed: this file, the copy of the database or
// the newest row of the audit trail.
[[nodiscard]] bool wasSetUp(const QString& databasePath);

} // namespace campanel::store
