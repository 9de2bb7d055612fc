// SPDX-License-Identifier: Apache-2.0
// The database: created, opened again, damaged, full, written by a newer version; the thread that owns it.
#include "app/store/store_thread.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace test_database {

using namespace campanel::store;
using namespace Qt::StringLiterals;

namespace {

std::unique_ptr<Database> opened(const QTemporaryDir& folder)
{
    auto database = Database::open(folder.path());
    return database ? std::move(*database) : nullptr;
}

bool addRecipe(Database& database, const QString& name)
{
    return database.execute(u"INSERT INTO recipe (name) VALUES (?)"_s, {name}).has_value();
}

int recipes(Database& database)
{
    auto counted = database.execute(u"SELECT count(*) FROM recipe"_s);
    return counted && counted->next() ? counted->value(0).toInt() : -1;
}

// Overwrites the middle of the file, which contains pages.
void damage(const QString& path)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    for (qint64 at = 4096; at < file.size(); at += 4096) {
        file.seek(at);
        file.write(QByteArray(2048, '\x5A'));
    }
}

} // namespace

class TestDatabase : public QObject {
    Q_OBJECT

private slots:
    void isMadeAndFoundAgain();
    void transactionIsAllOrNothing();
    void rulesOfTheTablesAreKept();
    void newerSchemaIsLeftAlone();
    void whatIsNotOfThePanelIsAnError();
    void whatAPersonMeasuredIsNone();
    void damagedFileGivesWayToItsCopy();
    void damagedFileWithoutACopyIsKeptBeside();
    void fullDiskLosesNothing();
    void fullDiskIsSaidWhenItOpens();
    void folderThatCannotBeMade();
    void jobsAreDoneInOrderAndBeforeTheEnd();
    void jobsWaitForTheOpening();
    void unopenedStoreStillWorksUntilTheEnd();
};

void TestDatabase::isMadeAndFoundAgain()
{
    const QTemporaryDir folder;
    {
        const auto database = opened(folder);
        QVERIFY(database);
        QVERIFY(database->opening().isNew);
        QVERIFY(addRecipe(*database, u"one"_s));
    }
    const auto database = opened(folder);
    QVERIFY(database && !database->opening().isNew);
    QCOMPARE(recipes(*database), 1);
    auto mode = database->execute(u"PRAGMA synchronous"_s);
    QVERIFY(mode && mode->next());
    QCOMPARE(mode->value(0).toInt(), 2); // FULL
}

void TestDatabase::transactionIsAllOrNothing()
{
    const QTemporaryDir folder;
    const auto database = opened(folder);
    const auto failed = database->transaction([&]() -> tl::expected<void, StoreError> {
        addRecipe(*database, u"one"_s);
        return tl::unexpected(StoreError{StoreError::Kind::Failed, {}, u"no"_s});
    });
    QVERIFY(!failed);
    QCOMPARE(failed.error().detail, u"no"_s);
    QCOMPARE(recipes(*database), 0);
    QVERIFY(database->transaction([&]() -> tl::expected<void, StoreError> {
        addRecipe(*database, u"one"_s);
        return {};
    }));
    QCOMPARE(recipes(*database), 1);
}

void TestDatabase::rulesOfTheTablesAreKept()
{
    const QTemporaryDir folder;
    const auto database = opened(folder);
    QVERIFY(addRecipe(*database, u"Biscuit"_s));
    const auto twice = database->execute(u"INSERT INTO recipe (name) VALUES (?)"_s, {u"BISCUIT"_s});
    QVERIFY(!twice);
    QCOMPARE(twice.error().kind, StoreError::Kind::Refused);
    const auto orphan =
        database->execute(u"INSERT INTO recipe_version VALUES (99, 1, 0, '', 'rotary_cutter', x'00', 0)"_s);
    QVERIFY(!orphan);
    QCOMPARE(orphan.error().kind, StoreError::Kind::Refused);
}

void TestDatabase::newerSchemaIsLeftAlone()
{
    const QTemporaryDir folder;
    QVERIFY(opened(folder)->execute(u"PRAGMA user_version = %1"_s.arg(schemaVersion() + 1)));
    const auto refused = Database::open(folder.path());
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, StoreError::Kind::NewerSchema);
    QVERIFY(!StoreErrorText::describe(refused.error()).isEmpty());
}

// The file stays as it is, and nobody gains rights: the database in its place has the users of the copy.
void TestDatabase::whatIsNotOfThePanelIsAnError()
{
    const QTemporaryDir folder;
    QVERIFY(opened(folder)->execute(
        u"CREATE TRIGGER x AFTER UPDATE ON user BEGIN UPDATE user SET locked_until_ms = 0; END"_s));
    for (const auto& opening :
         {Database::open(folder.path()).map([](const auto&) {}),
          Database::openReadOnly(folder.filePath(u"campanel.sqlite"_s)).map([](const auto&) {})}) {
        QVERIFY(!opening);
        QCOMPARE(opening.error().kind, StoreError::Kind::Foreign);
        QCOMPARE(opening.error().detail, u"trigger x"_s);
    }
    QVERIFY(QDir(folder.path()).entryList({u"*damaged*"_s}).isEmpty());
    StoreThread store(folder.path());
    QSignalSpy spy(&store, &StoreThread::opened);
    store.open();
    QTRY_COMPARE(spy.size(), 1);
    QCOMPARE(spy[0][0].value<StoreThread::Report>().error->kind, StoreError::Kind::Foreign);
}

