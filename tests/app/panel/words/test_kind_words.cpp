// SPDX-License-Identifier: Apache-2.0
// The texts of programs of every kind: refusals, tables, differences, strokes.
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/table_text.h"
#include "app/program/interval_speeds.h"
#include "profile/model/refusal.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <string>

namespace test_kind_words {

using namespace campanel;
using namespace campanel::test;
using panel::ProgramDownload;
using panel::StrokeModel;
using panel::StrokeRow;
using panel::TableText;

class TestKindWords : public QObject {
    Q_OBJECT

private slots:
    void refusalsAreSentences_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QList<QPair<int, double>>>("values");
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("suggests");
        const auto row = [](const char* tag, ProgramKind kind, const QList<QPair<Field, double>>& values,
                            const QString& words, bool suggests) {
            QList<QPair<int, double>> plain;
            for (const auto& [field, value] : values)
                plain << QPair(static_cast<int>(field), value);
            QTest::newRow(tag) << static_cast<int>(kind) << plain << words << suggests;
        };
        const auto position = ProgramKind::PositionMove;
        row("motor too slow", position, {{Field::Distance, 7000}}, "Motor speed would reach", true);
        row("torque", position, {{Field::MaxTorque, 0.05}}, "Motor torque would reach", true);
        row("RMS torque", position, {{Field::RatedTorque, 0.03}}, "the motor would overheat", true);
        const auto cutter = ProgramKind::RotaryCutter;
        row("torque of the knife", cutter, {{Field::Inertia, 20}, {Field::MaxTorque, 0.03}},
            "Motor torque would reach 0.040 Nm at 0.201 s (72°)", true);
        row("RMS torque of the knife", cutter, {{Field::Inertia, 20}, {Field::RatedTorque, 0.02}},
            "RMS torque would be 0.024 Nm", true);
        row("cycle above the natural frequency", cutter, {{Field::NaturalFrequency, 0.8}},
            "The cycle repeats at 1.0 Hz, above the shaft's natural frequency of 0.8 Hz", true);
        row("acceleration", position, {{Field::MaxAcceleration, 30000}}, "Acceleration would reach", true);
        row("frequency", position, {{Field::MaxPulseFrequency, 100000}}, "Pulse frequency would reach", true);
        row("nothing moves", position, {{Field::Distance, 0}}, "gives no motion", false);
        row("no change of speed", ProgramKind::SpeedMove, {{Field::EndSpeed, 0}}, "gives no motion", false);
        row("master stands", ProgramKind::PointCam, {{Field::MasterRate, 0}}, "gives no motion", false);
        row("master too fast", ProgramKind::PointCam, {{Field::MasterRate, 1000}}, "the limit is", true);
        row("touch before the approach ends", ProgramKind::Press, {{Field::ProbeEnd, 50}},
            "Contact before 50.00 mm must be beyond 60.00 mm", true);
        row("press to before the touch", ProgramKind::Press, {{Field::PressPosition, 80}},
            "Press to 80.00 mm must be beyond 90.00 mm", true);
        row("ramps longer than a row holds", ProgramKind::Press, {{Field::MaxAcceleration, 70}},
            "needs a ramp of 1143 ms", false);
        row("one ramp longer than a row holds", ProgramKind::Press,
            {{Field::MaxAcceleration, 70}, {Field::ApproachSpeed, 60}},
            "Return speed needs a ramp of 1143 ms", true);
        row("probe force above the largest", ProgramKind::Press, {{Field::ProbeForce, 9000}},
            "must be at most", true);
        row("least force above the most", ProgramKind::Press, {{Field::MinStopForce, 7000}},
            "must be at most", true);
    }

    void refusalsAreSentences()
    {
        QFETCH(int, kind);
        using Values = QList<QPair<int, double>>;
        QFETCH(Values, values);
        QFETCH(QString, words);
        QFETCH(bool, suggests);
        PanelRig rig;
        rig.editor.newProgram(kind);
        for (const auto& [field, value] : values)
            enter(rig.editor, static_cast<Field>(field), value);
        QVERIFY2(!rig.editor.feasible(), qPrintable(rig.editor.verdict() + rig.editor.peakText()));
        QCOMPARE(rig.editor.severity(), Editor::Severity::Bad);
        QVERIFY2(rig.editor.verdict().contains(words), qPrintable(rig.editor.verdict()));
        QCOMPARE(rig.editor.table()->count(), 0);
        QVERIFY(rig.editor.table()->summary().isEmpty());
        QVERIFY2(rig.editor.suggestionText().isEmpty() != suggests, qPrintable(rig.editor.suggestionText()));
        if (!suggests)
            return;
        rig.editor.applySuggestion();
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
    }

