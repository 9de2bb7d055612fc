// SPDX-License-Identifier: Apache-2.0
// The log of orders: the queue and its order, rewriting, what is forgotten, an update of the database, CSV.
#include "app/store/database/clock_mark.h"
#include "app/store/logs/order_log.h"
#include "tests/support/earlier_schema.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

namespace test_order_log {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using State = OrderRow::State;

namespace {

constexpr qint64 now = 1'795'000'000'000;
constexpr qint64 year = 31'557'600'000;

OrderRow order(qint64 id, State state = State::Complete, qint64 startedMs = now)
{
    OrderRow row;
    row.id = id;
    row.number = static_cast<int>(id);
    row.controller = u"2a"_s;
    row.text = u"4711"_s;
    row.lot = u"L17"_s;
    row.recipe = u"Biscuit 250"_s;
    row.version = 3;
    row.tableCrc = 0xC0FFEE;
    row.quantity = 5000;
    row.action = OrderRow::Action::Message;
    row.messageBefore = 20;
    row.state = state;
    row.good = 1240;
    row.rejected = 3;
    row.empty = 2;
    row.cut = 1246;
    row.filmMm = 311'500;
    row.startedMs = startedMs;
    row.startedBy = u"Ann"_s;
    row.checkedBy = u"Bo"_s;
    return row;
}

OrderRow waiting(const QString& lot)
{
    OrderRow row;
    row.lot = lot;
    row.quantity = 12;
    return row;
}

QStringList lots(const QList<OrderRow>& rows)
{
    QStringList all;
    for (const OrderRow& row : rows)
        all << row.lot;
    return all;
}

} // namespace

class TestOrderLog : public QObject {
    Q_OBJECT

private slots:
    void anOrderIsWrittenAgainAndReadBack()
    {
        const QTemporaryDir folder;
        OrderRow row = order(1, State::Active);
        {
            const auto database = *Database::open(folder.path());
            QVERIFY(!OrderLog::begin(*database, {})->last);
            QVERIFY(OrderLog::write(*database, {{row}, {}}));
            row.good = 5000;
            row.state = State::Complete;
            row.endedMs = now + 60'000;
            QVERIFY(OrderLog::write(*database, {{row}, {}}));
        }
        const auto database = *Database::open(folder.path());
        const auto start = *OrderLog::begin(*database, u"2a"_s);
        QCOMPARE(start.last, row);
        QCOMPARE(start.lastId, 1);
        QVERIFY(!OrderLog::begin(*database, u"2b"_s)->last);
        QCOMPARE(OrderLog::begin(*database, u"2b"_s)->lastId, 1);
    }

    void theQueueKeepsItsOrderBesideTheLog()
    {
        const QTemporaryDir folder;
        {
            const auto database = *Database::open(folder.path());
            QVERIFY(OrderLog::write(*database, {{order(1)}, QList{waiting(u"A"_s), waiting(u"B"_s)}}));
            QVERIFY(
                OrderLog::write(*database, {{}, QList{waiting(u"B"_s), waiting(u"C"_s), waiting(u"A"_s)}}));
        }
        const auto database = *Database::open(folder.path());
        const auto start = *OrderLog::begin(*database, {});
        QCOMPARE(lots(start.queue), (QStringList{u"B"_s, u"C"_s, u"A"_s}));
        QCOMPARE(start.queue.first().id, -1);
        QCOMPARE(start.last, order(1));
        // The first of the queue starts: it is in the log, and the queue has moved up, or nothing has
        // changed.
        QVERIFY(OrderLog::write(*database, {{order(2, State::Active)}, start.queue.mid(1)}));
        QCOMPARE(lots(OrderLog::begin(*database, {})->queue), (QStringList{u"C"_s, u"A"_s}));
        // The history has only what was started.
        QCOMPARE(orderTable().page(*database, 0, 10, {.fromMs = 1})->size(), 2);
    }

