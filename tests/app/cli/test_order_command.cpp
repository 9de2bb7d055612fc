// SPDX-License-Identifier: Apache-2.0
// campanelctl order, as a person calls it: an order from its start to its quantity, with a power cut of the
// controller in between.
#include "app/store/logs/order_log.h"
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

namespace test_order_command {

using namespace Qt::StringLiterals;
using namespace campanel;
using namespace campanel::test;

class OrderCommandTest : public QObject {
    Q_OBJECT

private slots:
    void complaints_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("complaint");
        const auto start = [](const QString& quantity, const QString& lot, const QStringList& more = {}) {
            return QStringList{u"start"_s, u"--quantity"_s, quantity, u"--lot"_s, lot} + more;
        };
        QTest::newRow("nothing to do") << QStringList() << QByteArray("start, status, end, list FILE");
        QTest::newRow("no such thing") << QStringList{u"pause"_s} << QByteArray("start, status, end, list FILE");
        QTest::newRow("no quantity") << QStringList{u"start"_s, u"--lot"_s, u"L"_s}
                                     << QByteArray("--quantity");
        for (const char* quantity : {"0", "-5", "1000001", "1000000000", "4294967301", "2.5", "ten", ""})
            QTest::addRow("quantity %s", quantity)
                << start(QString::fromLatin1(quantity), u"L"_s) << QByteArray("--quantity");
        QTest::newRow("no lot") << QStringList{u"start"_s, u"--quantity"_s, u"5"_s} << QByteArray("--lot");
        QTest::newRow("long lot") << start(u"5"_s, QString(500, u'x')) << QByteArray("1 to 40 bytes");
        QTest::newRow("lot of 20 characters and 60 bytes")
            << start(u"5"_s, QString(20, u'批')) << QByteArray("40");
        QTest::newRow("lot of two lines") << start(u"5"_s, u"L1\nL2"_s) << QByteArray("one line");
        QTest::newRow("action") << start(u"5"_s, u"L"_s, {u"--action"_s, u"shout"_s})
                                << QByteArray("none, message, stop");
    }
    void complaints()
    {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, complaint);
        const Result result =
            call(QStringList{u"order"_s} + words + QStringList{u"--port"_s, u"/dev/null"_s});
        QCOMPARE(result.code, int{Usage});
        QVERIFY2(result.complaint.contains(complaint), result.complaint.constData());
        QCOMPARE(result.complaint.count('\n'), 1);
        QVERIFY(result.out.isEmpty());
    }

    void theOrdersOfAPanelAreListed()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"campanel.sqlite"_s);
        const auto list = [&path](const QString& format) {
            return call({u"order"_s, u"list"_s, path, u"--format"_s, format});
        };
        {
            const auto database = *store::Database::open(folder.path());
            store::OrderRow done{.id = 1, .number = 7, .text = u"=1+1"_s, .lot = u"L1,7"_s, .quantity = 12};
            done.state = store::OrderRow::State::Complete;
            done.good = 12;
            done.cut = 12;
            done.startedMs = 1'795'000'000'000;
            const store::OrderRow waiting{.text = u"4712"_s, .quantity = 30};
            QVERIFY(store::OrderLog::write(*database, {{done}, QList{waiting}}));
        }
        const QJsonArray orders = list(u"json"_s).json()[u"orders"_s].toArray();
        QCOMPARE(orders.size(), 2);
        QCOMPARE(orders[0][u"state"_s], u"queued"_s);
        QVERIFY(orders[0][u"started_utc"_s].isNull());
        QCOMPARE(orders[1][u"lot"_s], u"L1,7"_s);
        QCOMPARE(orders[1][u"good"_s], 12);
        const Result text = list(u"text"_s);
        QCOMPARE(text.lines().size(), 3);
        QVERIFY2(text.lines()[2].startsWith("complete  =1+1"), text.out);
        QVERIFY2(list(u"csv"_s).out.contains(",'=1+1,\"L1,7\","), list(u"csv"_s).out);
        const Result missing = call({u"order"_s, u"list"_s, folder.filePath(u"none"_s)});
        QCOMPARE(missing.code, int{File});
        QVERIFY2(missing.complaint.contains("is not a file"), missing.complaint);
    }

    void anOrderEndsTheRun()
    {
        ControllerProcess controller({u"--speed"_s, u"20"_s});
        const QStringList port{u"--port"_s, controller.port()};
        const auto run = [&port](const QStringList& words) {
            const Result result = call(words + port);
            QTest::qCompare(result.code, int{Ok}, result.complaint.constData(), "Ok", __FILE__, __LINE__);
            return result;
        };
        const auto order = [&run] {
            const QJsonObject now = run({u"order"_s, u"status"_s, u"--format"_s, u"json"_s}).json();
            const auto count = [&now](QStringView key) { return now[key].toInt(); };
            [&] {
                QCOMPARE(count(u"good") + count(u"rejected") + count(u"empty") + count(u"on_the_way"),
                         count(u"cut"));
            }();
            return now;
        };
        QCOMPARE(order()[u"state"_s], u"None"_s);
        QVERIFY(order()[u"quantity"_s].isNull());
        run({u"download"_s});
        run({u"order"_s, u"start"_s, u"--quantity"_s, u"150"_s, u"--lot"_s, u"=1+1, Läß"_s});
        const Result second =
            call(QStringList{u"order"_s, u"start"_s, u"--quantity"_s, u"5"_s, u"--lot"_s, u"L"_s} + port);
        QCOMPARE(second.code, int{Refused});
        QVERIFY2(second.complaint.contains("End it first"), second.complaint.constData());
        run({u"start"_s});
        QTRY_VERIFY_WITH_TIMEOUT(order()[u"good"_s].toInt() > 20, 20'000);
        controller.kill();
        controller.start();
        const QJsonObject kept = order();
        QCOMPARE(kept[u"state"_s], u"Active"_s);
        QCOMPARE(kept[u"quantity"_s], 150);
        QCOMPARE(kept[u"lot"_s], u"=1+1, Läß"_s);
        QVERIFY(kept[u"good"_s].toInt() > 20);
        run({u"download"_s}); // it was not saved
        // What is missing behind a start is made up after another.
        for (int starts = 0; starts < 5 && order()[u"state"_s] != u"Complete"_s; ++starts) {
            run({u"start"_s});
            QTRY_VERIFY_WITH_TIMEOUT(
                run({u"status"_s, u"--format"_s, u"json"_s}).json()[u"state"_s] == u"Ready"_s, 60'000);
        }
        const QJsonObject end = order();
        QCOMPARE(end[u"state"_s], u"Complete"_s);
        QCOMPARE(end[u"good"_s], 150);
        QCOMPARE(end[u"on_the_way"_s], 0);
    }

    void anOrderIsEndedEarly()
    {
        const ControllerProcess controller({u"--speed"_s, u"20"_s});
        const QStringList port{u"--port"_s, controller.port()};
        const Result none = call(QStringList{u"order"_s, u"end"_s} + port);
        QCOMPARE(none.code, int{Refused});
        QVERIFY2(none.complaint.contains("not under way"), none.complaint.constData());
        const QStringList start{u"order"_s, u"start"_s, u"--quantity"_s, u"5"_s,
                                u"--lot"_s, u"L"_s,     u"--action"_s,   u"message"_s};
        QCOMPARE(call(start + port).code, int{Ok}); // before any program
        const Result end = call(QStringList{u"order"_s, u"end"_s, u"--format"_s, u"json"_s} + port);
        QCOMPARE(end.code, int{Ok});
        QCOMPARE(end.json()[u"state"_s], u"Ended"_s);
        QCOMPARE(end.json()[u"action"_s], u"message"_s);
    }

    void anOlderControllerCountsNone()
    {
        const ControllerProcess controller({u"--map-minor"_s, u"5"_s});
        const Result result = call({u"order"_s, u"status"_s, u"--port"_s, controller.port()});
        QCOMPARE(result.code, int{Refused});
        QVERIFY2(result.complaint.contains("counts no orders"), result.complaint.constData());
    }
};

CAMPANEL_TEST(OrderCommandTest)

} // namespace test_order_command

#include "test_order_command.moc"
