// SPDX-License-Identifier: Apache-2.0
// The editor with sealing jaws: the refusals in words, the one-key mends, and the dot on the regime map.
#include "app/panel/explain/explanations.h"
#include "app/panel/maintenance/line_figures.h"
#include "app/panel/stops/stops.h"
#include "app/panel/words/recipe_words.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/paper_lengths.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_cutter_map {

using namespace campanel;
using panel::Editor;
using profile::Field;
using test::PanelRig;

namespace {

std::shared_ptr<const profile::RegimeMap> mapOf(Editor& editor)
{
    return editor.map()->map().value<std::shared_ptr<const profile::RegimeMap>>();
}

} // namespace

class TestCutterMap : public QObject {
    Q_OBJECT

private slots:
    void narrowWindowIsWidenedByOneKey()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.item(Field::ContactAngle)->set(20);
        QVERIFY2(editor.feasible(), "250 mm hold the jaws");
        QVERIFY2(editor.peakText().endsWith(QStringLiteral("seal 84 ms")), qPrintable(editor.peakText()));
        editor.bagLength()->set(100);
        QVERIFY(!editor.feasible());
        QCOMPARE(editor.verdict(),
                 QStringLiteral("The jaws need a sync window of 22° of the knife; at 0.400 s "
                                "(144°) the window has only 19.1°."));
        QCOMPARE(editor.suggestionText(), QStringLiteral("Widen the window"));
        QCOMPARE(editor.plot().violations.size(), 1); // the window itself
        QVERIFY((editor.plot().violations[0] - QPointF(0.4, 0.599988)).manhattanLength() < 1e-6);
        editor.applySuggestion();
        QVERIFY2(editor.feasible(), qPrintable(editor.verdict()));
        QCOMPARE(editor.k2()->text(), QStringLiteral("2.5988"));
        QCOMPARE(editor.k3()->text(), QStringLiteral("1.6255"));
        QCOMPARE(editor.k1()->text(), QStringLiteral("4.00"));
        QCOMPARE(editor.bagLength()->text(), QStringLiteral("100.0"));
        editor.undo();
        QCOMPARE(editor.k2()->text(), QStringLiteral("2.50"));
    }

    void sealTimeIsALimit()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.minSealTime()->set(50);
        QCOMPARE(editor.suggestionText(), QStringLiteral("Min. seal time 0 ms"));
        QVERIFY2(editor.verdict().contains(QStringLiteral("no contact angle")), qPrintable(editor.verdict()));
        editor.item(Field::ContactAngle)->set(20);
        QVERIFY2(editor.verdict().contains(QStringLiteral("Possible up to 100.5 bags/min (seal time)")),
                 qPrintable(editor.verdict()));
        editor.rate()->set(100);
        QCOMPARE(editor.severity(), Editor::Severity::Warning); // 50.3 ms of 50 ms
        editor.rate()->set(200);
        QCOMPARE(editor.verdict(),
                 QStringLiteral("Seal time would be 25.1 ms at 0.120 s (144°); the film needs 50 ms."));
        QCOMPARE(editor.suggestionText(), QStringLiteral("Rate 100.5 bags/min"));
        editor.applySuggestion();
        QVERIFY(editor.feasible());
    }

    // The controller has no register for the film's seal time: nothing is compared with it.
    void sealTimeIsNotInTheController()
    {
        PanelRig rig;
        rig.editor.item(Field::ContactAngle)->set(20);
        rig.connectRunning();
        rig.editor.minSealTime()->set(10);
        QVERIFY(rig.editor.minSealTime()->activeText().isEmpty());
        QVERIFY(!rig.editor.rampSlices()->activeText().isEmpty());
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 0);
        QVERIFY(rig.editor.edited());
    }

    void runShowsTheSealTimeOfThePresentRate()
    {
        PanelRig rig;
        rig.connectRunning();
        QVERIFY(std::isnan(rig.machine.live().sealTimeMs));
        QSignalSpy changed(&rig.machine, &panel::Controller::liveChanged);
        rig.editor.item(Field::ContactAngle)->set(20);
        QVERIFY(changed.count() > 0);
        QVERIFY(std::abs(rig.machine.live().sealTimeMs - 83.775804) < 1e-5);
        rig.link.status.masterSpeedPercent = 50;
        rig.link.sendStatus(rig.now);
        QVERIFY(std::abs(rig.machine.live().sealTimeMs - 2 * 83.775804) < 1e-5);
        rig.link.status.masterSpeedPercent = 0;
        rig.link.sendStatus(rig.now);
        QVERIFY(std::isnan(rig.machine.live().sealTimeMs));
    }

    void mapIsComputedWhileItIsWatched()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        QVERIFY(!mapOf(editor));
        editor.map()->setWatched(true);
        const auto map = mapOf(editor);
        QVERIFY(map && map->points.size() >= 200);
        QCOMPARE(editor.map()->limitNames().size(), static_cast<qsizetype>(map->limits.size()));
        QCOMPARE(editor.map()->paperLengths().size(), static_cast<qsizetype>(profile::paperLengths.size()));
        QCOMPARE(editor.map()->text(), QStringLiteral("Up to 303.5 bags/min; limited by: acceleration."));
        editor.item(Field::MaxKnifeAcceleration)->set(20000);
        QVERIFY(mapOf(editor) != map);
        editor.newProgram(static_cast<int>(profile::ProgramKind::Press));
        QVERIFY(!mapOf(editor));
        QVERIFY(std::isnan(editor.map()->lengthMm()));
        editor.undo();
        QVERIFY(mapOf(editor));
        editor.map()->setWatched(false);
        QVERIFY(!mapOf(editor));
    }

    void draggedDotIsOneUndoStep()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.map()->setWatched(true);
        const auto map = mapOf(editor);
        for (int i = 1; i <= 20; ++i)
            editor.map()->drag(250 - 5.2 * i, 60 + 10.3 * i);
        editor.map()->endDrag();
        QCOMPARE(editor.bagLength()->value(), 146.0); // whole mm and bags/min
        QCOMPARE(editor.rate()->value(), 266.0);
        QVERIFY2(!editor.feasible(), "the dot stays where the finger left it");
        QCOMPARE(mapOf(editor), map); // the map does not depend on the dot
        QVERIFY(editor.canUndo());
        editor.undo();
        QCOMPARE(editor.bagLength()->value(), 250.0);
        QCOMPARE(editor.rate()->value(), 60.0);
        QVERIFY(!editor.canUndo());
    }

    // A drag far to the right and back leaves no empty map.
    void theRangeFollowsTheLength()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.map()->setWatched(true);
        const double before = mapOf(editor)->range.toMm;
        editor.map()->drag(before + 100, 20);
        editor.map()->endDrag();
        QVERIFY(mapOf(editor)->range.toMm > before);
        editor.map()->drag(250, 60);
        editor.map()->endDrag();
        QCOMPARE(mapOf(editor)->range.toMm, before);
    }

    // The ratios follow the dot, the map stays; its lines are explained.
    void dragWithRatiosThatFollow()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.item(Field::ContactAngle)->set(20);
        editor.ramps()->choose(panel::RampControl::Slow);
        editor.map()->setWatched(true);
        const auto map = mapOf(editor);
        QCOMPARE(editor.map()->linesText().count(u'·'), 2);
        QVERIFY(editor.map()->linesText().startsWith(QStringLiteral("Lmin: the jaws")));
        const double before = editor.k1()->value();
        for (int i = 1; i <= 20; ++i)
            editor.map()->drag(250 + 20 * i, 60);
        editor.map()->endDrag();
        QVERIFY(editor.k1()->value() != before);
        QCOMPARE(mapOf(editor), map);
        QVERIFY2(editor.feasible(), qPrintable(editor.verdict()));
        // 650 mm are beyond the stroke of the ratios at 250 mm, and on the map all the same.
        QVERIFY2(editor.map()->text().startsWith(QStringLiteral("Up to")), qPrintable(editor.map()->text()));
        editor.item(Field::ContactAngle)->set(0);
        QVERIFY(editor.map()->linesText().startsWith(QStringLiteral("h/c: ")));
    }

    void dotOfDerivedValues()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.filmSpeed()->set(200);
        editor.baseSpeed()->set(400);
        editor.map()->setWatched(true);
        QVERIFY(editor.bagLength()->derived());
        QCOMPARE(editor.map()->lengthMm(), editor.bagLength()->value());
        editor.map()->drag(300, 80);
        editor.map()->endDrag();
        QVERIFY(editor.bagLength()->pinned() && editor.rate()->pinned());
        QCOMPARE(editor.bagLength()->value(), 300.0);
    }

    // A recipe beyond the stroke has no dot, and the map remains.
    void unsolvableRecipeHasAMap()
    {
        PanelRig rig;
        Editor& editor = rig.editor;
        editor.map()->setWatched(true);
        editor.bagLength()->set(1500);
        QVERIFY(!editor.solvable());
        QVERIFY(mapOf(editor));
        QVERIFY(std::isnan(editor.map()->lengthMm()));
        QVERIFY(editor.map()->title().isEmpty() && editor.map()->text().isEmpty());
    }

    void numbersAreExplained()
    {
        PanelRig rig;
        panel::Stops stops(rig.machine, rig.settings, rig.records, nullptr);
        panel::Explanations explanations({rig.machine, rig.editor, *rig.maintenance.figures(), rig.trends,
                                          stops, *rig.maintenance.packing()->edges()},
                                         nullptr);
        QVERIFY(!explanations.ofVerdict().contains(panel::Explanations::SealTime));
        rig.editor.item(Field::ContactAngle)->set(20);
        rig.editor.minSealTime()->set(50);
        QVERIFY(explanations.ofVerdict().contains(panel::Explanations::SealTime));
        QVERIFY(explanations.ofVerdict().contains(panel::Explanations::SyncWindow));
        const QString seal = explanations.of(panel::Explanations::SealTime).text();
        QVERIFY2(seal.contains(QStringLiteral("1000 * 2 pi * 60 * 20 / 360 / 250")), qPrintable(seal));
        QVERIFY2(seal.endsWith(QStringLiteral("= 83.78 ms")), qPrintable(seal));
        const QString fastest = explanations.of(panel::Explanations::FastestRate).text();
        QVERIFY2(fastest.contains(QStringLiteral("60.0 × 83.78 / 50")), qPrintable(fastest));
        rig.connectRunning();
        const QString live = explanations.of(panel::Explanations::LiveSealTime).text();
        QVERIFY2(live.contains(QStringLiteral("60 000 × 20.94 / (1 × 250 × 60)")), qPrintable(live));
    }
};

CAMPANEL_TEST(TestCutterMap)

} // namespace test_cutter_map

#include "test_cutter_map.moc"
