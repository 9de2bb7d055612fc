// SPDX-License-Identifier: Apache-2.0
// Opens a database, and replaces a missing or damaged one.
#include "app/store/database/database.h"

#include "app/store/database/setup_marker.h"
#include "app/store/files/files.h"
#include "app/store/files/private_files.h"
#include "app/store/files/store_logging.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>

#include <algorithm>
#include <filesystem>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

StoreError fileError(StoreError::Kind kind, const QString& path, const QString& reason)
{
    return {kind, path, reason};
}

QString copyPath(const QString& path)
{
    return path + u".copy"_s;
}

// Returns an unused file name: two files may be moved aside within one second.
QString freeName(const QString& path)
{
    const QString stamp = QDateTime::currentDateTimeUtc().toString(u"yyyyMMdd-HHmmss"_s);
    const QString base = u"%1-%2"_s.arg(path, stamp);
    QString name = base;
    for (int i = 2; QFileInfo::exists(name) || QFileInfo::exists(name + u"-wal"_s); ++i)
        name = u"%1-%2"_s.arg(base, QString::number(i));
    return name;
}

// Moves the file and what its write-ahead log left to another name, which is returned. It is empty when
// there was no file.
tl::expected<QString, StoreError> moveAside(const QString& path, const DatabaseFile& file)
{
    if (!file.isPrecious) {
        QDir folder = QFileInfo(path).dir();
        for (const QString& old : folder.entryList({file.name + u".damaged-*"_s}, QDir::Files))
            folder.remove(old);
    }
    const QString aside = freeName(path + u".damaged"_s);
    const bool isThere = QFileInfo::exists(path);
    QFile moved(path);
    if (isThere && !moved.rename(aside))
        return tl::unexpected(fileError(StoreError::Kind::CannotOpen, path, moved.errorString()));
    QFile::rename(path + u"-wal"_s, aside + u"-wal"_s);
    QFile::remove(path + u"-shm"_s);
    return isThere ? aside : QString();
}

// Replaces the file in one step.
tl::expected<void, StoreError> replace(const QString& from, const QString& to)
{
    std::error_code failure;
    std::filesystem::rename(from.toStdU16String(), to.toStdU16String(), failure);
    if (failure)
        return tl::unexpected(
            fileError(StoreError::Kind::CannotOpen, to, QString::fromStdString(failure.message())));
    return {};
}

// Moves an unusable copy aside.
tl::expected<bool, StoreError> dropCopy(const QString& path, const DatabaseFile& file)
{
    return moveAside(copyPath(path), file).map([](const QString&) { return false; });
}

// Moves the last good copy into the empty place of the database. Returns false without a copy. A damaged copy
// is moved aside.
tl::expected<bool, StoreError> putCopy(const QString& path, const DatabaseFile& file)
{
    const QString copy = copyPath(path);
    if (!file.isPrecious || !QFileInfo::exists(copy))
        return false;
    if (const auto sound = Database::openReadOnly(copy, file); !sound) {
        if (sound.error().kind != StoreError::Kind::Damaged)
            return tl::unexpected(sound.error());
        return dropCopy(path, file);
    }
    const QString fresh = copy + u".new"_s;
    QFile::remove(fresh);
    makePrivate(copy);
    QFile source(copy);
    if (!source.copy(fresh))
        return tl::unexpected(fileError(StoreError::Kind::CannotOpen, path, source.errorString()));
    if (!syncFile(fresh))
        return tl::unexpected(fileError(StoreError::Kind::CannotOpen, path, qt_error_string()));
    return replace(fresh, path).map([] { return true; });
}

// Checks that SQLite will not wait for a pipe in the place of one of its files.
tl::expected<void, StoreError> checkFiles(const QString& path)
{
    for (const auto suffix : {""_L1, "-wal"_L1, "-shm"_L1, "-journal"_L1}) {
        if (!isRegularOrMissing(path + suffix))
            return tl::unexpected(
                fileError(StoreError::Kind::CannotOpen, path + suffix, FileErrorText::notAFile()));
    }
    return {};
}

qint64 numberOf(Database& database, const QString& statement)
{
    auto found = database.execute(statement);
    return found && found->next() ? found->value(0).toLongLong() : -1; // unknown
}

qint64 usersIn(Database& database)
{
    return numberOf(database, u"SELECT count(*) FROM user WHERE deleted = 0"_s);
}

// Returns true when `copy` has data that `database` does not have: none of these numbers ever decreases
// during operation.
bool hasMore(Database& copy, Database& database)
{
    const QStringList statements{u"SELECT count(*) FROM user"_s, u"SELECT count(*) FROM recipe"_s,
                                 u"SELECT count(*) FROM recipe_version"_s,
                                 u"SELECT max(sequence) FROM audit"_s};
    return std::ranges::any_of(statements, [&](const QString& statement) {
        return numberOf(copy, statement) > numberOf(database, statement);
    });
}

} // namespace

tl::expected<std::unique_ptr<Database>, StoreError> Database::openAsFound(const QString& path,
                                                                          const DatabaseFile& file)
{
    if (const auto checked = checkFiles(path); !checked)
        return tl::unexpected(checked.error());
    if (!makePrivateFile(path))
        return tl::unexpected(fileError(StoreError::Kind::CannotOpen, path, qt_error_string()));
    for (const auto suffix : {"-wal"_L1, "-shm"_L1, ".copy"_L1, ".audit"_L1, ".setup"_L1})
        makePrivate(path + suffix);
    std::unique_ptr<Database> database(new Database(path, file));
    const auto ready = database->connect()
                           .and_then([&] { return database->configure(); })
                           .and_then([&] { return database->checkSound(); })
                           .and_then([&] { return database->checkSchema(); })
                           .and_then([&] { return database->migrate(); });
    if (!ready)
        return tl::unexpected(ready.error());
    if (file.complete) {
        const auto renamed = file.complete(*database);
        if (!renamed)
            return tl::unexpected(renamed.error());
        database->m_opening.renamed = *renamed;
    }
    // An emptied file: a panel with users keeps at least one.
    if (file.isPrecious && usersIn(*database) == 0) {
        const auto copy = openReadOnly(copyPath(path), file);
        if (copy && usersIn(**copy) > 0)
            return tl::unexpected(fileError(StoreError::Kind::Damaged, path, {}));
    }
    return database;
}

