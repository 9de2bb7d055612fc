// SPDX-License-Identifier: Apache-2.0
// The audit trail: the chain detects any change of any row and missing rows, and its size is limited.
#include "app/store/logs/audit_log.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_audit_log {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using Fault = ChainCheck::Fault;

namespace {

constexpr int rows = 8;

AuditEntry entryNumber(int i)
{
    return {1'790'000'000'000 + i,
            i % 2 == 0 ? u"Anna"_s : u"李伟"_s,
            i % 4,
            i % 3 == 0 ? u"parameter.write"_s : u"user.login"_s,
            u"parameter.mark_distance"_s,
            QString::number(900 + i),
            QString::number(903 + i),
            QString::number(903 + i),
            u"done"_s};
}

struct Trail {
    QTemporaryDir folder;
    std::unique_ptr<Database> database;

    explicit Trail(int count = rows, const AuditBounds& bounds = {})
    {
        open();
        for (int i = 1; i <= count; ++i) {
            if (!appendAudit(*database, entryNumber(i), bounds))
                qFatal("a row was not taken");
        }
    }
    void open()
    {
        database.reset();
        database = *Database::open(folder.path());
    }
    void tamper(const QString& statement)
    {
        const auto done = database->execute(statement);
        QVERIFY2(done && done->numRowsAffected() > 0, qPrintable(statement));
    }
    [[nodiscard]] ChainCheck check() const { return *verifyChain(*database); }
    [[nodiscard]] QString anchorFile() const { return folder.filePath(u"campanel.sqlite.audit"_s); }
};

void cutOff(Trail& trail, int until)
{
    (void)trail.database->execute(u"DELETE FROM audit_start"_s);
    const QString number = QString::number(until);
    trail.tamper(u"INSERT INTO audit_start SELECT sequence, hash FROM audit WHERE sequence = "_s + number);
    trail.tamper(u"DELETE FROM audit WHERE sequence <= "_s + number);
}

} // namespace

class TestAuditLog : public QObject {
    Q_OBJECT

private slots:
    void whatWasAppendedIsReadNewestFirst()
    {
        Trail trail;
        trail.open();
        const auto page = auditTable().page(*trail.database, 0, 3);
        QVERIFY(page);
        QCOMPARE(page->size(), 3);
        QCOMPARE(page->first().sequence, qint64{rows});
        QCOMPARE(page->first().entry, entryNumber(rows));
        const auto next = auditTable().page(*trail.database, page->last().sequence, 100);
        QCOMPARE(next->size(), rows - 3);
        QCOMPARE(next->last().sequence, qint64{1});
        QCOMPARE(auditTable().page(*trail.database, 0, 100, {.who = u"Anna"_s})->size(), rows / 2);
        QCOMPARE(auditTable().page(*trail.database, 0, 100, {.area = u"parameter"_s})->size(), 2);
        QCOMPARE(auditTable().page(*trail.database, 0, 100, {.area = u"para"_s})->size(), 0);
        QCOMPARE(*auditNames(*trail.database), QStringList({u"Anna"_s, u"李伟"_s}));
    }

    void anUntouchedChainIsUnbroken()
    {
        Trail empty(0);
        QCOMPARE(empty.check().fault(), Fault::None);
        Trail trail;
        trail.open();
        const ChainCheck check = trail.check();
        QCOMPARE(check.fault(), Fault::None);
        QCOMPARE(check.rows(), qint64{rows});
        QCOMPARE(check.losses(), qint64{0});
    }

    void partsOfTheCheckAddUp()
    {
        Trail trail;
        ChainCheck check;
        int parts = 0;
        for (; !check.isOver(); ++parts)
            QVERIFY(check.advance(*trail.database, 3));
        QCOMPARE(parts, 3);
        QCOMPARE(check.fault(), Fault::None);
        QCOMPARE(check.rows(), qint64{rows});
    }

