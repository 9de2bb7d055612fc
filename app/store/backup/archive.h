// SPDX-License-Identifier: Apache-2.0
// Zip archives by libzip: written as a whole, read entry by entry. Names of entries are only compared with
// known names, never used as paths. Not for the GUI thread.
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

#include <tl/expected.hpp>

#include <memory>

struct zip;

namespace campanel::store {

struct ArchiveEntry {
    QString name;
    QByteArray bytes;
    QString file; // when not empty, its content is used instead of `bytes`
};

// Writes the whole archive or none. The error is the system's reason.
[[nodiscard]] tl::expected<void, QString> writeArchive(const QString& path,
                                                       const QList<ArchiveEntry>& entries);

class ArchiveReader {
public:
    // Encrypted: by a password. OtherMethod: compressed in a way that is not supported.
    enum class Fault { NotReadable, NotAnArchive, Damaged, NotWritable, Encrypted, OtherMethod };
    struct Error {
        Fault fault = Fault::Damaged;
        QString detail; // the system's reason, or the name of the entry
    };

    [[nodiscard]] static tl::expected<ArchiveReader, Error> open(const QString& path);

    // Finds the entry `name` at the top or in the only folder at the top: read() and extract() then use that
    // folder. Returns false without such an entry.
    [[nodiscard]] bool enterFolderOf(const QString& name);

    // Reads a whole entry, which must not be longer than `maxBytes`.
    [[nodiscard]] tl::expected<QByteArray, Error> read(const QString& name, qint64 maxBytes);
    // Extracts an entry of exactly `bytes` bytes to the new file `target` and returns its SHA-256.
    [[nodiscard]] tl::expected<QByteArray, Error> extract(const QString& name, qint64 bytes,
                                                          const QString& target);

private:
    struct Closer {
        void operator()(zip* archive) const;
    };

    explicit ArchiveReader(zip* archive)
        : m_archive(archive)
    {
    }

    std::unique_ptr<zip, Closer> m_archive;
    QString m_folder; // "name/" or empty
};

} // namespace campanel::store
