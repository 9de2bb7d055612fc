// SPDX-License-Identifier: Apache-2.0
// Backup and restore of everything. Damaged, truncated, foreign or newer files are refused without changes; a
// restore that was interrupted anywhere is completed.
#include "app/store/backup/archive.h"
#include "app/store/backup/restore.h"
#include "app/store/logs/trend_log.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/recipe_library.h"
#include "app/store/users/pin_hash.h"
#include "app/store/users/user_store.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QTimeZone>

#include <map>
#include <random>

namespace test_backup {

using namespace campanel::store;
using namespace Qt::StringLiterals;

namespace {

constexpr qint64 nowMs = 1'790'000'000'000;

AuditEntry entryOf(const QString& what)
{
    return {nowMs, u"Anna"_s, 3, what, u"x"_s, {}, {}, {}, u"done"_s};
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

campanel::program::Recipe recipeOf(const char* name)
{
    campanel::program::Recipe recipe;
    recipe.name = name;
    return recipe;
}

// The hash of a PIN; making one takes a while.
const QString& pinHash()
{
    static const QString hash = hashPin(u"258025"_s).value_or(QString());
    return hash;
}

// A panel's folder, with data and a backup of it.
struct Home {
    QTemporaryDir dir;
    QTemporaryDir stick;
    QString backup = stick.filePath(u"day.zip"_s);

    [[nodiscard]] QString at(const char* name) const { return dir.filePath(QString::fromLatin1(name)); }

    Home()
    {
        fill("Biscuit", "Anna", 3);
        keepBackup();
    }

    void fill(const char* recipe, const char* user, int rows)
    {
        measure(rows);
        const auto database = Database::open(dir.path());
        QVERIFY(RecipeLibrary(**database).save(recipeOf(recipe), QString::fromLatin1(user), nowMs));
        QVERIFY(addUser(**database, QString::fromLatin1(user), UserLevel::Service, pinHash()));
        for (int i = 0; i < rows; ++i)
            QVERIFY(appendAudit(**database, entryOf(u"user.add"_s)));
        put(at("recipe.json"), toJson(recipeOf(recipe)));
        put(at("working_copy.json"), toJson(recipeOf(recipe)));
        put(at("settings.ini"), QByteArray("theme=") + recipe);
    }

    // Adds this many seconds to the trends.
    void measure(int seconds)
    {
        const auto database = Database::open(dir.path(), trendDatabase());
        const qint64 begin = nowMs / 1000 + measured();
        TrendLog log(**database);
        QVERIFY((*database)->transaction([&]() -> tl::expected<void, StoreError> {
            QList<TrendPart> parts;
            for (int i = 0; i < seconds; ++i) {
                parts << TrendPart{begin + i, TrendQuantity::Rate, {}};
                parts.last().bucket.add(60, true);
            }
            return log.add(parts);
        }));
    }

    [[nodiscard]] int measured() const
    {
        const auto database = Database::open(dir.path(), trendDatabase());
        int seconds = 0;
        (void)TrendLog(**database)
            .forEach(TrendLog::Level::Second, 0, 2 * nowMs, {TrendQuantity::Rate},
                     [&](qint64, TrendQuantity, const TrendBucket&) { ++seconds; });
        return seconds;
    }

    void keepBackup()
    {
        const QTemporaryDir snapshot;
        QVERIFY(takeTrendSnapshot(**Database::open(dir.path(), trendDatabase()), snapshot.path()));
        const auto database = Database::open(dir.path());
        auto manifest = takeSnapshot(**database, snapshot.path());
        QVERIFY(manifest);
        manifest->program = u"1.2"_s;
        manifest->made = QDateTime::fromMSecsSinceEpoch(nowMs, QTimeZone::utc());
        manifest->madeBy = u"Anna"_s;
        const BackupParts parts{bytesOf(at("settings.ini")), bytesOf(at("recipe.json")),
                                bytesOf(at("working_copy.json"))};
        QVERIFY(writeBackup(backup, *manifest, snapshot.path(), parts));
    }

    // Returns the names of the recipes and users, and the rows of the trail, if all are linked.
    [[nodiscard]] QString contents() const
    {
        const auto database = Database::open(dir.path());
        QStringList words;
        const QList<RecipeVersion> recipes =
            RecipeLibrary(**database).newest().value_or(QList<RecipeVersion>());
        for (const RecipeVersion& each : recipes)
            words << QString::fromStdString(each.recipe.name);
        const QList<User> people = users(**database).value_or(QList<User>());
        for (const User& each : people)
            words << each.name;
        const auto check = verifyChain(**database);
        words << QString::number(check->rows());
        if (check->fault() != ChainCheck::Fault::None)
            words << u"broken"_s;
        const auto stored = fromJson(bytesOf(at("recipe.json")), {});
        words << (stored ? QString::fromStdString(stored->name) : u"?"_s);
        words << QString::fromUtf8(bytesOf(at("settings.ini")));
        words.removeDuplicates();
        return words.join(u' ');
    }

    [[nodiscard]] FinishedRestore finish() const { return finishRestore(dir.path(), at("settings.ini")); }

    [[nodiscard]] std::map<QString, QByteArray> files() const
    {
        std::map<QString, QByteArray> found;
        QDirIterator it(dir.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            const QString path = it.next();
            found[path] = QCryptographicHash::hash(bytesOf(path), QCryptographicHash::Sha256);
        }
        return found;
    }
};

// Writes a backup with another manifest.
void rewriteText(const QString& path, const std::function<void(QByteArray&)>& change)
{
    auto archive = ArchiveReader::open(path);
    QByteArray manifest = *archive->read(u"manifest.json"_s, 100'000);
    change(manifest);
    QList<ArchiveEntry> entries{{u"manifest.json"_s, manifest, {}}};
    for (const char* name : {"campanel.sqlite", "campanel.sqlite.audit", "settings.ini", "recipe.json",
                             "working_copy.json", "trends.sqlite"})
        entries << ArchiveEntry{
            QString::fromLatin1(name), *archive->read(QString::fromLatin1(name), 100'000'000), {}};
    QFile::remove(path);
    QVERIFY(writeArchive(path, entries));
}

void rewrite(const QString& path, const std::function<void(QJsonObject&)>& change)
{
    rewriteText(path, [&change](QByteArray& manifest) {
        QJsonObject json = QJsonDocument::fromJson(manifest).object();
        change(json);
        manifest = QJsonDocument(json).toJson();
    });
}

// Changes a database in a backup like somebody who has SQLite, and makes the manifest fit.
void alter(const QString& backup, const QString& database, const QStringList& statements)
{
    const QTemporaryDir parts;
    auto manifest = unpackBackup(backup, parts.path());
    QVERIFY(manifest);
    {
        QSqlDatabase file = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"alter"_s);
        file.setDatabaseName(parts.filePath(database));
        QVERIFY(file.open());
        for (const QString& statement : statements) {
            QSqlQuery query(file);
            QVERIFY2(query.exec(statement), qPrintable(statement));
        }
        auto counted = file.exec(u"SELECT (SELECT count(*) FROM user WHERE deleted = 0)"_s);
        if (counted.next())
            manifest->users = counted.value(0).toInt();
    }
    QSqlDatabase::removeDatabase(u"alter"_s);
    manifest->parts.clear();
    QVERIFY(QFile::remove(backup));
    QVERIFY(
        writeBackup(backup, *manifest, parts.path(),
                    {bytesOf(parts.filePath(u"settings.ini"_s)), bytesOf(parts.filePath(u"recipe.json"_s)),
                     bytesOf(parts.filePath(u"working_copy.json"_s))}));
}

// Changes a number of two bytes in all headers of an archive: their places in the header of an entry and in
// the directory at the end.
void patchHeaders(const QString& path, qsizetype inEntry, qsizetype inDirectory, char value)
{
    QByteArray bytes = bytesOf(path);
    for (const auto& [mark, place] : {std::pair("PK\x03\x04", inEntry), {"PK\x01\x02", inDirectory}}) {
        for (qsizetype at = bytes.indexOf(mark); at >= 0; at = bytes.indexOf(mark, at + 1))
            bytes[at + place] = value;
    }
    put(path, bytes);
}

} // namespace

class TestBackup : public QObject {
    Q_OBJECT

private slots:
    void thereAndBack()
    {
        Home home;
        home.fill("Noodles", "Bo", 7);
        QVERIFY2(home.contents().endsWith(u"Anna Bo 10 theme=Noodles"_s), qPrintable(home.contents()));
        const auto manifest = stageRestore(home.backup, home.dir.path());
        QVERIFY(manifest);
        QCOMPARE(manifest->recipes, 1);
        QCOMPARE(manifest->users, 1);
        QCOMPARE(manifest->program, u"1.2"_s);
        QVERIFY(commitRestore(home.dir.path(), entryOf(u"backup.restored"_s)));
        const FinishedRestore finished = home.finish();
        QVERIFY2(finished.isDone && finished.problem.isEmpty(), qPrintable(finished.problem));
        QCOMPARE(home.contents(), u"Biscuit Anna 4 theme=Biscuit"_s);
        QCOMPARE(home.measured(), 3);
        QVERIFY(!home.finish().isDone);
        // The earlier data can still be opened.
        const auto before = Database::open(finished.keptIn);
        QCOMPARE(users(**before)->size(), 2);
        QCOMPARE(bytesOf(finished.keptIn + u"/settings.ini"_s), QByteArray("theme=Noodles"));
    }

