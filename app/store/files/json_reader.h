// SPDX-License-Identifier: Apache-2.0
// Reads one object of a recipe file; stores the requested keys and the first error. Internal to app/store.
#pragma once

#include "app/store/files/file_error.h"
#include "profile/model/fields.h"

#include <QJsonObject>
#include <QJsonValue>
#include <QSet>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace campanel::store {

inline QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

inline QString idOf(profile::Field field)
{
    return toQString(profile::info(field).id);
}

// One object of the file; stores the requested keys and the first error.
class ObjectReader {
public:
    ObjectReader(const QJsonObject& object, QString prefix, std::optional<FileError>& failure)
        : m_object(object)
        , m_prefix(std::move(prefix))
        , m_failure(failure)
    {
    }

    QJsonValue take(const QString& key)
    {
        m_asked.insert(key);
        return m_object.value(key);
    }

    bool has(const QString& key) { return !take(key).isNull() && !take(key).isUndefined(); }

    QJsonObject object(const QString& key)
    {
        const QJsonValue found = take(key);
        if (!found.isObject())
            fail(key, found.isUndefined() ? FileError::Kind::MissingKey : FileError::Kind::WrongType, {},
                 FileErrorText::anObject());
        return found.toObject();
    }

    QString text(const QString& key)
    {
        const QJsonValue found = take(key);
        if (!found.isString())
            fail(key, found.isUndefined() ? FileError::Kind::MissingKey : FileError::Kind::WrongType, {},
                 FileErrorText::aText());
        return found.toString();
    }

    // Returns a number within the limits in any case.
    double number(const QString& key, bool whole, const profile::FieldInfo& limits)
    {
        const QJsonValue found = take(key);
        const double value = found.toDouble();
        if (found.isUndefined() || found.isNull())
            fail(key, FileError::Kind::MissingKey, {}, {});
        else if (!found.isDouble())
            fail(key, FileError::Kind::WrongType, {},
                 whole ? FileErrorText::aWholeNumber() : FileErrorText::aNumber());
        else if (!(value >= limits.min && value <= limits.max))
            fail(key, FileError::Kind::OutOfRange, QString::number(value, 'g', 9),
                 FileErrorText::range(limits.min, limits.max, toQString(limits.unit)));
        else if (whole && value != std::floor(value))
            fail(key, FileError::Kind::WrongType, {}, FileErrorText::aWholeNumber());
        return std::clamp(value, limits.min, limits.max);
    }

    void refuseUnknownKeys()
    {
        for (const QString& key : m_object.keys()) {
            if (!m_asked.contains(key))
                fail(key, FileError::Kind::UnknownKey, {}, {});
        }
    }

    void fail(const QString& key, FileError::Kind kind, const QString& found, const QString& expected)
    {
        if (!m_failure)
            m_failure = FileError{kind, {}, m_prefix + key, found, expected, 0};
    }

private:
    QJsonObject m_object;
    QString m_prefix;
    QSet<QString> m_asked;
    std::optional<FileError>& m_failure;
};

} // namespace campanel::store