    void onlyTheRateLimitIsCalledTheLargestRate()
    {
        const QString maxRate = panel::RecipeWords::limitName(profile::Limit::MachineRate);
        QCOMPARE(maxRate, QStringLiteral("max. rate"));
        constexpr int last = static_cast<int>(profile::Limit::NaturalFrequency);
        for (int i = 0; i <= last; ++i) {
            const auto limit = static_cast<profile::Limit>(i);
            if (limit != profile::Limit::MachineRate)
                QVERIFY2(panel::RecipeWords::limitName(limit) != maxRate,
                         std::string(profile::limitId(limit)).c_str());
        }
    }

    // No limit of the machine is near: the range of the speeds is reached first.
    void fastestRateEndsAtTheLargestSpeed()
    {
        PanelRig rig;
        for (const Field field :
             {Field::MaxRate, Field::MaxMotorRpm, Field::MaxKnifeAcceleration, Field::MaxPulseFrequency})
            enter(rig.editor, field, profile::info(field).max);
        enter(rig.editor, Field::PulsesPerMotorRev, profile::info(Field::PulsesPerMotorRev).min);
        enter(rig.editor, Field::BagLength, 1050);
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        QVERIFY2(rig.editor.verdict().contains(QStringLiteral("(knife speed)")),
                 qPrintable(rig.editor.verdict()));
    }

    void distancesThatDoNotFitTheSpeeds()
    {
        PanelRig rig;
        begin(rig, ProgramKind::SpeedMove);
        choose(rig.editor, "Duration", "Over a distance");
        enter(rig.editor, Field::Distance, -5000);
        QVERIFY2(rig.editor.verdict().contains("have opposite directions"), qPrintable(rig.editor.verdict()));
        enter(rig.editor, Field::Distance, 5000);
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        choose(rig.editor, "Execution", "Intervals");
        choose(rig.editor, "Duration", "In a given time");
        enter(rig.editor, Field::StartSpeed, -9000);
        // Intervals are compiled once the finger rests.
        QTRY_VERIFY2(rig.editor.verdict().contains("intervals run in one direction. Choose cam points"),
                     qPrintable(rig.editor.verdict()));
    }