    // Every column of every row, each with a value that another row may have.
    void anyChangeIsFound()
    {
        const QStringList texts{u"who"_s,   u"what"_s,      u"object"_s, u"before"_s,
                                u"after"_s, u"read_back"_s, u"outcome"_s};
        const QStringList numbers{u"sequence"_s, u"time_ms"_s, u"level"_s};
        Trail trail;
        for (int row = 1; row <= rows; ++row) {
            QStringList changes;
            for (const QString& column : texts)
                changes << u"%1 = %1 || 'x'"_s.arg(column) << u"%1 = ''"_s.arg(column);
            for (const QString& column : numbers)
                changes << u"%1 = %1 + 100"_s.arg(column) << u"%1 = %1 - 100"_s.arg(column);
            for (const QString& column : {u"previous"_s, u"hash"_s})
                changes << u"%1 = randomblob(32)"_s.arg(column) << u"%1 = x''"_s.arg(column);
            for (const QString& change : changes) {
                QVERIFY(trail.database->execute(u"BEGIN"_s));
                trail.tamper(u"UPDATE audit SET %1 WHERE sequence = %2"_s.arg(change).arg(row));
                const ChainCheck check = trail.check();
                QVERIFY(trail.database->execute(u"ROLLBACK"_s));
                QVERIFY2(check.fault() != Fault::None, qPrintable(change));
                const bool isMoved = change.startsWith(u"sequence = sequence - ");
                QCOMPARE(check.brokenSequence(), isMoved ? row - 100 : row);
            }
        }
        QCOMPARE(trail.check().fault(), Fault::None);
    }

    void textMovedBetweenColumnsIsFound()
    {
        Trail trail;
        trail.tamper(u"UPDATE audit SET before = before || after, after = '' WHERE sequence = 4"_s);
        QCOMPARE(trail.check().brokenSequence(), qint64{4});
    }

    void missingRowsAreFound()
    {
        for (int row = 1; row <= rows; ++row) {
            Trail trail;
            trail.tamper(u"DELETE FROM audit WHERE sequence = %1"_s.arg(row));
            const ChainCheck check = trail.check();
            QCOMPARE(check.fault(), row == rows ? Fault::MissingAtEnd : Fault::Missing);
            QCOMPARE(check.brokenSequence(), qint64{row});
        }
    }

    void exchangedRowsAreFound()
    {
        Trail trail;
        trail.tamper(u"UPDATE audit SET sequence = 100 WHERE sequence = 3"_s);
        trail.tamper(u"UPDATE audit SET sequence = 3 WHERE sequence = 4"_s);
        trail.tamper(u"UPDATE audit SET sequence = 4 WHERE sequence = 100"_s);
        QCOMPARE(trail.check().fault(), Fault::Altered);
        QCOMPARE(trail.check().brokenSequence(), qint64{3});
    }

    void truncationIsFoundAndStaysTold()
    {
        Trail trail;
        trail.tamper(u"DELETE FROM audit WHERE sequence > 5"_s);
        QCOMPARE(trail.check().fault(), Fault::MissingAtEnd);
        QCOMPARE(trail.check().brokenSequence(), qint64{6});
        trail.open();
        QVERIFY(appendAudit(*trail.database, entryNumber(9)));
        const auto page = auditTable().page(*trail.database, 0, 2);
        QCOMPARE(page->first().sequence, qint64{7});
        QCOMPARE(page->last().entry.what, u"audit.loss"_s);
        QCOMPARE(page->last().entry.object, u"6..8"_s);
        QCOMPARE(trail.check().fault(), Fault::None);
        QCOMPARE(trail.check().losses(), qint64{1});
    }

