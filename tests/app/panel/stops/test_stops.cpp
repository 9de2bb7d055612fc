// SPDX-License-Identifier: Apache-2.0
// Stops of a machine on a fake link: states, pieces and reasons are recorded, long stops are asked about, and
// the answers are in the shift, in the CSV files and in the audit trail.
#include "stop_rig.h"
#include "tests/support/packer_image.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_stops {

using namespace campanel;
using modbus::State;
using panel::ShiftView;
using store::StateInterval;
using test::StopRig;

namespace {

panel::StopReason reason(const char* group, bool isPlanned = false)
{
    return {QString::fromLatin1(group), {}, isPlanned};
}

void run(StopRig& rig)
{
    rig.panel.connectRunning();
    rig.pass(10);
}

void showShift(StopRig& rig)
{
    rig.stops->shift()->setWatched(true);
    rig.stops->shift()->refresh();
    rig.settle();
    rig.settle();
}

} // namespace

class TestStops : public QObject {
    Q_OBJECT

private slots:
    void statesAndPiecesAreRecorded()
    {
        StopRig rig;
        run(rig);
        for (int i = 0; i < 20; ++i) {
            ++rig.panel.link.status.bagCount;
            rig.panel.link.status.bagLengthMm = 250;
            rig.panel.link.status.bagDeviationMm = i < 3 ? 2.0 : 0.1; // three are out of the tolerance
            rig.pass(1);
        }
        rig.setState(State::Ready);
        rig.pass(30);
        const auto span = rig.logged();
        QCOMPARE(span.intervals.size(), 2);
        const StateInterval& ran = span.intervals[0];
        QCOMPARE(ran.state, StateInterval::State::Running);
        QCOMPARE(ran.program, QStringLiteral("Biscuit 250"));
        QCOMPARE(ran.durationMs, 30'000);
        QCOMPARE(ran.pieces, 20);
        QCOMPARE(ran.outOfTolerance, 3);
        // The recipe's fastest rate on the machine of the panel.
        QCOMPARE(ran.idealPerMin, rig.panel.editor.solution().fastest->rateBagsPerMin);
        QCOMPARE(span.intervals[1].stop, span.intervals[1].id);
        QCOMPARE(span.intervals[1].durationMs, 30'000);
    }

    void theBuildersIdealRateGoesFirst()
    {
        StopRig rig;
        rig.panel.settings.setting(QStringLiteral("stops.ideal_rate"))->set(77.5);
        run(rig);
        QCOMPARE(rig.logged().intervals.first().idealPerMin, 77.5);
    }

    void recordedBagsAreCountedByTheirFlags()
    {
        StopRig rig;
        run(rig);
        const auto record = [&](auto change) {
            modbus::BagRecord bag;
            change(bag);
            emit rig.panel.machine.packing()->bagRecorded(bag);
        };
        record([](modbus::BagRecord& bag) { bag.isStartUp = true; });
        record([](modbus::BagRecord& bag) { bag.isChangeOver = true; });
        record([](modbus::BagRecord& bag) { bag.deviationMm = -0.6; });
        record([](modbus::BagRecord& bag) { bag.deviationMm = 0.5; }); // at the limit
        rig.pass(1);
        const StateInterval ran = rig.logged().intervals.first();
        QCOMPARE(ran.pieces, 4);
        QCOMPARE(ran.startUpScrap, 2);
        QCOMPARE(ran.outOfTolerance, 1);
    }

    void aFaultAndTheLimitOfSkipsBringTheirReason()
    {
        StopRig rig;
        run(rig);
        rig.panel.link.status.faultBits = 1u << static_cast<unsigned>(modbus::FaultBit::DriveAlarm);
        rig.setState(State::Fault);
        rig.pass(100);
        QCOMPARE(rig.stops->reason(), QStringLiteral("C-08"));
        QCOMPARE(rig.stops->reasonText(), QStringLiteral("Drive alarm (C-08)"));
        QVERIFY2(rig.stops->lastTitle().startsWith(QStringLiteral("Stopped at ")),
                 qPrintable(rig.stops->lastTitle()));
        QVERIFY(!rig.stops->asking());
        rig.panel.link.status.faultBits = 0;
        rig.setState(State::Running);
        rig.pass(10);
        QCOMPARE(rig.stops->reason(), QString());
        // It stays in sight while the machine runs.
        QVERIFY2(rig.stops->lastTitle().startsWith(QStringLiteral("Last stop ")),
                 qPrintable(rig.stops->lastTitle()));
        QCOMPARE(rig.stops->lastReason(), QStringLiteral("Drive alarm (C-08)"));
        QCOMPARE(rig.stops->lastDuration(), QStringLiteral("1 min"));
        rig.panel.link.status.warningBits = 1u << static_cast<unsigned>(modbus::WarningBit::TooManySkips);
        rig.setState(State::Ready);
        rig.pass(100);
        QVERIFY(!rig.stops->asking());
        const auto stops = rig.logged().stops;
        QCOMPARE(stops.size(), 2);
        QCOMPARE(stops[1].reason, panel::AlarmCatalogue::of(modbus::WarningBit::TooManySkips).code());
    }

    // The times and pieces of an order are its own, though the machine ran before and goes on behind.
    void anOrdersTimeIsShown()
    {
        StopRig rig;
        run(rig);
        rig.pass(100);
        rig.stops->divide();
        const qint64 beginMs = rig.wallMs;
        rig.pass(60);
        rig.setState(State::Ready);
        rig.pass(30);
        rig.setState(State::Running);
        rig.pass(30);
        rig.stops->divide();
        const qint64 endMs = rig.wallMs;
        rig.pass(100);
        panel::ShiftView& view = *rig.stops->shift();
        view.setWatched(true);
        view.showOrder(QStringLiteral("4711"), static_cast<double>(beginMs), static_cast<double>(endMs));
        rig.settle();
        QTRY_COMPARE(view.content(), panel::ShiftView::Shown);
        QVERIFY2(view.title().startsWith(QStringLiteral("4711 · ")), qPrintable(view.title()));
        QCOMPARE(view.summary().production.runMs, 90'000);
        QCOMPARE(view.summary().stopMs, 30'000);
        QCOMPARE(view.stops()->count(), 1);
        QCOMPARE(view.availability(), 0.75);
        view.refresh(); // it stays until somebody chooses another time
        rig.settle();
        QVERIFY(!view.isPresent());
        view.showPresent();
        rig.settle();
        QTRY_COMPARE(view.content(), panel::ShiftView::Shown);
        QVERIFY(view.isPresent());
        QVERIFY(view.summary().production.runMs >= 290'000);
    }

    void aLongStopIsAskedAbout()
    {
        StopRig rig;
        run(rig);
        QSignalSpy changed(rig.stops.get(), &panel::Stops::presentChanged);
        rig.setState(State::Ready);
        rig.pass(59);
        QVERIFY(!rig.stops->asking());
        rig.pass(1);
        QVERIFY(rig.stops->asking());
        QVERIFY2(rig.stops->sinceText().endsWith(QStringLiteral("1 min")),
                 qPrintable(rig.stops->sinceText()));
        panel::ReasonKeys& keys = *rig.stops->keys();
        QVERIFY(keys.rows()->count() <= 8);
        keys.touch(0); // Material has reasons of its own
        QCOMPARE(keys.groupText(), QStringLiteral("Material"));
        QVERIFY(rig.stops->asking());
        keys.touch(0);
        QVERIFY(!rig.stops->asking());
        QCOMPARE(rig.stops->reason(), QStringLiteral("material/film_change"));
        QCOMPARE(rig.stops->reasonText(), QStringLiteral("Material · Film change"));
        QCOMPARE(keys.groupText(), QString());
        const auto span = rig.logged();
        QCOMPARE(span.stops.size(), 1);
        QCOMPARE(span.stops[0].reason, QStringLiteral("material/film_change"));
    }

    void theQuestionGoesWithTheStop()
    {
        StopRig rig;
        run(rig);
        rig.setState(State::Ready);
        rig.pass(100);
        QVERIFY(rig.stops->asking());
        rig.setState(State::Running);
        QVERIFY(!rig.stops->asking());
        rig.pass(5);
        QVERIFY(rig.logged().stops.isEmpty()); // without a reason
        rig.setState(State::Ready);
        rig.pass(100);
        QVERIFY(rig.stops->asking());
        rig.stops->postpone();
        QVERIFY(!rig.stops->asking());
        rig.pass(100);
        QVERIFY(!rig.stops->asking());
    }

    void withoutAProgramNobodyIsAsked()
    {
        StopRig rig;
        rig.panel.connectIdle();
        rig.pass(200);
        QVERIFY(!rig.stops->asking());
        QVERIFY2(rig.logged().intervals.isEmpty(), "a machine that never had a program does not stand");
    }

    void aStopIsAnsweredLaterAndAnsweredAnew()
    {
        StopRig rig;
        QSignalSpy noted(rig.stops.get(), &panel::Stops::noted);
        rig.panel.machine.accessCheck().setLevel(panel::Level::Service, QStringLiteral("Ann"));
        run(rig);
        rig.setState(State::Ready);
        rig.pass(90);
        rig.setState(State::Running);
        rig.pass(10);
        showShift(rig);
        ShiftView& shift = *rig.stops->shift();
        QCOMPARE(shift.stops()->count(), 1);
        QCOMPARE(shift.openStops(), 1);
        QVERIFY(shift.stops()->row(0).isOpen());
        shift.select(0);
        QVERIFY(shift.selectedText().contains(QStringLiteral("1 min")));
        QSignalSpy answered(&shift, &ShiftView::answered);
        shift.keys()->touch(4); // cleaning
        QCOMPARE(answered.size(), 1);
        rig.settle();
        rig.settle();
        QCOMPARE(shift.openStops(), 0);
        QCOMPARE(shift.stops()->row(0).reasonText(), QStringLiteral("Cleaning"));
        QCOMPARE(shift.stops()->row(0).by(), QStringLiteral("Ann"));
        QCOMPARE(noted.size(), 0); // the first answer
        shift.select(0);
        shift.keys()->touch(6); // a break is planned
        rig.settle();
        rig.settle();
        QCOMPARE(noted.size(), 1);
        const auto entry = noted[0][0].value<store::AuditEntry>();
        QCOMPARE(entry.what, QStringLiteral("stop.reason"));
        QCOMPARE(entry.before, QStringLiteral("cleaning"));
        QCOMPARE(entry.after, QStringLiteral("break"));
        QCOMPARE(shift.summary().plannedStopMs, 90'000);
        QCOMPARE(shift.summary().production.plannedMs, 20'000);
        QCOMPARE(shift.availability(), 1.0);
    }

    void anAnswerIsUndoneAlsoAfterTheStop()
    {
        StopRig rig;
        QSignalSpy noted(rig.stops.get(), &panel::Stops::noted);
        run(rig);
        rig.setState(State::Ready);
        rig.pass(90);
        const qint64 stop = rig.stops->book().presentStop().id;
        QVERIFY(rig.stops->answer(stop, reason("cleaning")));
        QCOMPARE(rig.stops->answerText(), QStringLiteral("Stop reason: Cleaning."));
        QVERIFY(rig.stops->answer(stop, reason("break")));
        rig.stops->undoAnswer();
        QCOMPARE(rig.stops->reason(), QStringLiteral("cleaning"));
        QVERIFY(rig.stops->answerText().isEmpty());
        rig.stops->undoAnswer(); // only the last answer
        QCOMPARE(rig.stops->reason(), QStringLiteral("cleaning"));
        QCOMPARE(noted.size(), 2); // the trail has both ways
        QVERIFY(rig.stops->answer(stop, reason("break")));
        rig.setState(State::Running);
        rig.pass(10);
        rig.panel.machine.accessCheck().setLevel(panel::Level::Viewer);
        rig.stops->undoAnswer();
        QVERIFY(!rig.stops->answerText().isEmpty());
        rig.panel.machine.accessCheck().setLevel(panel::Level::Operator);
        rig.stops->undoAnswer();
        QCOMPARE(rig.logged().stops.first().reason, QStringLiteral("cleaning"));
    }

    void onlyOperatorsAnswer()
    {
        StopRig rig;
        run(rig);
        rig.setState(State::Ready);
        rig.pass(90);
        rig.panel.machine.accessCheck().setLevel(panel::Level::Viewer);
        QVERIFY(!rig.stops->answer(rig.stops->book().presentStop().id, reason("cleaning")));
        QVERIFY(rig.stops->asking());
        rig.panel.machine.accessCheck().setLevel(panel::Level::Operator);
        QVERIFY(rig.stops->answer(rig.stops->book().presentStop().id, reason("cleaning")));
        QVERIFY(!rig.stops->asking());
    }

    void aShiftHasItsFigures()
    {
        StopRig rig;
        rig.panel.settings.setting(QStringLiteral("stops.ideal_rate"))->set(120);
        run(rig);
        for (int i = 0; i < 100; ++i) {
            ++rig.panel.link.status.bagCount;
            rig.panel.link.status.bagDeviationMm = i < 10 ? 2.0 : 0.1;
            rig.panel.link.status.bagLengthMm = 250;
            rig.pass(1);
        }
        rig.setState(State::Ready);
        rig.pass(50);
        showShift(rig);
        ShiftView& shift = *rig.stops->shift();
        QCOMPARE(shift.content(), ShiftView::Shown);
        QVERIFY(shift.isPresent());
        QVERIFY(std::abs(shift.availability() - 110.0 / 160) < 1e-9);
        QVERIFY(std::abs(shift.performance() - 100 * 0.5 / 110) < 1e-9);
        QVERIFY(std::abs(shift.quality() - 0.9) < 1e-9);
        QVERIFY(std::abs(shift.oee() - shift.availability() * shift.performance() * 0.9) < 1e-12);
        QCOMPARE(shift.bar()->count() > 0, true);
        QCOMPARE(shift.reasons()->count(), 1);
        QVERIFY2(shift.reasons()->row(0).text().startsWith(QStringLiteral("Short stops")),
                 qPrintable(shift.reasons()->row(0).text()));
        shift.showPrevious();
        rig.settle();
        QVERIFY(!shift.isPresent());
        QCOMPARE(shift.content(), ShiftView::Nothing);
        QVERIFY(std::isnan(shift.oee()));
        shift.showNext();
        rig.settle();
        QVERIFY(shift.isPresent());
        shift.showNext(); // not into the future
        QVERIFY(shift.isPresent());
    }

    void stopsAndStatesAreExported()
    {
        StopRig rig;
        run(rig);
        rig.setState(State::Ready);
        rig.pass(90);
        QVERIFY(rig.stops->answer(rig.stops->book().presentStop().id, reason("cleaning")));
        showShift(rig);
        QSignalSpy ready(rig.stops->shift()->csv(), &panel::CsvExport::ready);
        rig.stops->shift()->csv()->make(rig.panel.maintenance.files());
        QVERIFY(ready.wait());
        const QString folder = rig.panel.folder.filePath(QStringLiteral("out"));
        QVERIFY(QDir().mkpath(folder));
        panel::ReportFiles& files = *rig.panel.maintenance.files();
        QTRY_VERIFY(!files.busy());
        files.setScanner([&](const QString&) {
            return QList<store::Place>{{folder, QStringLiteral("out"), false}};
        });
        files.scan();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        QFile stops(folder + QStringLiteral("/stops.csv"));
        QVERIFY(stops.open(QIODevice::ReadOnly));
        QVERIFY(stops.readAll().contains(",90.000,ready,cleaning,no,"));
        QFile states(folder + QStringLiteral("/states.csv"));
        QVERIFY(states.open(QIODevice::ReadOnly));
        QVERIFY(states.readAll().contains(",running,,Biscuit 250,"));
    }

    void aRestartGoesOnWithTheStop()
    {
        StopRig rig;
        run(rig);
        rig.setState(State::Ready);
        rig.pass(90);
        QVERIFY(rig.stops->answer(rig.stops->book().presentStop().id, reason("cleaning")));
        const qint64 stop = rig.stops->book().presentStop().id;
        rig.restart(); // what was not written yet is
        rig.pass(30);
        QCOMPARE(rig.stops->book().presentStop().id, stop);
        QCOMPARE(rig.stops->reason(), QStringLiteral("cleaning"));
        qint64 sum = 0;
        for (const StateInterval& each : rig.logged().intervals)
            sum += each.stop == stop ? each.durationMs : 0;
        QCOMPARE(sum, 119'000); // the second of the restart is unknown
    }

    void aFullDiskIsToldOnceAndNothingIsLost()
    {
        StopRig rig;
        run(rig);
        const auto setPages = [&](bool isFull) {
            rig.records->store().run(
                rig.records.get(),
                [isFull](store::Database& database) {
                    auto pages = database.execute(QStringLiteral("PRAGMA page_count"));
                    const int count = pages && pages->next() ? pages->value(0).toInt() : 1;
                    pages->finish();
                    return database
                        .execute(QStringLiteral("PRAGMA max_page_count = %1").arg(isFull ? count : 1'000'000))
                        .has_value();
                },
                [](bool) {});
            rig.settle();
        };
        rig.stops->write();
        rig.settle();
        setPages(true);
        QSignalSpy told(rig.records.get(), &panel::DatabaseService::errorReported);
        for (int i = 0; i < 600; ++i) { // fills the last page, and more
            rig.setState(i % 2 == 0 ? State::Ready : State::Running);
            rig.pass(1);
            rig.settle();
        }
        QCOMPARE(told.size(), 1);
        setPages(false);
        rig.pass(10);
        rig.settle();
        rig.pass(10);
        qint64 sum = 0;
        for (const StateInterval& each : rig.logged().intervals)
            sum += each.durationMs;
        QCOMPARE(sum, 630'000);
        QCOMPARE(told.size(), 1);
    }
};

CAMPANEL_TEST(TestStops)

} // namespace test_stops

#include "test_stops.moc"
