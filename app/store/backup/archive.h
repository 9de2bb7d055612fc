// SPDX-License-Identifier: Apache-2.0
// Zip archives by libzip: written as a whole, read entry by entry. Names of entries are only ever compared
// with names that are known, never taken as paths. Not for the GUI thread.
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
    QString file; // when not empty its content instead of `bytes`
};

// The archive is there as a whole or not at all. The system's reason on failure.
[[nodiscard]] tl::expected<void, QString> writeArchive(const QString& path,
                                                       const QList<ArchiveEntry>& entries);

class ArchiveReader {
public:
    enum class Fault { NotReadable, NotAnArchive, Damaged, NotWritable };
    struct Error {
        Fault fault = Fault::Damaged;
        QString detail; // the system's reason, or the entry
    };

    [[nodiscard]] static tl::expected<ArchiveReader, Error> open(const QString& path);

    // The whole entry, which must not be longer than `mostBytes`.
    [[nodiscard]] tl::expected<QByteArray, Error> read(const QString& name, qint64 mostBytes);
    // Of an entry of exactly `bytes` bytes: its SHA-256, while it is written to the new file `target`.
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
};

} // namespace campanel::store
