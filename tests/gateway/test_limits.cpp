// SPDX-License-Identifier: Apache-2.0
// The limits of messages from others: lines of the log, messages that wait, connections, and places of
// offers.
#include "app/store/recipes/signed_recipe.h"
#include "gateway/arrivals.h"
#include "gateway/back_off.h"
#include "gateway/log_limit.h"
#include "gateway/mqtt_line.h"
#include "gateway/offer_inbox.h"
#include "tests/gateway/fake_broker.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace test_limits {

using namespace campanel;
using namespace campanel::gateway;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

namespace {

const QString commandTopic = u"spBv1.0/Hall/NCMD/P7"_s;

// An inbox between a broker and a panel of the test.
struct InboxRig {
    QTemporaryDir keys;
    store::SigningKey key = store::newSigningKey(u"Anna Plant"_s).value();
    test::FakeBroker broker;
    QMap<QString, QByteArray> panel;
    int messages = 0;
    bool hasRoom = true;
    QStringList reports;
    OfferInbox inbox{OfferInbox::Kind::Recipe,
                     OfferInbox::recipeTopic(u"Hall"_s),
                     broker,
                     {[this](const plant::OfferMessage& offer) { return take(offer); },
                      [this](LogKind, const QString& sentence) { reports << sentence; }},
                     keys.path()};

    InboxRig()
    {
        QFile file(keys.filePath(u"anna.json"_s));
        if (!file.open(QIODevice::WriteOnly) || file.write(store::publicKeyFile(key)) < 0)
            qFatal("no key");
        file.close();
        inbox.brokerOpened();
    }
    bool take(const plant::OfferMessage& offer)
    {
        if (!hasRoom)
            return false;
        ++messages;
        if (offer.name.isEmpty())
            panel.clear();
        else if (offer.file.isEmpty())
            panel.remove(offer.name);
        else
            panel.insert(offer.name, offer.file);
        return panel.size() <= plant::maxOffers;
    }
    void publish(const QString& name, const QByteArray& file)
    {
        if (!inbox.take(u"campanel/Hall/recipes/"_s + name, file))
            qFatal("not a topic of the offers");
    }
    [[nodiscard]] QByteArray recipe(const QString& name, int version) const
    {
        program::Recipe recipe;
        recipe.name = name.toStdString();
        recipe.version = version;
        return store::signRecipe(recipe, 1'790'000'000'000, 1, key);
    }
};

} // namespace

class TestLimits : public QObject {
    Q_OBJECT

private slots:
    void oneLineOfEachKindAMinute()
    {
        QStringList lines;
        LogLimit::Clock::time_point now{1h};
        LogLimit log([&lines](const QString& line) { lines << line; }, [&now] { return now; });
        for (int i = 0; i < 100'000; ++i)
            log.report(LogKind::Command, u"Refused: %1."_s.arg(i));
        log.report(LogKind::NotACommand, u"Not understood."_s);
        QCOMPARE(lines, (QStringList{u"Refused: 0."_s, u"Not understood."_s}));
        now += 59s;
        log.tick();
        QCOMPARE(lines.size(), 2);
        now += 1s;
        log.tick();
        log.tick();
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines.last(), u"Refused: 99999. (99998 more lines like this one were left out)"_s);
        log.report(LogKind::Command, u"Refused: %1."_s); // the next minute has begun
        QCOMPARE(lines.size(), 3);
        log.flush();
        QCOMPARE(lines.last(), u"Refused: %1."_s);
        now += 10min;
        log.tick();
        log.report(LogKind::Command, u"Refused: again."_s);
        QCOMPARE(lines.last(), u"Refused: again."_s);
    }

