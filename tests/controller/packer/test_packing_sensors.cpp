// SPDX-License-Identifier: Apache-2.0
// A packing line knows where an axis was some time ago, for sensors that answer late, and records their
// edges.
#include "ctl_registers.h"
#include "packer/ctl_edges.h"
#include "packer/ctl_mark_sensor.h"
#include "packer/ctl_past.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_packing_sensors {

class TestPackingSensors : public QObject {
    Q_OBJECT

private slots:
    // A film that speeds up evenly: where it was is half the acceleration times the square of the time.
    void pastOfAnAcceleratedAxis()
    {
        constexpr double perS2 = 5.0e8; // 1/256 pulse; some 30 m/s^2
        const auto at = [](double us) { return std::llround(0.5 * perS2 * us * us * 1e-12); };
        for (const std::uint64_t sliceUs : {100u, 250u, 500u, 2500u}) {
            ctl_past past{};
            ctl_past_reset(&past, 0, 0);
            std::uint64_t now = 0;
            while (now < 100'000) {
                now += sliceUs;
                ctl_past_add(&past, now, at(static_cast<double>(now)));
            }
            for (const std::uint32_t deadUs : {1u, 499u, 1000u, 7777u, 20'000u}) {
                const double edgeUs = static_cast<double>(now) - 0.4 * static_cast<double>(sliceUs);
                const double found = static_cast<double>(ctl_past_before(&past, at(edgeUs), deadUs));
                const double wanted = static_cast<double>(at(edgeUs - deadUs));
                const double sampleUs = std::max<double>(CTL_PAST_SAMPLE_US, static_cast<double>(sliceUs));
                const double chord = perS2 * sampleUs * sampleUs * 1e-12 / 8.0; // off a straight line
                // The time of the edge within its slice is taken from a straight line, too.
                QVERIFY2(std::abs(found - wanted) <= 2.0 * chord + 3.0,
                         qPrintable(QStringLiteral("%1, %2").arg(found).arg(wanted)));
            }
            QCOMPARE(ctl_past_before(&past, 12345, 0), std::int64_t{12345});
        }
    }

    // An axis that stood still was where it is, however long ago; its numbers may be long.
    void pastOfAStandstill()
    {
        ctl_past past{};
        ctl_past_reset(&past, 5'000'000'000u, 7'000'000'000);
        for (std::uint64_t us = 5'000'000'250u; us < 5'000'100'000u; us += 250)
            ctl_past_add(&past, us, 7'000'000'000);
        QCOMPARE(ctl_past_before(&past, 7'000'000'000, 20'000), std::int64_t{7'000'000'000});
    }

    // Place, speed and acceleration of an edge come out in the units of the registers.
    void recordsAnEdge()
    {
        constexpr std::uint32_t feedUm = 150'000;
        constexpr std::uint32_t pulses = 10'000;
        constexpr double finePerMm = pulses * 256.0 / 150.0;
        constexpr double speed = 700.0; // mm/s now
        constexpr double acceleration = -1800.0;
        const auto at = [](double s) {
            return std::llround(finePerMm * (1000.0 + speed * s + 0.5 * acceleration * s * s));
        };
        ctl_past past{};
        ctl_past_reset(&past, 0, at(-0.1));
        for (int i = -399; i <= 0; ++i)
            ctl_past_add(&past, static_cast<std::uint64_t>(100'000 + 250 * i), at(250e-6 * i));
        const ctl_edge edge{at(0),
                            std::llround(-0.25 * finePerMm),
                            std::llround(4.98 * finePerMm),
                            ctl_past_last_way(&past, 0),
                            ctl_past_last_way(&past, 1),
                            CTL_MARK_VERDICT_TAKEN,
                            1500};
        ctl_edges edges{};
        ctl_edges_add(&edges, &edge);
        for (int i = 0; i < 6; ++i) {
            QCOMPARE(edges.number, 0u);
            ctl_edges_work(&edges, feedUm, pulses);
        }
        std::uint16_t registers[CTL_GROUP_SENSOR] = {};
        ctl_edges_registers(&edges, registers);
        const std::uint16_t* record = &registers[2 + CTL_EDGE_REGISTERS];
        QCOMPARE(registers[1], std::uint16_t{1});
        QCOMPARE(record[0] << 16 | record[1], 1'000'000);
        QCOMPARE(static_cast<std::int16_t>(record[2]), std::int16_t{-25});
        QVERIFY(std::abs(static_cast<std::int16_t>(record[3]) - 7000) <= 2);
        QVERIFY(std::abs(static_cast<std::int16_t>(record[4]) + 1800) <= 20);
        QCOMPARE(record[5], std::uint16_t{CTL_MARK_VERDICT_TAKEN});
        QCOMPARE(record[6], std::uint16_t{1500});
        QCOMPARE(record[7], std::uint16_t{498});
    }

    // Place and speed of an edge of the eye in parts of the product pitch, also before the count began.
    void recordsAnEdgeOfTheEye_data()
    {
        QTest::addColumn<double>("pitches");
        QTest::addColumn<bool>("covered");
        QTest::addColumn<int>("place");
        QTest::newRow("begins") << 1234.25 << true << 16384;
        QTest::newRow("ends") << 7.75 << false << 49152;
        QTest::newRow("negative") << -3.75 << true << 16384;
    }
    void recordsAnEdgeOfTheEye()
    {
        QFETCH(double, pitches);
        QFETCH(bool, covered);
        QFETCH(int, place);
        constexpr std::int64_t flight = 20'000 * 256;
        constexpr double perS = 4.321;
        const auto at = [&](double s) { return std::llround(flight * (pitches + perS * s)); };
        ctl_past past{};
        ctl_past_reset(&past, 0, at(-0.1));
        for (int i = -399; i <= 0; ++i)
            ctl_past_add(&past, static_cast<std::uint64_t>(100'000 + 250 * i), at(250e-6 * i));
        ctl_eye_edges edges{};
        const ctl_eye_edge edge{at(0), ctl_past_last_way(&past, 0), 2500, covered};
        const ctl_eye_edge tooSoon{at(0), {}, 0, !covered};
        ctl_eye_edges_add(&edges, &edge);
        ctl_eye_edges_add(&edges, &tooSoon);
        for (int i = 0; i < 20; ++i)
            ctl_eye_edges_work(&edges, flight);
        std::uint16_t registers[CTL_GROUP_EYE] = {};
        ctl_eye_edges_registers(&edges, registers);
        const std::uint16_t* record = &registers[2 + CTL_EYE_REGISTERS];
        QCOMPARE(registers[1], std::uint16_t{1});
        QVERIFY(std::abs(record[0] - place) <= 1);
        QVERIFY(std::abs(record[1] - 4321) <= 1);
        QCOMPARE(record[2], static_cast<std::uint16_t>(covered ? 1 : 0));
        QCOMPARE(record[3], std::uint16_t{2500});
    }

    // Where no width is asked for, a mark counts from its beginning; a minimum is known before its end, a
    // maximum at the end.
    void judgesAMarkAsSoonAsItsWidthAllows_data()
    {
        QTest::addColumn<int>("narrowest");
        QTest::addColumn<int>("widest");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("judgedAt");
        QTest::addColumn<int>("verdict");
        QTest::newRow("any") << 0 << 0 << 500 << 0 << int{CTL_MARK_VERDICT_SEARCHED};
        QTest::newRow("minimum") << 400 << 0 << 500 << 400 << int{CTL_MARK_VERDICT_SEARCHED};
        QTest::newRow("too narrow") << 600 << 0 << 500 << 500 << int{CTL_MARK_VERDICT_TOO_NARROW};
        QTest::newRow("just not too narrow") << 500 << 500 << 500 << 500 << int{CTL_MARK_VERDICT_SEARCHED};
        QTest::newRow("maximum") << 0 << 600 << 500 << 500 << int{CTL_MARK_VERDICT_SEARCHED};
        QTest::newRow("too wide, known at the maximum")
            << 0 << 300 << 500 << 301 << int{CTL_MARK_VERDICT_TOO_WIDE};
    }
    void judgesAMarkAsSoonAsItsWidthAllows()
    {
        QFETCH(int, narrowest);
        QFETCH(int, widest);
        QFETCH(int, width);
        QFETCH(int, judgedAt);
        QFETCH(int, verdict);
        ctl_marks marks{};
        ctl_mark_settings settings{};
        settings.nominal = 100'000;
        ctl_marks_search(&marks, &settings, 0);
        ctl_mark_sensor sensor{};
        sensor.narrowest = narrowest;
        sensor.widest = widest;
        sensor.edge.at = 7000;
        ctl_mark_sensor_begin(&sensor, &marks);
        int judged = sensor.waits ? -1 : 0;
        for (int at = 1; at < width; ++at) {
            if (sensor.waits)
                ctl_mark_sensor_watch(&sensor, &marks, 7000 + at);
            if (judged < 0 && !sensor.waits)
                judged = at;
        }
        ctl_mark_sensor_end(&sensor, &marks, 7000 + width);
        QCOMPARE(judged < 0 ? width : judged, judgedAt);
        QCOMPARE(static_cast<int>(sensor.edge.verdict), verdict);
        QCOMPARE(sensor.edge.width, std::int64_t{width});
        QVERIFY(!sensor.there);
        QCOMPARE(marks.unexpected, verdict == CTL_MARK_VERDICT_SEARCHED ? 0u : 1u);
        QCOMPARE(marks.has_candidate, verdict == CTL_MARK_VERDICT_SEARCHED);
    }

    // More edges at a time than there is room for: the first ones are recorded, none twice.
    void recordsABurst()
    {
        ctl_edges edges{};
        for (std::int64_t i = 0; i < 10; ++i) {
            const ctl_edge edge{i * 256, 0, 0, {}, {}, CTL_MARK_VERDICT_NOT_USED, 0};
            ctl_edges_add(&edges, &edge);
        }
        for (int i = 0; i < 100; ++i)
            ctl_edges_work(&edges, 1000, 1);
        QCOMPARE(edges.number, std::uint32_t{CTL_EDGES_WAITING});
        for (std::uint32_t i = 0; i < CTL_EDGES_WAITING; ++i)
            QCOMPARE(edges.records[CTL_EDGE_REGISTERS * (i + 1) + 1], static_cast<std::uint16_t>(1000 * i));
    }
};

CAMPANEL_TEST(TestPackingSensors)

} // namespace test_packing_sensors

#include "test_packing_sensors.moc"