    // Rows removed from the end, together with the file beside the database.
    void aMissingFileBesideIsToldAndStaysTold()
    {
        for (const QByteArray& left : {QByteArray(), QByteArray("5 abc\n")}) {
            Trail trail;
            trail.tamper(u"DELETE FROM audit WHERE sequence > 5"_s);
            QVERIFY(QFile::remove(trail.anchorFile()));
            QFile unreadable(trail.anchorFile());
            QVERIFY(left.isEmpty() || (unreadable.open(QIODevice::WriteOnly) && unreadable.write(left) > 0));
            unreadable.close();
            QCOMPARE(trail.check().fault(), Fault::EndUnknown);
            QCOMPARE(trail.check().brokenSequence(), qint64{6});
            QVERIFY(appendAudit(*trail.database, entryNumber(9)));
            QCOMPARE(auditTable().page(*trail.database, 7, 1)->first().entry.what, u"audit.end_unknown"_s);
            QCOMPARE(trail.check().fault(), Fault::None);
            QCOMPARE(trail.check().losses(), qint64{1});
        }
        // Killed between the first row and its file.
        Trail young(1);
        QVERIFY(QFile::remove(young.anchorFile()));
        QCOMPARE(young.check().fault(), Fault::None);
    }

    void emptiedTrailIsFound()
    {
        Trail trail;
        trail.tamper(u"DELETE FROM audit"_s);
        QCOMPARE(trail.check().fault(), Fault::MissingAtEnd);
        QCOMPARE(trail.check().brokenSequence(), qint64{1});
    }

    // All rows recomputed: only the file beside the database differs.
    void aRewrittenChainDiffersFromTheAnchor()
    {
        Trail trail;
        const QString anchor = trail.anchorFile();
        QVERIFY(QFile::rename(anchor, anchor + u".kept"_s));
        trail.tamper(u"DELETE FROM audit"_s);
        for (int i = 1; i <= rows; ++i)
            QVERIFY(appendAudit(*trail.database, entryNumber(i == 4 ? 40 : i)));
        QCOMPARE(trail.check().fault(), Fault::None);
        QVERIFY(QFile::remove(anchor) && QFile::rename(anchor + u".kept"_s, anchor));
        QCOMPARE(trail.check().fault(), Fault::Altered);
        QCOMPARE(trail.check().brokenSequence(), qint64{rows});
    }

    // The database was written, but not the file: as after a power cut in between.
    void anOldAnchorIsNoFault()
    {
        Trail trail(5);
        const QString anchor = trail.anchorFile();
        QVERIFY(QFile::copy(anchor, anchor + u".old"_s));
        QVERIFY(appendAudit(*trail.database, entryNumber(6)));
        QVERIFY(QFile::remove(anchor) && QFile::rename(anchor + u".old"_s, anchor));
        QCOMPARE(trail.check().fault(), Fault::None);
        QVERIFY(appendAudit(*trail.database, entryNumber(7)));
        QCOMPARE(trail.check().rows(), qint64{7});
    }

    void oldestRowsGiveWay()
    {
        Trail trail(57, {20, 5, 0, 20});
        const auto kept = auditTable().page(*trail.database, 0, 1000);
        QVERIFY(kept->size() <= 21);
        QVERIFY(kept->size() > 14);
        QVERIFY(kept->last().sequence > 1);
        QCOMPARE(kept->first().entry, entryNumber(57));
        const ChainCheck check = trail.check();
        QCOMPARE(check.fault(), Fault::None);
        QCOMPARE(check.rows(), qint64{kept->size()});
        int told = 0;
        for (const AuditRow& row : *kept)
            told += row.entry.what == u"audit.trimmed" ? 1 : 0;
        QVERIFY(told > 0);
        // The new start is part of the chain.
        trail.tamper(u"UPDATE audit_start SET hash = randomblob(32)"_s);
        QCOMPARE(trail.check().brokenSequence(), kept->last().sequence);
    }

