// SPDX-License-Identifier: Apache-2.0
// The state of this computer's clock: set by a hardware clock, by a time server, or not at all.
#include "app/shell/clock_state.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_clock_state {

using namespace Qt::StringLiterals;
using campanel::shell::isClockUnset;

class TestClockState : public QObject {
    Q_OBJECT

private slots:
    void states_data()
    {
        QTest::addColumn<QByteArrayList>("hardwareClocks");
        QTest::addColumn<bool>("isSynchronized");
        QTest::addColumn<bool>("isUnset");
        QTest::newRow("no hardware clock, no server") << QByteArrayList{} << false << true;
        QTest::newRow("time server") << QByteArrayList{} << true << false;
        QTest::newRow("hardware clock") << QByteArrayList{"1\n"} << false << false;
        QTest::newRow("hardware clock without a battery") << QByteArrayList{"0\n"} << false << true;
        QTest::newRow("the second one") << QByteArrayList{"0\n", "1\n"} << false << false;
    }

    void states()
    {
        QFETCH(QByteArrayList, hardwareClocks);
        QFETCH(bool, isSynchronized);
        const QTemporaryDir folder;
        for (qsizetype i = 0; i < hardwareClocks.size(); ++i) {
            const QString name = u"rtc%1"_s.arg(i);
            QVERIFY(QDir(folder.path()).mkdir(name));
            QFile file(folder.filePath(name + u"/hctosys"_s));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(hardwareClocks[i]);
        }
        QTEST(isClockUnset([isSynchronized] { return isSynchronized; }, folder.path()), "isUnset");
    }

    void noFolder()
    {
        QVERIFY(isClockUnset([] { return false; }, u"/nonexistent"_s));
    }
};

CAMPANEL_TEST(TestClockState)

} // namespace test_clock_state

#include "test_clock_state.moc"
