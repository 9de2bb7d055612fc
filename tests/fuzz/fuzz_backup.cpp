// SPDX-License-Identifier: Apache-2.0
// Backup archives: any bytes as the file; and a whole archive whose manifest is right, with any changes of
// its parts. Nothing but files of the target folder is written.
#include "app/store/backup/archive.h"
#include "app/store/backup/backup_file.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/recipe_json.h"
#include "tests/fuzz/fuzz_target.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace campanel::fuzz {
namespace {

using namespace campanel::store;
using namespace Qt::StringLiterals;

constexpr qsizetype longestInput = 16'000;

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "a file can be written");
}

// A panel's backup, made once, and its parts.
struct Good {
    QTemporaryDir folder;
    QByteArray archive;
    QByteArray manifest;
    QList<ArchiveEntry> parts;

    Good()
    {
        const QString path = folder.filePath(u"good.zip"_s);
        const QString snapshot = folder.filePath(u"snapshot"_s);
        require(QDir().mkdir(snapshot), "a folder can be made");
        const auto database = Database::open(folder.path());
        const auto trends = Database::open(folder.path(), trendDatabase());
        require(database && trends, "databases can be made");
        auto head = takeSnapshot(**database, snapshot);
        require(head && takeTrendSnapshot(**trends, snapshot), "a snapshot can be taken");
        head->program = u"0.1.0"_s;
        head->made = QDateTime::fromMSecsSinceEpoch(1'790'000'000'000).toUTC();
        const QByteArray recipe = toJson(program::Recipe());
        require(writeBackup(path, *head, snapshot, {"[a]\nb=1\n", recipe, recipe}).has_value(),
                "a backup can be written");
        archive = contentOf(path);
        auto reader = ArchiveReader::open(path);
        const auto whole = readManifest(path);
        require(reader && whole, "a backup can be read");
        constexpr qint64 large = 10'000'000;
        manifest = reader->read(u"manifest.json"_s, large).value();
        for (const BackupManifest::Part& part : whole->parts)
            parts.append({part.name, reader->read(part.name, large).value(), {}});
    }
};

const Good& good()
{
    // Before the first database: Qt 6.8 opens none without it.
    static int argc = 1;
    static char name[] = "fuzz";
    static char* argv[] = {name, nullptr};
    static const QCoreApplication application(argc, argv);
    static const Good made;
    return made;
}

// Writes an archive whose parts were changed and whose manifest knows the changed ones.
void writeChanged(const QString& path, InputReader& input)
{
    QList<ArchiveEntry> entries = good().parts;
    QJsonObject manifest = QJsonDocument::fromJson(good().manifest).object();
    for (unsigned changes = input.byte() % 64u; changes != 0; --changes) {
        QByteArray& bytes = entries[input.byte() % entries.size()].bytes;
        const qsizetype at = input.word() * (1 + input.byte() % 4);
        if (const std::uint8_t how = input.byte(); how == 0xFF)
            bytes.truncate(at);
        else if (at < bytes.size())
            bytes[at] = static_cast<char>(input.byte());
    }
    QJsonArray parts;
    for (const ArchiveEntry& entry : entries)
        parts << QJsonObject{
            {u"name"_s, entry.name},
            {u"bytes"_s, entry.bytes.size()},
            {u"sha256"_s,
             QString::fromLatin1(QCryptographicHash::hash(entry.bytes, QCryptographicHash::Sha256).toHex())}};
    manifest[u"parts"_s] = parts;
    entries.prepend({u"manifest.json"_s, QJsonDocument(manifest).toJson(), {}});
    require(writeArchive(path, entries).has_value(), "an archive can be written");
}

// Writes an archive with any bytes as its manifest.
void writeManifest(const QString& path, InputReader& input)
{
    const auto bytes = input.rest();
    QList<ArchiveEntry> entries = good().parts;
    entries.prepend(
        {u"manifest.json"_s,
         QByteArray(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())),
         {}});
    require(writeArchive(path, entries).has_value(), "an archive can be written");
}

} // namespace

void runTarget(std::span<const std::uint8_t> bytes)
{
    const Good& original = good();
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"backup.zip"_s);
    const QString target = folder.filePath(u"target"_s);
    require(QDir().mkdir(target), "a folder can be made");
    InputReader input(bytes);
    switch (input.byte() % 3) {
    case 0: {
        const auto rest = input.rest();
        put(path,
            QByteArray(reinterpret_cast<const char*>(rest.data()), static_cast<qsizetype>(rest.size())));
        break;
    }
    case 1:
        writeManifest(path, input);
        break;
    default:
        writeChanged(path, input);
        break;
    }
    const auto manifest = readManifest(path);
    const auto unpacked = unpackBackup(path, target);
    require(manifest || !unpacked, "nothing is unpacked without its manifest");
    if (!unpacked)
        require(!BackupErrorText::describe(unpacked.error()).isEmpty(), "a refusal has a sentence");
    require(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size() == 2,
            "nothing is written beside the target");
    require(original.archive.size() > 0, "the original stays");
}

std::vector<Bytes> targetSeeds()
{
    std::vector<Bytes> seeds{{2, 0}, {2, 2, 0, 0, 24, 0, 0, 4, 1, 0, 9, 0, 0xFF}, {2, 1, 3, 0, 2, 0, 0, 'x'}};
    Bytes manifest{1};
    manifest.insert(manifest.end(), good().manifest.begin(), good().manifest.end());
    seeds.push_back(manifest);
    Bytes archive{0};
    const QByteArray& whole = good().archive;
    archive.insert(archive.end(), whole.begin(), whole.begin() + std::min(whole.size(), longestInput));
    seeds.push_back(archive);
    return seeds;
}

} // namespace campanel::fuzz