    void tablesInWords_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<bool>("intervals");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("summary");
        QTest::newRow("cutter") << 1 << false << "Step table"
                                << "10000 pulses per cycle";
        QTest::newRow("move") << 2 << false << "Cam points"
                              << "101 points, 60000 pulses per cycle, 1.000 s";
        QTest::newRow("intervals") << 2 << true << "Intervals"
                                   << "60000 pulses";
        QTest::newRow("cam") << 4 << false << "Cam points"
                             << "1001 points, 0 pulses per cycle";
        QTest::newRow("press") << 5 << false << "Press stages"
                               << "0.01 mm per pulse";
    }

    void tablesInWords()
    {
        QFETCH(int, kind);
        QFETCH(bool, intervals);
        QFETCH(QString, name);
        QFETCH(QString, summary);
        program::Recipe recipe = program::defaultRecipe(static_cast<ProgramKind>(kind));
        if (intervals)
            program::setChoice(recipe.program, program::Choice::Execution, 1);
        const auto image = program::buildProgram(recipe);
        QVERIFY(image);
        const TableText text(*image);
        QCOMPARE(text.name(), name);
        QVERIFY2(text.summary().first().contains(summary), qPrintable(text.summary().first()));
        const std::vector<double> starts = text.startsS();
        for (std::size_t row = 0; row < starts.size(); ++row) {
            const QStringList cells = text.cells(row, starts[row]);
            QCOMPARE(cells.size(), text.columns().size());
            QCOMPARE(cells.first(), QString::number(row + 1));
            QVERIFY(!cells.contains(QString()));
            QVERIFY(row == 0 || kind == 5 || starts[row] > starts[row - 1]);
        }
        if (const auto* table = std::get_if<profile::IntervalTable>(&image->table)) {
            // The last row begins before the end by its own duration.
            const double last =
                program::speedsOf(table->rows.back(), table->fractionBits).timeS + starts.back();
            QVERIFY2(std::abs(last - table->timeS) < 1e-3, qPrintable(QString::number(last)));
            QVERIFY2(text.cells(0, 0)[1] == "accel.", qPrintable(text.cells(0, 0)[1]));
            QCOMPARE(text.cells(starts.size() - 1, 0)[1], "decel.");
        }
    }

    void aBackwardCamHasTheSameErrors()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        enter(rig.editor, Field::Phase, 30);
        const QStringList forwards = rig.editor.table()->summary();
        enter(rig.editor, Field::MasterRate, -60);
        QCOMPARE(rig.editor.table()->summary(), forwards);
    }

    void differencesInWords()
    {
        PanelRig rig;
        begin(rig, ProgramKind::SpeedMove);
        rig.connectIdle();
        rig.link.activate(rig.image(), rig.now);
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 0);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::NothingToDo);
        enter(rig.editor, Field::EndSpeed, 8000);
        choose(rig.editor, "Duration", "As fast as possible");
        rig.editor.setLaw("cycloidal");
        QStringList rows;
        for (const auto& row : rig.editor.programDownload()->differences()->rows())
            rows << row.name + ": " + row.activeText + " > " + row.editedText;
        rows.sort();
        QCOMPARE(rows, (QStringList{"Duration: In a given time > As fast as possible",
                                    "End speed: 9000.0 mm/s > 8000.0 mm/s",
                                    "Speed law: Half modified sine > Cycloidal"}));
        QCOMPARE(rig.editor.item(Field::EndSpeed)->activeText(), "9000.0");
        begin(rig, ProgramKind::PointCam);
        rows.clear();
        for (const auto& row : rig.editor.programDownload()->differences()->rows())
            rows << row.name + ": " + row.activeText + " > " + row.editedText;
        QVERIFY2(rows.contains("Program type: Speed move > Point cam"), qPrintable(rows.join('\n')));
        QCOMPARE(rig.editor.item(Field::MasterRate)->activeText(), QString());
    }

    void strokesAreListedNewestFirst()
    {
        StrokeModel strokes;
        modbus::StatusBlock status;
        strokes.note(status, 100); // no press
        status.press.emplace();
        status.cycleCount = 7;
        status.press->stage = modbus::PressStage::Standing;
        strokes.note(status, 100);
        QCOMPARE(strokes.rows()->count(), 0);
        const auto stroke = [&](modbus::StrokeResult result, std::int16_t error, std::uint16_t force) {
            for (int step = 0; step <= 100; ++step) {
                status.press->stage = step < 60 ? modbus::PressStage::Approach : modbus::PressStage::Press;
                status.press->forceN = static_cast<std::uint16_t>(step < 60 ? 0 : 50 * (step - 60));
                status.axisPositionPulses = 100 * step;
                strokes.note(status, 100);
            }
            ++status.cycleCount;
            status.press->stage = modbus::PressStage::Standing;
            status.press->result = result;
            status.press->stopErrorPulses = error;
            status.press->stopForceN = force;
            status.press->peakForceN = static_cast<std::uint16_t>(force + 100);
            strokes.note(status, 100);
            strokes.note(status, 100);
        };
        stroke(modbus::StrokeResult::Ok, -1, 2000);
        QCOMPARE(strokes.rows()->count(), 1);
        QCOMPARE(strokes.forceCurve().size(), 101);
        QCOMPARE(strokes.forceCurve().last(), QPointF(100, 2000));
        stroke(modbus::StrokeResult::ForceTooLow, 0, 500);
        QCOMPARE(strokes.forceCurve().size(), 101); // only the newest stroke
        const StrokeRow newest = strokes.rows()->row(0);
        const StrokeRow first = strokes.rows()->row(1);
        QCOMPARE(newest.number, 2U); // those of earlier programs do not count
        QCOMPARE(newest.resultText(), "Force too low");
        QCOMPARE(first.resultText(), "OK");
        QCOMPARE(first.stopErrorText(), "−0.01");
        QCOMPARE(first.stopForceText(), "2000");
        QCOMPARE(first.status.peakForceN, 2100.0);
        QCOMPARE(strokes.goodCount(), 1);
        for (int i = 0; i < 2 * StrokeModel::maxStrokes; ++i)
            stroke(modbus::StrokeResult::Ok, 0, 3000);
        QCOMPARE(strokes.rows()->count(), int{StrokeModel::maxStrokes});
        QCOMPARE(strokes.goodCount(), int{StrokeModel::maxStrokes});
        strokes.clear();
        QCOMPARE(strokes.rows()->count(), 0);
        QVERIFY(strokes.forceCurve().isEmpty());
    }
};

CAMPANEL_TEST(TestKindWords)

} // namespace test_kind_words

#include "test_kind_words.moc"