    void theOldestOrdersGo()
    {
        const auto database = Database::inMemory();
        constexpr qint64 capacity = 50;
        QVERIFY(OrderLog::write(*database, {{}, QList{waiting(u"A"_s)}}, capacity));
        QVERIFY(OrderLog::write(*database, {{order(1, State::Active)}, {}}, capacity));
        for (qint64 id = 2; id <= 120; ++id)
            QVERIFY(OrderLog::write(*database, {{order(id)}, {}}, capacity));
        const auto rows = *orderTable().page(*database, 0, 1000, {.fromMs = 1});
        QCOMPARE(rows.size(), capacity + 1);
        QCOMPARE(rows.first().id, 120);
        QCOMPARE(rows.last(), order(1, State::Active)); // it is not over
        QCOMPARE(lots(OrderLog::begin(*database, {})->queue), QStringList{u"A"_s});
    }

    void whatIsOlderThanFiveYearsGoes()
    {
        const auto database = Database::inMemory();
        QVERIFY(OrderLog::write(*database, {{order(1, State::Complete, now - 6 * year),
                                             order(2, State::Complete, now - 4 * year), order(3)},
                                            {}}));
        QCOMPARE(orderTable().page(*database)->size(), 2);
        OrderRow ahead = order(4, State::Complete, now + 30 * year);
        ahead.isClockDoubtful = true;
        QVERIFY(OrderLog::write(*database, {{ahead}, {}}));
        QVERIFY2(orderTable().page(*database)->size() == 3, "a clock that is wrong deletes nothing");
    }

    void aDatabaseOfAnEarlierVersionGetsTheTable_data()
    {
        QTest::addColumn<int>("before");
        QTest::newRow("without orders") << 9;
        QTest::newRow("without their film") << 10;
    }

    void aDatabaseOfAnEarlierVersionGetsTheTable()
    {
        const QTemporaryDir folder;
        QFETCH(int, before);
        QVERIFY(campanel::test::goBackTo(**Database::open(folder.path()), before));
        const auto database = *Database::open(folder.path());
        QCOMPARE(database->opening().migratedFrom, before);
        QVERIFY(OrderLog::write(*database, {{order(1)}, QList{waiting(u"A"_s)}}));
    }

    void aClockThatRanAheadMarksItsOrders()
    {
        const auto database = Database::inMemory();
        QVERIFY(OrderLog::write(*database, {{order(1), order(2, State::Complete, now + year)}, {}}));
        QVERIFY(noteClockProven(*database, now));
        const auto rows = *orderTable().page(*database);
        QVERIFY(rows[0].isClockDoubtful && !rows[1].isClockDoubtful);
    }

    void theOrdersOfASpanOfTime()
    {
        const auto database = Database::inMemory();
        OrderRow first = order(1, State::Complete, now);
        first.endedMs = now + 1000;
        OrderRow second = order(2, State::Active, now + 2000);
        QVERIFY(OrderLog::write(*database, {{first, second}, QList{waiting(u"A"_s)}}));
        QCOMPARE(*OrderLog::between(*database, now + 500, now + 1500), QList{first});
        QCOMPARE(*OrderLog::between(*database, now + 5000, now + 6000), QList{second});
        QCOMPARE(*OrderLog::between(*database, now - 5000, now + 6000), (QList{first, second}));
        QVERIFY(OrderLog::between(*database, now - 5000, now)->isEmpty());
    }

    void ordersAsCsv()
    {
        const auto database = Database::inMemory();
        OrderRow row = order(1);
        row.text = u"=1+1"_s;
        row.lot = u"L17, night"_s;
        row.endedMs = now + 60'000;
        QVERIFY(OrderLog::write(*database, {{row}, QList{waiting(u"A"_s)}}));
        const QByteArray csv = orderTable().csv(*database, {.fromMs = 1})->bytes;
        QCOMPARE(csv,
                 QByteArray(
                     "id,number,controller,order,lot,recipe,version,table_crc,quantity,action,"
                     "message_before,state,good,rejected,empty,cut,film_mm,started_utc,ended_utc,started_by,"
                     "checked_by,clock\n"
                     "1,1,2a,'=1+1,\"L17, night\",Biscuit 250,3,00c0ffee,5000,message,20,complete,"
                     "1240,3,2,1246,311500,2026-11-18T11:06:40.000Z,2026-11-18T11:07:40.000Z,Ann,Bo,set\n"));
        // Without a filter those that wait are in it too, behind all others.
        QCOMPARE(orderTable().csv(*database, {})->bytes.count('\n'), 3);
    }
};

CAMPANEL_TEST(TestOrderLog)

} // namespace test_order_log

#include "test_order_log.moc"
