// SPDX-License-Identifier: Apache-2.0
// An error in a recipe file: its place, the value found and the expected one.
#pragma once

#include <QCoreApplication>
#include <QString>

namespace campanel::store {

struct FileError {
    enum class Kind {
        NotFound,
        NotReadable, // `found` is the system's reason
        NotWritable, // `found` is the system's reason
        NotJson,     // `found` is the parser's reason, `offset` the byte
        NotARecipe,
        NewerVersion, // `found` is the file's format version, `expected` the supported one
        UnknownKey,
        MissingKey,
        WrongType,  // `expected` is "a number" and the like
        OutOfRange, // `expected` is "10 to 2000 mm"
        NotAChoice, // `expected` lists the choices
        TooLong,    // `expected` is the maximum number of bytes
        RepeatedKey,
        HiddenCharacter, // `found` is "U+202E"
        UnknownSigner,   // `found` is the signer
        WithdrawnSigner, // the same
        WrongSignature,  // the same
        NotSigned,
        NotShown, // `found` is a whole sentence: files of a place are missing in a list
    };

    Kind kind = Kind::NotFound;
    QString path;
    QString key; // "program.k1"
    QString found;
    QString expected;
    qint64 offset = 0;
};

class FileErrorText {
    Q_DECLARE_TR_FUNCTIONS(FileErrorText)

public:
    // Returns one or two sentences in the language of the program: what is wrong, where, and what to do.
    [[nodiscard]] static QString describe(const FileError& error);
    // Returns the text of FileError::found for anything but a regular file of at most 1 MB.
    [[nodiscard]] static QString notAFile();
    [[nodiscard]] static QString tooLarge();
    // Return the texts of FileError::expected.
    [[nodiscard]] static QString aNumber();
    [[nodiscard]] static QString aWholeNumber();
    [[nodiscard]] static QString aText();
    [[nodiscard]] static QString aVisibleText();
    [[nodiscard]] static QString anObject();
    [[nodiscard]] static QString twoPinnedKeys();
    [[nodiscard]] static QString pairsOfNumbers();
    [[nodiscard]] static QString objects();
    [[nodiscard]] static QString range(double minimum, double maximum, const QString& unit);
};

} // namespace campanel::store