    // A backup as made before format 2.
    void aBackupWithoutTrendsLeavesThem()
    {
        Home home;
        rewrite(home.backup, [](QJsonObject& json) {
            json[u"formatVersion"] = 1;
            QJsonArray parts = json[u"parts"].toArray();
            parts.removeLast();
            json[u"parts"] = parts;
        });
        home.fill("Noodles", "Bo", 7);
        const auto manifest = stageRestore(home.backup, home.dir.path());
        QVERIFY(manifest);
        QVERIFY(!manifest->hasTrends());
        QVERIFY(commitRestore(home.dir.path(), entryOf(u"backup.restored"_s)));
        QVERIFY(home.finish().isDone);
        QCOMPARE(home.contents(), u"Biscuit Anna 4 theme=Biscuit"_s);
        QCOMPARE(home.measured(), 10);
    }

    void anInterruptedRestoreEndsWhole()
    {
        const std::pair<const char*, const char*> steps[]{
            {"settings.ini", "before-restore/settings.ini"},
            {"restore-ready/settings.ini", "settings.ini"},
            {"campanel.sqlite-wal", "before-restore/campanel.sqlite-wal"},
            {"campanel.sqlite", "before-restore/campanel.sqlite"},
            {"restore-ready/campanel.sqlite", "campanel.sqlite"},
            {"campanel.sqlite.audit", "before-restore/campanel.sqlite.audit"},
            {"restore-ready/campanel.sqlite.audit", "campanel.sqlite.audit"},
            {"recipe.json", "before-restore/recipe.json"},
            {"restore-ready/recipe.json", "recipe.json"},
            {"trends.sqlite", "before-restore/trends.sqlite"},
            {"restore-ready/trends.sqlite", "trends.sqlite"},
            {"working_copy.json", "before-restore/working_copy.json"},
            {"restore-ready/working_copy.json", "working_copy.json"}};
        for (std::size_t done = 0; done <= std::size(steps); ++done) {
            Home home;
            home.fill("Noodles", "Bo", 7);
            QVERIFY(stageRestore(home.backup, home.dir.path()));
            QVERIFY(commitRestore(home.dir.path(), entryOf(u"backup.restored"_s)));
            put(home.at("campanel.sqlite-wal"), "a log that a killed panel has left");
            for (std::size_t i = 0; i < done; ++i)
                QVERIFY2(QFile::rename(home.at(steps[i].first), home.at(steps[i].second)), steps[i].first);
            QVERIFY(home.finish().isDone);
            QCOMPARE(home.contents(), u"Biscuit Anna 4 theme=Biscuit"_s);
            QCOMPARE(home.measured(), 3);
            QVERIFY(QFile::exists(home.at("before-restore/campanel.sqlite-wal")));
            QVERIFY(!QFile::exists(home.at("restore-ready")));
        }
    }

