// SPDX-License-Identifier: Apache-2.0
// Orders that the plant offers: what can be taken, once, and why the others cannot.
#include "order_rig.h"
#include "tests/support/test_program.h"

#include "app/store/signed_order.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace test_order_offers {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using store::OrderRow;
using Kind = plant::OfferMessage::Kind;

namespace {

constexpr qint64 signedMs = 1'790'000'000'000;

struct OfferedRig : OrderRig {
    QTemporaryDir keys;
    store::SigningKey key = store::newSigningKey(u"Anna Plant"_s).value();
    OrderRow order{.text = u"4711"_s, .lot = u"L17"_s, .recipe = u"Biscuit 250"_s, .quantity = 5000};

    OfferedRig() { installKey(false); }
    void installKey(bool isWithdrawn) const
    {
        QJsonObject object = QJsonDocument::fromJson(store::publicKeyFile(key)).object();
        object[u"withdrawn"_s] = isWithdrawn;
        QFile file(keys.filePath(u"anna.json"_s));
        if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(object).toJson()) < 0)
            qFatal("no key");
    }
    [[nodiscard]] QByteArray offer(const QString& node = u"Packer 7"_s) const
    {
        return store::signOrder(order, node, signedMs, key);
    }
    void receive(const QByteArray& file, const QString& name = u"a"_s)
    {
        orders->offers()->setTrust(keys.path(), u"Packer 7"_s);
        orders->offers()->takeOffer({name, file, Kind::Order});
        settle();
    }
    [[nodiscard]] panel::OfferRow row() const { return orders->offers()->rows()->rows().value(0); }
};

} // namespace

class TestOrderOffers : public QObject {
    Q_OBJECT

private slots:
    void anOperatorTakesAnOfferOnce()
    {
        OfferedRig rig;
        rig.receive(rig.offer());
        QCOMPARE(rig.orders->offers()->titles(), u"4711 · L17"_s);
        QVERIFY(rig.row().usable);
        QCOMPARE(rig.row().note, u"5,000 bags · Biscuit 250 · The run stops · signed by Anna Plant"_s);
        QVERIFY(rig.waiting().isEmpty());

        QSignalSpy noted(rig.orders.get(), &panel::Orders::noted);
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        rig.orders->addOffered(0);
        QVERIFY(rig.waiting().isEmpty());
        rig.machine.accessCheck().setLevel(panel::Level::Operator, u"Bo"_s);
        rig.orders->addOffered(0);
        rig.settle();
        QCOMPARE(rig.waiting(), QStringList{u"L17"_s});
        const auto entry = noted.last().first().value<store::AuditEntry>();
        QCOMPARE(entry.what, u"order.add"_s);
        QCOMPARE(entry.after, u"5000, signed by Anna Plant"_s);
        rig.settle();
        QVERIFY(!rig.row().usable);
        QVERIFY2(rig.row().note.contains(u"waits in the queue"_s), qPrintable(rig.row().note));
        QVERIFY(rig.orders->offers()->titles().isEmpty());
        rig.orders->addOffered(0);
        rig.orders->addOffered(7);
        QCOMPARE(rig.waiting().size(), 1);

        rig.connectRunning(); // started, made, and offered again by a broker that keeps it
        rig.orders->start(0);
        rig.answer();
        rig.settle();
        QVERIFY(rig.waiting().isEmpty());
        rig.restartPanel();
        rig.receive(rig.offer());
        QVERIFY(!rig.row().usable);

        rig.receive({});
        QVERIFY(rig.orders->offers()->rows()->rows().isEmpty());
    }

