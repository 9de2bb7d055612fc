// SPDX-License-Identifier: Apache-2.0
#include "app/store/backup/restore.h"

#include "app/store/database/setup_marker.h"
#include "app/store/files/files.h"
#include "app/store/files/private_files.h"
#include "app/store/users/user_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <filesystem>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString stagingName = u"restore-unpacked"_s;
const QString readyName = u"restore-ready"_s;
const QString staleName = u"restore-stale"_s;
const QString keptFolder = u"before-restore"_s;
const QString databaseSuffix = u".sqlite"_s;

std::filesystem::path native(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

// Moves a file in one step, replacing the existing one; across file systems by a copy that replaces in one
// step.
tl::expected<void, QString> move(const QString& from, const QString& to)
{
    std::error_code failure;
    std::filesystem::rename(native(from), native(to), failure);
    if (!failure)
        return {};
    if (failure != std::errc::cross_device_link)
        return tl::unexpected(QString::fromStdString(failure.message()));
    const auto copied = readBytes(from).and_then( // the settings, a few KB
        [&to](const QByteArray& bytes) { return replaceBytes(to, bytes); });
    QFile source(from);
    if (!copied || !source.remove())
        return tl::unexpected(copied ? source.errorString() : copied.error().found);
    return {};
}

// Succeeds when there is nothing to move.
tl::expected<void, QString> moveIfThere(const QString& from, const QString& to)
{
    return QFileInfo::exists(from) ? move(from, to) : tl::expected<void, QString>();
}

// Moves the files beside a database away. They go first: a new database must never meet an old log.
tl::expected<void, QString> keepCompanions(const QString& path, const QString& kept)
{
    tl::expected<void, QString> done;
    for (const auto suffix : {"-wal"_L1, "-shm"_L1, ".copy"_L1, ".setup"_L1})
        done = done.and_then([&] { return moveIfThere(path + suffix, kept + suffix); });
    return done;
}

// Moves the old part aside and the new one into place. A part that is missing in `ready` is already in place.
tl::expected<void, QString> finishPart(const QDir& ready, const QDir& kept, const QString& name,
                                       const QString& path)
{
    if (!ready.exists(name))
        return {};
    tl::expected<void, QString> done;
    if (name.endsWith(databaseSuffix))
        done = keepCompanions(path, kept.filePath(name));
    return done.and_then([&] { return moveIfThere(path, kept.filePath(name)); }).and_then([&] {
        QDir().mkpath(QFileInfo(path).path());
        return move(ready.filePath(name), path);
    });
}

// Checks that the users of an unpacked backup can still set up the panel: a panel that has PINs keeps some.
tl::expected<void, BackupError> checkUsers(const QString& staging, const QString& folder,
                                           const QString& backup)
{
    using Kind = BackupError::Kind;
    const auto database = Database::open(staging);
    const auto found = database ? serviceUsers(**database) : tl::unexpected(database.error());
    if (!found)
        return tl::unexpected(BackupError{Kind::Damaged, backup, found.error().detail});
    const QString present = QDir(folder).filePath(mainDatabase().name);
    const SetUp setUp = readSetupMarker(present);
    const bool hasPins = setUp == SetUp::WithPins || (setUp == SetUp::Unknown && wasSetUp(present));
    if (found->users == 0 && hasPins)
        return tl::unexpected(BackupError{Kind::NoUsers, backup, {}});
    if (found->users > 0 && found->withService == 0)
        return tl::unexpected(BackupError{Kind::NoService, backup, {}});
    return {};
}

} // namespace

tl::expected<BackupManifest, BackupError> stageRestore(const QString& backup, const QString& folder)
{
    discardRestore(folder);
    const QString staging = QDir(folder).filePath(stagingName);
    if (!makePrivateFolder(staging))
        return tl::unexpected(BackupError{BackupError::Kind::NotWritable, backup, staging});
    auto manifest = unpackBackup(backup, staging);
    if (manifest) {
        if (const auto checked = checkUsers(staging, folder, backup); !checked)
            manifest = tl::unexpected(checked.error());
    }
    if (!manifest)
        discardRestore(folder);
    return manifest;
}

tl::expected<void, QString> commitRestore(const QString& folder, const AuditEntry& entry)
{
    const QDir home(folder);
    const QString staging = home.filePath(stagingName);
    {
        const auto database = Database::open(staging);
        if (!database)
            return tl::unexpected(database.error().detail);
        if (const auto row = appendAudit(**database, entry); !row)
            return tl::unexpected(row.error().detail);
    } // closed: its log is part of the file
    QDir(home.filePath(keptFolder)).removeRecursively();
    if (!makePrivateFolder(home.filePath(keptFolder)))
        return tl::unexpected(home.filePath(keptFolder));
    return settle(staging)
        .map_error([](const FileError& error) { return error.found; })
        // A restore that could not be finished.
        .and_then([&] { return moveIfThere(home.filePath(readyName), home.filePath(staleName)); })
        .and_then([&] { return move(staging, home.filePath(readyName)); })
        .and_then(
            [&] { return settle(folder).map_error([](const FileError& error) { return error.found; }); });
}

void discardRestore(const QString& folder)
{
    for (const QString& name : {stagingName, staleName})
        QDir(QDir(folder).filePath(name)).removeRecursively();
}

FinishedRestore finishRestore(const QString& folder, const QString& settingsFile)
{
    const QDir home(folder);
    discardRestore(folder);
    QDir ready(home.filePath(readyName));
    if (!ready.exists())
        return {};
    const QDir kept(home.filePath(keptFolder));
    (void)makePrivateFolder(kept.path()); // without it nothing can be moved, which is reported
    FinishedRestore finished{true, {}, kept.path()};
    tl::expected<void, QString> done = finishPart(ready, kept, backedUpSettings, settingsFile);
    for (const QString& name : ready.entryList(QDir::Files)) {
        if (name != backedUpSettings)
            done = done.and_then([&] { return finishPart(ready, kept, name, home.filePath(name)); });
    }
    if (done)
        ready.removeRecursively();
    else
        finished.problem = done.error();
    return finished;
}

} // namespace campanel::store
