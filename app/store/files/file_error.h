// SPDX-License-Identifier: Apache-2.0
// What is wrong with a recipe file: where, what was found, what was expected.
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
        NewerVersion, // `found` is the file's format version, `expected` the one that is known
        UnknownKey,
        MissingKey,
        WrongType,  // `expected` is "a number" and the like
        OutOfRange, // `expected` is "10 to 2000 mm"
        NotAChoice, // `expected` lists the choices
        TooLong,    // `expected` is the largest number of bytes
        RepeatedKey,
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
    // One or two sentences in the language of the program: what is wrong, where, and what to do.
    [[nodiscard]] static QString describe(const FileError& error);
    // The words that go into FileError::found, for what is no regular file or has more than 1 MB.
    [[nodiscard]] static QString notAFile();
    [[nodiscard]] static QString tooLarge();
    // The words that go into FileError::expected.
    [[nodiscard]] static QString aNumber();
    [[nodiscard]] static QString aWholeNumber();
    [[nodiscard]] static QString aText();
    [[nodiscard]] static QString anObject();
    [[nodiscard]] static QString twoPinnedKeys();
    [[nodiscard]] static QString pairsOfNumbers();
    [[nodiscard]] static QString range(double minimum, double maximum, const QString& unit);
};

} // namespace campanel::store
