// SPDX-License-Identifier: Apache-2.0
// Orders at the panel: the form and what it refuses, the queue, start and end, what a restart of the panel or
// of the controller leaves, and orders that somebody else has started.
#include "order_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_orders {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using modbus::OrderState;
using panel::OrderEntry;
using panel::Orders;
using store::OrderRow;
using State = store::OrderRow::State;

class TestOrders : public QObject {
    Q_OBJECT

private slots:
    void anOrderIsStartedCountedAndComplete()
    {
        OrderRig rig;
        rig.connectRunning();
        QVERIFY(rig.orders->offered());
        QVERIFY(!rig.orders->current().present());
        rig.enter(5000, u"L17"_s, u"4711"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QCOMPARE(rig.counted.number, 1);
        QCOMPARE(rig.counted.quantity, 5000U);
        QCOMPARE(rig.counted.lot, std::string("L17"));
        QVERIFY(rig.waiting().isEmpty());
        QCOMPARE(rig.current().state, State::Active);
        QCOMPARE(rig.current().text, u"4711"_s);
        QCOMPARE(rig.current().recipe, QString::fromStdString(rig.machine.program()->name));
        QCOMPARE(rig.current().tableCrc, rig.image().crc);
        rig.count(1240, 3, 2);
        rig.pass();
        QCOMPARE(rig.orders->current().progress(), u"1,240 of 5,000"_s);
        QCOMPARE(rig.orders->current().rejected(), 3.0);
        QCOMPARE(rig.orders->current().empty(), 2.0);
        QVERIFY(rig.orders->notice().isEmpty());
        rig.count(5000, 3, 2);
        rig.pass();
        QVERIFY(rig.orders->current().complete());
        QCOMPARE(rig.orders->notice(), u"4711 · L17 is complete: 5,000 good bags, 3 rejected, 2 empty."_s);
        rig.orders->dismissNotice();
        QVERIFY(rig.orders->notice().isEmpty());
        QCOMPARE(rig.logged(), QList{rig.current()});
        QCOMPARE(rig.logged()[0].endedMs, rig.wallMs);
        // Nobody told of the film here: it is counted by the bags.
        QCOMPARE(rig.logged()[0].filmMm, qint64(5005) * 250);
        QVERIFY2(rig.orders->current().facts().contains(u"1,251 m of film"_s),
                 qPrintable(rig.orders->current().facts()));
    }

    void theEndFollowsFromTheRate()
    {
        qputenv("TZ", "UTC");
        tzset();
        OrderRig rig;
        rig.connectRunning();
        rig.enter(601, u"L17"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QCOMPARE(rig.machine.live().rateBagsPerMin, 60.0);
        rig.count(1);
        rig.pass();
        const auto end = QDateTime::fromMSecsSinceEpoch(rig.wallMs + 600'000).toUTC();
        QCOMPARE(rig.orders->endText(), end.toString(u"HH:mm"_s));
        rig.link.status.state = modbus::State::Ready;
        rig.pass();
        QCOMPARE(rig.orders->endText(), QString());
    }

    void whatCannotBeAnOrderIsRefused_data()
    {
        QTest::addColumn<double>("quantity");
        QTest::addColumn<QString>("lot");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence"); // a part of it; empty: it is an order
        QTest::newRow("none") << 0.0 << u"L17"_s << QString() << u"how many good bags"_s;
        QTest::newRow("billion") << 1e9 << u"L17"_s << QString() << u"how many good bags"_s;
        QTest::newRow("most") << 1e6 << u"L17"_s << QString() << QString();
        QTest::newRow("long lot") << 1.0 << QString(500, u'x') << QString() << u"500 bytes, at most 40"_s;
        QTest::newRow("40 bytes") << 1.0 << QString(40, u'x') << QString() << QString();
        QTest::newRow("41 bytes of Chinese")
            << 1.0 << QString(13, u'批') + u"ab"_s << QString() << u"41 bytes"_s;
        QTest::newRow("line feed") << 1.0 << u"L1\n7"_s << QString() << u"nobody sees"_s;
        QTest::newRow("control") << 1.0 << u"L17"_s << u"a\u0007b"_s << u"nobody sees"_s;
        QTest::newRow("turned") << 1.0 << u"L17"_s << u"a\u202Eb"_s << u"nobody sees"_s;
        QTest::newRow("comma") << 1.0 << u"L1,7"_s << u"=1+1"_s << QString();
        QTest::newRow("long text") << 1.0 << u"L17"_s << QString(81, u'x') << u"81 characters, at most 80"_s;
        QTest::newRow("no lot") << 1.0 << QString() << QString() << QString();
    }

    void whatCannotBeAnOrderIsRefused()
    {
        QFETCH(double, quantity);
        QFETCH(QString, lot);
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        OrderRig rig;
        rig.connectRunning();
        rig.enter(quantity, lot, text);
        QCOMPARE(rig.orders->add(), sentence.isEmpty());
        QVERIFY2(rig.orders->message().contains(sentence), qPrintable(rig.orders->message()));
        QCOMPARE(rig.orders->message().isEmpty(), sentence.isEmpty());
        QCOMPARE(rig.waiting().size(), sentence.isEmpty() ? 1 : 0);
    }

    void theQueueKeepsItsOrderOverARestart()
    {
        OrderRig rig;
        rig.connectRunning();
        for (const QString& lot : {u"A"_s, u"B"_s, u"C"_s}) {
            rig.enter(12, lot);
            QVERIFY(rig.orders->add());
        }
        rig.orders->raise(2);
        rig.orders->remove(0);
        rig.orders->raise(0); // already the first one
        rig.orders->remove(7);
        QCOMPARE(rig.waiting(), (QStringList{u"C"_s, u"B"_s}));
        rig.restartPanel();
        QCOMPARE(rig.waiting(), (QStringList{u"C"_s, u"B"_s}));
        rig.orders->start(0);
        rig.answer();
        QCOMPARE(rig.waiting(), QStringList{u"B"_s});
        QCOMPARE(rig.current().lot, u"C"_s);
        rig.orders->start(0);
        QVERIFY2(rig.orders->message().contains(u"under way"_s), qPrintable(rig.orders->message()));
        rig.count(12);
        rig.pass();
        rig.orders->start(0);
        rig.answer();
        QCOMPARE(rig.current().lot, u"B"_s);
        QCOMPARE(rig.current().number, 2);
        QCOMPARE(rig.logged().size(), 2);
    }

    void theQueueTakesTwenty()
    {
        OrderRig rig;
        rig.connectRunning();
        for (int i = 0; i < 20; ++i) {
            rig.enter(12, QString::number(i));
            QVERIFY(rig.orders->add());
        }
        QVERIFY(!rig.orders->add());
        QVERIFY2(rig.orders->message().contains(u"full"_s), qPrintable(rig.orders->message()));
        QCOMPARE(rig.waiting().size(), 20);
    }

    void countsWhileThePanelIsOffAreEntered()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s, u"4711"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        rig.count(5);
        rig.pass();
        rig.orders.reset();
        rig.link.becomeLost();
        rig.count(12, 1);
        rig.wallMs += 3'600'000;
        rig.restartPanel();
        QCOMPARE(rig.current().state, State::Active); // as it was left
        rig.connectRunning();
        QCOMPARE(rig.current().state, State::Complete);
        QCOMPARE(rig.current().text, u"4711"_s);
        QCOMPARE(rig.current().rejected, 1);
        QVERIFY(!rig.orders->notice().isEmpty());
        QCOMPARE(rig.logged(), QList{rig.current()});
    }

    void aPanelThatDiesBesideTheCommandFindsItsOrder()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.isAnswering = false;
        rig.enter(12, u"L17"_s, u"4711"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer(); // the controller has it, and the panel does not know
        QCOMPARE(rig.counted.state, OrderState::Active);
        QCOMPARE(rig.waiting(), QStringList{u"L17"_s});
        rig.isAnswering = true;
        rig.restartPanel();
        rig.connectRunning();
        QVERIFY(rig.waiting().isEmpty());
        QCOMPARE(rig.current().text, u"4711"_s);
        QCOMPARE(rig.current().state, State::Active);
    }

    void anOrderFromElsewhereIsEntered()
    {
        OrderRig rig;
        rig.counted = {.state = OrderState::Active,
                       .number = 7,
                       .action = modbus::OrderAction::Message,
                       .quantity = 300,
                       .lot = "L9"};
        rig.count(100);
        rig.connectRunning();
        QCOMPARE(rig.current().number, 7);
        QCOMPARE(rig.current().lot, u"L9"_s);
        QCOMPARE(rig.current().action, OrderRow::Action::Message);
        QCOMPARE(rig.current().good, 100);
        QVERIFY(rig.current().startedBy.isEmpty());
        // Its next one begins before anybody has seen the end of this.
        rig.counted = {.state = OrderState::Active,
                       .number = 8,
                       .action = modbus::OrderAction::Stop,
                       .quantity = 50,
                       .lot = "L10"};
        rig.pass();
        const auto rows = rig.logged();
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[0].state, State::Lost);
        QCOMPARE(rows[0].good, 100);
        QCOMPARE(rows[1].lot, u"L10"_s);
    }

    void aControllerThatHasForgottenLosesTheOrder()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        rig.count(5);
        rig.pass();
        rig.counted = {.state = OrderState::None, .action = modbus::OrderAction::None, .lot = {}};
        rig.pass();
        QCOMPARE(rig.current().state, State::Lost);
        QCOMPARE(rig.current().good, 5);
        // It begins to count at 1 again: that is another order.
        rig.enter(12, u"L18"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QCOMPARE(rig.current().number, 1);
        QCOMPARE(rig.logged().size(), 2);
        QCOMPARE(rig.logged()[0].good, 5);
    }

    void anotherControllerHasItsOwnOrder()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        rig.count(5);
        rig.pass();
        const modbus::OrderStatus first = rig.counted;
        rig.uniqueId = 43;
        rig.counted = {.state = OrderState::None, .action = modbus::OrderAction::None, .lot = {}};
        rig.connectRunning();
        QVERIFY(!rig.orders->current().present());
        rig.uniqueId = 42;
        rig.counted = first;
        rig.count(7);
        rig.connectRunning();
        QCOMPARE(rig.current().lot, u"L17"_s);
        QCOMPARE(rig.current().good, 7);
        QCOMPARE(rig.logged().size(), 1);
    }

