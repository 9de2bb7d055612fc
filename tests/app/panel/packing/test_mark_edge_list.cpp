// SPDX-License-Identifier: Apache-2.0
// The edges of the mark sensor as a technician sees them: on a simulated machine whose film has false and
// missing marks, and with edges written by hand.
#include "app/panel/kit/units.h"
#include "packer_image.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/core_link.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_mark_edge_list {

using namespace campanel;
using modbus::MarkVerdict;
using panel::MarkEdgeList;

namespace {

constexpr double bagMm = 300;

// Texts without the marks that keep a number and its unit together.
QString plain(QString text)
{
    return text.remove(QChar(0x2060)).replace(QChar(0xA0), u' ');
}

// The panel on a fake link, with edges written by hand.
struct EdgeRig : test::PanelRig {
    std::vector<std::uint16_t> registers = std::vector<std::uint16_t>(modbus::sensorRegisters);
    std::uint32_t number = 0;

    EdgeRig()
    {
        editor.bagLength()->set(bagMm);
        connectRunning();
        test::PackerImage packer;
        packer.set("packer.mark_state", static_cast<double>(modbus::MarkState::Tracking));
        packer.set("packer.mark_pitch", bagMm);
        const std::uint16_t count = modbus::packerRegisters(machine.identity()->mapMinor);
        std::vector<std::uint16_t> status = packer.registers();
        status.resize(count);
        emit link.registersRead({{0, modbus::packerAddress, count}, link::ReadEnd::Done, status, now, {}});
        emit link.parameterEnded({0, "parameter.mark_window", link::ParameterEnd::Done, 2.0, {}});
    }

    [[nodiscard]] MarkEdgeList& edges() { return *maintenance.packing()->edges(); }
    void see(double placeMm, MarkVerdict verdict, double offMm, double widthMm = 0)
    {
        ++number;
        registers[0] = static_cast<std::uint16_t>(number >> 16U);
        registers[1] = static_cast<std::uint16_t>(number);
        const auto um = static_cast<std::uint32_t>(std::llround(placeMm * 1000));
        const std::size_t at = 2 + 8 * (number % modbus::edgeRecords);
        registers[at] = static_cast<std::uint16_t>(um >> 16U);
        registers[at + 1] = static_cast<std::uint16_t>(um);
        registers[at + 2] = static_cast<std::uint16_t>(std::lround(offMm * 100));
        registers[at + 5] = static_cast<std::uint16_t>(verdict);
        registers[at + 7] = static_cast<std::uint16_t>(std::lround(widthMm * 100));
    }
    void tell()
    {
        const link::ReadRequest request{0, modbus::sensorAddress, modbus::sensorRegisters};
        emit link.registersRead({request, link::ReadEnd::Done, registers, now, {}});
    }
    void takeMarks(int marks, double fromMm)
    {
        for (int mark = 0; mark < marks; ++mark)
            see(fromMm + mark * bagMm, MarkVerdict::Taken, 0.1);
        tell();
    }
};

// The panel on the controller's core with a simulated machine.
struct Machine {
    QTemporaryDir folder;
    test::CoreLink link;
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    panel::Controller machine{link, settings, nullptr};
    panel::Editor editor{machine, folder.path(), nullptr};
    panel::PackingSetup setup{machine, nullptr};

    explicit Machine(const controller::MachineOptions& options)
        : link(std::make_unique<test::Rig>(options))
    {
        machine.setClock([this] { return link.now(); });
        link.setFilmTimer(machine.packing()->findChild<QTimer*>());
        link.setConnected(true);
        pass(1);
        editor.bagLength()->set(bagMm);
        editor.rate()->set(200);
        editor.download();
        pass(3);
        setup.open();
        pass(1);
    }
    void pass(double seconds)
    {
        for (double s = 0; s < seconds; s += test::CoreLink::stepUs * 1e-6) {
            link.step();
            QCoreApplication::processEvents();
        }
    }
    MarkEdgeList& edges() { return *setup.edges(); }
};

} // namespace

