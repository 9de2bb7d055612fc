// SPDX-License-Identifier: Apache-2.0
#include "app/store/backup/backup_file.h"

#include "app/store/backup/archive.h"
#include "app/store/files/files.h"
#include "app/store/files/json_keys.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/recipe_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStorageInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString manifestName = u"manifest.json"_s;
const QString backupFormat = u"campanel-backup"_s;
constexpr qint64 maxManifestBytes = 100'000;
constexpr qint64 maxRecipeBytes = maxFileBytes;

const QString databaseName = u"campanel.sqlite"_s;
const QString anchorName = u"campanel.sqlite.audit"_s;
const QString storedName = u"recipe.json"_s;
const QString workingName = u"working_copy.json"_s;
const QStringList partNames{databaseName, anchorName, backedUpSettings, storedName, workingName};
const QString& trendsName = trendDatabase().name; // if it exists, after the others

constexpr qint64 megabyte = 1'000'000;
// The maximum size of a database: a million rows of the audit trail, or ten million bags, take less than half
// of it.
constexpr qint64 maxDatabaseBytes = 1'000 * megabyte;
constexpr qint64 maxAnchorBytes = 10'000;

using Kind = BackupError::Kind;

qint64 maxBytesOf(const QString& part)
{
    if (part == databaseName || part == trendsName)
        return maxDatabaseBytes;
    return part == anchorName ? maxAnchorBytes : maxRecipeBytes;
}

BackupError errorOf(const ArchiveReader::Error& error, const QString& path)
{
    switch (error.fault) {
    case ArchiveReader::Fault::NotReadable:
        return {Kind::NotReadable, path, error.detail};
    case ArchiveReader::Fault::NotAnArchive:
        return {Kind::NotABackup, path, {}};
    case ArchiveReader::Fault::NotWritable:
        return {Kind::NotWritable, path, error.detail};
    case ArchiveReader::Fault::Encrypted:
        return {Kind::Encrypted, path, {}};
    case ArchiveReader::Fault::OtherMethod:
        return {Kind::OtherMethod, path, {}};
    case ArchiveReader::Fault::Damaged:
        break;
    }
    return {Kind::Damaged, path, error.detail};
}

tl::expected<QByteArray, QString> hashOf(const QString& path)
{
    const auto file = openRegular(path);
    if (!file)
        return tl::unexpected(file.error().found);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!hash.addData(file->get()))
        return tl::unexpected((*file)->errorString());
    return hash.result();
}

QByteArray manifestJson(const BackupManifest& manifest)
{
    QJsonArray parts;
    for (const BackupManifest::Part& part : manifest.parts)
        parts << QJsonObject{{u"name"_s, part.name},
                             {u"bytes"_s, part.bytes},
                             {u"sha256"_s, QString::fromLatin1(part.sha256.toHex())}};
    return QJsonDocument(QJsonObject{{u"format"_s, backupFormat},
                                     {u"formatVersion"_s, backupFormatVersion},
                                     {u"campanel"_s, manifest.program},
                                     {u"schema"_s, manifest.schema},
                                     {u"made"_s, manifest.made.toUTC().toString(Qt::ISODateWithMs)},
                                     {u"madeBy"_s, manifest.madeBy},
                                     {u"recipes"_s, manifest.recipes},
                                     {u"users"_s, manifest.users},
                                     {u"parts"_s, parts}})
        .toJson();
}

tl::expected<BackupManifest, BackupError> manifestOf(ArchiveReader& archive, const QString& path)
{
    if (!archive.enterFolderOf(manifestName))
        return tl::unexpected(BackupError{Kind::NotABackup, path, {}});
    const auto bytes = archive.read(manifestName, maxManifestBytes);
    if (!bytes)
        return tl::unexpected(errorOf(bytes.error(), path));
    const QJsonObject json = QJsonDocument::fromJson(*bytes).object();
    if (json.value("format"_L1).toString() != backupFormat)
        return tl::unexpected(BackupError{Kind::NotABackup, path, {}});
    if (repeatedKey(*bytes))
        return tl::unexpected(BackupError{Kind::Damaged, path, manifestName});
    BackupManifest manifest;
    manifest.program = json.value("campanel"_L1).toString();
    manifest.schema = json.value("schema"_L1).toInt();
    if (json.value("formatVersion"_L1).toInt() > backupFormatVersion || manifest.schema > schemaVersion())
        return tl::unexpected(BackupError{Kind::Newer, path, manifest.program});
    manifest.made = QDateTime::fromString(json.value("made"_L1).toString(), Qt::ISODateWithMs);
    manifest.madeBy = json.value("madeBy"_L1).toString();
    manifest.recipes = json.value("recipes"_L1).toInt();
    manifest.users = json.value("users"_L1).toInt();
    QStringList names;
    for (const auto& value : json.value("parts"_L1).toArray()) {
        const QJsonObject part = value.toObject();
        names << part.value("name"_L1).toString();
        manifest.parts << BackupManifest::Part{
            names.last(), part.value("bytes"_L1).toInteger(-1),
            QByteArray::fromHex(part.value("sha256"_L1).toString().toLatin1())};
    }
    if ((names != partNames && names != partNames + QStringList{trendsName}) || !manifest.made.isValid())
        return tl::unexpected(BackupError{Kind::Damaged, path, manifestName});
    return manifest;
}

