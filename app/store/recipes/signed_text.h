// SPDX-License-Identifier: Apache-2.0
// A text that a person has signed, in a JSON file. The signature covers the text, the person, the time and
// one more value, the mark.
#pragma once

#include "app/store/files/file_error.h"
#include "app/store/recipes/recipe_keys.h"

#include <tl/expected.hpp>

namespace campanel::store {

// The form of the file: its name, and the keys of text and mark.
struct SignedForm {
    QString format;
    QString textKey;
    QString markKey;
};

struct SignedText {
    QString text;
    QString signer;
    QString time; // UTC, ISO 8601
    QString mark;

    // Returns the time since 1970 UTC in milliseconds, whole seconds.
    [[nodiscard]] qint64 signedMs() const;
};

// Returns true when the file claims to be of this form.
[[nodiscard]] bool isOfForm(const SignedForm& form, const QByteArray& json);
[[nodiscard]] QByteArray signText(const SignedForm& form, const QString& text, const QString& mark,
                                  qint64 signedMs, const SigningKey& key);
// Reads the file and checks the signature. `path` is only for the error. Errors of the signature:
// UnknownSigner, WithdrawnSigner, WrongSignature.
[[nodiscard]] tl::expected<SignedText, FileError>
verifyText(const SignedForm& form, const QByteArray& json, const QString& path, const QList<SignerKey>& keys);

} // namespace campanel::store
