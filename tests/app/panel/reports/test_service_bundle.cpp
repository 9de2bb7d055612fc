// SPDX-License-Identifier: Apache-2.0
// The archive for the manufacturer: its contents, and the last seconds of the machine.
#include "tests/app/panel/access_rig.h"

#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/reports/service_bundle.h"
#include "app/program/table/table_columns.h"
#include "app/store/recipes/recipe_json.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTimeZone>

#include <algorithm>
#include <utility>

namespace test_service_bundle {

using namespace campanel;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using panel::ServiceBundle;
using panel::StatusTrace;
using test::AccessRig;

namespace {

constexpr qint64 maxBytes = 50'000'000;

struct BundleRig : AccessRig {
    ServiceBundle bundle{
        {machine, editor, records, *maintenance.figures(), *maintenance.files(), *maintenance.frames()},
        nullptr};

    BundleRig()
    {
        bundle.setWallClock([this] { return QDateTime::fromMSecsSinceEpoch(wallMs, QTimeZone::utc()); });
        const QString stick = folder.filePath(u"stick"_s);
        maintenance.files()->setScanner([stick](const QString&) {
            return QList<store::Place>{{stick, u"stick"_s, false}};
        });
        QDir().mkpath(stick);
    }

    // Returns the archive on the stick; fails the test when there is none.
    [[nodiscard]] QString make()
    {
        QSignalSpy offered(&bundle, &ServiceBundle::offered);
        bundle.make();
        emit link.figuresReported({});
        for (const link::ReadRequest& request : std::exchange(link.reads, {}))
            emit link.registersRead(
                {request, link::ReadEnd::Done, std::vector<std::uint16_t>(request.count, 7), now, {}});
        panel::ReportFiles& files = *maintenance.files();
        if (!QTest::qWaitFor(
                [&] { return offered.count() == 1 && !files.busy() && files.places()->count() == 1; }))
            qFatal("the bundle was not offered");
        files.write(0);
        if (!QTest::qWaitFor([&] { return !files.busy() && !files.message().isEmpty(); }))
            qFatal("the bundle was not written");
        const QStringList found =
            QDir(folder.filePath(u"stick"_s)).entryList({u"*.zip"_s}, QDir::Files, QDir::Time);
        return found.isEmpty() ? QString() : folder.filePath(u"stick/"_s + found.first());
    }
};

// Returns an empty array for a missing entry.
QByteArray entry(const QString& archive, const char* name)
{
    auto reader = store::ArchiveReader::open(archive);
    return reader ? reader->read(QString::fromLatin1(name), maxBytes).value_or(QByteArray()) : QByteArray();
}

QList<QByteArray> lines(const QByteArray& csv)
{
    return csv.trimmed().split('\n');
}

} // namespace

class TestServiceBundle : public QObject {
    Q_OBJECT

private slots:
    void everythingIsInIt()
    {
        BundleRig rig;
        rig.connectRunning();
        rig.settings.set("display.theme", u"dark"_s); // creates an audit entry
        store::AlarmRow old;
        old.id = 1;
        old.code = u"M-01"_s;
        old.raisedMs = rig.wallMs - 8 * 86'400'000LL;
        store::AlarmRow recent = old;
        recent.id = 2;
        recent.code = u"C-02"_s;
        recent.raisedMs = rig.wallMs - 6 * 86'400'000LL;
        recent.detail = u"said, \"so\""_s;
        rig.records.store().run(
            &rig.records,
            [rows = QList{old, recent}](store::Database& database) {
                return store::AlarmLog::write(database, {rows, {}, {}}).has_value();
            },
            [](bool isWritten) { QVERIFY(isWritten); });
        rig.settle();

        const QString archive = rig.make();
        QVERIFY(!archive.isEmpty());
        for (const char* name : {"README.txt", "about.json", "link_figures.csv", "link_24_hours.csv"})
            QVERIFY2(!entry(archive, name).isEmpty(), name);
        const auto recipe = store::fromJson(entry(archive, "recipe.json"), {});
        QVERIFY(recipe.has_value());
        QVERIFY(panel::sameRecipe(*recipe, rig.editor.recipe()));
        QCOMPARE(lines(entry(archive, "table.csv")).size() - 1,
                 static_cast<qsizetype>(program::tableColumns(rig.image())[0].values.size()));
        const QJsonObject controller = QJsonDocument::fromJson(entry(archive, "controller.json")).object();
        QCOMPARE(controller[u"active_crc32"_s].toString(),
                 QString::number(rig.image().crc, 16).toUpper().rightJustified(8, u'0'));
        QCOMPARE(controller[u"generation"_s].toInteger(), qint64(rig.link.status.generation));
        const auto alarms = lines(entry(archive, "alarms.csv"));
        QCOMPARE(alarms.size(), 2); // header and the recent one
        QVERIFY(alarms[1].startsWith("2,C-02,"));
        QVERIFY(alarms[1].contains("\"said, \"\"so\"\"\""));
        const auto audit = lines(entry(archive, "audit.csv"));
        QVERIFY(audit.size() >= 2);
        QVERIFY(audit[1].contains(",theme,light,dark,"));
        QCOMPARE(lines(entry(archive, "trace.csv")).size() - 1,
                 qsizetype(rig.bundle.trace().latest().size()));
        QVERIFY(entry(archive, "trace_before_fault.csv").isEmpty());
        for (const char* name :
             {"alarms.csv", "audit.csv", "trace.csv", "table.csv", "link_figures.csv", "link_24_hours.csv"}) {
            const QByteArray csv = entry(archive, name);
            QVERIFY2(csv.endsWith('\n') && !csv.contains('\r'), name);
        }
    }