tl::expected<int, StoreError> count(Database& database, const QString& table)
{
    auto counted = database.execute(u"SELECT count(*) FROM %1 WHERE deleted = 0"_s.arg(table));
    if (!counted)
        return tl::unexpected(counted.error());
    return counted->next() ? counted->value(0).toInt() : 0;
}

tl::expected<void, BackupError> checkRecipe(const QDir& folder, const QString& name, const QString& path)
{
    if (!readRecipe(folder.filePath(name)))
        return tl::unexpected(BackupError{Kind::Damaged, path, name});
    return {};
}

// Opens a database; it must be valid and have the present schema.
tl::expected<std::unique_ptr<Database>, BackupError>
openPart(const QString& folder, const DatabaseFile& file, const BackupManifest& manifest, const QString& path)
{
    auto database = Database::open(folder, file);
    if (!database) {
        const StoreError& error = database.error();
        if (error.kind == StoreError::Kind::NewerSchema)
            return tl::unexpected(BackupError{Kind::Newer, path, manifest.program});
        const bool isForeign = error.kind == StoreError::Kind::Foreign;
        return tl::unexpected(BackupError{isForeign ? Kind::Foreign : Kind::NotWritable, path, error.detail});
    }
    if ((*database)->opening().isNew || (*database)->opening().isReplaced())
        return tl::unexpected(BackupError{Kind::Damaged, path, file.name});
    return std::move(*database);
}

tl::expected<void, BackupError> checkDatabase(const QString& folder, const BackupManifest& manifest,
                                              const QString& path)
{
    const auto database = openPart(folder, mainDatabase(), manifest, path);
    if (!database)
        return tl::unexpected(database.error());
    if (count(**database, u"recipe"_s) != manifest.recipes || count(**database, u"user"_s) != manifest.users)
        return tl::unexpected(BackupError{Kind::Damaged, path, databaseName});
    return {};
}

tl::expected<void, BackupError> checkTrends(const QString& folder, const BackupManifest& manifest,
                                            const QString& path)
{
    if (!manifest.hasTrends())
        return {};
    return openPart(folder, trendDatabase(), manifest, path).map([](const auto&) {});
}

tl::expected<void, StoreError> copyInto(Database& database, const QString& path)
{
    return database.execute(u"VACUUM INTO ?"_s, {path}).map([](const auto&) {});
}

} // namespace

bool BackupManifest::hasTrends() const
{
    return std::ranges::any_of(parts, [](const Part& part) { return part.name == trendsName; });
}

QString BackupErrorText::describe(const BackupError& error)
{
    const QString path = QFileInfo(error.path).fileName();
    switch (error.kind) {
    case Kind::NotReadable:
        return tr("The file %1 cannot be read: %2. Nothing was changed.").arg(path, error.detail);
    case Kind::NotABackup:
        return tr("%1 is not a backup of CamPanel. Nothing was changed.").arg(path);
    case Kind::Encrypted:
        return tr("%1 is protected by a password. Unpack it on a computer and pack it as a zip file without "
                  "a "
                  "password. Nothing was changed.")
            .arg(path);
    case Kind::OtherMethod:
        return tr("%1 was packed in a way that this panel cannot read. Unpack it on a computer and pack it "
                  "as a "
                  "usual zip file. Nothing was changed.")
            .arg(path);
    case Kind::Foreign:
        return tr("%1 was altered by another program: %2 is not of CamPanel. Use another backup. Nothing was "
                  "changed.")
            .arg(path, error.detail);
    case Kind::NoUsers:
        return tr("%1 has no users, but this panel has PINs. Use a backup that was made after the first PIN. "
                  "Nothing was changed.")
            .arg(path);
    case Kind::NoService:
        return tr("Nobody in %1 can log in as Service: the panel could not be set up any more. Use another "
                  "backup. Nothing was changed.")
            .arg(path);
    case Kind::Newer:
        return tr("%1 was made by the newer CamPanel %2. Install that version first. Nothing was changed.")
            .arg(path, error.detail);
    case Kind::Damaged:
        return tr("%1 is damaged (%2). Use another backup. Nothing was changed.").arg(path, error.detail);
    case Kind::NotWritable:
        return tr("The backup cannot be unpacked: %1. Free space on this panel. Nothing was changed.")
            .arg(error.detail);
    }
    return {};
}