    // Changes by people are kept for five years, whatever the clock does, up to a number that the disk
    // bears.
    void rowsOfTheLastYearsStay()
    {
        constexpr qint64 dayMs = 86'400'000;
        const AuditBounds bounds{20, 5, 30 * dayMs, 60};
        Trail trail(0);
        const auto append = [&](qint64 day, bool isClockDoubtful = false) {
            AuditEntry entry = entryNumber(1);
            entry.timeMs = day * dayMs;
            entry.isClockDoubtful = isClockDoubtful;
            return appendAudit(*trail.database, entry, bounds).has_value();
        };
        const auto kept = [&trail] { return auditTable().page(*trail.database, 0, 1000)->size(); };
        for (qint64 day = 1; day <= 34; ++day)
            QVERIFY(append(day));
        QCOMPARE(kept(), 34); // the fifth row is 29 days old
        QVERIFY(append(4000, true));
        QCOMPARE(kept(), 35);
        QVERIFY(append(35));
        QCOMPARE(kept(), 32); // five less, and a row that says so
        for (int i = 0; i < 100; ++i)
            QVERIFY(append(35));
        QVERIFY2(kept() <= 61, QByteArray::number(kept()));
        QCOMPARE(trail.check().fault(), Fault::None);
    }

    // Somebody cuts off the beginning and moves the start of the chain.
    void aBeginningThatWasCutOffIsFound_data()
    {
        QTest::addColumn<int>("written");
        QTest::addColumn<int>("cut");
        QTest::addColumn<qint64>("firstMissing");
        QTest::newRow("the first row") << 8 << 1 << qint64{1};
        QTest::newRow("all but one") << 8 << 7 << qint64{1};
        QTest::newRow("all") << 8 << 8 << qint64{1};
        // After the program itself deleted rows 1 to 5.
        QTest::newRow("more than the program deleted") << 24 << 7 << qint64{6};
        QTest::newRow("also the row that tells of it") << 24 << 21 << qint64{1};
    }

    void aBeginningThatWasCutOffIsFound()
    {
        QFETCH(int, written);
        QFETCH(int, cut);
        QFETCH(qint64, firstMissing);
        Trail trail(written, {20, 5, 0, 20});
        QCOMPARE(trail.check().fault(), Fault::None);
        cutOff(trail, cut);
        const ChainCheck check = trail.check();
        QCOMPARE(check.fault(), Fault::Missing);
        QCOMPARE(check.brokenSequence(), firstMissing);
    }

    // The rows "audit.trimmed" of earlier versions have no hash.
    void aTrailThatAnEarlierVersionShortenedIsUnbroken()
    {
        Trail trail;
        AuditEntry trimmed = entryNumber(9);
        trimmed.what = u"audit.trimmed"_s;
        trimmed.object = u"1..5"_s;
        trimmed.after.clear();
        QVERIFY(appendAudit(*trail.database, trimmed));
        cutOff(trail, 5);
        QCOMPARE(trail.check().fault(), Fault::None);
        cutOff(trail, 6);
        QCOMPARE(trail.check().fault(), Fault::Missing);
    }

    void theHashIsTheOneOfTheDescription()
    {
        // Computed by hand: three numbers of eight bytes, seven texts, 32 zeros.
        AuditEntry entry{2, u"a"_s, 3, u"b"_s, {}, {}, {}, {}, u"ä"_s};
        QByteArray bytes = QByteArray::fromHex("0000000000000001"
                                               "0000000000000002"
                                               "0000000000000003"
                                               "00000001"
                                               "61"
                                               "00000001"
                                               "62"
                                               "00000000"
                                               "00000000"
                                               "00000000"
                                               "00000000"
                                               "00000002"
                                               "c3a4") +
                           QByteArray(32, '\0');
        QCOMPARE(auditHash(1, entry, QByteArray(32, '\0')),
                 QCryptographicHash::hash(bytes, QCryptographicHash::Sha256));
    }
};

CAMPANEL_TEST(TestAuditLog)

} // namespace test_audit_log

#include "test_audit_log.moc"