    void whatIsNoOrderForThisMachineIsRefused_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QString>("sentence");
        const OfferedRig rig;
        const auto changed = [&rig](auto change) {
            OrderRow order = rig.order;
            change(order);
            return store::signOrder(order, u"Packer 7"_s, signedMs, rig.key);
        };
        // The keys of the rigs differ: each row is signed anew in the test.
        QTest::newRow("garbage") << QByteArray("\xff\xfe") << u"damaged at byte"_s;
        QTest::newRow("no object") << QByteArray("[]") << u"lacks the key"_s;
        QTest::newRow("stranger") << changed([](OrderRow&) {}) << u"does not match the signature"_s;
        QTest::newRow("large") << QByteArray(plant::maxOfferBytes, ' ') << u"damaged at byte"_s;
    }

    void whatIsNoOrderForThisMachineIsRefused()
    {
        QFETCH(QByteArray, file);
        QFETCH(QString, sentence);
        OfferedRig rig;
        rig.receive(file);
        QVERIFY(!rig.row().usable);
        QVERIFY2(rig.row().note.contains(sentence), qPrintable(rig.row().note));
        rig.orders->addOffered(0);
        QVERIFY(rig.waiting().isEmpty());
    }

    void aSignatureMakesNoBadOrderGood_data()
    {
        QTest::addColumn<qint64>("quantity");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("lot");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* title, qint64 quantity, const QString& text, const QString& lot,
                            const QString& sentence) {
            QTest::newRow(title) << quantity << text << lot << sentence;
        };
        row("none", 0, u"4711"_s, u"L17"_s, u"enter 1 to 1000000"_s);
        row("billion", 1'000'000'000, u"4711"_s, u"L17"_s, u"enter 1 to 1000000"_s);
        row("long lot", 1, u"4711"_s, QString(500, u'x'), u"500 bytes, at most 40"_s);
        row("line feed in the lot", 1, u"4711"_s, u"L\n17"_s, u"nobody sees"_s);
        row("no lot", 1, u"4711"_s, u" "_s, u"order.lot"_s);
        row("no number", 1, QString(), u"L17"_s, u"order.order"_s);
        row("long number", 1, QString(500, u'x'), u"L17"_s, u"500 characters"_s);
    }

    void aSignatureMakesNoBadOrderGood()
    {
        QFETCH(qint64, quantity);
        QFETCH(QString, text);
        QFETCH(QString, lot);
        QFETCH(QString, sentence);
        OfferedRig rig;
        rig.order.quantity = quantity;
        rig.order.text = text;
        rig.order.lot = lot;
        rig.receive(rig.offer());
        QVERIFY(!rig.row().usable);
        QVERIFY2(rig.row().note.contains(sentence), qPrintable(rig.row().note));
    }

    void aTextThatLooksLikeAFormulaIsText()
    {
        OfferedRig rig;
        rig.order.text = u"=1+1"_s;
        rig.order.lot = u"L,17"_s;
        rig.receive(rig.offer());
        QVERIFY(rig.row().usable);
        rig.orders->addOffered(0);
        QCOMPARE(rig.waiting(), QStringList{u"L,17"_s});
    }

    void otherMachinesAndWithdrawnKeysAreRefused()
    {
        OfferedRig rig;
        rig.receive(rig.offer(u"Packer 8"_s));
        QCOMPARE(rig.row().note, u"This order is for the machine Packer 8; this one is Packer 7."_s);
        rig.installKey(true);
        rig.receive(rig.offer());
        QVERIFY2(rig.row().note.contains(u"withdrawn"_s), qPrintable(rig.row().note));
        rig.installKey(false);
        rig.orders->offers()->update();
        rig.settle();
        QVERIFY(rig.row().usable);
        rig.orders->offers()->takeOffer({{}, {}, Kind::Recipe}); // of another kind
        QVERIFY(rig.row().usable);
        rig.orders->offers()->takeOffer({{}, {}, Kind::Order});
        rig.settle();
        QVERIFY(rig.orders->offers()->rows()->rows().isEmpty());
    }
};

CAMPANEL_TEST(TestOrderOffers)

} // namespace test_order_offers

#include "test_order_offers.moc"
