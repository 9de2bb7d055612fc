// SPDX-License-Identifier: Apache-2.0
// campanelctl audit verify: intact, altered and truncated trails, and files without a trail.
#include "app/store/backup/backup_file.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/recipes/recipe_json.h"
#include "campanelctl_call.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

namespace test_audit_verify {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace campanel::test;

namespace {

constexpr int rows = 5;

// A panel's database with a trail, closed.
struct Trail {
    QTemporaryDir folder;
    QString path = folder.filePath(u"campanel.sqlite"_s);

    Trail()
    {
        const auto database = store::Database::open(folder.path());
        for (int i = 0; i < rows; ++i)
            QVERIFY(store::appendAudit(
                **database,
                {1'790'000'000'000 + i, u"Anna"_s, 3, u"user.add"_s, u"Bo"_s, {}, {}, {}, u"done"_s}));
    }
    void execute(const QString& statement) const
    {
        QVERIFY((*store::Database::open(folder.path()))->execute(statement));
    }
    // Returns names and contents of all files.
    [[nodiscard]] QMap<QString, QByteArray> contents() const
    {
        QMap<QString, QByteArray> found;
        const QStringList names = QDir(folder.path()).entryList(QDir::Files);
        for (const QString& name : names) {
            QFile file(folder.filePath(name));
            if (file.open(QIODevice::ReadOnly))
                found[name] = file.readAll();
        }
        return found;
    }
    [[nodiscard]] Result verify() const
    {
        return call({u"audit"_s, u"verify"_s, path, u"--format"_s, u"json"_s});
    }
};

} // namespace

class CliAuditTest : public QObject {
    Q_OBJECT

private slots:
    void unbrokenTrail()
    {
        const Trail trail;
        const auto before = trail.contents();
        const Result result = trail.verify();
        QCOMPARE(result.code, Ok);
        QCOMPARE(result.json()[u"verdict"_s].toString(), u"unbroken"_s);
        QCOMPARE(result.json()[u"rows"_s].toInt(), rows);
        QCOMPARE(trail.contents(), before);
    }

    void trailInUse()
    {
        const Trail trail;
        const auto panel = store::Database::open(trail.folder.path());
        QVERIFY(store::appendAudit(**panel, {1, u"Bo"_s, 2, u"user.login"_s, {}, {}, {}, {}, u"done"_s}));
        const Result result = trail.verify();
        QCOMPARE(result.code, Ok);
        QCOMPARE(result.json()[u"rows"_s].toInt(), rows + 1);
    }

    void brokenTrail_data()
    {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<QString>("verdict");
        QTest::addColumn<int>("row");
        QTest::newRow("altered") << u"UPDATE audit SET who = 'Eve' WHERE sequence = 3"_s << u"altered"_s << 3;
        QTest::newRow("taken out") << u"DELETE FROM audit WHERE sequence = 2"_s << u"missing"_s << 2;
        QTest::newRow("cut off") << u"DELETE FROM audit WHERE sequence > 4"_s << u"missing_at_end"_s << 5;
    }
    void brokenTrail()
    {
        QFETCH(QString, statement);
        QFETCH(QString, verdict);
        QFETCH(int, row);
        const Trail trail;
        trail.execute(statement);
        const Result result = trail.verify();
        QCOMPARE(result.code, Refused);
        QCOMPARE(result.json()[u"verdict"_s].toString(), verdict);
        QCOMPARE(result.json()[u"broken_row"_s].toInt(), row);
        QVERIFY2(result.complaint.contains("row " + QByteArray::number(row)), result.complaint);
    }

    void endThatNobodyKnows()
    {
        const Trail trail;
        QVERIFY(QFile::remove(trail.path + u".audit"_s));
        const Result result = trail.verify();
        QCOMPARE(result.code, Refused);
        QCOMPARE(result.json()[u"verdict"_s].toString(), u"end_unknown"_s);
        QVERIFY2(result.complaint.contains("campanel.sqlite.audit"), result.complaint);
    }

    void trailOfABackup()
    {
        const Trail trail;
        const QTemporaryDir snapshot;
        QVERIFY(store::takeTrendSnapshot(**store::Database::open(trail.folder.path(), store::trendDatabase()),
                                         snapshot.path()));
        const QString path = trail.folder.filePath(u"day.zip"_s);
        {
            const auto database = store::Database::open(trail.folder.path());
            auto manifest = store::takeSnapshot(**database, snapshot.path());
            QVERIFY(manifest);
            manifest->made = QDateTime::fromMSecsSinceEpoch(1'790'000'000'000).toUTC();
            const QByteArray recipe = store::toJson({});
            QVERIFY(store::writeBackup(path, *manifest, snapshot.path(), {{}, recipe, recipe}));
        }
        const Result result = call({u"audit"_s, u"verify"_s, path, u"--format"_s, u"json"_s});
        QVERIFY2(result.code == Ok, result.complaint);
        QCOMPARE(result.json()[u"rows"_s].toInt(), rows);
    }

    void filesThatHoldNone_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("not a database\n");
        QTest::newRow("zip") << QByteArray("PK\x03\x04 and no more");
        QTest::newRow("header") << QByteArray("SQLite format 3\0", 16) + QByteArray(4080, '\xff');
    }
    void filesThatHoldNone()
    {
        QFETCH(QByteArray, bytes);
        const QTemporaryDir folder;
        QFile file(folder.filePath(u"x"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        const Result result = call({u"audit"_s, u"verify"_s, file.fileName()});
        QCOMPARE(result.code, File);
        QVERIFY2(result.complaint.contains(file.fileName().toUtf8()), result.complaint);
    }

    void wrongUse()
    {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath(u"pipe"_s);
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QCOMPARE(call({u"audit"_s, u"verify"_s, pipe}).code, File);
        QCOMPARE(call({u"audit"_s, u"verify"_s, u"/no/such/file"_s}).code, File);
        for (const char* words : {"audit", "audit verify", "audit check x", "audit verify a b"})
            QCOMPARE(call(QString::fromLatin1(words)).code, Usage);
    }
};

CAMPANEL_TEST(CliAuditTest)

} // namespace test_audit_verify

#include "test_audit_verify.moc"