class TestMarkEdgeList : public QObject {
    Q_OBJECT

private slots:
    void aMachineWithFalseAndMissingMarksIsSeen()
    {
        controller::MachineOptions options;
        options.film.marksFalse = 0.2;
        options.film.marksMissing = 0.1;
        Machine machine(options);
        QVERIFY2(machine.edges().emptyText().startsWith(QStringLiteral("No edges so far. Start")),
                 qPrintable(machine.edges().emptyText()));
        machine.machine.start();
        machine.pass(40);
        MarkEdgeList& edges = machine.edges();
        QCOMPARE(edges.places().size(), qsizetype(MarkEdgeList::maxEdges));
        QVERIFY(edges.emptyText().isEmpty());
        const QList<double> places = edges.places();
        const QList<int> looks = edges.looks();
        const QStringList notes = edges.notes();
        const QList<QPointF> windows = edges.windows();
        QCOMPARE(places.last(), 0.0);
        int rejected = 0;
        for (qsizetype i = 0; i < places.size(); ++i) {
            QVERIFY(i == 0 || places[i] > places[i - 1]);
            const bool isInside = std::ranges::any_of(windows, [at = places[i]](const QPointF& window) {
                return std::abs(at - window.x()) <= window.y() + 0.001;
            });
            if (looks[i] == MarkEdgeList::Solid)
                QVERIFY2(isInside, qPrintable(QString::number(places[i])));
            if (looks[i] == MarkEdgeList::Rejected) {
                ++rejected;
                QVERIFY2(!isInside, qPrintable(QString::number(places[i])));
                QVERIFY2(notes[i].isEmpty() || notes[i].contains(QStringLiteral("mm")), qPrintable(notes[i]));
            }
        }
        QVERIFY2(rejected >= 4, qPrintable(QString::number(rejected)));
        // A window without an edge is a mark that is missing.
        const auto empty = std::ranges::count_if(windows, [&places](const QPointF& window) {
            return std::ranges::none_of(
                places, [&window](double at) { return std::abs(at - window.x()) <= window.y() + 0.001; });
        });
        QVERIFY2(empty >= 1, qPrintable(QString::number(empty)));
        QVERIFY(edges.newestRejected() || !edges.rejectedText().isEmpty());
        QVERIFY(edges.summary().startsWith(QStringLiteral("60 edges (taken: ")));
    }

    void aMarkBehindItsWindowSaysHowFar()
    {
        EdgeRig rig;
        rig.takeMarks(5, 1000);
        QCOMPARE(plain(rig.edges().newestText()),
                 QStringLiteral("Taken: 0.1 mm behind the expected mark. The window is ±2 mm."));
        rig.see(1000 + 5 * bagMm - 0.1 + 4.3, MarkVerdict::OutsideWindow, 4.3);
        rig.tell();
        QVERIFY2(plain(rig.edges().newestText())
                     .startsWith(QStringLiteral(
                         "Not taken: 4.3 mm behind the expected mark; the window is ±2 mm. Check")),
                 qPrintable(rig.edges().newestText()));
        QVERIFY(rig.edges().newestRejected());
        QCOMPARE(plain(rig.edges().notes().last()), QStringLiteral("+4.3 mm"));
        const QPointF window = rig.edges().windows().last();
        QVERIFY2(std::abs(window.x() + 4.3) < 0.001, qPrintable(QString::number(window.x())));
        QCOMPARE(window.y(), 2.0);
        QCOMPARE(rig.edges().newestOffMm() > 4.29 && rig.edges().newestOffMm() < 4.31, true);

        rig.takeMarks(2, 1000 + 6 * bagMm);
        QVERIFY(!rig.edges().newestRejected());
        QCOMPARE(rig.edges().sinceRejected(), 2);
        QVERIFY(rig.edges().rejectedText().startsWith(QStringLiteral("Not taken: 4.3")));
    }

    void aMarkTooEarlySaysSo()
    {
        EdgeRig rig;
        rig.takeMarks(3, 1000);
        rig.see(1000 + 3 * bagMm - 0.1 - 2.04, MarkVerdict::OutsideWindow, -2.04);
        rig.tell();
        // As many decimals as tell it from the window.
        QVERIFY2(plain(rig.edges().newestText())
                     .startsWith(
                         QStringLiteral("Not taken: 2.04 mm before the expected mark; the window is ±2 mm.")),
                 qPrintable(rig.edges().newestText()));
    }

    void aMarkBeyondTheRegisterIsFarAway()
    {
        EdgeRig rig;
        rig.takeMarks(3, 1000);
        rig.see(1000 + 3 * bagMm + 400, MarkVerdict::OutsideWindow, 327.67);
        rig.tell();
        QVERIFY2(
            rig.edges().newestText().startsWith(QStringLiteral("Not taken: far from the expected mark;")),
            qPrintable(rig.edges().newestText()));
        QVERIFY(std::isnan(rig.edges().newestOffMm()));
    }

    void lengthsAreInTheUnitsOfThePanel()
    {
        EdgeRig rig;
        rig.takeMarks(3, 1000);
        rig.see(1000 + 3 * bagMm + 9, MarkVerdict::OutsideWindow, 9.0);
        rig.tell();
        panel::Units::setInch(true);
        const QString inch = plain(rig.edges().newestText());
        panel::Units::setInch(false);
        QVERIFY2(inch.contains(QStringLiteral("0.3543 in behind")), qPrintable(inch));
        QVERIFY2(!inch.contains(QStringLiteral("mm")), qPrintable(inch));
    }