    void whatWasOnlyUnpackedIsForgotten()
    {
        Home home;
        home.fill("Noodles", "Bo", 1);
        const auto before = home.files();
        QVERIFY(stageRestore(home.backup, home.dir.path()));
        QVERIFY(!home.finish().isDone);
        QVERIFY(home.files() == before);
    }

    void refused_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("how");
        using Kind = BackupError::Kind;
        QTest::newRow("not there") << static_cast<int>(Kind::NotReadable) << u"gone"_s;
        QTest::newRow("empty") << static_cast<int>(Kind::NotABackup) << u"empty"_s;
        QTest::newRow("text") << static_cast<int>(Kind::NotABackup) << u"text"_s;
        QTest::newRow("another archive") << static_cast<int>(Kind::NotABackup) << u"zip"_s;
        QTest::newRow("half of it") << static_cast<int>(Kind::Damaged) << u"half"_s;
        QTest::newRow("without its last byte") << static_cast<int>(Kind::Damaged) << u"byte"_s;
        QTest::newRow("another hash") << static_cast<int>(Kind::Damaged) << u"sha256"_s;
        QTest::newRow("another count") << static_cast<int>(Kind::Damaged) << u"recipes"_s;
        QTest::newRow("a key twice") << static_cast<int>(Kind::Damaged) << u"twice"_s;
        QTest::newRow("newer format") << static_cast<int>(Kind::Newer) << u"formatVersion"_s;
        QTest::newRow("newer schema") << static_cast<int>(Kind::Newer) << u"schema"_s;
    }

