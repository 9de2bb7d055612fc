// SPDX-License-Identifier: Apache-2.0
// The panel's settings: keys with their values in an ini file, with a checksum, and the same once more as its
// last good copy. What is damaged is never taken for settings that nobody has made.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

#include <tl/expected.hpp>

namespace campanel::store {

class SettingsFile {
public:
    using Values = QMap<QString, QString>; // by "key" or "section/key"

    enum class Origin {
        None,     // neither the file nor a copy was there: a new panel
        File,     // as it was written
        Copy,     // the file was damaged or gone; its last good copy took its place
        Defaults, // the file was damaged and there was no good copy: nothing is known
    };

    // Reads the file. A damaged one is kept as FILE.damaged. `knownKeys` judge a file that has no checksum,
    // as it was written by an earlier version or by hand: with another key it counts as damaged.
    SettingsFile(QString path, const QStringList& knownKeys);

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] Origin origin() const { return m_origin; }
    [[nodiscard]] bool isEmpty() const { return m_values.isEmpty(); }
    [[nodiscard]] bool contains(const QString& key) const { return m_values.contains(key); }
    [[nodiscard]] QString value(const QString& key, const QString& otherwise = {}) const;

    // Writes at once, when something changes.
    void set(const QString& key, const QString& value) { set(Values{{key, value}}); }
    void set(const Values& values);

    // The last writing was done.
    [[nodiscard]] bool isKept() const { return m_isKept; }
    // What is in the file, or should be.
    [[nodiscard]] QByteArray contents() const;

private:
    void write();

    QString m_path;
    Values m_values;
    Origin m_origin = Origin::None;
    bool m_isKept = true;
};

} // namespace campanel::store
