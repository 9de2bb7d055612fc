// SPDX-License-Identifier: Apache-2.0
// Finds keys that occur twice. Qt's JSON reader uses the last value without an error.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace campanel::store {

// Returns the first key that occurs twice in one object, with its place, as "program.k1". The text must be
// JSON.
[[nodiscard]] std::optional<QString> repeatedKey(const QByteArray& json);

} // namespace campanel::store
