// SPDX-License-Identifier: Apache-2.0
// The editor with the kinds other than the rotary cutter: its fields, choices, undo, law comparison.
#include "app/panel/explain/explanations.h"
#include "app/panel/maintenance/line_figures.h"
#include "app/panel/recipe/choice_model.h"
#include "app/panel/stops/stops.h"
#include "profile/laws/laws.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_editor_kinds {

using namespace campanel;
using namespace campanel::test;
using panel::ChoiceRow;
using panel::ProgramDownload;

class TestEditorKinds : public QObject {
    Q_OBJECT

private slots:
    void beginsFeasibleWithEveryKind_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("fields");
        QTest::addColumn<int>("choices");
        QTest::newRow("position move") << 2 << QStringList{"distance_mm", "time_s", "cam_points"} << 2;
        QTest::newRow("speed move") << 3
                                    << QStringList{"start_speed_mm_per_s", "end_speed_mm_per_s", "time_s",
                                                   "cam_points"}
                                    << 2;
        QTest::newRow("point cam") << 4
                                   << QStringList{"master_rate_rev_per_min",
                                                  "master_ramp_s",
                                                  "master_ratio",
                                                  "master_scale",
                                                  "slave_scale",
                                                  "phase_deg",
                                                  "cam_points"}
                                   << 3;
        QTest::newRow("press") << 5 << QStringList{} << 0;
    }

    void beginsFeasibleWithEveryKind()
    {
        QFETCH(int, kind);
        QFETCH(QStringList, fields);
        QFETCH(int, choices);
        PanelRig rig;
        rig.connectIdle();
        QSignalSpy changed(&rig.editor, &Editor::fieldsChanged);
        rig.editor.newProgram(kind);
        QCOMPARE(static_cast<int>(rig.editor.kind()), kind);
        QCOMPARE(changed.size(), 1);
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        QCOMPARE(rig.editor.severity(), Editor::Severity::Good);
        QCOMPARE(rig.editor.verdict(), "Within all limits.");
        if (!fields.isEmpty())
            QCOMPARE(idsOf(rig.editor.fields()), fields);
        QCOMPARE(rig.editor.fields().size() > 0, true);
        QCOMPARE(rig.editor.choices()->count(), choices);
        QCOMPARE(rig.editor.hasLaw(), kind == 2 || kind == 3);
        QCOMPARE(rig.editor.laws()->count(), 0); // nobody looks at them
        rig.editor.watchLaws(true);
        QCOMPARE(rig.editor.laws()->count() > 0, rig.editor.hasLaw());
        QCOMPARE(rig.editor.knots()->count(), kind == 4 ? 5 : 0);
        QVERIFY(rig.editor.plot().ratioTimes.isEmpty());
        QVERIFY(rig.editor.plot().curves.isValid());
        QVERIFY(rig.editor.plot().cycleSeconds > 0);
        QVERIFY(rig.editor.plot().limitVelocity > 0 && rig.editor.plot().limitAcceleration > 0);
        QVERIFY2(rig.editor.peakText().contains("Nm") == (kind != 5), qPrintable(rig.editor.peakText()));
        QVERIFY(rig.editor.table()->count() > 4);
        QVERIFY(!rig.editor.table()->summary().isEmpty());
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        for (const auto& list : {rig.editor.fields(), rig.editor.machineFields()}) {
            for (const QVariant& each : list) {
                const auto* field = each.value<EditorField*>();
                const auto known = profile::fieldById(field->fieldId().toStdString());
                const bool mayBeUnknown = known && profile::info(*known).isUnknownAtZero;
                QVERIFY2(!field->label().isEmpty() && (mayBeUnknown || field->text() != "--"),
                         qPrintable(field->fieldId()));
            }
        }
        rig.editor.undo();
        QCOMPARE(rig.editor.kind(), Editor::Kind::RotaryCutter);
        QCOMPARE(rig.editor.choices()->count(), 1); // its master
        rig.editor.redo();
        QCOMPARE(static_cast<int>(rig.editor.kind()), kind);
    }

    void ignoresKindsThatThereAreNot()
    {
        PanelRig rig;
        for (const int kind : {-1, 0, 7, 100})
            rig.editor.newProgram(kind);
        QCOMPARE(rig.editor.kind(), Editor::Kind::RotaryCutter);
        QVERIFY(!rig.editor.canUndo());
        QCOMPARE(rig.editor.kinds().size(), 6);
        begin(rig, ProgramKind::PositionMove);
        for (const auto& [row, option] : {std::pair{-1, 0}, {0, -1}, {0, 2}, {9, 0}})
            rig.editor.setChoice(row, option);
        rig.editor.undo();
        QVERIFY(!rig.editor.canUndo());
        rig.editor.dragRatio(0, 0.1);
        rig.editor.knots()->insert(0.5);
        rig.editor.knots()->removeSelected();
        rig.editor.knots()->repairWrap();
        rig.editor.knots()->beginDrag(0);
        rig.editor.knots()->drag(0.1, 1);
        rig.editor.knots()->endDrag();
        QCOMPARE(rig.editor.knots()->count(), 0);
    }

    void choicesDecideWhatIsShown()
    {
        PanelRig rig;
        begin(rig, ProgramKind::SpeedMove);
        const auto fields = [&] { return idsOf(rig.editor.fields()); };
        choose(rig.editor, "Duration", "Over a distance");
        QVERIFY(fields().contains("distance_mm") && !fields().contains("time_s"));
        choose(rig.editor, "Execution", "Intervals");
        QVERIFY(!fields().contains("cam_points"));
        QTRY_COMPARE(rig.editor.table()->name(), "Intervals"); // compiled once the finger rests
        choose(rig.editor, "Duration", "As fast as possible");
        QVERIFY(!fields().contains("distance_mm") && !fields().contains("time_s"));
        for (int i = 0; i < 3; ++i)
            rig.editor.undo();
        QVERIFY(fields().contains("time_s") && fields().contains("cam_points"));
        QCOMPARE(rig.editor.table()->name(), "Cam points");
        QCOMPARE(rig.editor.kind(), Editor::Kind::SpeedMove);
        rig.editor.redo();
        QVERIFY(fields().contains("distance_mm"));
    }

    // An execution that the controller lacks is no choice; a recipe that has it still shows it.
    void slowControllersOfferNoIntervals()
    {
        program::Recipe recipe = program::defaultRecipe(ProgramKind::SpeedMove);
        modbus::Identity controller;
        const auto options = [&] {
            const auto rows = ChoiceRow::rows(recipe, controller);
            const auto row = std::ranges::find(rows, program::Choice::Execution, &ChoiceRow::choice);
            return row == rows.end() ? QStringList() : row->options;
        };
        QCOMPARE(options(), QStringList({"Cam points", "Intervals"}));
        controller.tableLayouts =
            static_cast<std::uint16_t>(1u << static_cast<unsigned>(modbus::TableLayout::CamPoints));
        QCOMPARE(options(), QStringList({"Cam points"}));
        program::setChoice(recipe.program, program::Choice::Execution,
                           static_cast<std::uint16_t>(profile::Execution::Intervals));
        QCOMPARE(options(), QStringList({"Cam points", "Intervals"}));
    }

    void numbersOfThePaper()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PositionMove);
        QCOMPARE(rig.editor.lawTitle(), "Displacement law");
        QVERIFY2(rig.editor.peakText().contains("6750 r/min"), qPrintable(rig.editor.peakText()));
        enter(rig.editor, Field::Distance, 3000);
        QVERIFY2(rig.editor.peakText().contains("3375 r/min"), qPrintable(rig.editor.peakText()));
        QVERIFY(rig.editor.edited());
        begin(rig, ProgramKind::SpeedMove);
        QCOMPARE(rig.editor.lawTitle(), "Speed law");
        QVERIFY2(rig.editor.peakText().contains("5400 r/min · 14.14 m/s²"),
                 qPrintable(rig.editor.peakText()));
    }

    void vibrationIsExplained()
    {
        PanelRig rig;
        panel::Stops stops(rig.machine, rig.settings, rig.records, nullptr);
        const panel::Explanations explanations({rig.machine, rig.editor, *rig.maintenance.figures(),
                                                rig.trends, stops, *rig.maintenance.packing()->edges()},
                                               nullptr);
        constexpr int topic = panel::Explanations::ShaftVibration;
        for (const ProgramKind kind :
             {ProgramKind::PointCam, ProgramKind::SegmentCam, ProgramKind::PositionMove}) {
            begin(rig, kind);
            QVERIFY(!explanations.ofVerdict().contains(topic));
            rig.editor.item(Field::NaturalFrequency)->set(4);
            QVERIFY(explanations.ofVerdict().contains(topic));
            const panel::Explanation found = explanations.of(topic);
            const bool isCam = kind != ProgramKind::PositionMove;
            QCOMPARE(found.title, isCam ? "Vibration over the cycle" : "Vibration after the move");
            QVERIFY2(found.text().contains("f0 = 4 Hz"), qPrintable(found.text()));
            const double expected = program::vibrationMm(rig.editor.recipe(), *rig.editor.solution().solved);
            QCOMPARE(found.value, panel::Format().compact(expected, 0, 3));
            QVERIFY(expected > 0.1);
            rig.editor.item(Field::NaturalFrequency)->set(0);
        }
    }

    void lawsAreComparedBehindTheCurves()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PositionMove);
        QVERIFY(!rig.editor.overlayCurves().isValid());
        rig.editor.watchLaws(true);
        rig.editor.compareLaw("harmonic");
        QCOMPARE(rig.editor.overlayName(), "Harmonic");
        const auto curves = rig.editor.overlayCurves().value<std::shared_ptr<const profile::Curves>>();
        QVERIFY(curves);
        const double fastest = *std::ranges::max_element(curves->velocityMmPerS);
        QVERIFY(std::abs(fastest - 3000 * std::acos(-1.0)) < 1);
        int compared = 0;
        for (const panel::LawRow& law : rig.editor.laws()->rows()) {
            compared += law.compared ? 1 : 0;
            QVERIFY(law.lawId != "half_modified_sine");
            QVERIFY(law.peakFrequencyText.contains("Nm"));
        }
        QCOMPARE(compared, 1);
        QCOMPARE(rig.editor.lawName(), "Quintic 3-4-5"); // compared, not selected
        QVERIFY(!rig.editor.lawName().isEmpty());
        enter(rig.editor, Field::Distance, 600);
        const auto shorter = rig.editor.overlayCurves().value<std::shared_ptr<const profile::Curves>>();
        QVERIFY(std::abs(*std::ranges::max_element(shorter->velocityMmPerS) - 300 * std::acos(-1.0)) < 0.1);
        rig.editor.compareLaw("half_modified_sine"); // not for a position move
        QVERIFY(rig.editor.overlayName().isEmpty());
        QVERIFY(!rig.editor.overlayCurves().isValid());
        rig.editor.compareLaw("cubic");
        begin(rig, ProgramKind::Press);
        QVERIFY(rig.editor.overlayName().isEmpty());
        QVERIFY(!rig.editor.overlayCurves().isValid());
    }

    void aRestartFindsTheKind()
    {
        PanelRig rig;
        begin(rig, ProgramKind::Press);
        enter(rig.editor, Field::HoldTime, 1.25);
        begin(rig, ProgramKind::PointCam);
        rig.editor.knots()->select(1);
        rig.editor.knots()->slave()->set(21);
        const auto wanted = camOf(rig.editor).knots;
        {
            auto first = std::make_unique<Editor>(rig.machine, rig.folder.path(), nullptr);
            first->newProgram(4);
            first->knots()->select(1);
            first->knots()->slave()->set(21);
        }
        Editor second(rig.machine, rig.folder.path(), nullptr);
        QCOMPARE(second.kind(), Editor::Kind::PointCam);
        QVERIFY(camOf(second).knots == wanted);
        QCOMPARE(second.notice(), QString());
    }
};

CAMPANEL_TEST(TestEditorKinds)

} // namespace test_editor_kinds

#include "test_editor_kinds.moc"