    void everyVerdictHasItsWordsAndItsLook()
    {
        EdgeRig rig;
        rig.see(1000, MarkVerdict::NotUsed, 0);
        rig.tell();
        QVERIFY(rig.edges().newestText().contains(QStringLiteral("mark tracking is off")));
        rig.see(1300, MarkVerdict::Searched, 0);
        rig.tell();
        QVERIFY(rig.edges().newestText().startsWith(QStringLiteral("Searched:")));
        rig.see(1600, static_cast<MarkVerdict>(77), 0);
        rig.tell();
        QVERIFY(rig.edges().newestText().contains(QStringLiteral("Update the panel")));
        QCOMPARE(rig.edges().looks(),
                 (QList<int>{MarkEdgeList::Dotted, MarkEdgeList::Dashed, MarkEdgeList::Rejected}));
        QVERIFY(rig.edges().windows().isEmpty());
        QStringList counts;
        for (int row = 0; row < rig.edges().verdicts()->count(); ++row) {
            const auto index = rig.edges().verdicts()->index(row);
            const auto roles = rig.edges().verdicts()->roleNames();
            counts << rig.edges().verdicts()->data(index, roles.key("name")).toString() + u' ' +
                          rig.edges().verdicts()->data(index, roles.key("edges")).toString();
        }
        QCOMPARE(counts.join(u", "),
                 QStringLiteral("taken 0, outside the window 0, searched 1, not used 1, other 1"));
    }

    // A print that is no mark says why, and how wide it is where its end was seen.
    void anotherPrintSaysWhyItIsNoMark()
    {
        EdgeRig rig;
        const auto textOf = [&rig](MarkVerdict verdict, double widthMm) {
            rig.see(1000 + 10.0 * rig.number, verdict, 0, widthMm);
            rig.tell();
            return rig.edges().newestText();
        };
        QCOMPARE(textOf(MarkVerdict::TooNarrow, 1.9),
                 QStringLiteral("Another print: narrower than a mark. If it is one, reduce the minimum "
                                "width. Its width is 1.9 mm."));
        QVERIFY(
            textOf(MarkVerdict::TooWide, 9).startsWith(QStringLiteral("Another print: wider than a mark.")));
        QVERIFY(textOf(MarkVerdict::Masked, 0).endsWith(QStringLiteral("behind the mark before it.")));
        QCOMPARE(rig.edges().looks(),
                 (QList<int>{MarkEdgeList::Dotted, MarkEdgeList::Dotted, MarkEdgeList::Dotted}));
    }

    void aMissingMarkLeavesItsWindow()
    {
        EdgeRig rig;
        rig.takeMarks(3, 1000);
        rig.takeMarks(2, 1000 + 4 * bagMm); // the fourth is missing
        const QList<QPointF> windows = rig.edges().windows();
        QCOMPARE(windows.size(), 6);
        QVERIFY2(std::abs(windows[3].x() + 2 * bagMm + 0.1) < 0.01,
                 qPrintable(QString::number(windows[3].x())));
    }

    void theWindowMayBeReadLater()
    {
        EdgeRig rig;
        rig.machine.parameter("parameter.mark_window").clear();
        rig.takeMarks(3, 1000);
        rig.see(1000 + 3 * bagMm - 0.1 + 4.3, MarkVerdict::OutsideWindow, 4.3);
        rig.tell();
        QVERIFY(rig.edges().windows().isEmpty());
        emit rig.link.parameterEnded({0, "parameter.mark_window", link::ParameterEnd::Done, 2.0, {}});
        QVERIFY2(plain(rig.edges().newestText()).startsWith(QStringLiteral("Not taken: 4.3 mm behind")),
                 qPrintable(rig.edges().newestText()));
        QCOMPARE(rig.edges().windows().size(), 4);
    }

    void aPausedListStays()
    {
        EdgeRig rig;
        rig.takeMarks(3, 1000);
        rig.edges().setPaused(true);
        rig.takeMarks(3, 1000 + 3 * bagMm);
        QCOMPARE(rig.edges().places().size(), 3);
        rig.edges().setPaused(false);
        QCOMPARE(rig.edges().places().size(), 6);
    }

    void aRestartedControllerBeginsANewList()
    {
        EdgeRig rig;
        rig.takeMarks(5, 1000);
        rig.number = 0;
        rig.takeMarks(2, 100);
        QCOMPARE(rig.edges().places().size(), 2);
    }

    void anOldControllerSaysWhatIsMissing()
    {
        test::PanelRig rig;
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.identity = test::FakeLink::identity();
        report.identity->mapMinor = 5;
        rig.connectRunning();
        emit rig.link.reported(report);
        rig.link.sendStatus(rig.now);
        const std::uint16_t count = modbus::packerRegisters(5);
        emit rig.link.registersRead({{0, modbus::packerAddress, count},
                                     link::ReadEnd::Done,
                                     std::vector<std::uint16_t>(count),
                                     rig.now,
                                     {}});
        const QString text = rig.maintenance.packing()->edges()->emptyText();
        QVERIFY2(text.contains(QStringLiteral("must be 1.6 or newer")), qPrintable(text));
    }
};

CAMPANEL_TEST(TestMarkEdgeList)

} // namespace test_mark_edge_list

#include "test_mark_edge_list.moc"
