// SPDX-License-Identifier: Apache-2.0
// The operator's messages about a database that is damaged or cannot be opened.
#include "app/panel/records/database_service.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace test_records {

using campanel::panel::DatabaseService;
namespace store = campanel::store;

class TestRecords : public QObject {
    Q_OBJECT

private slots:
    void soundMemoryIsCopiedInSilence()
    {
        const QTemporaryDir folder;
        DatabaseService records(folder.path(), nullptr);
        records.open();
        QTRY_VERIFY(QFile::exists(folder.filePath(QStringLiteral("campanel.sqlite.copy"))));
        QVERIFY(records.notice().isEmpty());
    }

    void damageIsToldUntilDismissed()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("campanel.sqlite")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(9000, 'x')) == 9000);
        file.close();
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("database was damaged")));
        DatabaseService records(folder.path(), nullptr);
        QSignalSpy told(&records, &DatabaseService::noticeChanged);
        records.open();
        QTRY_VERIFY(records.notice().contains(QStringLiteral("damaged")));
        records.dismissNotice();
        QVERIFY(records.notice().isEmpty());
        QCOMPARE(told.count(), 2);
    }

    void missingMemoryIsToldAndRecorded()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("campanel.sqlite"));
        QVERIFY((*store::Database::open(folder.path()))->makeCopy());
        QVERIFY(QFile::remove(path));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("database was missing")));
        {
            DatabaseService records(folder.path(), nullptr);
            records.open();
            QTRY_VERIFY(records.notice().contains(QStringLiteral("last good copy")));
        }
        const auto database = store::Database::open(folder.path());
        const auto rows = store::auditTable().page(**database, 0, 10);
        QVERIFY(rows);
        QCOMPARE(rows->size(), 1);
        QCOMPARE(rows->first().entry.what, QStringLiteral("memory.from_copy"));
    }

    void memoryThatCannotBeOpenedIsTold()
    {
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("cannot be opened")));
        DatabaseService records(QStringLiteral("/proc/no/such/folder"), nullptr);
        records.open();
        QTRY_VERIFY(records.notice().contains(QStringLiteral("new data are lost")));
    }
};

CAMPANEL_TEST(TestRecords)

} // namespace test_records

#include "test_records.moc"
