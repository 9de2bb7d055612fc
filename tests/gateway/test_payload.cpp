// SPDX-License-Identifier: Apache-2.0
// The bytes of a Sparkplug B payload: against bytes that were put together by hand from the specification,
// and back; damaged ones.
#include "gateway/payload.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

namespace test_payload {

using namespace campanel;
using namespace campanel::gateway;
using namespace Qt::StringLiterals;

namespace {

Payload somePayload()
{
    return {1'790'000'000'000,
            17,
            {{.name = u"CamPanel/Recipe/Name"_s,
              .alias = 10,
              .timestampMs = 1'789'999'999'000,
              .type = 12,
              .value = u"饼干"_s},
             {.name = u"Status/MachSpeed"_s,
              .alias = 3,
              .timestampMs = 1,
              .type = 10,
              .value = 60.25,
              .unit = u"bags/min"_s},
             {.name = u"n"_s, .timestampMs = 2, .type = 3, .value = std::int64_t(-5), .isHistorical = true},
             {.name = u"u"_s, .timestampMs = 2, .type = 7, .value = std::int64_t(4'294'967'295)},
             {.name = u"bdSeq"_s, .timestampMs = 2, .type = 4, .value = std::int64_t(255)},
             {.name = u"t"_s, .timestampMs = 2, .type = 11, .value = true},
             {.name = u"z"_s, .timestampMs = 2, .type = 10, .value = {}}}};
}

} // namespace

class TestPayload : public QObject {
    Q_OBJECT

private slots:
    void aPayloadComesBackAsItWas()
    {
        const auto back = decodedPayload(encodedPayload(somePayload()));
        QVERIFY(back);
        QCOMPARE(*back, somePayload());
    }

    // Field numbers and wire types by hand: tag = number * 8 + type, 0 varint, 1 eight bytes, 2 length.
    void theBytesAreThoseOfTheSpecification()
    {
        const Payload payload{
            300, 5, {{.name = u"a"_s, .alias = 2, .timestampMs = 1, .type = 3, .value = std::int64_t(7)}}};
        const QByteArray byHand = QByteArray::fromHex("08ac02" // 1: timestamp 300
                                                      "120b"   // 2: a metric of 11 bytes
                                                      "0a0161" // 1: name "a"
                                                      "1002"   // 2: alias 2
                                                      "1801"   // 3: timestamp 1
                                                      "2003"   // 4: Int32
                                                      "5007"   // 10: int_value 7
                                                      "1805"); // 3: seq 5
        QCOMPARE(encodedPayload(payload), byHand);
        const Payload null{
            0, {}, {{.alias = 16, .timestampMs = 0, .type = 10, .value = {}, .isHistorical = true}}};
        QCOMPARE(encodedPayload(null), QByteArray::fromHex("0800"
                                                           "120a"
                                                           "1010"    // 2: alias 16
                                                           "1800"    // 3: timestamp 0
                                                           "200a"    // 4: Double
                                                           "2801"    // 5: is_historical
                                                           "3801")); // 7: is_null
    }

    void otherFieldsAreSkipped()
    {
        // 4: uuid "x", 5: body of two bytes, and a metric with 6: is_transient and 8: an empty metadata.
        const auto read = decodedPayload(QByteArray::fromHex("220178"
                                                             "2a020102"
                                                             "1207"
                                                             "0a0161"
                                                             "3001"
                                                             "4200"));
        QVERIFY(read);
        QCOMPARE(read->metrics.size(), 1);
        QCOMPARE(read->metrics.first().name, u"a"_s);
    }

    // A command of a host may have no data type, and hosts have UInt32 in either field.
    void numbersOfCommandsAreReadInEachForm()
    {
        // 2: alias 2, 10: int_value -2
        const auto alias = decodedPayload(QByteArray::fromHex("1208"
                                                              "1002"
                                                              "50"
                                                              "feffffff"
                                                              "0f"));
        QVERIFY(alias);
        QCOMPARE(alias->metrics.first().value, plant::MetricValue(std::int64_t(-2)));
        for (const char* field : {"50", "58"}) { // 4: UInt32, 10: int_value or 11: long_value 0xF0000000
            const auto read =
                decodedPayload(QByteArray::fromHex(QByteArray("12082007") + field + "808080800f"));
            QVERIFY(read);
            QCOMPARE(read->metrics.first().value, plant::MetricValue(std::int64_t(0xF0000000)));
        }
    }

    void garbageIsNoPayload()
    {
        QVERIFY(!decodedPayload("start the machine"));
        QVERIFY(!decodedPayload(QByteArray(16, '\xff')));
        QVERIFY(!decodedPayload(QByteArray(maxPayloadBytes + 1, '\0')));
        QVERIFY(decodedPayload({})); // a payload without anything
    }

    void damagedPayloads()
    {
        constexpr unsigned seed = 23;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const QByteArray good = encodedPayload(somePayload());
        for (int i = 0; i < 20'000; ++i) {
            QByteArray bytes = good.first(static_cast<qsizetype>(random() % unsigned(good.size() + 1)));
            for (unsigned changes = random() % 4; changes > 0 && !bytes.isEmpty(); --changes)
                bytes[static_cast<qsizetype>(random() % unsigned(bytes.size()))] = char(random());
            if (const auto read = decodedPayload(bytes))
                (void)encodedPayload(*read);
        }
    }
};

CAMPANEL_TEST(TestPayload)

} // namespace test_payload

#include "test_payload.moc"