    void aRefusedOrderStaysInTheQueue()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.refusal = modbus::Refusal::NoBags;
        rig.enter(12, u"L17"_s);
        QSignalSpy noted(rig.orders.get(), &Orders::noted);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QVERIFY2(rig.orders->message().contains(u"refused"_s), qPrintable(rig.orders->message()));
        QCOMPARE(rig.waiting(), QStringList{u"L17"_s});
        QCOMPARE(rig.orders->queue().row(0).order.number, 0);
        QCOMPARE(noted.size(), 2); // added, and not started
        QVERIFY(noted[1][0].value<store::AuditEntry>().outcome.startsWith(u"refused"_s));
    }

    void endingIsForOperatorsAndInTheTrail()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s);
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        QSignalSpy refused(&rig.machine.accessCheck(), &panel::AccessCheck::refused);
        QVERIFY(!rig.orders->add() && !rig.orders->addAndStart());
        rig.machine.accessCheck().setLevel(panel::Level::Operator, u"Ann"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QCOMPARE(rig.current().startedBy, u"Ann"_s);
        rig.count(5);
        rig.pass();
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        rig.orders->end();
        rig.orders->setCheckedBy(u"Bo"_s);
        QCOMPARE(refused.size(), 4);
        QCOMPARE(rig.counted.state, OrderState::Active);
        rig.machine.accessCheck().setLevel(panel::Level::Operator, u"Ann"_s);
        QSignalSpy noted(rig.orders.get(), &Orders::noted);
        rig.orders->setCheckedBy(u" Bo "_s);
        rig.orders->end();
        rig.answer();
        QCOMPARE(rig.current().state, State::Ended);
        QCOMPARE(rig.current().checkedBy, u"Bo"_s);
        QCOMPARE(noted.size(), 2);
        const auto entry = noted[1][0].value<store::AuditEntry>();
        QCOMPARE(entry.what, u"command.order_end"_s);
        QCOMPARE(entry.object, u"L17"_s);
        QCOMPARE(entry.after, u"5 of 12"_s);
        QCOMPARE(entry.outcome, u"done"_s);
    }

    void theMessageComesOnceBeforeTheEnd()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(100, u"L17"_s);
        rig.orders->entry()->setAction(OrderEntry::Message);
        rig.orders->entry()->messageBefore()->set(20);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        QCOMPARE(rig.counted.action, modbus::OrderAction::Message);
        rig.count(79);
        rig.pass();
        QVERIFY(rig.orders->notice().isEmpty());
        rig.count(81);
        rig.pass();
        QCOMPARE(rig.orders->notice(), u"L17: 19 bags left."_s);
        rig.orders->dismissNotice();
        rig.count(85);
        rig.pass();
        QVERIFY(rig.orders->notice().isEmpty());
    }

    void anOrderOfAnotherRecipeIsNotStarted()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s);
        rig.orders->entry()->setRecipe(u"Waffle 90"_s);
        QVERIFY(!rig.orders->addAndStart());
        QVERIFY2(rig.orders->message().contains(u"This order is for Waffle 90"_s),
                 qPrintable(rig.orders->message()));
        QVERIFY(rig.orders->add()); // it waits
        rig.orders->start(0);
        QVERIFY(!rig.orders->message().isEmpty());
        QCOMPARE(rig.orders->wantedRecipe(), u"Waffle 90"_s);
        QVERIFY(rig.link.requests.isEmpty());
        rig.orders->clearMessage();
        QCOMPARE(rig.orders->wantedRecipe(), QString());
    }

    void anOlderControllerSaysSo()
    {
        OrderRig rig;
        rig.mapMinor = 5;
        rig.connectRunning();
        QVERIFY2(rig.orders->tooOldText().contains(u"1.5"_s), qPrintable(rig.orders->tooOldText()));
        rig.enter(12, u"L17"_s);
        QVERIFY(!rig.orders->addAndStart());
        QCOMPARE(rig.orders->message(), rig.orders->tooOldText());
        QVERIFY(std::ranges::none_of(rig.link.reads, [](const link::ReadRequest& request) {
            return request.address == modbus::orderStatusAddress;
        }));
    }

    void theHistoryHasWhatWasStarted()
    {
        OrderRig rig;
        rig.connectRunning();
        rig.enter(12, u"L17"_s);
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        rig.enter(12, u"L18"_s);
        QVERIFY(rig.orders->add());
        rig.orders->history()->setWatched(true);
        rig.settle();
        QCOMPARE(rig.orders->history()->rows()->count(), 1);
        rig.count(12);
        rig.pass();
        QCOMPARE(rig.orders->history()->rows()->row(0).stateText(), u"Complete"_s);
        rig.orders->start(0);
        rig.answer();
        QCOMPARE(rig.orders->history()->rows()->count(), 2);
        QCOMPARE(rig.orders->history()->rows()->row(0).title(), u"L18"_s);
    }
};

CAMPANEL_TEST(TestOrders)

} // namespace test_orders

#include "test_orders.moc"
