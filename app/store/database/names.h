// SPDX-License-Identifier: Apache-2.0
// The one rule for a name of a recipe, a user or a signer: visible characters in their composed form (NFC),
// without white space at the ends. Names that differ only in upper and lower case, or in the width of their
// spaces, are one.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// Returns the first character that nobody sees: of control, without width, of a direction of writing, or none
// at all.
[[nodiscard]] std::optional<char32_t> hiddenCharacter(const QString& text);

// Returns the name in the form in which it is kept; it is empty when nothing of it is visible. Removes hidden
// characters: who reads a name from outside refuses them before.
[[nodiscard]] QString keptName(const QString& text);
// Returns the key of a name, which is the same for all of its spellings.
[[nodiscard]] QString nameKey(const QString& name);
[[nodiscard]] inline bool isSameName(const QString& left, const QString& right)
{
    return nameKey(left) == nameKey(right);
}

// Sets the keys of recipes and users that have none, as written by earlier versions. A name that is the same
// as another one gets a number; returns these, and those that were kept in another form.
[[nodiscard]] tl::expected<QList<Renamed>, StoreError> completeNames(Database& database);

} // namespace campanel::store
