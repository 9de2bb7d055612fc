// SPDX-License-Identifier: Apache-2.0
// A panel whose database was deleted, emptied, damaged or made unreadable: its last good copy replaces it,
// and without a copy nobody gains rights.
#include "app/store/database/setup_marker.h"
#include "app/store/files/folder_lock.h"
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"
#include "app/store/store_thread.h"
#include "app/store/users/user_store.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

namespace test_lost_database {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using Kind = StoreError::Kind;

namespace {

AuditEntry someEntry()
{
    return {1'790'000'000'000, u"Anna"_s, 3, u"user.add"_s, u"Bo"_s, {}, {}, {}, u"done"_s};
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

int recipesIn(Database& database)
{
    return static_cast<int>(RecipeLibrary(database).newest().value_or(QList<RecipeVersion>()).size());
}

// A panel's data folder, by default with users, a recipe, a trail and a copy.
struct Home {
    enum Content { Nothing, WithoutUsers, Whole };

    QTemporaryDir folder;
    QString path = folder.filePath(u"campanel.sqlite"_s);
    QString copy = path + u".copy"_s;

    explicit Home(Content content = Whole)
    {
        if (content == Nothing)
            return;
        const auto database = open();
        campanel::program::Recipe recipe;
        recipe.name = "Biscuit";
        QVERIFY(RecipeLibrary(*database).save(recipe, u"Anna"_s, 1));
        if (content == Whole)
            QVERIFY(addUser(*database, u"Anna"_s, UserLevel::Service, u"hash"_s));
        QVERIFY(appendAudit(*database, someEntry()));
        QVERIFY(database->makeCopy());
    }

    [[nodiscard]] std::unique_ptr<Database> open() const
    {
        auto opened = Database::open(folder.path());
        return opened ? std::move(*opened) : nullptr;
    }
    [[nodiscard]] QStringList files(const char* pattern) const
    {
        return QDir(folder.path()).entryList({QString::fromLatin1(pattern)}, QDir::Files, QDir::Name);
    }
    void execute(const QString& statement) const { QVERIFY(open()->execute(statement)); }
    // Without opening it like a panel.
    void setVersion(const QString& file, const QString& version) const
    {
        QSqlDatabase other = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"other"_s);
        other.setDatabaseName(file);
        QVERIFY(other.open());
        {
            QSqlQuery query(other);
            QVERIFY(query.exec(u"PRAGMA user_version = "_s + version));
        }
        other.close();
        other = {};
        QSqlDatabase::removeDatabase(u"other"_s);
    }
};

} // namespace

class TestLostDatabase : public QObject {
    Q_OBJECT

private slots:
    void missingDatabaseGivesWayToItsCopy_data()
    {
        QTest::addColumn<bool>("isEmptied"); // to zero length; otherwise deleted
        QTest::addColumn<QString>("alsoDeleted");
        QTest::newRow("deleted") << false << QString();
        QTest::newRow("zero length") << true << QString();
        QTest::newRow("deleted with the marker") << false << u".setup"_s;
        QTest::newRow("deleted with the anchor") << false << u".audit"_s;
    }
    void missingDatabaseGivesWayToItsCopy()
    {
        QFETCH(bool, isEmptied);
        QFETCH(QString, alsoDeleted);
        const Home home;
        if (isEmptied)
            QVERIFY(QFile::resize(home.path, 0));
        else
            QVERIFY(QFile::remove(home.path));
        if (!alsoDeleted.isEmpty())
            QVERIFY(QFile::remove(home.path + alsoDeleted));
        const QByteArray copied = bytesOf(home.copy);
        const auto database = home.open();
        QVERIFY(database);
        QVERIFY(database->opening().wasMissing && database->opening().fromCopy);
        QCOMPARE(users(*database)->size(), 1);
        QCOMPARE(recipesIn(*database), 1);
        QCOMPARE(bytesOf(home.copy), copied);
    }

    void newPanelIsNotMissingAnything()
    {
        const Home home(Home::Nothing);
        const auto database = home.open();
        QVERIFY(database->opening().isNew && !database->opening().isReplaced());
        QVERIFY(users(*database) && users(*database)->isEmpty());
        QCOMPARE(readSetupMarker(home.path), SetUp::WithoutPins);
    }

    // The copy is missing too. Nobody gets in without a PIN, not even at a later start, until the panel is
    // restored.
    void panelWithPinsStaysLockedWithoutItsDatabase()
    {
        const Home home;
        QVERIFY(QFile::remove(home.path) && QFile::remove(home.copy));
        for (int start = 0; start < 3; ++start) {
            const auto database = home.open();
            QVERIFY(database);
            QCOMPARE(database->opening().wasMissing, start == 0);
            const auto found = users(*database);
            QVERIFY(!found);
            QCOMPARE(found.error().kind, Kind::PinsLost);
            QVERIFY(StoreErrorText::describe(found.error()).contains(home.path + u".setup"_s));
            QVERIFY(database->makeCopy());
        }
        QVERIFY(QFile::remove(home.path + u".setup"_s));
        QVERIFY(users(*home.open()));
    }