void TestDatabase::whatAPersonMeasuredIsNone()
{
    const QTemporaryDir folder;
    {
        const auto database = opened(folder);
        QVERIFY(addRecipe(*database, u"one"_s));
        QVERIFY(database->execute(u"ANALYZE"_s));
        // A statement from outside the program cannot rewrite the schema either.
        (void)database->execute(u"PRAGMA writable_schema = ON"_s);
        QVERIFY(!database->execute(u"UPDATE sqlite_schema SET sql = '' WHERE name = 'stop'"_s));
        auto trusted = database->execute(u"PRAGMA trusted_schema"_s);
        QVERIFY(trusted && trusted->next());
        QCOMPARE(trusted->value(0).toInt(), 0);
    }
    QVERIFY(opened(folder));
}

void TestDatabase::damagedFileGivesWayToItsCopy()
{
    const QTemporaryDir folder;
    QString path;
    {
        const auto database = opened(folder);
        path = database->path();
        for (int i = 0; i < 200; ++i)
            QVERIFY(addRecipe(*database, QString::number(i)));
        QVERIFY(database->makeCopy());
        QVERIFY(database->makeCopy()); // replaces the previous one
    }
    damage(path);
    const auto database = opened(folder);
    QVERIFY(database);
    QVERIFY(database->opening().fromCopy);
    QVERIFY(QFile::exists(database->opening().damagedKeptAs));
    QCOMPARE(recipes(*database), 200);
}

void TestDatabase::damagedFileWithoutACopyIsKeptBeside()
{
    const QTemporaryDir folder;
    {
        QFile file(folder.filePath(u"campanel.sqlite"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(10'000, 'x'));
    }
    const auto database = opened(folder);
    QVERIFY(database);
    QVERIFY(!database->opening().fromCopy);
    QCOMPARE(QFileInfo(database->opening().damagedKeptAs).size(), 10'000);
    QCOMPARE(recipes(*database), 0);
}

void TestDatabase::fullDiskLosesNothing()
{
    const QTemporaryDir folder;
    const auto database = opened(folder);
    QVERIFY(addRecipe(*database, u"kept"_s));
    auto pages = database->execute(u"PRAGMA page_count"_s);
    QVERIFY(pages && pages->next());
    const int size = pages->value(0).toInt();
    pages->finish();
    QVERIFY(database->execute(u"PRAGMA max_page_count = %1"_s.arg(size)));
    const auto full = database->transaction([&]() -> tl::expected<void, StoreError> {
        const auto big =
            database->execute(u"INSERT INTO recipe_version VALUES (1, 1, 0, '', 'x', zeroblob(200000), 0)"_s);
        return big ? tl::expected<void, StoreError>() : tl::unexpected(big.error());
    });
    QVERIFY(!full);
    QCOMPARE(full.error().kind, StoreError::Kind::Full);
    QCOMPARE(recipes(*database), 1);
    QVERIFY(database->execute(u"PRAGMA max_page_count = 100000"_s));
    QVERIFY(addRecipe(*database, u"after"_s));
}

// SQLite wants room beside the file even for reading.
void TestDatabase::fullDiskIsSaidWhenItOpens()
{
    const QTemporaryDir folder;
    QVERIFY(addRecipe(*opened(folder), u"kept"_s));
    {
        const campanel::test::FullDisk full(16); // a file can be made, as on a disk
        const auto refused = Database::open(folder.path());
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, StoreError::Kind::Full);
    }
    QCOMPARE(recipes(*opened(folder)), 1);
}

void TestDatabase::folderThatCannotBeMade()
{
    const auto refused = Database::open(u"/proc/no/such/folder"_s);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, StoreError::Kind::CannotOpen);
}

void TestDatabase::jobsAreDoneInOrderAndBeforeTheEnd()
{
    const QTemporaryDir folder;
    QObject context;
    QList<int> counts;
    {
        StoreThread store(folder.path());
        QSignalSpy spy(&store, &StoreThread::opened);
        store.open();
        for (int i = 0; i < 20; ++i)
            store.run(
                &context,
                [i](Database& database) {
                    addRecipe(database, QString::number(i));
                    return recipes(database);
                },
                [&counts](int count) { counts << count; });
        QTRY_COMPARE(counts.size(), 20);
        QCOMPARE(counts.last(), 20);
        QCOMPARE(spy.count(), 1);
        QVERIFY(!spy.first().first().value<StoreThread::Report>().error);
        store.run(
            &context, [](Database& database) { return addRecipe(database, u"last"_s); }, [](bool) {});
    }
    QCOMPARE(recipes(*opened(folder)), 21);
}

void TestDatabase::jobsWaitForTheOpening()
{
    const QTemporaryDir folder;
    {
        StoreThread store(folder.path());
        store.run(
            this, [](Database& database) { return addRecipe(database, u"early"_s); }, [](bool) {});
        QVERIFY(!QFile::exists(folder.filePath(u"campanel.sqlite"_s)));
    }
    QCOMPARE(recipes(*opened(folder)), 1);
}

void TestDatabase::unopenedStoreStillWorksUntilTheEnd()
{
    StoreThread store(u"/proc/no/such/folder"_s);
    QSignalSpy spy(&store, &StoreThread::opened);
    store.open();
    int count = -1;
    store.run(
        this,
        [](Database& database) {
            addRecipe(database, u"one"_s);
            return recipes(database);
        },
        [&count](int value) { count = value; });
    QTRY_COMPARE(count, 1);
    QVERIFY(spy.first().first().value<StoreThread::Report>().error);
}

CAMPANEL_TEST(TestDatabase)

} // namespace test_database

#include "test_database.moc"
