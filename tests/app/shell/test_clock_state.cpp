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
using campanel::shell::clockState;
using State = campanel::store::ClockState;

class TestClockState : public QObject {
    Q_OBJECT

private slots:
    void states_data()
    {
        QTest::addColumn<QByteArrayList>("hardwareClocks");
        QTest::addColumn<bool>("isSynchronized");
        QTest::addColumn<State>("state");
        QTest::newRow("no hardware clock, no server") << QByteArrayList{} << false << State::NotSet;
        QTest::newRow("time server") << QByteArrayList{} << true << State::Proven;
        QTest::newRow("hardware clock") << QByteArrayList{"1\n"} << false << State::Unproven;
        QTest::newRow("both") << QByteArrayList{"1\n"} << true << State::Proven;
        QTest::newRow("hardware clock without a battery") << QByteArrayList{"0\n"} << false << State::NotSet;
        QTest::newRow("the second one") << QByteArrayList{"0\n", "1\n"} << false << State::Unproven;
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
        QTEST(clockState([isSynchronized] { return isSynchronized; }, folder.path()), "state");
    }

    void noFolder()
    {
        QCOMPARE(clockState([] { return false; }, u"/nonexistent"_s), State::NotSet);
    }
};

CAMPANEL_TEST(TestClockState)

} // namespace test_clock_state

#include "test_clock_state.moc"