tl::expected<BackupManifest, StoreError> takeSnapshot(Database& database, const QString& folder)
{
    BackupManifest manifest;
    manifest.schema = schemaVersion();
    const auto recipes = count(database, u"recipe"_s);
    const auto users = count(database, u"user"_s);
    if (!recipes || !users)
        return tl::unexpected(recipes ? users.error() : recipes.error());
    manifest.recipes = *recipes;
    manifest.users = *users;
    const QDir target(folder);
    if (const auto done = copyInto(database, target.filePath(databaseName)); !done)
        return tl::unexpected(done.error());
    // Does not exist before the first row.
    const auto anchor = readBytes(database.path() + u".audit"_s);
    const auto copied = replaceBytes(target.filePath(anchorName), anchor.value_or(QByteArray()));
    if (!copied)
        return tl::unexpected(
            StoreError{StoreError::Kind::Failed, copied.error().path, copied.error().found});
    return manifest;
}

tl::expected<void, StoreError> takeTrendSnapshot(Database& database, const QString& folder)
{
    return copyInto(database, QDir(folder).filePath(trendsName));
}

tl::expected<void, QString> writeBackup(const QString& path, BackupManifest manifest,
                                        const QString& snapshotFolder, const BackupParts& parts)
{
    const QDir snapshot(snapshotFolder);
    QList<ArchiveEntry> entries{{databaseName, {}, snapshot.filePath(databaseName)},
                                {anchorName, {}, snapshot.filePath(anchorName)},
                                {backedUpSettings, parts.settings, {}},
                                {storedName, parts.storedRecipe, {}},
                                {workingName, parts.workingCopy, {}},
                                {trendsName, {}, snapshot.filePath(trendsName)}};
    for (const ArchiveEntry& entry : entries) {
        BackupManifest::Part part{entry.name, entry.bytes.size(),
                                  QCryptographicHash::hash(entry.bytes, QCryptographicHash::Sha256)};
        if (!entry.file.isEmpty()) {
            const auto hash = hashOf(entry.file);
            if (!hash)
                return tl::unexpected(hash.error());
            part.bytes = QFileInfo(entry.file).size();
            part.sha256 = *hash;
        }
        manifest.parts << part;
    }
    entries.prepend({manifestName, manifestJson(manifest), {}});
    return writeArchive(path, entries);
}

tl::expected<BackupManifest, BackupError> readManifest(const QString& path)
{
    auto archive = ArchiveReader::open(path);
    if (!archive)
        return tl::unexpected(errorOf(archive.error(), path));
    return manifestOf(*archive, path);
}

tl::expected<void, BackupError> checkSizes(const BackupManifest& manifest, qint64 archiveBytes,
                                           qint64 freeBytes, const QString& path)
{
    constexpr qint64 maxRatio = 100; // the usual ratio for a database is 5 to 30
    constexpr qint64 smallBytes = 16 * megabyte;
    constexpr qint64 reserveBytes = 64 * megabyte; // for the panel's further data
    qint64 total = 0;
    for (const BackupManifest::Part& part : manifest.parts) {
        if (part.bytes < 0 || part.bytes > maxBytesOf(part.name))
            return tl::unexpected(BackupError{Kind::Damaged, path, part.name});
        total += part.bytes;
    }
    if (total > smallBytes && total / maxRatio > archiveBytes)
        return tl::unexpected(BackupError{Kind::Damaged, path, manifestName});
    if (total + reserveBytes > freeBytes)
        return tl::unexpected(BackupError{Kind::NotWritable, path,
                                          BackupErrorText::tr("%1 MB are required and %2 MB are free")
                                              .arg((total + reserveBytes) / megabyte + 1)
                                              .arg(freeBytes / megabyte)});
    return {};
}

tl::expected<BackupManifest, BackupError> unpackBackup(const QString& path, const QString& folder)
{
    auto archive = ArchiveReader::open(path);
    if (!archive)
        return tl::unexpected(errorOf(archive.error(), path));
    const auto manifest = manifestOf(*archive, path);
    if (!manifest)
        return manifest;
    const QDir target(folder);
    if (const auto fits =
            checkSizes(*manifest, QFileInfo(path).size(), QStorageInfo(folder).bytesAvailable(), path);
        !fits)
        return tl::unexpected(fits.error());
    for (const BackupManifest::Part& part : manifest->parts) {
        const auto hash = archive->extract(part.name, part.bytes, target.filePath(part.name));
        if (!hash)
            return tl::unexpected(errorOf(hash.error(), path));
        if (*hash != part.sha256)
            return tl::unexpected(BackupError{Kind::Damaged, path, part.name});
    }
    const auto checked = checkRecipe(target, storedName, path)
                             .and_then([&] { return checkRecipe(target, workingName, path); })
                             .and_then([&] { return checkDatabase(folder, *manifest, path); })
                             .and_then([&] { return checkTrends(folder, *manifest, path); });
    if (!checked)
        return tl::unexpected(checked.error());
    return manifest;
}

} // namespace campanel::store
