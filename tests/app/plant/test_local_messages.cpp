// SPDX-License-Identifier: Apache-2.0
// The messages between panel and gateway: whole, in pieces, damaged, too long, of another version.
#include "app/plant/local_messages.h"
#include "tests/support/test_program.h"

#include <QCborArray>
#include <QCborMap>
#include <QTest>
#include <QtEndian>

#include <random>

namespace test_local_messages {

using namespace campanel::plant;
using namespace Qt::StringLiterals;

namespace {

QByteArray framed(const QByteArray& body)
{
    QByteArray bytes(4, 0);
    qToBigEndian(static_cast<quint32>(body.size()), bytes.data());
    return bytes + body;
}

ValueMessage someValues()
{
    return {{{Metric::StateCurrent, std::int64_t(6), 12},
             {Metric::CurMachSpeed, 61.5, 0},
             {Metric::RecipeName, u"饼干 250"_s, 0},
             {Metric::FilmSaved, {}, 0},
             {Metric::RecipeCrc, std::int64_t(0xFFFFFFFF), 3}}};
}

} // namespace

class TestLocalMessages : public QObject {
    Q_OBJECT

private slots:
    void aMessageComesBackAsItWas()
    {
        LocalReader reader;
        reader.add(encoded(someValues()) + encoded(CommandMessage{u"Status/StateCurrent"_s, u"6"_s}) +
                   encoded(OfferMessage{u"Biscuit"_s, QByteArray("{\0}", 3)}) + encoded(OfferMessage{}) +
                   encoded(OfferMessage{u"4711"_s, "{}", OfferMessage::Kind::Order}) +
                   encoded(ValueMessage{}) + encoded(GatewayMessage{u"1.2.3"_s}));
        QCOMPARE(std::get<ValueMessage>(reader.next().value()), someValues());
        QCOMPARE(std::get<CommandMessage>(reader.next().value()).metric, u"Status/StateCurrent"_s);
        QCOMPARE(std::get<OfferMessage>(reader.next().value()),
                 (OfferMessage{u"Biscuit"_s, QByteArray("{\0}", 3)}));
        QCOMPARE(std::get<OfferMessage>(reader.next().value()), OfferMessage());
        QCOMPARE(std::get<OfferMessage>(reader.next().value()),
                 (OfferMessage{u"4711"_s, "{}", OfferMessage::Kind::Order}));
        QVERIFY(std::get<ValueMessage>(reader.next().value()).readings.isEmpty());
        QCOMPARE(std::get<GatewayMessage>(reader.next().value()).version, u"1.2.3"_s);
        QVERIFY(!reader.next() && !reader.error());
    }

    void aMessageInPiecesIsPutTogether()
    {
        LocalReader reader;
        const QByteArray bytes = encoded(someValues());
        for (qsizetype i = 0; i < bytes.size(); ++i) {
            QVERIFY(!reader.next());
            reader.add(bytes.sliced(i, 1));
        }
        QCOMPARE(std::get<ValueMessage>(reader.next().value()), someValues());
    }

    void whatIsNoMessageEndsTheConnection_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("error");
        const auto row = [](const char* name, const QByteArray& bytes, LocalError error) {
            QTest::newRow(name) << bytes << static_cast<int>(error);
        };
        row("too long", QByteArray("\0\x10\0\0", 4), LocalError::TooLong);
        row("2 GB", QByteArray("\x7f\xff\xff\xff", 4), LocalError::TooLong);
        row("no CBOR", framed("\xff\xff"), LocalError::NotAMessage);
        row("empty", framed({}), LocalError::NotAMessage);
        row("no map", framed(QCborValue(1).toCbor()), LocalError::NotAMessage);
        row("another version", framed(QCborMap{{0, 99}, {1, QCborArray()}}.toCborValue().toCbor()),
            LocalError::OtherVersion);
        const auto values = [](const QCborArray& reading) {
            return framed(QCborMap{{0, localVersion}, {1, QCborArray{reading}}}.toCborValue().toCbor());
        };
        row("unknown metric", values({9999, 1, 0}), LocalError::NotAMessage);
        row("no metric", values({0, 1, 0}), LocalError::NotAMessage);
        row("half a metric", values({int(Metric::CurMachSpeed) + 0.5, 1.0, 0}), LocalError::NotAMessage);
        row("another type", values({int(Metric::CurMachSpeed), u"fast"_s, 0}), LocalError::NotAMessage);
        row("negative age", values({int(Metric::CurMachSpeed), 1.0, -1}), LocalError::NotAMessage);
        row("without an age", values({int(Metric::CurMachSpeed), 1.0}), LocalError::NotAMessage);
    }
    void whatIsNoMessageEndsTheConnection()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, error);
        LocalReader reader;
        reader.add(bytes);
        QVERIFY(!reader.next());
        QVERIFY(reader.error());
        QCOMPARE(static_cast<int>(*reader.error()), error);
        reader.add(encoded(someValues()));
        QVERIFY(!reader.next()); // nothing is believed after it
    }

    void longTextsAreCut()
    {
        LocalReader reader;
        reader.add(encoded(ValueMessage{{{Metric::RecipeName, QString(100'000, u'x'), 0}}}));
        const auto message = std::get<ValueMessage>(reader.next().value());
        QCOMPARE(std::get<QString>(message.readings.first().value).size(), maxTextLength);
        reader.add(encoded(OfferMessage{u"Biscuit"_s, QByteArray(3'000'000, 'x')}));
        QCOMPARE(std::get<OfferMessage>(reader.next().value()).file.size(), maxOfferBytes + 1);
    }

    // Never a crash, and never a value of another type.
    void damagedMessages()
    {
        constexpr unsigned seed = 23;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const QByteArray good = encoded(someValues());
        for (int i = 0; i < 20'000; ++i) {
            QByteArray bytes = good;
            for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
                bytes[static_cast<qsizetype>(random() % unsigned(bytes.size()))] = char(random());
            LocalReader reader;
            reader.add(bytes);
            if (const auto message = reader.next();
                message && std::holds_alternative<ValueMessage>(*message)) {
                for (const MetricReading& reading : std::get<ValueMessage>(*message).readings)
                    QVERIFY(isOfType(reading.value, metricRow(reading.metric).type));
            }
        }
    }
};

CAMPANEL_TEST(TestLocalMessages)

} // namespace test_local_messages

#include "test_local_messages.moc"
