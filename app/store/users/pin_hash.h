// SPDX-License-Identifier: Apache-2.0
// PINs as Argon2id hashes. A PIN has few digits: somebody who can read the file can try them all. One core
// needs about half an hour for four digits and two days for six; the hash delays that, no more.
#pragma once

#include <QString>

#include <optional>

namespace campanel::store {

inline constexpr int fewestPinDigits = 4;
inline constexpr int minServicePinDigits = 6; // of whoever may do everything
inline constexpr int mostPinDigits = 8;

// Takes 128 MiB and, on a small panel, up to half a second: not for the GUI thread. Empty when the memory
// cannot be had.
[[nodiscard]] std::optional<QString> hashPin(const QString& pin);
// The effort that the hash was made with. False for a hash that is none.
[[nodiscard]] bool isPin(const QString& hash, const QString& pin);
// True when the hash was made with another effort than today's.
[[nodiscard]] bool isOutdated(const QString& hash);

} // namespace campanel::store