    void refused()
    {
        QFETCH(int, kind);
        QFETCH(QString, how);
        Home home;
        home.fill("Noodles", "Bo", 1);
        const QByteArray whole = bytesOf(home.backup);
        if (how == u"gone")
            QVERIFY(QFile::remove(home.backup));
        else if (how == u"empty")
            put(home.backup, {});
        else if (how == u"text")
            put(home.backup, "angle,position\n0,0\n");
        else if (how == u"half" || how == u"byte")
            put(home.backup, whole.chopped(how == u"half" ? whole.size() / 2 : 1));
        else if (how == u"zip") {
            QVERIFY(QFile::remove(home.backup));
            QVERIFY(writeArchive(home.backup, {{u"holiday.txt"_s, "sun", {}}}));
        } else if (how == u"twice") {
            rewriteText(home.backup,
                        [](QByteArray& text) { text.replace("\"users\":", "\"users\": 1, \"users\":"); });
        } else {
            rewrite(home.backup, [&how](QJsonObject& json) {
                if (how == u"sha256") {
                    const QString text = QString::fromUtf8(QJsonDocument(json).toJson());
                    const qsizetype at = text.indexOf(u"sha256"_s) + 12;
                    QString changed = text;
                    changed[at] = changed[at] == u'a' ? u'b' : u'a';
                    json = QJsonDocument::fromJson(changed.toUtf8()).object();
                } else {
                    json[how] = json[how].toInt() + 1;
                }
            });
        }
        const auto before = home.files();
        const auto staged = stageRestore(home.backup, home.dir.path());
        QVERIFY(!staged);
        QCOMPARE(static_cast<int>(staged.error().kind), kind);
        const QString sentence = BackupErrorText::describe(staged.error());
        QVERIFY2(sentence.contains(u"day.zip"_s) && sentence.endsWith(u"Nothing was changed."),
                 qPrintable(sentence));
        QVERIFY(home.files() == before);
    }

    void databaseBringsNothingOfItsOwn_data()
    {
        QTest::addColumn<QString>("database");
        QTest::addColumn<QString>("statement");
        const QString main = u"campanel.sqlite"_s;
        QTest::newRow("trigger that ends the wait")
            << main
            << u"CREATE TRIGGER x AFTER UPDATE ON user BEGIN UPDATE user SET locked_until_ms = 0; END"_s;
        QTest::newRow("trigger that makes a user visible")
            << main << u"CREATE TRIGGER x AFTER INSERT ON alarm BEGIN UPDATE user SET deleted = 0; END"_s;
        QTest::newRow("view") << main << u"CREATE VIEW x AS SELECT * FROM user"_s;
        QTest::newRow("table") << main << u"CREATE TABLE x (y)"_s;
        QTest::newRow("index") << main << u"CREATE INDEX x ON audit (who)"_s;
        QTest::newRow("column") << main << u"ALTER TABLE user ADD COLUMN x DEFAULT 1"_s;
        QTest::newRow("column that is computed")
            << main << u"ALTER TABLE user ADD COLUMN x GENERATED ALWAYS AS (abs(level)) VIRTUAL"_s;
        QTest::newRow("trigger of the trends")
            << u"trends.sqlite"_s << u"CREATE TRIGGER x AFTER INSERT ON bag BEGIN DELETE FROM bag; END"_s;
    }

