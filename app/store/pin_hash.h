// SPDX-License-Identifier: Apache-2.0
// PINs as Argon2id hashes. A PIN has few digits: who can read the file can try them all in minutes or hours,
// so the hash delays that and keeps a PIN that is used elsewhere from being read off, no more.
#pragma once

#include <QString>

#include <optional>

namespace campanel::store {

inline constexpr int fewestPinDigits = 4;
inline constexpr int mostPinDigits = 8;

// Takes some 32 MiB and, on a small panel, about a tenth of a second: not for the GUI thread. Empty when the
// memory cannot be had.
[[nodiscard]] std::optional<QString> hashPin(const QString& pin);
// The same effort. False for a hash that is none.
[[nodiscard]] bool isPin(const QString& hash, const QString& pin);

} // namespace campanel::store
