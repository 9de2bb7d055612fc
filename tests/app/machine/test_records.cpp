// SPDX-License-Identifier: Apache-2.0
// What an operator is told of the panel's memory when it was damaged or cannot be opened.
#include "app/machine/records.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace test_records {

using campanel::machine::Records;

class TestRecords : public QObject {
    Q_OBJECT

private slots:
    void soundMemoryIsCopiedInSilence()
    {
        const QTemporaryDir folder;
        Records records(folder.path(), nullptr);
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
        Records records(folder.path(), nullptr);
        QSignalSpy told(&records, &Records::noticeChanged);
        records.open();
        QTRY_VERIFY(records.notice().contains(QStringLiteral("damaged")));
        records.dismissNotice();
        QVERIFY(records.notice().isEmpty());
        QCOMPARE(told.count(), 2);
    }

    void memoryThatCannotBeOpenedIsTold()
    {
        Records records(QStringLiteral("/proc/no/such/folder"), nullptr);
        records.open();
        QTRY_VERIFY(records.notice().contains(QStringLiteral("nothing is kept")));
    }
};

CAMPANEL_TEST(TestRecords)

} // namespace test_records

#include "test_records.moc"