tl::expected<std::unique_ptr<Database>, StoreError> Database::open(const QString& folder,
                                                                   const DatabaseFile& file)
{
    if (!makePrivateFolder(folder))
        return tl::unexpected(StoreError{StoreError::Kind::CannotOpen, folder,
                                         StoreErrorText::tr("the folder cannot be created")});
    const QString path = QDir(folder).filePath(file.name);
    Opening opening;
    opening.isNew = QFileInfo(path).size() == 0;
    opening.wasMissing = opening.isNew && file.isPrecious && wasSetUp(path);
    // Tries the file itself, then its copy, then a new file.
    for (int attempt = opening.wasMissing ? 1 : 0;; ++attempt) {
        if (attempt > 0) {
            const auto kept = moveAside(path, file);
            if (!kept)
                return tl::unexpected(kept.error());
            if (!opening.wasMissing && opening.damagedKeptAs.isEmpty())
                opening.damagedKeptAs = *kept;
            const auto put = attempt == 1 ? putCopy(path, file) : dropCopy(path, file);
            if (!put)
                return tl::unexpected(put.error());
            opening.fromCopy = *put;
            // Unknown if there were PINs: assumes that there were.
            if (file.isPrecious && !*put && readSetupMarker(path) == SetUp::Unknown &&
                !writeSetupMarker(path, SetUp::WithPins))
                return tl::unexpected(fileError(StoreError::Kind::CannotOpen, setupMarkerPath(path),
                                                StoreErrorText::tr("the file cannot be written")));
        }
        auto database = openAsFound(path, file);
        if (database) {
            opening.migratedFrom = (*database)->m_opening.migratedFrom;
            opening.renamed = (*database)->m_opening.renamed;
            (*database)->m_opening = opening;
            (*database)->noteSetUp();
            return database;
        }
        if (database.error().kind != StoreError::Kind::Damaged || attempt == 2)
            return database;
    }
}

tl::expected<std::unique_ptr<Database>, StoreError> Database::openReadOnly(const QString& path,
                                                                           const DatabaseFile& file)
{
    if (!QFileInfo(path).isFile())
        return tl::unexpected(
            fileError(StoreError::Kind::CannotOpen, path, StoreErrorText::tr("this file does not exist")));
    if (const auto checked = checkFiles(path); !checked)
        return tl::unexpected(checked.error());
    std::unique_ptr<Database> database(new Database(path, file));
    // A read-only folder does not allow merging the log; without a log that is not necessary.
    const bool hasLog = QFileInfo::exists(path + u"-wal"_s);
    QUrl uri = QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath());
    uri.setQuery(hasLog ? u"mode=ro"_s : u"mode=ro&immutable=1"_s);
    database->m_database.setDatabaseName(QString::fromUtf8(uri.toEncoded()));
    database->m_database.setConnectOptions(u"QSQLITE_OPEN_READONLY;QSQLITE_OPEN_URI"_s);
    const auto ready = database->connect().and_then([&] { return database->checkSound(); }).and_then([&] {
        return database->checkSchema();
    });
    if (!ready)
        return tl::unexpected(ready.error());
    return database;
}

tl::expected<std::unique_ptr<Database>, StoreError> Database::openAnew(const QString& folder,
                                                                       const DatabaseFile& file)
{
    const QString path = QDir(folder).filePath(file.name);
    const auto kept = moveAside(path, file);
    if (!kept)
        return tl::unexpected(kept.error());
    auto database = open(folder, file);
    if (database)
        (*database)->m_opening.damagedKeptAs = *kept;
    return database;
}

// Writes the setup marker. After a failure the next opening repeats it.
void Database::noteSetUp()
{
    if (!m_file.isPrecious)
        return;
    if (usersIn(*this) > 0)
        (void)writeSetupMarker(m_path, SetUp::WithPins);
    else if (readSetupMarker(m_path) == SetUp::Unknown)
        (void)writeSetupMarker(m_path, SetUp::WithoutPins);
}

tl::expected<void, StoreError> Database::makeCopy()
{
    if (isInMemory())
        return {};
    const QString copy = copyPath(m_path);
    const QString fresh = copy + u".new"_s;
    QFile::remove(fresh);
    // Private from its creation; VACUUM INTO accepts an empty file.
    const auto written =
        makePrivateFile(fresh)
            ? execute(u"VACUUM INTO ?"_s, {fresh}).map([](const auto&) {})
            : tl::unexpected(fileError(StoreError::Kind::CannotOpen, fresh, qt_error_string()));
    if (!written) {
        QFile::remove(fresh);
        return written;
    }
    if (!syncFile(fresh))
        return tl::unexpected(fileError(StoreError::Kind::Failed, fresh, qt_error_string()));
    if (QFileInfo::exists(copy)) {
        const auto before = openReadOnly(copy, m_file);
        if (!before || hasMore(**before, *this)) {
            const QString aside = freeName(copy);
            qCWarning(storeLog, "%s holds what the database does not; it is kept as %s", qPrintable(copy),
                      qPrintable(aside));
            if (const auto kept = replace(copy, aside); !kept)
                return kept;
        }
    }
    return replace(fresh, copy);
}

} // namespace campanel::store
