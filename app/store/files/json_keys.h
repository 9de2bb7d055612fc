// SPDX-License-Identifier: Apache-2.0
// What Qt's JSON reader does not say: that a key occurs twice. It takes the last value without a word.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace campanel::store {

// Returns the first key that occurs twice in one object, with its place, as "program.k1". The text must be
// JSON.
[[nodiscard]] std::optional<QString> repeatedKey(const QByteArray& json);

} // namespace campanel::store
