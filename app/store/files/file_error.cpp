// SPDX-License-Identifier: Apache-2.0
// The sentences about recipe files.
#include "app/store/files/file_error.h"

#include <QDir>

namespace campanel::store {

QString FileErrorText::describe(const FileError& error)
{
    const QString path = QDir::toNativeSeparators(error.path);
    switch (error.kind) {
    case FileError::Kind::NotFound:
        return tr("The file %1 does not exist. Check its name.").arg(path);
    case FileError::Kind::NotReadable:
        return tr("The file %1 cannot be read: %2.").arg(path, error.found);
    case FileError::Kind::NotWritable:
        return tr("The recipe could not be saved to %1: %2; the stored recipe is unchanged. Free disk space "
                  "or check the permissions, then save again.")
            .arg(path, error.found);
    case FileError::Kind::NotJson:
        return tr("The file %1 is damaged at byte %2: %3. Restore it from a copy.")
            .arg(path, QString::number(error.offset), error.found);
    case FileError::Kind::NotARecipe:
        return tr("%1 is not a CamPanel recipe: the key \"format\" must be \"campanel-recipe\".").arg(path);
    case FileError::Kind::NewerVersion:
        return tr("The file %1 has format version %2, this program reads versions up to %3. "
                  "Update the program.")
            .arg(path, error.found, error.expected);
    case FileError::Kind::UnknownKey:
        return tr("The file %1 has an unknown key %2. Correct or remove the key.").arg(path, error.key);
    case FileError::Kind::MissingKey:
        return tr("The file %1 lacks the key %2. Add the key.").arg(path, error.key);
    case FileError::Kind::WrongType:
        return tr("In the file %1, %2 must be %3.").arg(path, error.key, error.expected);
    case FileError::Kind::OutOfRange:
        return tr("In the file %1, %2 is %3; enter %4.").arg(path, error.key, error.found, error.expected);
    case FileError::Kind::NotAChoice:
        return tr("In the file %1, %2 is \"%3\"; choose one of: %4.")
            .arg(path, error.key, error.found, error.expected);
    case FileError::Kind::TooLong:
        return tr("In the file %1, %2 is longer than %3 bytes. Shorten the text.")
            .arg(path, error.key, error.expected);
    case FileError::Kind::RepeatedKey:
        return tr("The file %1 has the key %2 twice. Remove one of them.").arg(path, error.key);
    case FileError::Kind::HiddenCharacter:
        return tr("In the file %1, %2 has the character %3, which nobody can see. Remove the "
                  "character.")
            .arg(path, error.key, error.found);
    case FileError::Kind::UnknownSigner:
        return tr("The file %1 is signed by %2, whose key this machine does not have. Ask Service to "
                  "install the key, or have it signed by somebody else.")
            .arg(path, error.found);
    case FileError::Kind::WithdrawnSigner:
        return tr("The file %1 is signed by %2, whose key was withdrawn. Have it signed with a valid key.")
            .arg(path, error.found);
    case FileError::Kind::WrongSignature:
        return tr("The file %1 does not match the signature of %2: it was changed, or another key "
                  "signed it. Ask for a new copy.")
            .arg(path, error.found);
    case FileError::Kind::NotSigned:
        return tr("The file %1 is not signed; the plant's network offers signed files only. Have it "
                  "signed.")
            .arg(path);
    case FileError::Kind::NotShown:
        return error.found;
    }
    return {};
}

QString FileErrorText::notAFile()
{
    return tr("not a regular file");
}

QString FileErrorText::tooLarge()
{
    return tr("larger than 1 MB");
}

QString FileErrorText::aNumber()
{
    return tr("a number");
}

QString FileErrorText::aWholeNumber()
{
    return tr("a whole number");
}

QString FileErrorText::aText()
{
    return tr("a text");
}

QString FileErrorText::aVisibleText()
{
    return tr("a text of visible characters");
}

QString FileErrorText::anObject()
{
    return tr("an object in braces");
}

QString FileErrorText::twoPinnedKeys()
{
    return tr("a list of two of bag_length_mm, rate_bags_per_min, base_speed_mm_per_s, film_speed_mm_per_s");
}

QString FileErrorText::objects()
{
    return tr("a list of objects");
}

QString FileErrorText::pairsOfNumbers()
{
    return tr("pairs of master angle and position");
}

QString FileErrorText::range(double minimum, double maximum, const QString& unit)
{
    constexpr int significant = 9;
    const QString low = QString::number(minimum, 'g', significant);
    const QString high = QString::number(maximum, 'g', significant);
    return unit.isEmpty() ? tr("%1 to %2").arg(low, high) : tr("%1 to %2 %3").arg(low, high, unit);
}

} // namespace campanel::store