    // Fifteen seconds of a line of 100 Mbit/s, whatever the sizes, while nobody reads.
    void whatWaitsIsBounded()
    {
        constexpr unsigned seed = 41;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        Arrivals arrivals;
        const QStringList topics{commandTopic, u"campanel/Hall/rebirth"_s, u"campanel/Hall/recipes/A"_s,
                                 u"spBv1.0/Hall/NBIRTH/P7"_s,
                                 u"campanel/Hall/recipes/"_s + QString(60'000, u'x')};
        qint64 sent = 0;
        for (qsizetype bytes = 0; bytes < 187'000'000; ++sent) {
            const qsizetype size = qsizetype(1) << (random() % 21U);
            (void)arrivals.add({1, topics[qsizetype(random() % 5U)], QByteArray(size, 'x')});
            bytes += size;
            QVERIFY(arrivals.bytes() <=
                    Arrivals::maxBytes + Arrivals::maxCommands * Arrivals::maxCommandBytes);
            QVERIFY(arrivals.messages() <= Arrivals::maxMessages + Arrivals::maxCommands);
        }
        const qsizetype waiting = arrivals.messages();
        QCOMPARE(arrivals.takeDropped(), sent - waiting);
        qsizetype taken = 0;
        while (arrivals.take(1))
            ++taken;
        QCOMPARE(taken, waiting);
        QCOMPARE(arrivals.bytes(), 0);
    }

    // Commands take no place of other messages, and no answer of the broker is ever lost.
    void commandsAreLostFirst()
    {
        Arrivals arrivals;
        for (int i = 0; i < 100'000; ++i)
            (void)arrivals.add({1, commandTopic, "command"});
        QCOMPARE(arrivals.messages(), Arrivals::maxCommands);
        for (int i = 0; i < plant::maxOffers; ++i)
            QVERIFY(!arrivals.add({1, u"campanel/Hall/recipes/%1"_s.arg(i), QByteArray(1'000'001, 'x')}));
        QCOMPARE(arrivals.messages(), Arrivals::maxCommands + plant::maxOffers);
        for (int i = 0; i < 100'000; ++i)
            (void)arrivals.add({1, u"spBv1.0/Hall/NBIRTH/P7"_s, "birth"});
        (void)arrivals.add({1, {}, {}});
        QVERIFY(arrivals.take(1)->topic.isEmpty());
        QCOMPARE(arrivals.take(1)->topic, u"campanel/Hall/recipes/0"_s);
    }

    // A message of one connection is not handled in the next one, nor before that is known.
    void messagesBelongToTheirConnection()
    {
        Arrivals arrivals;
        QVERIFY(arrivals.add({1, u"a"_s, "old"}));
        QVERIFY(!arrivals.add({2, u"a"_s, "new"}));
        (void)arrivals.add({1, {}, {}});
        QVERIFY(!arrivals.take(0));
        QVERIFY(arrivals.add({2, u"b"_s, "new"})); // the reader had found nothing
        QCOMPARE(arrivals.take(2)->bytes, QByteArray("new"));
        QCOMPARE(arrivals.take(2)->topic, u"b"_s);
        QVERIFY(!arrivals.take(2));
        QCOMPARE(arrivals.messages(), 0);
    }

    // A broker that accepts and then closes has a few dozen connections an hour; one that is away is tried
    // often.
    void pausesGrow()
    {
        BackOff pauses(MqttLine::firstPauseMs);
        int connections = 0;
        for (int passedMs = 0; passedMs < 3'600'000; ++connections)
            passedMs += pauses.next(MqttLine::maxAnsweredPauseMs);
        QVERIFY2(connections <= 36, QByteArray::number(connections));
        QCOMPARE(pauses.next(MqttLine::maxPauseMs), MqttLine::maxPauseMs);
        pauses.reset();
        QCOMPARE(pauses.next(MqttLine::maxPauseMs), MqttLine::firstPauseMs);
        for (int i = 0; i < 100; ++i)
            QVERIFY(pauses.next(MqttLine::maxPauseMs) <= MqttLine::maxPauseMs);
    }

    // Texts that anybody may publish have few places; the newest of them are seen.
    void othersDoNotFillTheInbox()
    {
        InboxRig rig;
        rig.publish(u"Biscuit"_s, rig.recipe(u"Biscuit"_s, 3));
        for (int i = 0; i < 100; ++i)
            rig.publish(u"X%1"_s.arg(i), "text");
        rig.inbox.tick();
        QCOMPARE(rig.panel.keys(), (QStringList{u"Biscuit"_s, u"X96"_s, u"X97"_s, u"X98"_s, u"X99"_s}));
        QVERIFY(rig.reports.last().contains(u"X95 is left out"_s));
        // A forged signature, and a copy of a true offer.
        for (int i = 0; i < 100; ++i)
            rig.publish(u"F%1"_s.arg(i), rig.recipe(u"Forged"_s, i + 1).replace("Anna", "Bert"));
        for (int i = 0; i < 100; ++i)
            rig.publish(u"C%1"_s.arg(i), rig.recipe(u"Biscuit"_s, 2));
        for (int i = 0; i < 11; ++i)
            rig.publish(u"R%1"_s.arg(i), rig.recipe(u"Recipe %1"_s.arg(i), 1));
        rig.inbox.tick();
        QCOMPARE(rig.panel.size(), plant::maxOffers);
        QVERIFY(rig.panel.contains(u"Biscuit"_s) && rig.panel.contains(u"R0"_s) &&
                rig.panel.contains(u"F99"_s));
        for (int i = 11; i < 15; ++i) // they take the places of the others
            rig.publish(u"R%1"_s.arg(i), rig.recipe(u"Recipe %1"_s.arg(i), 1));
        rig.inbox.tick();
        QCOMPARE(rig.panel.size(), plant::maxOffers);
        QVERIFY(rig.panel.contains(u"Biscuit"_s) && rig.panel.contains(u"R14"_s) &&
                !rig.panel.contains(u"F99"_s));
        rig.publish(u"Biscuit new"_s, rig.recipe(u"Biscuit"_s, 4)); // its newest version has the place
        rig.inbox.tick();
        QVERIFY(rig.panel.contains(u"Biscuit new"_s) && !rig.panel.contains(u"Biscuit"_s));
        rig.publish(u"X"_s, "text");
        rig.inbox.tick();
        QVERIFY(rig.panel.contains(u"X"_s) || rig.panel.size() == plant::maxOffers);
        QVERIFY(rig.panel.contains(u"Biscuit new"_s));
    }

    // The panel gets the last one of a thousand offers with one name, when it has room.
    void theNewestOfANameIsSent()
    {
        InboxRig rig;
        rig.hasRoom = false;
        for (int i = 0; i < 1000; ++i) {
            rig.publish(u"A"_s, QByteArray::number(i + 1));
            rig.publish(u"B%1"_s.arg(i), "text");
            rig.publish(u"B%1"_s.arg(i), {});
            rig.inbox.tick();
        }
        rig.hasRoom = true;
        rig.inbox.tick();
        QCOMPARE(rig.panel, (QMap<QString, QByteArray>{{u"A"_s, "1000"}}));
        QVERIFY2(rig.messages <= 100, QByteArray::number(rig.messages));
        rig.panel.clear();
        rig.inbox.panelConnected();
        rig.inbox.tick();
        QCOMPARE(rig.panel.value(u"A"_s), QByteArray("1000"));
    }
};

CAMPANEL_TEST(TestLimits)

} // namespace test_limits

#include "test_limits.moc"
