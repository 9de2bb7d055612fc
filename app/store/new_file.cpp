// SPDX-License-Identifier: Apache-2.0
#include "app/store/new_file.h"

#include "app/store/file_error.h"
#include "app/store/files.h"

#include <QDir>

namespace campanel::store {

tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name, const QString& suffix,
                                            const QByteArray& bytes)
{
    const QString path = freePath(place, name, suffix);
    if (const auto written = replaceBytes(path, bytes); !written)
        return tl::unexpected(
            FileErrorText::tr("%1 Make room there, unlock the stick or choose another place.",
                              "%1: whole sentence")
                .arg(FileErrorText::tr("The file %1 cannot be written: %2.")
                         .arg(QDir::toNativeSeparators(path), written.error().found)));
    return path;
}

} // namespace campanel::store
