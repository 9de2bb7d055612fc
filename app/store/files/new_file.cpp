// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/new_file.h"

#include "app/store/files/file_error.h"
#include "app/store/files/files.h"

#include <QDir>
#include <QFile>

namespace campanel::store {

tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name, const QString& suffix,
                                            const QByteArray& bytes)
{
    return writeNewFile(place, name, suffix, [&bytes](const QString& path) {
        return replaceBytes(path, bytes).map_error([](const FileError& error) { return error.found; });
    });
}

tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name, const QString& suffix,
                                            const FileWriter& write)
{
    const QString path = freePath(place, name, suffix);
    const auto written = write(path).and_then(
        [&path] { return settle(path).map_error([](const FileError& error) { return error.found; }); });
    if (!written) {
        QFile::remove(path); // it did not exist before
        return tl::unexpected(
            FileErrorText::tr("%1 Free some space, unlock the stick or choose another location.",
                              "%1: whole sentence")
                .arg(FileErrorText::tr("The file %1 cannot be written: %2.")
                         .arg(QDir::toNativeSeparators(path), written.error())));
    }
    return path;
}

} // namespace campanel::store
