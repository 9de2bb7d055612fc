// SPDX-License-Identifier: Apache-2.0
// The panel's settings: keys and values in an ini file with a checksum, and a last good copy. Damaged
// settings are never mistaken for missing ones.
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
        None,     // neither the file nor a copy existed: a new panel
        File,     // the file was intact
        Copy,     // the file was damaged or missing; its last good copy was used
        Defaults, // the file was damaged and there was no good copy: defaults
    };

    // Reads the file. A damaged one is kept as FILE.damaged. A file without a checksum (from an earlier
    // version or written by hand) counts as damaged when it has a key that is not in `knownKeys`.
    SettingsFile(QString path, const QStringList& knownKeys);

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] Origin origin() const { return m_origin; }
    [[nodiscard]] bool isEmpty() const { return m_values.isEmpty(); }
    [[nodiscard]] bool contains(const QString& key) const { return m_values.contains(key); }
    [[nodiscard]] QString value(const QString& key, const QString& otherwise = {}) const;

    // Writes at once when a value changes.
    void set(const QString& key, const QString& value) { set(Values{{key, value}}); }
    void set(const Values& values);

    // Returns true when the last write succeeded.
    [[nodiscard]] bool isKept() const { return m_isKept; }
    // Returns the contents that the file has or should have.
    [[nodiscard]] QByteArray contents() const;

private:
    void write();

    QString m_path;
    Values m_values;
    Origin m_origin = Origin::None;
    bool m_isKept = true;
};

} // namespace campanel::store