    void theMomentOfAFaultIsInIt()
    {
        BundleRig rig;
        rig.connectRunning();
        QByteArray screen("before");
        rig.bundle.setScreen([&screen] { return screen; });
        QVERIFY(entry(rig.make(), "screen_at_fault.png").isEmpty());

        rig.link.status.faultBits = 1;
        rig.link.sendStatus(rig.now);
        QVERIFY(rig.link.areFramesWatched);
        modbus::FrameRecord frame;
        frame.number = 3;
        for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{1, 3, 2, 0, 7})
            frame.data[frame.length++] = byte;
        emit rig.link.framesRecorded({frame});
        QVERIFY(!rig.link.areFramesWatched);
        screen = "with the alarm";
        QTest::qWait(600);
        screen = "later";
        rig.link.sendStatus(rig.now); // the same fault
        const QString archive = rig.make();
        QCOMPARE(entry(archive, "screen_at_fault.png"), QByteArray("with the alarm"));
        QVERIFY(entry(archive, "frames_before_fault.txt").contains("01 03 02 00 07"));
    }

    void parametersAreReadForIt()
    {
        BundleRig rig;
        rig.connectRunning();
        const auto rows = lines(entry(rig.make(), "parameters.csv"));
        QCOMPARE(rows.size() - 1, std::ranges::count_if(modbus::registers(), modbus::isMachineData));
        QVERIFY(std::ranges::any_of(
            rows, [](const QByteArray& row) { return row.startsWith("master.speed_max,"); }));
        QCOMPARE(rows[0], QByteArray("parameter,value"));
        QVERIFY(rows[1].startsWith("parameter."));
    }

    void whatALimitForbidsHasNoTable()
    {
        BundleRig rig;
        program::Recipe recipe = rig.editor.recipe();
        recipe.machine.maxMotorRpm = 1;
        rig.editor.open(recipe);
        QVERIFY(!rig.editor.feasible());
        const QString archive = rig.make();
        QVERIFY(!entry(archive, "recipe.json").isEmpty());
        QVERIFY(entry(archive, "table.csv").isEmpty());
    }

    void theTraceHasTenSecondsAndThoseBeforeAFault()
    {
        StatusTrace trace;
        link::StatusSample sample;
        sample.receivedAt = link::SteadyTime(1h);
        for (int i = 0; i < 2000; ++i) {
            sample.receivedAt += 10ms;
            sample.status.cycleCount = static_cast<std::uint32_t>(i);
            sample.status.faultBits = i >= 1500 && i < 1600 ? 1 : 0;
            trace.add(sample);
        }
        QCOMPARE(trace.latest().size(), std::size_t(1001));
        QCOMPARE(trace.latest().back().status.cycleCount, 1999u);
        QCOMPARE(trace.beforeFault().size(), std::size_t(1001));
        QCOMPARE(trace.beforeFault().back().status.cycleCount, 1500u);

        const QDateTime timeOfDay(QDate(2026, 1, 2), QTime(3, 4, 5), QTimeZone::utc());
        const auto csv = lines(StatusTrace::csv(trace.latest(), sample.receivedAt, timeOfDay));
        QCOMPARE(csv.size(), 1002);
        QVERIFY(csv.last().startsWith("2026-01-02T03:04:05.000Z,"));
        QVERIFY(csv[1].startsWith("2026-01-02T03:03:55.000Z,"));
        QCOMPARE(csv[0].count(','), csv[1].count(','));

        modbus::StatusBlock& status = sample.status;
        status = {};
        status.state = modbus::State::Running;
        status.faultBits = 2;
        status.warningBits = 3;
        status.generation = 4;
        status.cycleCount = 5;
        status.masterAngleDeg = 6.5;
        status.masterSpeedPercent = 7.25;
        status.commandedFrequencyHz = 8;
        status.actualFrequencyHz = 9;
        status.commandedPositionPulses = 10;
        status.axisPositionPulses = 11;
        status.followingErrorPulses = -12;
        status.knifeAngleDeg = 13.125;
        status.bagCount = 14;
        status.bagLengthMm = 15.5;
        status.bagDeviationMm = -0.25;
        status.uptimeS = 17;
        status.sampleTimeMs = 18;
        sample.latency = 19ms;
        const auto each = lines(StatusTrace::csv({sample}, sample.receivedAt, timeOfDay));
        QCOMPARE(
            each[0],
            QByteArray("time_utc,state,fault_bits,warning_bits,generation,cycle,master_deg,master_percent,"
                       "commanded_hz,actual_hz,commanded_pulses,position_pulses,following_error_pulses,"
                       "knife_deg,bag,bag_length_mm,bag_deviation_mm,force_n,uptime_s,sample_ms,latency_ms"));
        QCOMPARE(each[1],
                 QByteArray("2026-01-02T03:04:05.000Z,Running,2,3,4,5,6.500,7.25,8,9,10,11,-12,13.125,14,"
                            "15.500,-0.250,,17,18,19.000"));
    }

    void aSecondRequestWaitsForTheFirst()
    {
        BundleRig rig;
        QSignalSpy offered(&rig.bundle, &ServiceBundle::offered);
        rig.bundle.make();
        rig.bundle.make();
        QVERIFY(rig.bundle.busy());
        QVERIFY(rig.link.areFiguresWatched);
        emit rig.link.figuresReported({});
        QVERIFY(!rig.link.areFiguresWatched);
        emit rig.link.figuresReported({});
        rig.settle();
        QTRY_COMPARE(offered.count(), 1);
        QVERIFY(!rig.bundle.busy());
    }
};

CAMPANEL_TEST(TestServiceBundle)

} // namespace test_service_bundle

#include "test_service_bundle.moc"
