// SPDX-License-Identifier: Apache-2.0
// A small file beside the main database that says whether the panel has PINs. With it a database that was
// deleted or emptied is not taken for that of a new panel, where everybody may do everything.
#pragma once

#include <QString>

namespace campanel::store {

// Unknown: there is no such file, or it is damaged.
enum class SetUp { Unknown, WithoutPins, WithPins };

[[nodiscard]] QString setupMarkerPath(const QString& databasePath);
[[nodiscard]] SetUp readSetupMarker(const QString& databasePath);
// Writes only what is not there yet. False: it cannot be written.
[[nodiscard]] bool writeSetupMarker(const QString& databasePath, SetUp setUp);
// True when something beside the database shows that there has been one: this file, the copy of the database
// or the newest row of the audit trail.
[[nodiscard]] bool wasSetUp(const QString& databasePath);

} // namespace campanel::store