    // Without the marker it is unknown if there were PINs.
    void panelOfAnOlderVersionIsLockedToo()
    {
        const Home home;
        for (const auto suffix : {""_L1, ".setup"_L1, ".copy"_L1})
            QVERIFY(QFile::remove(home.path + suffix));
        QVERIFY(!users(*home.open())); // the newest row of the trail is still known
        QVERIFY(!users(*home.open()));
    }

    void panelWithoutPinsStaysOpenWithoutItsDatabase()
    {
        const Home home(Home::WithoutUsers);
        QVERIFY(QFile::remove(home.path) && QFile::remove(home.copy));
        const auto database = home.open();
        QVERIFY(database->opening().wasMissing && !database->opening().fromCopy);
        QVERIFY(users(*database));
    }

    // Its tables are valid: only the copy shows that there were users.
    void databaseWithoutItsUsersGivesWayToItsCopy()
    {
        const Home home;
        home.execute(u"DELETE FROM user"_s);
        QVERIFY(QFile::remove(home.path + u".setup"_s));
        const auto database = home.open();
        QVERIFY(database->opening().fromCopy);
        QVERIFY(QFile::exists(database->opening().damagedKeptAs));
        QCOMPARE(users(*database)->size(), 1);
    }

    void copyIsNotReplacedBySomethingEmptier()
    {
        const Home home;
        const QByteArray copied = bytesOf(home.copy);
        const auto database = home.open();
        QVERIFY(database->execute(u"DELETE FROM recipe_version"_s));
        QVERIFY(database->makeCopy());
        const QStringList kept = home.files("campanel.sqlite.copy-*");
        QCOMPARE(kept.size(), 1);
        QCOMPARE(bytesOf(home.folder.filePath(kept.first())), copied);
        QVERIFY(appendAudit(*database, someEntry()));
        QVERIFY(database->makeCopy()); // with more data
        QCOMPARE(home.files("campanel.sqlite.copy-*").size(), 1);
    }

    void versionThatIsNoneIsDamage_data()
    {
        QTest::addColumn<QString>("version");
        for (const char* version : {"-1", "-2147483648", "0", "1", "3"})
            QTest::newRow(version) << QString::fromLatin1(version);
    }
    void versionThatIsNoneIsDamage()
    {
        QFETCH(QString, version);
        const Home home;
        home.setVersion(home.path, version);
        {
            const auto database = home.open();
            QVERIFY(database);
            QVERIFY(database->opening().fromCopy);
            QVERIFY(QFile::exists(database->opening().damagedKeptAs));
            QCOMPARE(users(*database)->size(), 1);
        }
        home.setVersion(home.path, version);
        home.setVersion(home.copy, version);
        const auto database = home.open();
        QVERIFY(database);
        QVERIFY(!database->opening().fromCopy);
        QVERIFY(!users(*database));
        QVERIFY(!home.files("campanel.sqlite.copy.damaged-*").isEmpty());
    }

    // One bit of each byte of the header, and all of the version: never a crash, never open to everybody.
    void noBitOfTheHeaderOpensThePanel()
    {
        const Home home;
        QVERIFY(users(*home.open()));
        const QByteArray sound = bytesOf(home.path);
        const QByteArray copy = bytesOf(home.copy);
        for (int bit = 0; bit < 8 * 100; ++bit) {
            const int byte = bit / 8;
            const bool isOfVersion = byte >= 60 && byte < 64;
            if (!isOfVersion && bit % 8 != byte % 8)
                continue;
            QByteArray bytes = sound;
            bytes[byte] = static_cast<char>(bytes[byte] ^ (1 << (bit % 8)));
            for (const QString& each : home.files("*"))
                QFile::remove(home.folder.filePath(each));
            put(home.path, bytes);
            put(home.copy, copy);
            StoreThread store(home.folder.path());
            store.open();
            tl::expected<QList<User>, StoreError> found;
            bool isDone = false;
            store.run(this, &users, [&](const tl::expected<QList<User>, StoreError>& read) {
                found = read;
                isDone = true;
            });
            QTRY_VERIFY2(isDone, qPrintable(QString::number(bit)));
            QVERIFY2(found && found->size() == 1, qPrintable(QString::number(bit)));
        }
    }

    // Both within one second: their names differ.
    void damagedDatabaseAndCopyAreBothKept()
    {
        const Home home;
        put(home.path, QByteArray(9000, 'x'));
        put(home.copy, QByteArray(7000, 'y'));
        const auto database = home.open();
        QVERIFY(database);
        QVERIFY(!database->opening().fromCopy);
        QCOMPARE(bytesOf(database->opening().damagedKeptAs), QByteArray(9000, 'x'));
        const QStringList copies = home.files("campanel.sqlite.copy.damaged-*");
        QCOMPARE(copies.size(), 1);
        QCOMPARE(bytesOf(home.folder.filePath(copies.first())), QByteArray(7000, 'y'));
        QCOMPARE(recipesIn(*database), 0);
    }
    void copyWhoseTablesDoNotFitIsDamagedToo()
    {
        const Home home;
        home.setVersion(home.path, u"2"_s);
        home.setVersion(home.copy, u"2"_s);
        const auto database = home.open();
        QVERIFY(database && database->opening().isReplaced() && !database->opening().fromCopy);
        QCOMPARE(home.files("campanel.sqlite.damaged-*").size(), 1);
        QCOMPARE(home.files("campanel.sqlite.copy.damaged-*").size(), 1);
    }

