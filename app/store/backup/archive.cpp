// SPDX-License-Identifier: Apache-2.0
#include "app/store/backup/archive.h"

#include "app/store/files/files.h"

#include <QCryptographicHash>
#include <QFile>

#include <fcntl.h>
#include <functional>
#include <unistd.h>
#include <zip.h>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr qint64 pieceBytes = 65'536;

struct EntryCloser {
    void operator()(zip_file_t* entry) const { (void)zip_fclose(entry); }
};
using Entry = std::unique_ptr<zip_file_t, EntryCloser>;

using Error = ArchiveReader::Error;
using Fault = ArchiveReader::Fault;

QString reasonOf(int code)
{
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const QString text = QString::fromLocal8Bit(zip_error_strerror(&error));
    zip_error_fini(&error);
    return text;
}

// Returns null when the source cannot be read.
zip_source_t* sourceOf(zip_t* archive, const ArchiveEntry& entry)
{
    if (!entry.file.isEmpty())
        return zip_source_file(archive, QFile::encodeName(entry.file).constData(), 0, -1);
    return zip_source_buffer(archive, entry.bytes.constData(), static_cast<zip_uint64_t>(entry.bytes.size()),
                             0);
}

bool addEntry(zip_t* archive, const ArchiveEntry& entry)
{
    zip_source_t* source = sourceOf(archive, entry);
    if (!source)
        return false;
    if (zip_file_add(archive, entry.name.toUtf8().constData(), source, ZIP_FL_ENC_UTF_8) < 0) {
        zip_source_free(source);
        return false;
    }
    return true;
}

// Returns why an entry cannot be opened.
Fault faultOf(zip_error_t* error)
{
    switch (zip_error_code_zip(error)) {
    case ZIP_ER_NOPASSWD:
    case ZIP_ER_WRONGPASSWD:
    case ZIP_ER_ENCRNOTSUPP:
        return Fault::Encrypted;
    case ZIP_ER_COMPNOTSUPP:
        return Fault::OtherMethod;
    default:
        return Fault::Damaged;
    }
}

// Passes the pieces of the entry `name` to `take`, at most `maxBytes` together.
tl::expected<void, Error> readPieces(zip_t* archive, const QString& name, qint64 maxBytes,
                                     const std::function<bool(const QByteArray&)>& take)
{
    const Entry entry(zip_fopen(archive, name.toUtf8().constData(), 0));
    if (!entry)
        return tl::unexpected(Error{faultOf(zip_get_error(archive)), name});
    qint64 total = 0;
    for (;;) {
        QByteArray piece(pieceBytes, Qt::Uninitialized);
        const zip_int64_t got = zip_fread(entry.get(), piece.data(), pieceBytes);
        total += got;
        if (got < 0 || total > maxBytes) // wrong checksum, or another entry
            return tl::unexpected(Error{Fault::Damaged, name});
        if (got == 0)
            return {};
        piece.truncate(got);
        if (!take(piece))
            return tl::unexpected(Error{Fault::NotWritable, {}});
    }
}

} // namespace

tl::expected<void, QString> writeArchive(const QString& path, const QList<ArchiveEntry>& entries)
{
    int code = 0;
    zip_t* archive = zip_open(QFile::encodeName(path).constData(), ZIP_CREATE | ZIP_TRUNCATE, &code);
    if (!archive)
        return tl::unexpected(reasonOf(code));
    bool isWritten = true;
    for (const ArchiveEntry& entry : entries)
        isWritten = isWritten && addEntry(archive, entry);
    // libzip writes a temporary file, then renames it.
    if (isWritten && zip_close(archive) == 0)
        return {};
    const QString reason = QString::fromLocal8Bit(zip_strerror(archive));
    zip_discard(archive);
    return tl::unexpected(reason);
}

void ArchiveReader::Closer::operator()(zip* archive) const
{
    zip_discard(archive); // no change
}

tl::expected<ArchiveReader, Error> ArchiveReader::open(const QString& path)
{
    const auto file = openRegular(path);
    if (!file)
        return tl::unexpected(Error{Fault::NotReadable, file.error().found});
    const bool beginsAsOne = (*file)->peek(4) == QByteArray("PK\x03\x04", 4);
    int code = ZIP_ER_OPEN;
    const int handle = ::fcntl((*file)->handle(), F_DUPFD_CLOEXEC, 0);
    zip_t* archive = handle < 0 ? nullptr : zip_fdopen(handle, ZIP_CHECKCONS, &code);
    if (!archive && handle >= 0)
        ::close(handle); // libzip closes it only with the archive
    if (archive)
        return ArchiveReader(archive);
    return tl::unexpected(Error{beginsAsOne ? Fault::Damaged : Fault::NotAnArchive, reasonOf(code)});
}

bool ArchiveReader::enterFolderOf(const QString& name)
{
    const auto has = [this](const QString& entry) {
        return zip_name_locate(m_archive.get(), entry.toUtf8().constData(), ZIP_FL_ENC_UTF_8) >= 0;
    };
    m_folder.clear();
    if (has(name))
        return true;
    const char* first = zip_get_name(m_archive.get(), 0, ZIP_FL_ENC_GUESS);
    const QString folder = QString::fromUtf8(first).section(u'/', 0, 0) + u'/';
    if (!has(folder + name))
        return false;
    m_folder = folder;
    return true;
}

tl::expected<QByteArray, Error> ArchiveReader::read(const QString& name, qint64 maxBytes)
{
    QByteArray bytes;
    const auto done =
        readPieces(m_archive.get(), m_folder + name, maxBytes, [&bytes](const QByteArray& piece) {
            bytes += piece;
            return true;
        });
    if (!done)
        return tl::unexpected(done.error());
    return bytes;
}

tl::expected<QByteArray, Error> ArchiveReader::extract(const QString& name, qint64 bytes,
                                                       const QString& target)
{
    QFile file(target);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return tl::unexpected(Error{Fault::NotWritable, file.errorString()});
    QCryptographicHash hash(QCryptographicHash::Sha256);
    auto done = readPieces(m_archive.get(), m_folder + name, bytes, [&](const QByteArray& piece) {
        hash.addData(piece);
        return file.write(piece) == piece.size();
    });
    if (done && !file.flush())
        done = tl::unexpected(Error{Fault::NotWritable, {}});
    if (!done && done.error().fault == Fault::NotWritable)
        done.error().detail = file.errorString();
    if (!done)
        return tl::unexpected(done.error());
    if (file.size() != bytes)
        return tl::unexpected(Error{Fault::Damaged, name});
    return hash.result();
}

} // namespace campanel::store