    void databaseBringsNothingOfItsOwn()
    {
        QFETCH(QString, database);
        QFETCH(QString, statement);
        Home home;
        alter(home.backup, database, {statement});
        const auto before = home.files();
        const auto staged = stageRestore(home.backup, home.dir.path());
        QVERIFY(!staged);
        QCOMPARE(static_cast<int>(staged.error().kind), static_cast<int>(BackupError::Kind::Foreign));
        const QString sentence = BackupErrorText::describe(staged.error());
        QVERIFY2(sentence.contains(u"day.zip"_s) && sentence.endsWith(u"Nothing was changed."),
                 qPrintable(sentence));
        QVERIFY(home.files() == before);
    }

    // A table in the place of which a view stands, and one that another program has made anew.
    void tablesAreThoseOfThePanel()
    {
        for (const QStringList& statements :
             {QStringList{u"ALTER TABLE audit_start RENAME TO x"_s,
                          u"CREATE VIEW audit_start AS SELECT * FROM x"_s},
              QStringList{
                  u"DROP TABLE audit_start"_s,
                  u"CREATE TABLE audit_start (sequence INTEGER NOT NULL, hash BLOB NOT NULL, more)"_s}}) {
            Home home;
            alter(home.backup, u"campanel.sqlite"_s, statements);
            const auto staged = stageRestore(home.backup, home.dir.path());
            QVERIFY(!staged);
            QCOMPARE(static_cast<int>(staged.error().kind), static_cast<int>(BackupError::Kind::Foreign));
        }
    }

    void usersOfABackupCanSetUpThePanel_data()
    {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<bool>("hasPins"); // the panel that is restored
        QTest::addColumn<int>("kind");     // -1: restored
        const int noUsers = static_cast<int>(BackupError::Kind::NoUsers);
        const int noService = static_cast<int>(BackupError::Kind::NoService);
        const QString remove = u"DELETE FROM user"_s;
        const QString demote = u"UPDATE user SET level = 2"_s;
        QTest::newRow("none, for a panel with PINs") << remove << true << noUsers;
        QTest::newRow("removed, for a panel with PINs")
            << u"UPDATE user SET deleted = 1"_s << true << noUsers;
        QTest::newRow("none, for a new panel") << remove << false << -1;
        QTest::newRow("technicians alone") << demote << true << noService;
        QTest::newRow("technicians alone, for a new panel") << demote << false << noService;
        QTest::newRow("no PIN that can be checked") << u"UPDATE user SET pin = 'x'"_s << true << noService;
    }

    void usersOfABackupCanSetUpThePanel()
    {
        QFETCH(QString, statement);
        QFETCH(bool, hasPins);
        QFETCH(int, kind);
        Home home;
        alter(home.backup, u"campanel.sqlite"_s, {statement});
        const QTemporaryDir fresh;
        const auto staged = stageRestore(home.backup, hasPins ? home.dir.path() : fresh.path());
        QCOMPARE(staged ? -1 : static_cast<int>(staged.error().kind), kind);
        if (!staged)
            QVERIFY(BackupErrorText::describe(staged.error()).endsWith(u"Nothing was changed."));
    }

    void anArchiveThatWasPackedAgain()
    {
        const Home home;
        auto archive = ArchiveReader::open(home.backup);
        QList<ArchiveEntry> entries;
        for (const char* name : {"manifest.json", "campanel.sqlite", "campanel.sqlite.audit", "settings.ini",
                                 "recipe.json", "working_copy.json", "trends.sqlite"})
            entries << ArchiveEntry{u"CamPanel backup 1/"_s + QLatin1String(name),
                                    *archive->read(QString::fromLatin1(name), 100'000'000),
                                    {}};
        const QString again = home.stick.filePath(u"again.zip"_s);
        QVERIFY(writeArchive(again, entries));
        QVERIFY(readManifest(again));
        const QTemporaryDir target;
        QVERIFY(unpackBackup(again, target.path()));
        QCOMPARE(bytesOf(target.filePath(u"settings.ini"_s)), QByteArray("theme=Biscuit"));
        patchHeaders(again, 6, 8, 1); // the flag of a password
        QCOMPARE(static_cast<int>(readManifest(again).error().kind),
                 static_cast<int>(BackupError::Kind::Encrypted));
        QCOMPARE(static_cast<int>(unpackBackup(again, target.path()).error().kind),
                 static_cast<int>(BackupError::Kind::Encrypted));
        const QString other = home.stick.filePath(u"other.zip"_s);
        QVERIFY(QFile::copy(home.backup, other));
        patchHeaders(other, 8, 10, 9); // Deflate64
        QCOMPARE(static_cast<int>(readManifest(other).error().kind),
                 static_cast<int>(BackupError::Kind::OtherMethod));
    }