    // No space for the copy: no empty database is created.
    void fullDiskDoesNotReplaceTheCopy()
    {
        const Home home;
        QVERIFY(QFile::remove(home.path));
        const QByteArray copied = bytesOf(home.copy);
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
        rlimit small = before;
        small.rlim_cur = 8192;
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto refused = Database::open(home.folder.path());
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, handler);
        QVERIFY(!refused);
        QCOMPARE(bytesOf(home.copy), copied);
        const auto database = home.open();
        QVERIFY(database->opening().fromCopy);
        QCOMPARE(users(*database)->size(), 1);
    }

    void usersOfTheCopyAreKnownWhileTheDatabaseIsNot_data()
    {
        QTest::addColumn<bool>("hasCopy");
        QTest::addColumn<bool>("isNewer"); // otherwise it is not a file
        QTest::addRow("newer") << true << true;
        QTest::addRow("newer, no copy") << false << true;
        QTest::addRow("no file") << true << false;
        QTest::addRow("no file, no copy") << false << false;
    }
    void usersOfTheCopyAreKnownWhileTheDatabaseIsNot()
    {
        QFETCH(bool, hasCopy);
        QFETCH(bool, isNewer);
        const Home home;
        if (!hasCopy)
            QVERIFY(QFile::remove(home.copy));
        if (isNewer) {
            home.setVersion(home.path, QString::number(schemaVersion() + 1));
        } else {
            QVERIFY(QFile::remove(home.path));
            QVERIFY(QDir().mkpath(home.path + u"/in the way"_s));
        }
        StoreThread store(home.folder.path());
        QSignalSpy opened(&store, &StoreThread::opened);
        store.open();
        QTRY_COMPARE(opened.count(), 1);
        const auto report = opened[0][0].value<StoreThread::Report>();
        QCOMPARE(report.error.has_value(), true);
        QCOMPARE(report.error->kind, isNewer ? Kind::NewerSchema : Kind::CannotOpen);
        int known = -1;
        store.run(this, &users, [&known](const tl::expected<QList<User>, StoreError>& found) {
            known = found ? static_cast<int>(found->size()) : 0;
        });
        QTRY_COMPARE(known, hasCopy ? 1 : 0);
    }

    void databaseThatIsInUseIsNotDamaged()
    {
        const Home home;
        const auto other = home.open();
        QVERIFY(other->execute(u"PRAGMA locking_mode = EXCLUSIVE"_s));
        QVERIFY(other->execute(u"DELETE FROM alarm"_s));
        QVERIFY(other->execute(u"PRAGMA journal_mode = DELETE"_s));
        QVERIFY(other->execute(u"BEGIN EXCLUSIVE"_s));
        const auto refused = Database::open(home.folder.path());
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, Kind::InUse);
        QVERIFY(home.files("*damaged*").isEmpty());
    }

    void nobodyElseReadsTheFiles()
    {
        const mode_t before = umask(0);
        const Home home;
        const QString deep = home.folder.filePath(u"a/b"_s);
        {
            const auto database = home.open();
            QVERIFY(appendAudit(*database, someEntry()));
            for (const QString& each : home.files("*"))
                QVERIFY2((QFile::permissions(home.folder.filePath(each)) & 0x77) == 0, qPrintable(each));
            QVERIFY(Database::open(deep));
            QCOMPARE(QFile::permissions(deep) & 0x77, QFile::Permissions());
        }
        // Files of an older version.
        for (const QString& each : home.files("*"))
            QVERIFY(QFile::setPermissions(home.folder.filePath(each), QFile::Permissions(0x6644)));
        (void)home.open();
        for (const QString& each : home.files("*"))
            QVERIFY2((QFile::permissions(home.folder.filePath(each)) & 0x77) == 0, qPrintable(each));
        umask(before);
    }

    void folderBelongsToOnePanel()
    {
        const QTemporaryDir folder;
        {
            const FolderLock first(folder.path());
            QVERIFY(!first.isHeldByAnother());
            QVERIFY(FolderLock(folder.path()).isHeldByAnother());
        }
        QVERIFY(!FolderLock(folder.path()).isHeldByAnother());
        QVERIFY(!FolderLock(u"/proc/no/such"_s).isHeldByAnother()); // opening its database will report it
    }
};

CAMPANEL_TEST(TestLostDatabase)

} // namespace test_lost_database

#include "test_lost_database.moc"
