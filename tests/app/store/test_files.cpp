// SPDX-License-Identifier: Apache-2.0
// Small files: anything but a small regular file is refused at once; a full disk destroys no old file.
#include "app/store/backup/archive.h"
#include "app/store/backup/backup_file.h"
#include "app/store/files/files.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/list_file.h"
#include "app/store/recipes/recipe_file.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

namespace test_files {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using campanel::test::FullDisk;

namespace {

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s", qPrintable(file.errorString()));
}

} // namespace

class TestFiles : public QObject {
    Q_OBJECT

private slots:
    void whatIsNoFileIsRefusedAtOnce_data()
    {
        QTest::addColumn<QString>("path");
        const QString pipe = m_folder.filePath(u"pipe"_s);
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QTest::newRow("pipe") << pipe;
        QTest::newRow("zeros without end") << u"/dev/zero"_s;
        QTest::newRow("folder") << m_folder.path();
        const QString large = m_folder.filePath(u"large"_s);
        put(large, QByteArray(1'000'001, ' '));
        QTest::newRow("large") << large;
        const QString huge = m_folder.filePath(u"huge"_s);
        put(huge, {});
        QVERIFY(QFile::resize(huge, 100'000'000'000)); // sparse
        QTest::newRow("huge") << huge;
    }

    void whatIsNoFileIsRefusedAtOnce()
    {
        QFETCH(QString, path);
        const auto bytes = readBytes(path);
        QVERIFY(!bytes);
        QCOMPARE(static_cast<int>(bytes.error().kind), static_cast<int>(FileError::Kind::NotReadable));
        QVERIFY(!bytes.error().found.isEmpty());
        QVERIFY(!readRecipe(path));
        campanel::profile::Program cam = campanel::profile::PointCamProgram{};
        QVERIFY(!readListCsv(path, cam));
    }

    void theLargestFileIsReadWhole()
    {
        const QString path = m_folder.filePath(u"largest"_s);
        put(path, QByteArray(1'000'000, 'x'));
        QCOMPARE(readBytes(path)->size(), 1'000'000);
    }

    void aFullDiskKeepsTheOldFile()
    {
        const QString path = m_folder.filePath(u"old"_s);
        put(path, "old");
        for (const rlim_t room : {rlim_t{0}, rlim_t{10}}) {
            const FullDisk full(room);
            const auto written = replaceBytes(path, QByteArray(100, 'n'));
            QVERIFY(!written);
            QVERIFY(!written.error().found.isEmpty());
        }
        QCOMPARE(*readBytes(path), QByteArray("old"));
        QVERIFY(replaceBytes(path, "new"));
        QCOMPARE(*readBytes(path), QByteArray("new"));
    }

    void aLinkIsFollowedOnlyWhereItMay()
    {
        const QString target = m_folder.filePath(u"target"_s);
        const QString link = m_folder.filePath(u"link"_s);
        put(target, "content");
        QVERIFY(QFile::link(target, link));
        QCOMPARE(*readBytes(link), QByteArray("content"));
        QVERIFY(!readBytes(link, Links::Refuse));
        QCOMPARE(*readBytes(target, Links::Refuse), QByteArray("content"));
    }

    // A file of any size: openRegular() has no limit, readBytes() has one.
    void aLargeFileIsOpened()
    {
        const QString path = m_folder.filePath(u"larger"_s);
        put(path, QByteArray(1'000'001, 'x'));
        const auto file = openRegular(path);
        QVERIFY(file);
        QCOMPARE((*file)->size(), 1'000'001);
        QVERIFY(!openRegular(m_folder.path()));
        QVERIFY(isRegularOrMissing(path) && isRegularOrMissing(m_folder.filePath(u"none"_s)));
        QVERIFY(!isRegularOrMissing(m_folder.path()));
    }

    void noDatabaseWaitsForAPipe_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("opens");
        QTest::newRow("database") << u"campanel.sqlite"_s << false;
        QTest::newRow("log") << u"campanel.sqlite-wal"_s << false;
        QTest::newRow("index of the log") << u"campanel.sqlite-shm"_s << false;
        QTest::newRow("newest row of the trail") << u"campanel.sqlite.audit"_s << true;
        QTest::newRow("copy") << u"campanel.sqlite.copy"_s << true;
        QTest::newRow("setup marker") << u"campanel.sqlite.setup"_s << true;
        QTest::newRow("trends") << u"trends.sqlite"_s << false;
    }

    void noDatabaseWaitsForAPipe()
    {
        QFETCH(QString, name);
        QFETCH(bool, opens);
        const QTemporaryDir home;
        const QString pipe = home.filePath(name);
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        const bool isTrends = name == trendDatabase().name;
        auto database = Database::open(home.path(), isTrends ? trendDatabase() : mainDatabase());
        QCOMPARE(database.has_value(), opens);
        if (!database)
            QCOMPARE(static_cast<int>(database.error().kind), static_cast<int>(StoreError::Kind::CannotOpen));
        if (opens) {
            (void)appendAudit(**database, {});
            QVERIFY(verifyChain(**database));
            const QTemporaryDir snapshot;
            QVERIFY(takeSnapshot(**database, snapshot.path()));
            (void)(*database)->makeCopy();
        }
        QVERIFY(!ArchiveReader::open(pipe));
    }

    void aPipeIsNotReplaced()
    {
        const QString path = m_folder.filePath(u"kept-pipe"_s);
        QCOMPARE(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
        QVERIFY(!replaceBytes(path, "new"));
        struct stat status = {};
        QCOMPARE(stat(QFile::encodeName(path).constData(), &status), 0);
        QVERIFY(S_ISFIFO(status.st_mode));
    }

    void controlCharactersBecomeVisible()
    {
        QCOMPARE(printable(u"a\x1b[2J\x7f\x9b\r\n\tb 面"_s), u"a\\u001b[2J\\u007f\\u009b\\u000d\n\tb 面"_s);
        QCOMPARE(printable(u"a\u202eb\u2066\u200f\u2028\U000e0041 😀"_s),
                 u"a\\u202eb\\u2066\\u200f\\u2028\\udb40\\udc41 😀"_s);
    }

    void aTextFromElsewhereIsOneShortLine()
    {
        QCOMPARE(oneLine(u" P7   Biscuit  250\n\tP8 \r\u2028\u202e😀\u00a0 面\u0085 "_s),
                 u"P7 Biscuit 250\\u000a\\u0009P8 \\u000d\\u2028\\u202e😀\u00a0面\\u0085"_s);
        QCOMPARE(oneLine({}), QString());
        QCOMPARE(oneLine(QString(80, u'x')), QString(80, u'x'));
        QCOMPARE(oneLine(QString(81, u'x')), QString(80, u'x') + u'…');
        QCOMPARE(oneLine(QString(79, u'x') + u"😀"_s), QString(79, u'x') + u'…');
        QCOMPARE(oneLine(QString(1'000'000, u'\n')).size(), 79);
    }

private:
    QTemporaryDir m_folder;
};

CAMPANEL_TEST(TestFiles)

} // namespace test_files

#include "test_files.moc"
