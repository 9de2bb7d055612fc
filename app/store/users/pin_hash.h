// SPDX-License-Identifier: Apache-2.0
// PINs as Argon2id hashes. A PIN has few digits: somebody who can read the file can try them all. One core
// needs about half an hour for four digits and two days for six; the hash only delays that.
#pragma once

#include <QString>

#include <optional>

namespace campanel::store {

inline constexpr int minPinDigits = 4;
inline constexpr int minServicePinDigits = 6; // for the level Service
inline constexpr int maxPinDigits = 8;

// Takes 128 MiB and up to half a second on a small panel: not for the GUI thread. Returns nothing when the
// memory is not available.
[[nodiscard]] std::optional<QString> hashPin(const QString& pin);
// Compares with the effort of the hash. Returns false for an invalid hash.
[[nodiscard]] bool isPin(const QString& hash, const QString& pin);
// Returns true for a text that hashPin() may have made.
[[nodiscard]] bool isPinHash(const QString& hash);
// Returns true when the effort of the hash differs from the present one.
[[nodiscard]] bool isOutdated(const QString& hash);

} // namespace campanel::store
