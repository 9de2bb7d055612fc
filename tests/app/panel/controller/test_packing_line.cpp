// SPDX-License-Identifier: Apache-2.0
// The packing line as reported by its controller: requested only where it exists, each bag reported once, and
// bags of several lengths.
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_packing_line {

using namespace campanel;
using namespace campanel::test;
using panel::PackingLine;
using panel::Telemetry;

namespace {

constexpr double bagMm = 250;

// The group `packer` as registers.
struct Film {
    std::vector<std::uint16_t> registers = std::vector<std::uint16_t>(modbus::packerRegisters(), 0);

    Film()
    {
        for (const char* name : {"packer.cuts", "packer.seen_marks", "packer.seen_products"}) {
            for (std::uint16_t i = 0; i < modbus::findSpan(name)->count; ++i)
                put(name, 0x8000, i);
        }
    }
    void put(const char* name, unsigned value, std::size_t at = 0)
    {
        registers[modbus::findSpan(name)->address - modbus::packerAddress + at] =
            static_cast<std::uint16_t>(value);
    }
    void putWide(const char* name, std::uint32_t value)
    {
        put(name, value >> 16);
        put(name, value & 0xFFFFu, 1);
    }
    // Adds the newest bag.
    void addBag(std::uint32_t number, double deviationMm, unsigned lengths = 1)
    {
        const std::size_t at = 4 * (number % modbus::bagRecords);
        put("packer.bags", static_cast<unsigned>(std::lround(1000 * deviationMm)), at);
        put("packer.bags", lengths << 8, at + 3);
        putWide("packer.bag_number", number);
    }
};

struct Rig : PanelRig {
    Film film;

    explicit Rig(std::uint16_t mapMinor = modbus::mapMinor)
    {
        connect(mapMinor);
        link.status.state = modbus::State::Running;
        link.activate(image(), now);
        link.status.masterSpeedPercent = 100;
        link.sendStatus(now);
    }
    void connect(std::uint16_t mapMinor = modbus::mapMinor)
    {
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.portName = QStringLiteral("/dev/fake");
        report.simulator = link::SimulatorState::Serving;
        report.identity = FakeLink::identity();
        report.identity->mapMinor = mapMinor;
        emit link.reported(report);
    }
    [[nodiscard]] PackingLine& line() { return *machine.packing(); }
    [[nodiscard]] qsizetype filmReads() const
    {
        return std::ranges::count(link.reads, modbus::packerAddress, &link::ReadRequest::address);
    }
    void answer(link::ReadEnd end = link::ReadEnd::Done)
    {
        const bool isDone = end == link::ReadEnd::Done;
        const auto asked = std::ranges::find(link.reads.rbegin(), link.reads.rend(), modbus::packerAddress,
                                             &link::ReadRequest::address);
        emit link.registersRead(
            {*asked, end, isDone ? film.registers : std::vector<std::uint16_t>(), now, std::nullopt});
    }
    // Answers the next automatic request.
    void answerNext()
    {
        const qsizetype before = filmReads();
        QTRY_VERIFY(filmReads() > before);
        answer();
    }
    void answerParameter(const char* name, double value)
    {
        for (const link::ParameterRequest& asked : link.parameters) {
            if (asked.name == name)
                emit link.parameterEnded({asked.id, name, link::ParameterEnd::Done, value, std::nullopt});
        }
    }
};

} // namespace

class TestPackingLine : public QObject {
    Q_OBJECT

private slots:
    void isAskedForOfACutterAlone()
    {
        PanelRig other;
        begin(other, ProgramKind::PositionMove);
        other.connectRunning();
        QCOMPARE(other.link.reads.size(), 0);
        QVERIFY(!other.machine.packing()->present());
        Rig old(1);
        QCOMPARE(old.link.reads.size(), 0);
        QCOMPARE(old.link.parameters.size(), 0);
        QVERIFY(!old.line().present());
        Rig rig;
        QCOMPARE(rig.link.reads.size(), 1);
        QCOMPARE(rig.link.reads[0].address, modbus::packerAddress);
        QCOMPARE(rig.link.reads[0].count, modbus::packerRegisters());
        QVERIFY(rig.line().present());
        QVERIFY(!rig.line().known());
        QVERIFY(std::isnan(rig.machine.telemetry()->number("packer.mark_error")));
        QVERIFY(rig.line().cuts().isEmpty());
    }

    void isNotAskedWithoutAConnection()
    {
        Rig rig;
        rig.answer();
        QVERIFY(rig.line().known());
        rig.link.becomeLost();
        const qsizetype before = rig.link.reads.size();
        Rig other; // a link with a running clock
        other.answer();
        for (int i = 0; i < 3; ++i)
            other.answerNext();
        QCOMPARE(rig.link.reads.size(), before);
        QVERIFY2(rig.line().present(), "what was known stays, old");
        rig.connect();
        QTRY_VERIFY(rig.link.reads.size() > before);
    }

    void ages()
    {
        Rig rig;
        rig.answer();
        QVERIFY(rig.line().fresh());
        rig.now += std::chrono::milliseconds(1100);
        QVERIFY(!rig.line().fresh());
        QVERIFY(rig.line().known());
    }

    void aFailedReadIsRepeated()
    {
        Rig rig;
        rig.answer(link::ReadEnd::Failed);
        QVERIFY(!rig.line().known());
        rig.answerNext();
        QVERIFY(rig.line().known());
    }

    void numbersByTheNamesOfTheirRegisters()
    {
        Rig rig;
        const Telemetry& telemetry = *rig.machine.telemetry();
        int numbers = 0;
        for (const modbus::RegisterInfo& info : modbus::registers()) {
            const bool isNumber = info.name.starts_with("packer.") && info.enumName.empty() &&
                                  info.type != modbus::RegisterType::Block;
            if (!isNumber)
                continue;
            ++numbers;
            QVERIFY2(std::isnan(telemetry.number(info.name.data())), info.name.data());
            if (info.count == 2)
                rig.film.putWide(info.name.data(), 70'000u + info.address);
            else
                rig.film.put(info.name.data(), 0x10000u - info.address);
        }
        QVERIFY(numbers >= 22);
        rig.answer();
        for (const modbus::RegisterInfo& info : modbus::registers()) {
            if (!telemetry.contains(QString::fromLatin1(info.name)))
                continue;
            const double raw = info.count == 2                          ? 70'000 + info.address
                               : info.type == modbus::RegisterType::I16 ? -info.address
                                                                        : 0x10000 - info.address;
            QVERIFY2(std::abs(telemetry.number(info.name.data()) - raw * info.scale) < 1e-9,
                     info.name.data());
        }
        rig.connect();
        link::LinkReport other;
        other.state = link::LinkState::Searching;
        emit rig.link.reported(other);
        QVERIFY(std::isnan(telemetry.number("packer.marks")));
    }

    void onlyAChangedNumberIsNotified()
    {
        Rig rig;
        const Telemetry& telemetry = *rig.machine.telemetry();
        const auto notified = [&](const char* name) {
            const QMetaObject& type = *telemetry.metaObject();
            return type.property(type.indexOfProperty(name)).notifySignal();
        };
        rig.answer();
        QSignalSpy marks(&telemetry, notified("packer.marks"));
        QSignalSpy products(&telemetry, notified("packer.products"));
        rig.film.putWide("packer.marks", 7);
        rig.answerNext();
        QCOMPARE(marks.size(), 1);
        QCOMPARE(products.size(), 0);
    }

    void theScreenCannotWriteANumber()
    {
        Rig rig;
        rig.film.putWide("packer.marks", 7);
        rig.answer();
        rig.machine.telemetry()->setProperty("packer.marks", 8);
        rig.machine.telemetry()->setProperty("packer.other", 8);
        QCOMPARE(rig.machine.telemetry()->number("packer.marks"), 7.0);
        QVERIFY(!rig.machine.telemetry()->contains(QStringLiteral("packer.other")));
    }

    void numbersAsAPersonReadsThem_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("signed") << "packer.mark_error" << -0.124 << "−0.12 mm";
        QTest::newRow("with its sign") << "packer.mark_error" << 0.126 << "+0.13 mm";
        QTest::newRow("a measure") << "packer.mark_pitch" << 251.0 << "251.00 mm";
        QTest::newRow("meters") << "packer.film_saved" << 1.54 << "1.5 m";
        QTest::newRow("a count") << "packer.cuts_skipped" << 12345.0 << "12,345";
        QTest::newRow("unknown") << "packer.marks" << panel::unknown << "--";
        QTest::newRow("no register") << "packer.mark_eror" << 1.0 << "--";
    }

    void numbersAsAPersonReadsThem()
    {
        QFETCH(QString, name);
        QFETCH(double, value);
        QFETCH(QString, text);
        Rig rig;
        QCOMPARE(rig.machine.telemetry()->text(name, value), text);
    }

    void whatLiesOnTheFilm()
    {
        Rig rig;
        rig.film.put("packer.mark_state", static_cast<unsigned>(modbus::MarkState::Tracking));
        rig.film.putWide("packer.mark_pitch", 251'000);
        rig.film.put("packer.cuts", 1000, 0);
        rig.film.put("packer.cuts", 3501, 1);
        rig.film.put("packer.seen_marks", 1000, 0);
        rig.film.put("packer.seen_marks", 3501, 1);
        rig.film.put("packer.seen_products", 200, 0);
        rig.film.put("packer.seen_products", 1700, 1);
        rig.film.putWide("packer.film_position", 1'234'500);
        rig.answer();
        const PackingLine& line = rig.line();
        QCOMPARE(line.cuts(), (QList<QPointF>{{100, 0}, {350, 1}}));
        QCOMPARE(line.seenMarks(), (QList<QPointF>{{100, 0}, {350, 1}}));
        QCOMPARE(line.seenProducts(), (QList<QPointF>{{20, 170}}));
        QCOMPARE(line.filmPositionMm(), 1234.5);
        QCOMPARE(line.nextMarkMm(), 601.0);
        QCOMPARE(rig.machine.run()->marks(), "Tracking marks");
        QCOMPARE(line.filmSpeedMmPerS(), bagMm / rig.machine.active().cycleSeconds);
        QVERIFY(rig.machine.run()->film().isEmpty());
        rig.film.put("packer.knife_gate", static_cast<unsigned>(modbus::GateState::Standing));
        rig.film.put("packer.mark_state", static_cast<unsigned>(modbus::MarkState::Searching));
        rig.answerNext();
        QVERIFY(line.knifeOpen());
        QCOMPARE(rig.machine.run()->film(), "Knife stays open: product in its path");
        QVERIFY2(std::isnan(line.nextMarkMm()), "none is expected while they are looked for");
        rig.film.put("packer.film_gate", static_cast<unsigned>(modbus::GateState::Standing));
        rig.answerNext();
        QCOMPARE(line.filmSpeedMmPerS(), 0.0);
        QCOMPARE(rig.machine.run()->film(), "Film waits for a product");
    }

    void sensorAndWindowAreReadOnceAndFollowEveryWrite()
    {
        Rig rig;
        const auto asked = [&rig] { // without those of the master
            return std::ranges::count_if(rig.link.parameters, [](const link::ParameterRequest& request) {
                return request.name.starts_with("parameter.");
            });
        };
        QCOMPARE(asked(), 3);
        QVERIFY(std::isnan(rig.line().sensorMm()));
        rig.answerParameter("parameter.mark_distance", 900);
        rig.answerParameter("parameter.mark_window", 6);
        QVERIFY2(rig.line().marksWanted(), "the marks count as wanted until the controller says otherwise");
        rig.answerParameter("parameter.mark_tracking", 0);
        QVERIFY(!rig.line().marksWanted());
        QCOMPARE(rig.line().sensorMm(), 900.0);
        QCOMPARE(rig.line().windowMm(), 6.0);
        rig.answer();
        rig.answerNext();
        QCOMPARE(asked(), 3);
        emit rig.link.parameterEnded(
            {9000, "parameter.mark_distance", link::ParameterEnd::Done, 850, std::nullopt});
        QCOMPARE(rig.line().sensorMm(), 850.0);
        emit rig.link.parameterEnded({9001, "parameter.mark_distance", link::ParameterEnd::OutcomeUnknown,
                                      std::nullopt, std::nullopt});
        rig.answerNext();
        QTRY_COMPARE(asked(), 4);
        rig.answerParameter("parameter.mark_distance", 860);
        QCOMPARE(rig.line().sensorMm(), 860.0);
        // After a lost connection the values are uncertain.
        rig.link.becomeLost();
        QCOMPARE(rig.line().sensorMm(), 860.0);
        rig.connect();
        QTRY_COMPARE(asked(), 7);
    }

    void eachBagIsReportedOnce()
    {
        Rig rig;
        QSignalSpy told(&rig.line(), &PackingLine::bagRecorded);
        rig.film.addBag(41, 0.1);
        rig.answer();
        QVERIFY2(told.isEmpty(), "what was made before is of another program, perhaps");
        rig.film.addBag(42, 0.2);
        rig.film.addBag(43, 0.3);
        rig.answerNext();
        QCOMPARE(told.size(), 2);
        QCOMPARE(told[0][0].value<modbus::BagRecord>().number, 42u);
        QCOMPARE(told[1][0].value<modbus::BagRecord>().number, 43u);
        rig.answerNext();
        QCOMPARE(told.size(), 2);
        // A restarted controller counts from the start.
        rig.film.addBag(1, 0);
        rig.answerNext();
        QCOMPARE(told.size(), 2);
        rig.film.addBag(2, 0);
        rig.answerNext();
        QCOMPARE(told.size(), 3);
    }

    void aBagOfTwoLengthsSpoilsNothing()
    {
        Rig rig;
        rig.settings.set("bags.tolerance_mm", panel::settingText(0.15));
        rig.film.addBag(1, 0);
        rig.answer();
        rig.film.addBag(2, 20); // begun under another program
        rig.answerNext();
        QVERIFY(rig.machine.bags().series.isEmpty());
        rig.film.addBag(3, 0.1);
        rig.film.addBag(4, -0.2, 2);
        rig.film.addBag(5, 0.1);
        // The status reports the same bags: they count once.
        rig.link.status.bagCount = 5;
        rig.link.status.bagLengthMm = 499.8;
        rig.link.status.bagDeviationMm = 249.8;
        rig.link.sendStatus(rig.now);
        rig.answerNext();
        QCOMPARE(rig.machine.bags().series, (QList<double>{0.1, -0.2, 0.1}));
        QVERIFY(std::abs(rig.machine.bags().meanMm - bagMm) < 1e-9);
        QVERIFY(std::abs(rig.machine.bags().scatterMm - std::sqrt(0.03)) < 1e-9);
        QCOMPARE(rig.machine.bags().within, 2);
        QCOMPARE(rig.machine.bags().lengthMm, bagMm + 0.1);
        rig.film.addBag(6, 0.05, 3);
        rig.answerNext();
        QCOMPARE(rig.machine.bags().lengthMm, 3 * bagMm + 0.05);
        QCOMPARE(rig.machine.bags().lengths, 3);
    }

    void toleranceIsKept()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.ini"));
        {
            panel::Settings settings(path, nullptr);
            QCOMPARE(settings.bagToleranceMm(), 0.5);
            QSignalSpy changed(&settings, &panel::Settings::changed);
            settings.set("bags.tolerance_mm", panel::settingText(0.2));
            settings.set("bags.tolerance_mm", panel::settingText(0.2));
            QCOMPARE(changed.size(), 1);
        }
        panel::Settings settings(path, nullptr);
        QCOMPARE(settings.bagToleranceMm(), 0.2);
        settings.set("bags.tolerance_mm", panel::settingText(NAN));
        QCOMPARE(settings.bagToleranceMm(), 0.2);
        settings.set("bags.tolerance_mm", panel::settingText(100));
        QCOMPARE(settings.bagToleranceMm(), settings.setting("bags.tolerance_mm")->maximum());
    }
};

CAMPANEL_TEST(TestPackingLine)

} // namespace test_packing_line

#include "test_packing_line.moc"
