// SPDX-License-Identifier: Apache-2.0
#include "app/cli/database_file.h"

#include "app/store/backup/backup_file.h"

#include <QFileInfo>

#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::cli {

tl::expected<std::unique_ptr<store::Database>, Failure> openDatabaseFile(const QString& path,
                                                                         const QTemporaryDir& unpacked)
{
    if (!QFileInfo(path).isFile())
        return fail(ExitCode::File, u"%1 is not a file. Name a database or a backup."_s.arg(path));
    QString database = path;
    if (store::readManifest(path)) {
        const auto backup = store::unpackBackup(path, unpacked.path());
        if (!backup)
            return fail(ExitCode::File, store::BackupErrorText::describe(backup.error()));
        database = unpacked.filePath(store::mainDatabase().name);
    }
    auto opened = store::Database::openReadOnly(database);
    if (opened)
        return std::move(*opened);
    switch (opened.error().kind) {
    case store::StoreError::Kind::Damaged:
        return fail(ExitCode::File, u"%1 is damaged or not a database or backup of CamPanel."_s.arg(path));
    case store::StoreError::Kind::NewerSchema:
        return fail(ExitCode::File,
                    u"%1 was written by a newer version of CamPanel. Use that version."_s.arg(path));
    case store::StoreError::Kind::Foreign:
        return fail(
            ExitCode::File,
            u"%1 was altered by another program: %2 is not of CamPanel. Its records prove nothing."_s.arg(
                path, opened.error().detail));
    default:
        return fail(ExitCode::File, u"%1 cannot be read: %2."_s.arg(path, opened.error().detail));
    }
}

} // namespace campanel::cli
