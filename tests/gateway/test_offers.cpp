// SPDX-License-Identifier: Apache-2.0
// Recipes that the plant offers: from mosquitto through the gateway's executable to the panel, where a person
// accepts; bad ones are refused with their reason, and a gateway that is killed leaves nothing half.
#include "app/panel/library/recipes.h"
#include "app/store/signed_order.h"
#include "tests/app/panel/plant/plant_rig.h"
#include "tests/gateway/plant_bench.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>

#include <algorithm>
#include <random>

namespace test_offers {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::OfferRow;
using plant::Metric;
using test::Host;
using test::Machine;
using test::Mosquitto;

namespace {

constexpr int longWaitMs = 60'000;
constexpr qint64 signedMs = 1'790'000'000'000;

QString topicOf(const QString& name)
{
    return u"campanel/Hall/recipes/"_s + name;
}

// A panel without a screen behind the gateway of a machine.
struct OfferRig : test::PlantRig {
    panel::Recipes recipes{machine, editor, records, folder.path(), nullptr};
    panel::PlantFeed feed{sources, trail, nullptr};
    store::SigningKey key = store::newSigningKey(u"Anna Plant"_s).value();

    OfferRig()
    {
        recipes.files()->setScanner([](const QString&) { return QList<store::RecipeOffer>(); });
        installKey(false);
        recipes.files()->setKeyFolder(folder.filePath(u"keys"_s));
        QObject::connect(&feed, &panel::PlantFeed::offerReceived, recipes.files(),
                         &panel::RecipeFiles::takeOffer);
        machine.accessCheck().setLevel(panel::Level::Operator, u"Bo"_s);
        recipes.save(); // as the first version
        if (!QTest::qWaitFor([this] { return recipes.total() == 1 && recipes.ready(); }))
            qFatal("the library was not read");
        connectRunning();
    }
    void installKey(bool isWithdrawn) const
    {
        QDir(folder.path()).mkpath(u"keys"_s);
        QFile file(folder.filePath(u"keys/anna.json"_s));
        QJsonObject object = QJsonDocument::fromJson(store::publicKeyFile(key)).object();
        object[u"withdrawn"_s] = isWithdrawn;
        const QByteArray text = QJsonDocument(object).toJson();
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no key");
    }
    // Takes the place of the panel that the test plays.
    void openAt(Machine& gateway)
    {
        gateway.killGateway();
        feed.open(gateway.file(u"panel.socket"_s));
        gateway.startGateway();
    }
    [[nodiscard]] program::Recipe recipe(int version, double lengthMm) const
    {
        program::Recipe recipe = editor.storedRecipe();
        recipe.version = version;
        program::setValue(recipe, profile::Field::BagLength, lengthMm);
        return recipe;
    }
    [[nodiscard]] QByteArray signedText(const program::Recipe& recipe) const
    {
        return store::signRecipe(recipe, signedMs, 1, key);
    }
    [[nodiscard]] const QList<OfferRow>& rows() { return recipes.files()->files()->rows(); }
    [[nodiscard]] OfferRow row() { return rows().value(0); }
};

} // namespace

class TestOffers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY2(Mosquitto::isInstalled(),
                 "mosquitto or mosquitto_sub is not installed; see packaging/dependencies");
    }

    void aSignedRecipeReachesTheLibraryByAPerson()
    {
        OfferRig rig;
        Mosquitto broker;
        Machine gateway(broker.port());
        rig.openAt(gateway);
        broker.publish(topicOf(u"Biscuit"_s), rig.signedText(rig.recipe(8, 240)), true);
        QTRY_COMPARE_WITH_TIMEOUT(rig.recipes.files()->notice(), u"Offered: Biscuit 250, version 8"_s,
                                  20'000);
        const OfferRow row = rig.row();
        QVERIFY(row.usable);
        QCOMPARE(row.title, u"Offered: Biscuit 250, version 8"_s);
        QVERIFY2(row.note.contains(u"signed by Anna Plant"_s) && row.note.contains(u"Plant network"_s),
                 qPrintable(row.note));
        QVERIFY2(row.detail.contains(u"250.0 mm to 240.0 mm"_s), qPrintable(row.detail));
        QTest::qWait(500);
        QCOMPARE(rig.recipes.list()->rows().first().version, 1); // nothing comes in without a person
        QVERIFY(rig.link.requests.isEmpty());

        rig.machine.accessCheck().setLevel(panel::Level::Operator);
        rig.recipes.files()->take(0);
        QTRY_COMPARE(rig.recipes.list()->rows().first().version, 8);
        QTRY_COMPARE(rig.recipes.files()->notice(), QString());
        QVERIFY2(rig.row().detail.contains(u"nothing changes"_s), qPrintable(rig.row().detail));
        QVERIFY(rig.link.requests.isEmpty()); // no download
        QCOMPARE(rig.recipes.message(), u"Biscuit was imported as Biscuit 250, version 8."_s);

        broker.publish(topicOf(u"Biscuit"_s), {}, true); // withdrawn
        QTRY_VERIFY(rig.rows().isEmpty());
    }

    void badOffersAreRefusedWithTheirReason()
    {
        OfferRig rig;
        Mosquitto broker;
        Machine gateway(broker.port());
        rig.openAt(gateway);
        const auto refusedWith = [&](const QByteArray& offer, const QString& sentence) {
            broker.publish(topicOf(u"Offer"_s), offer, true);
            const bool isRefused = QTest::qWaitFor(
                [&] { return rig.rows().size() == 1 && rig.row().detail.contains(sentence); }, 20'000);
            if (!isRefused)
                qWarning("%s", qPrintable(rig.row().detail));
            return isRefused && !rig.row().usable && rig.recipes.files()->notice().isEmpty();
        };
        rig.machine.accessCheck().setLevel(panel::Level::Technician);
        const QByteArray good = rig.signedText(rig.recipe(8, 240));
        QVERIFY(refusedWith(QByteArray(1'500'000, ' ') + good, u"larger than 1 MB"_s));
        QVERIFY(refusedWith("\xff\xfe garbage", u"damaged at byte"_s));
        QVERIFY(refusedWith(good.left(good.size() / 2), u"damaged at byte"_s));
        QVERIFY(refusedWith(store::toJson(rig.recipe(8, 240)), u"is not signed"_s));
        QVERIFY(refusedWith(QByteArray(good).replace("Anna Plant", "Bert Plant"),
                            u"key this machine does not have"_s));
        QByteArray altered = good;
        altered.replace("\\\"bag_length_mm\\\": 240", "\\\"bag_length_mm\\\": 241");
        QVERIFY(altered != good);
        QVERIFY(refusedWith(altered, u"does not match the signature"_s));
        program::Recipe fast = rig.recipe(8, 240);
        program::setValue(fast, profile::Field::Rate, 590);
        QVERIFY(refusedWith(rig.signedText(fast), u"cannot run the recipe"_s));
        program::Recipe move = rig.editor.newRecipe(profile::ProgramKind::PositionMove);
        move.name = rig.editor.storedRecipe().name;
        move.version = 9;
        QVERIFY(refusedWith(rig.signedText(move), u"Rename"_s));

        broker.publish(topicOf(u"Offer"_s), good, true);
        QTRY_VERIFY_WITH_TIMEOUT(rig.row().usable, 20'000);
        rig.recipes.files()->take(0);
        QTRY_COMPARE(rig.recipes.list()->rows().first().version, 8);
        QVERIFY(refusedWith(rig.signedText(rig.recipe(7, 230)), u"older version"_s)); // replayed
        rig.installKey(true);
        QVERIFY(refusedWith(rig.signedText(rig.recipe(9, 230)), u"whose key was withdrawn"_s));
        QVERIFY(rig.link.requests.isEmpty());
        QCOMPARE(rig.recipes.total(), 1);
    }

    void offersAreBounded()
    {
        Mosquitto broker;
        Machine machine(broker.port());
        QTRY_VERIFY(machine.log().contains(u"Connected"_s));
        for (int i = 0; i < plant::maxOffers + 3; ++i)
            broker.publish(topicOf(u"R%1"_s.arg(i)), "x", true);
        broker.publish(u"campanel/Hall/other/R"_s, "x", true);
        const QStringList newest{u"R15"_s, u"R16"_s, u"R17"_s, u"R18"_s};
        QTRY_COMPARE(machine.panel.offers.keys(), newest);
        QVERIFY2(machine.log().contains(u"The offer R0 is left out"_s), qPrintable(machine.log()));
        QCOMPARE(machine.panel.offers.value(u"R15"_s), QByteArray("x"));
        broker.publish(topicOf(u"R17"_s), {}, true);
        QTRY_COMPARE(machine.panel.offers.keys(), (QStringList{u"R15"_s, u"R16"_s, u"R18"_s}));
        QVERIFY(machine.panel.commands.isEmpty());
    }

    void aSignedOrderReachesTheQueueByAPerson()
    {
        OfferRig rig;
        Mosquitto broker;
        Machine gateway(broker.port());
        rig.orders.offers()->setTrust(rig.folder.filePath(u"keys"_s), u"P1"_s);
        QObject::connect(&rig.feed, &panel::PlantFeed::offerReceived, rig.orders.offers(),
                         &panel::OrderOffers::takeOffer);
        rig.openAt(gateway);
        const store::OrderRow order{
            .text = u"4711"_s, .lot = u"L17"_s, .recipe = u"Biscuit 250"_s, .quantity = 5000};
        const QString topic = u"campanel/Hall/orders/%1/4711"_s;
        const QByteArray offer = store::signOrder(order, u"P1"_s, signedMs, rig.key);
        broker.publish(topic.arg(u"P2"_s), offer, true); // another machine's
        broker.publish(topic.arg(u"P1"_s), offer, true);
        QTRY_COMPARE_WITH_TIMEOUT(rig.orders.offers()->titles(), u"4711 · L17"_s, 20'000);
        QCOMPARE(rig.orders.offers()->rows()->rows().size(), 1);
        QCOMPARE(rig.orders.queue().rows().size(), 0); // nothing comes in without a person
        rig.orders.addOffered(0);
        QTRY_COMPARE(rig.orders.queue().rows().size(), 1);
        QCOMPARE(rig.orders.queue().rows().first().order.quantity, 5000);
        QTRY_COMPARE(rig.orders.offers()->titles(), QString()); // it cannot be taken twice
        broker.publish(topic.arg(u"P1"_s), {}, true);           // withdrawn
        QTRY_VERIFY(rig.orders.offers()->rows()->rows().isEmpty());
        QCOMPARE(rig.orders.queue().rows().size(), 1); // what a person took stays
        QVERIFY(rig.rows().isEmpty());                 // an order is no recipe
    }

    // Texts that anybody may publish do not keep out what a trusted person has signed, whichever comes first.
    void aSignedOfferHasItsPlace()
    {
        Mosquitto broker;
        const auto key = store::newSigningKey(u"Anna Plant"_s).value();
        program::Recipe recipe;
        recipe.name = "Biscuit 250";
        const QByteArray offer = store::signRecipe(recipe, signedMs, 1, key);
        for (int i = 0; i < 20; ++i)
            broker.publish(topicOf(u"X%1"_s.arg(i)), "x", true);
        broker.publish(topicOf(u"Biscuit"_s), offer, true);
        Machine machine(broker.port());
        machine.killGateway();
        QVERIFY(QDir().mkpath(machine.file(u"recipe-keys"_s)));
        QFile file(machine.file(u"recipe-keys/anna.json"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(store::publicKeyFile(key)) > 0);
        file.close();
        machine.startGateway();
        QTRY_COMPARE(machine.panel.offers.value(u"Biscuit"_s), offer);
        for (int i = 20; i < 40; ++i)
            broker.publish(topicOf(u"X%1"_s.arg(i)), "x", true);
        QTRY_VERIFY(machine.panel.offers.contains(u"X39"_s));
        QCOMPARE(machine.panel.offers.size(), 5);
        QVERIFY(machine.panel.offers.contains(u"Biscuit"_s));
    }

    // Offers that were withdrawn while the gateway was off are gone too.
    void aNewConnectionBringsWhatIsOfferedNow()
    {
        Mosquitto broker;
        broker.publish(topicOf(u"A"_s), "a", true);
        broker.publish(topicOf(u"B"_s), "b", true);
        Machine machine(broker.port());
        QTRY_COMPARE(machine.panel.offers.size(), 2);
        machine.killGateway();
        broker.publish(topicOf(u"A"_s), {}, true);
        QCOMPARE(machine.panel.offers.size(), 2); // the panel has what it knows
        machine.startGateway();
        QTRY_COMPARE(machine.panel.offers, (QMap<QString, QByteArray>{{u"B"_s, "b"}}));
    }

    void theReasonOfAStopReachesTheHost()
    {
        OfferRig rig;
        Mosquitto broker;
        Host host(broker);
        Machine gateway(broker.port());
        rig.openAt(gateway);
        rig.stops.setWallClock([&rig] { return rig.wallMs; });
        const auto reason = [&host] {
            const auto samples = host.samplesOf(Metric::StopReason, true);
            return samples.isEmpty() ? plant::MetricValue() : samples.last().value;
        };
        const auto passSeconds = [&rig](int seconds) {
            for (int i = 0; i < seconds; ++i) {
                rig.now += std::chrono::seconds(1);
                rig.wallMs += 1000;
                rig.link.sendStatus(rig.now);
                rig.stops.check();
            }
        };
        passSeconds(10);
        QTRY_COMPARE_WITH_TIMEOUT(reason(), plant::MetricValue(QString()), 20'000); // it produces
        rig.link.status.state = modbus::State::Ready;
        passSeconds(20);
        rig.machine.accessCheck().setLevel(panel::Level::Operator);
        emit rig.stops.keys()->chosen({u"material"_s, u"film_change"_s, false});
        QTRY_COMPARE(reason(), plant::MetricValue(u"material/film_change"_s));
        rig.link.status.state = modbus::State::Running;
        passSeconds(2);
        QTRY_COMPARE(reason(), plant::MetricValue(QString()));
        rig.link.becomeLost();
        QTRY_COMPARE(reason(), plant::MetricValue()); // not known
    }

    // Each kill is at a random moment of the distribution of the next version to all machines.
    void gatewaysKilledDuringDistributionLeaveOldOrNew()
    {
        const auto numberOf = [](const char* name, int otherwise) {
            const int number = qEnvironmentVariableIntValue(name);
            return number > 0 ? number : otherwise;
        };
        const int machines = numberOf("CAMPANEL_GATEWAYS", 4);
        const int kills = numberOf("CAMPANEL_KILLS", 12);
        const auto seed = static_cast<unsigned>(numberOf("CAMPANEL_SEED", 23));
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const auto key = store::newSigningKey(u"Anna Plant"_s).value();
        const QList<store::SignerKey> keys{store::publicKeyIn(store::publicKeyFile(key)).value()};
        const auto offerOf = [&key](int version) {
            program::Recipe recipe;
            recipe.name = "Biscuit 250";
            recipe.version = version;
            // Long enough for a kill in the middle; JSON allows blanks.
            return store::signRecipe(recipe, signedMs, 1, key) + QByteArray(400'000, ' ');
        };
        Mosquitto broker("max_inflight_messages 0\n");
        std::vector<std::unique_ptr<Machine>> hall;
        for (int i = 0; i < machines; ++i)
            hall.push_back(std::make_unique<Machine>(broker.port(), QByteArray(), u"M%1"_s.arg(i)));
        const auto all = [&](const QByteArray& offer) {
            return std::ranges::all_of(hall, [&](const auto& machine) {
                return machine->panel.offers.value(u"Biscuit"_s) == offer;
            });
        };
        QByteArray before = offerOf(1);
        broker.publish(topicOf(u"Biscuit"_s), before, true);
        QTRY_VERIFY_WITH_TIMEOUT(all(before), longWaitMs);
        int halves = 0;
        int olds = 0;
        int news = 0;
        const auto check = [&](const Machine& machine, const QByteArray& after) {
            const auto offers = machine.panel.offers;
            if (offers.isEmpty())
                return; // between a connection and its offers: nothing is shown yet
            const QByteArray& present = offers.value(u"Biscuit"_s);
            const auto valid = store::verifyRecipe(present, u"Biscuit"_s, keys);
            (present == before ? olds : present == after ? news : halves) += 1;
            halves += valid ? 0 : 1;
        };
        for (int kill = 0; kill < kills; ++kill) {
            const QByteArray after = offerOf(kill + 2);
            broker.publish(topicOf(u"Biscuit"_s), after, true);
            Machine& machine = *hall[random() % hall.size()];
            QTest::qWait(static_cast<int>(random() % 40));
            machine.killGateway();
            for (const auto& each : hall)
                check(*each, after);
            machine.startGateway();
            QTRY_VERIFY_WITH_TIMEOUT(all(after), longWaitMs);
            before = after;
        }
        QCOMPARE(halves, 0);
        QVERIFY(olds + news > 0);
        qInfo("%d gateways, %d kills: %d panels had the old offer, %d the new one, none a half", machines,
              kills, olds, news);
    }
};

CAMPANEL_TEST(TestOffers)

} // namespace test_offers

#include "test_offers.moc"
