// SPDX-License-Identifier: Apache-2.0
// The reason that the boot writes when the disk for the data is missing.
#include "app/shell/data_disk.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_data_disk {

using namespace Qt::StringLiterals;
using campanel::shell::diskLost;

class TestDataDisk : public QObject {
    Q_OBJECT

private slots:
    void reasons_data()
    {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QString>("reason");
        QTest::newRow("a line") << QByteArray("/dev/vda3: it is damaged.\n") << u"/dev/vda3: it is damaged"_s;
        QTest::newRow("two lines") << QByteArray("first\nsecond\n") << u"first"_s;
        QTest::newRow("nothing") << QByteArray() << u"?"_s;
        QTest::newRow("too long") << QByteArray(1000, 'x') << QString(199, u'x');
        QTest::newRow("control characters") << QByteArray("a\tb\r\n") << u"a b"_s;
    }

    void reasons()
    {
        QFETCH(QByteArray, written);
        const QTemporaryDir folder;
        QFile file(folder.filePath(u"no-data"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(written);
        file.close();
        QTEST(diskLost(file.fileName()), "reason");
    }

    void noFileIsAGoodDisk() { QCOMPARE(diskLost(u"/nonexistent/no-data"_s), QString()); }
};

CAMPANEL_TEST(TestDataDisk)

} // namespace test_data_disk

#include "test_data_disk.moc"