    // Its sizes are true: a database of zeros, a thousand times as large as the archive.
    void aBombIsNotUnpacked()
    {
        const Home home;
        QTemporaryDir snapshot;
        put(snapshot.filePath(u"campanel.sqlite"_s), {});
        QVERIFY(QFile::resize(snapshot.filePath(u"campanel.sqlite"_s), 30'000'000));
        put(snapshot.filePath(u"campanel.sqlite.audit"_s), {});
        put(snapshot.filePath(u"trends.sqlite"_s), {});
        BackupManifest manifest;
        manifest.made = QDateTime::fromMSecsSinceEpoch(nowMs).toUTC();
        const QString bomb = home.stick.filePath(u"bomb.zip"_s);
        QVERIFY(writeBackup(bomb, manifest, snapshot.path(), {}));
        QVERIFY(QFileInfo(bomb).size() < 300'000);
        const QTemporaryDir target;
        const auto unpacked = unpackBackup(bomb, target.path());
        QVERIFY(!unpacked);
        QCOMPARE(static_cast<int>(unpacked.error().kind), static_cast<int>(BackupError::Kind::Damaged));
        QVERIFY(QDir(target.path()).isEmpty());
    }

    void sizesAreCheckedBeforeAnythingIsUnpacked_data()
    {
        QTest::addColumn<QString>("part");
        QTest::addColumn<qint64>("bytes");
        QTest::addColumn<qint64>("freeBytes");
        QTest::addColumn<int>("kind"); // -1: accepted
        constexpr qint64 room = 10'000'000'000;
        const int damaged = static_cast<int>(BackupError::Kind::Damaged);
        const int full = static_cast<int>(BackupError::Kind::NotWritable);
        QTest::newRow("database") << u"campanel.sqlite"_s << qint64{900'000'000} << room << -1;
        QTest::newRow("large database") << u"campanel.sqlite"_s << qint64{1'000'000'001} << room << damaged;
        QTest::newRow("large trends") << u"trends.sqlite"_s << qint64{1'000'000'001} << room << damaged;
        QTest::newRow("large recipe") << u"recipe.json"_s << qint64{1'000'001} << room << damaged;
        QTest::newRow("large settings") << u"settings.ini"_s << qint64{1'000'001} << room << damaged;
        QTest::newRow("large trail") << u"campanel.sqlite.audit"_s << qint64{10'001} << room << damaged;
        QTest::newRow("less than nothing") << u"recipe.json"_s << qint64{-1} << room << damaged;
        QTest::newRow("no number at all")
            << u"recipe.json"_s << std::numeric_limits<qint64>::max() << room << damaged;
        QTest::newRow("no room") << u"campanel.sqlite"_s << qint64{900'000'000} << qint64{900'000'000}
                                 << full;
    }

    void sizesAreCheckedBeforeAnythingIsUnpacked()
    {
        QFETCH(QString, part);
        QFETCH(qint64, bytes);
        QFETCH(qint64, freeBytes);
        QFETCH(int, kind);
        BackupManifest manifest;
        manifest.parts << BackupManifest::Part{part, bytes, {}};
        const auto checked = checkSizes(manifest, 100'000'000, freeBytes, u"day.zip"_s);
        QCOMPARE(checked ? -1 : static_cast<int>(checked.error().kind), kind);
    }

    // A changed byte is detected anywhere, or has no effect on the restored data.
    void damagedAnywhere()
    {
        const Home home;
        const QByteArray whole = bytesOf(home.backup);
        const QTemporaryDir sound;
        QVERIFY(unpackBackup(home.backup, sound.path()));
        const unsigned seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        int refusals = 0;
        for (int i = 0; i < 60; ++i) {
            QByteArray bytes = whole;
            const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()));
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            put(home.backup, bytes);
            const QTemporaryDir target;
            if (!unpackBackup(home.backup, target.path())) {
                ++refusals;
                continue;
            }
            for (const char* name :
                 {"campanel.sqlite.audit", "settings.ini", "recipe.json", "working_copy.json"})
                QCOMPARE(bytesOf(target.filePath(QLatin1String(name))),
                         bytesOf(sound.filePath(QLatin1String(name))));
        }
        QVERIFY2(refusals > 45, qPrintable(QString::number(refusals)));
    }
};

CAMPANEL_TEST(TestBackup)

} // namespace test_backup

#include "test_backup.moc"
