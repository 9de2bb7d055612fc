// SPDX-License-Identifier: Apache-2.0
// The section for packing machines on a fake link: taught marks, parameters read and written, the distance
// wizard.
#include "packer_image.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_packing_setup {

using namespace campanel;
using panel::GainEstimate;
using panel::MarkWizard;
using panel::PackingFields;
using panel::PackingSetup;
using Step = MarkWizard::Step;
using namespace std::chrono_literals;

namespace {

struct PackingRig : test::PanelRig {
    test::PackerImage packer;

    PackingRig()
    {
        connectRunning();
        packer.set("packer.mark_state", static_cast<double>(modbus::MarkState::Tracking));
        tell();
    }

    [[nodiscard]] PackingSetup& setup() { return *maintenance.packing(); }
    [[nodiscard]] PackingFields& fields() { return *setup().fields(); }
    [[nodiscard]] MarkWizard& wizard() { return *setup().wizard(); }

    void tell()
    {
        const std::uint16_t count = modbus::packerRegisters(machine.identity()->mapMinor);
        std::vector<std::uint16_t> registers = packer.registers();
        registers.resize(count);
        emit link.registersRead({{0, modbus::packerAddress, count}, link::ReadEnd::Done, registers, now, {}});
    }
    void set(const char* name, double value)
    {
        packer.set(name, value);
        tell();
    }
    void cutBags(int bags, double markErrorMm = 0.0)
    {
        for (int bag = 0; bag < bags; ++bag) {
            packer.addBag(markErrorMm);
            tell();
        }
    }
    void setState(modbus::State state)
    {
        link.status.state = state;
        link.sendStatus(now);
    }
    // Answers every requested parameter with its default or the written value.
    void answerParameters()
    {
        for (const link::ParameterRequest& request : std::exchange(link.parameters, {})) {
            const modbus::RegisterInfo* info = modbus::findRegister(request.name);
            emit link.parameterEnded({request.id,
                                      request.name,
                                      link::ParameterEnd::Done,
                                      request.value.value_or(info->defaultValue),
                                      {}});
        }
    }
    void answerCommand(modbus::Command command, link::CommandEnd end = link::CommandEnd::Done)
    {
        link::CommandOutcome outcome;
        outcome.command = command;
        outcome.end = end;
        emit link.commandEnded(outcome);
    }
    [[nodiscard]] int rowOf(const QString& words)
    {
        for (int row = 0; row < fields().rowCount(); ++row) {
            if (at(row, PackingFields::NameRole).toString().startsWith(words))
                return row;
        }
        qFatal("no field %s", qPrintable(words));
    }
    [[nodiscard]] QVariant at(int row, int role) { return fields().data(fields().index(row), role); }
    [[nodiscard]] int writes() const
    {
        int writes = 0;
        for (const link::ParameterRequest& request : link.parameters)
            writes += request.value ? 1 : 0;
        return writes;
    }
    void openWizard()
    {
        setup().open();
        answerParameters();
        wizard().restart();
        answerParameters();
    }
};

} // namespace

class TestPackingSetup : public QObject {
    Q_OBJECT

private slots:
    void marksAreMeasuredAndCompared()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        QVERIFY(rig.setup().canTeach());
        rig.set("packer.teach_marks", 10); // from the previous teaching
        rig.setup().teach();
        QVERIFY(rig.setup().teaching() && !rig.setup().canTeach());
        QCOMPARE(rig.link.requests.last().command, modbus::Command::TeachMarks);
        QCOMPARE(rig.link.requests.last().arguments.argument0, std::uint16_t{10});
        rig.answerCommand(modbus::Command::TeachMarks);
        rig.tell(); // may have been read before
        QVERIFY(rig.setup().teaching());
        rig.set("packer.teach_marks", 4);
        QCOMPARE(rig.setup().teachText(), "4 of 10 marks measured …");
        QCOMPARE(rig.setup().teachProgress(), 0.4);
        rig.packer.set("packer.teach_pitch", 250.3);
        rig.packer.set("packer.teach_scatter", 0.08);
        rig.set("packer.teach_marks", 10);
        QVERIFY(!rig.setup().teaching() && !rig.setup().misfit());
        QCOMPARE(rig.setup().teachText(),
                 "The mark distance is 250.30 mm (±0.08 mm), the recipe cuts 250 mm.");
        rig.set("packer.teach_pitch", 260);
        QVERIFY(rig.setup().misfit());
        QVERIFY(rig.setup().teachText().endsWith("this film does not match this recipe."));
    }

    void teachingNeedsARunAndSaysARefusal()
    {
        PackingRig rig;
        rig.setState(modbus::State::Ready);
        QVERIFY(!rig.setup().canTeach());
        rig.setup().teach();
        QVERIFY(rig.link.requests.isEmpty());
        QVERIFY(rig.setup().teachText().startsWith("Start the machine"));
        rig.setState(modbus::State::Running);
        rig.setup().teach();
        rig.answerCommand(modbus::Command::TeachMarks, link::CommandEnd::NotReceived);
        QVERIFY(!rig.setup().teaching());
        QVERIFY(!rig.setup().teachText().contains("marks measured"));
        rig.link.becomeLost();
        QVERIFY(!rig.setup().canTeach());
    }

    // 250 to 300 mm at 60 a minute: the infeed slows from 20 to 16.7 kHz, of which 800 Hz may be one step.
    void aChangeOfTheRunningProgramIsForecast()
    {
        PackingRig rig;
        rig.editor.bagLength()->set(300);
        panel::ProgramDownload& download = *rig.editor.programDownload();
        QCOMPARE(download.text(), "The machine keeps running; the new recipe starts with the next cycle.");
        rig.answerParameters();
        QCOMPARE(download.text(),
                 "Slows down to 24 % (bags: 1, at least 1.2 s), then 60.0 bags/min. A product under the "
                 "first cut adds 2.9 s. Scrap bags: 2 to 10; the first good bag within 16.2 s.");
        rig.machine.parameter("parameter.anti_cut").write(0, {});
        rig.answerParameters();
        QCOMPARE(
            download.text(),
            "Slows down to 24 % (bags: 1, 1.2 s), then 60.0 bags/min. Scrap bags: 2 to 10; the first good "
            "bag within 13.2 s.");
        rig.editor.bagLength()->set(250);
        rig.editor.rate()->set(120);
        QCOMPARE(
            download.text(),
            "No slowing down. Speeds up to 120.0 bags/min within 0.4 s. Scrap bags: 1; the first good bag "
            "within 2.4 s.");
        QVERIFY(download.canDownload());

        // A step that no share of full speed keeps.
        rig.machine.parameter("parameter.infeed_step").write(10, {});
        rig.answerParameters();
        rig.editor.rate()->set(60);
        rig.editor.bagLength()->set(460);
        QCOMPARE(
            download.text(),
            "Slows down to 0.1 % (bags: 1, 1.6 s), then 60.0 bags/min. Scrap bags: 2 to 10; the first good "
            "bag within 13.6 s.");
        rig.machine.parameter("parameter.flight_pulses").write(10e6, {});
        rig.answerParameters();
        QVERIFY(!download.canDownload());
        QVERIFY2(download.text().startsWith("The speed of an axis would change too abruptly."),
                 qPrintable(download.text()));
        rig.setState(modbus::State::Ready);
        QVERIFY(download.canDownload());
    }

    // Behind an encoder it cannot slow down: the infeed would step by 3.3 kHz at the full rate, 0.7 at a
    // fifth.
    void aChangeBehindAnEncoderIsForecast()
    {
        PackingRig rig;
        rig.editor.bagLength()->set(300);
        panel::ProgramDownload& download = *rig.editor.programDownload();
        rig.answerParameters();
        rig.machine.parameter("parameter.anti_cut").write(0, {});
        rig.machine.parameter("master.source").write(1, {});
        rig.answerParameters();
        QVERIFY2(
            download.text().startsWith("Stops at the end of a cycle, then follows the line again (2.2 s at "
                                       "its present speed). Scrap bags: 2 to 10;"),
            qPrintable(download.text()));
        rig.link.status.masterSpeedPercent = 20;
        rig.setState(modbus::State::Running);
        rig.editor.bagLength()->set(301);
        rig.editor.bagLength()->set(300);
        QVERIFY2(
            download.text().startsWith("The machine keeps following the line; the new recipe starts with "
                                       "the next cycle. Scrap bags: 2 to 10;"),
            qPrintable(download.text()));
        // Half the rate: the line runs at 40 % of it, then at twice its speed.
        rig.editor.bagLength()->set(250);
        rig.editor.rate()->set(30);
        QVERIFY(download.canDownload());
        rig.link.status.masterSpeedPercent = 100;
        rig.setState(modbus::State::Running);
        rig.editor.rate()->set(31);
        rig.editor.rate()->set(30);
        QVERIFY(!download.canDownload());
        QVERIFY2(download.text().startsWith("The line runs faster than this program."),
                 qPrintable(download.text()));
    }

    void valuesAreReadOnceAndWrittenWithProof()
    {
        PackingRig rig;
        rig.setup().open();
        rig.setup().open();
        QCOMPARE(rig.link.parameters.size(), rig.fields().rowCount());
        const int row = rig.rowOf(QStringLiteral("Mark window"));
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "--");
        QVERIFY(!rig.at(row, PackingFields::KnownRole).toBool());
        rig.answerParameters();
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "6");
        QCOMPARE(rig.at(row, PackingFields::NoteRole).toString(), "0.5 mm to 30 mm");
        rig.fields().select(row);
        QCOMPARE(rig.fields().value()->unit(), "mm");
        QCOMPARE(rig.fields().value()->decimals(), 3);
        QCOMPARE(rig.fields().value()->check(31), "The maximum is 30 mm.");
        rig.fields().value()->set(31);
        QVERIFY(rig.link.parameters.isEmpty());
        rig.fields().value()->set(8);
        QCOMPARE(rig.link.parameters.last().name, std::string("parameter.mark_window"));
        QCOMPARE(rig.link.parameters.last().value, 8.0);
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "6"); // until it is proven
        QVERIFY(!rig.fields().unsaved());
        rig.answerParameters();
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "8");
        QCOMPARE(rig.fields().outcomeText(), "Mark window, ±: 8 mm, read back from the controller.");
        QVERIFY(rig.fields().unsaved());
        rig.link.becomeLost();
        rig.link.becomeConnected();
        rig.link.sendStatus(rig.now);
        QVERIFY(rig.fields().unsaved()); // still in the controller
        rig.fields().save();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::SaveToFlash);
        QCOMPARE(rig.link.requests.last().arguments.argument2, *rig.link.status.activeCrc);
        rig.answerCommand(modbus::Command::SaveToFlash);
        QVERIFY(!rig.fields().unsaved());
    }

    // No mark would fit: nothing is written, and the other value is named.
    void aMinimumWidthAboveTheMaximumIsRefusedAtEntry()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        const int minimum = rig.rowOf(QStringLiteral("Mark width, minimum"));
        QCOMPARE(rig.at(minimum, PackingFields::NoteRole).toString(), "0 mm to 60 mm · 0: not used");
        rig.fields().write("parameter.mark_width_max", 5.3);
        rig.answerParameters();
        rig.fields().select(minimum);
        rig.fields().value()->set(6);
        QVERIFY(rig.link.parameters.isEmpty());
        QVERIFY(rig.fields().failed());
        QVERIFY2(rig.fields().outcomeText().startsWith(
                     QStringLiteral("No mark would fit: at least 6.00 mm, at most 5.30 mm.")),
                 qPrintable(rig.fields().outcomeText()));
        rig.fields().value()->set(4.7);
        QCOMPARE(rig.link.parameters.last().value, 4.7);
    }

    void aDeadTimeOf50MsIsRefusedAtEntry_data()
    {
        QTest::addColumn<QString>("label");
        QTest::newRow("mark sensor") << QStringLiteral("Mark sensor: dead time");
        QTest::newRow("eye, begins") << QStringLiteral("Product eye: dead time, product comes");
        QTest::newRow("eye, ends") << QStringLiteral("Product eye: dead time, product ends");
    }
    void aDeadTimeOf50MsIsRefusedAtEntry()
    {
        QFETCH(QString, label);
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        rig.fields().select(rig.rowOf(label));
        QCOMPARE(rig.fields().value()->check(50).replace(QChar(0xA0), u' ').remove(QChar(0x2060)),
                 QStringLiteral("The maximum is 20 ms."));
        rig.fields().value()->set(50);
        QVERIFY(rig.link.parameters.isEmpty());
        rig.fields().value()->set(5);
        QCOMPARE(rig.link.parameters.last().value, 5.0);
    }

    // Each of the two times is possible alone, but not both together.
    void theEndOfAMarkIsNotLaterThanPossible()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        rig.fields().write("parameter.mark_dead_time", 15);
        rig.answerParameters();
        const auto sentence =
            QStringLiteral("The end of a mark would have a dead time of %1 ms; it must be 0 to "
                           "20 ms. Change the other time first.");
        rig.fields().write("parameter.mark_end_later", 15);
        QVERIFY(rig.link.parameters.isEmpty());
        QCOMPARE(rig.fields().outcomeText(), sentence.arg(QStringLiteral("30.00")));
        rig.fields().write("parameter.mark_end_later", -15.5);
        QVERIFY(rig.link.parameters.isEmpty());
        rig.fields().write("parameter.mark_end_later", 4);
        rig.answerParameters();
        rig.fields().write("parameter.mark_dead_time", 16.5);
        QVERIFY(rig.link.parameters.isEmpty());
        QCOMPARE(rig.fields().outcomeText(), sentence.arg(QStringLiteral("20.50")));
        rig.fields().write("parameter.mark_dead_time", 16);
        QCOMPARE(rig.link.parameters.last().value, 16.0);
    }

    void anglesThatLeaveOutTheCutSaySo()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        const auto note = [&rig](const char* label) {
            return rig.at(rig.rowOf(QLatin1String(label)), PackingFields::NoteRole).toString();
        };
        const auto leavesOut = QStringLiteral("leaves out the cut: enter both angles, or 0 for both");
        QVERIFY(note("Jaws close").endsWith(QStringLiteral("0: not used")));
        rig.fields().write("parameter.jaws_before", 20);
        rig.answerParameters();
        QVERIFY2(note("Jaws close").endsWith(leavesOut), qPrintable(note("Jaws close")));
        QVERIFY2(note("Jaws open").endsWith(leavesOut), qPrintable(note("Jaws open")));
        rig.fields().write("parameter.jaws_behind", 25);
        rig.answerParameters();
        QVERIFY(!note("Jaws close").endsWith(leavesOut));
        QVERIFY(!note("Jaws open").endsWith(leavesOut));
    }

    void aWriteWithoutProofLeavesAnUnknown()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        const int row = rig.rowOf(QStringLiteral("Film waits"));
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "Off");
        rig.fields().setChoice(row, 1);
        const link::ParameterRequest request = rig.link.parameters.last();
        QCOMPARE(request.value, 1.0);
        emit rig.link.parameterEnded({request.id, request.name, link::ParameterEnd::OutcomeUnknown, {}, {}});
        QVERIFY(rig.fields().failed());
        QCOMPARE(rig.at(row, PackingFields::ValueRole).toString(), "--");
        rig.link.becomeLost();
        QVERIFY(!rig.at(0, PackingFields::KnownRole).toBool());
    }

    void gainsAreSuggestedAfterEnoughBags()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        const int row = rig.rowOf(QStringLiteral("Phase gain"));
        const auto passMark = [&rig](int mark) {
            rig.packer.set("packer.marks", mark);
            rig.packer.set("packer.mark_pitch", 250);
            rig.set("packer.last_mark", (mark * 7919 % 101 - 50) * 0.001);
        };
        for (int mark = 1; mark <= GainEstimate::minBags; ++mark)
            passMark(mark);
        QVERIFY(rig.at(row, PackingFields::SuggestionRole).toString().isEmpty());
        QVERIFY(rig.at(row, PackingFields::NoteRole).toString().endsWith("still needed: 1"));
        passMark(GainEstimate::minBags + 1);
        const QString suggestion = rig.at(row, PackingFields::SuggestionRole).toString();
        QVERIFY(!suggestion.isEmpty());
        rig.fields().takeSuggestion(row);
        QCOMPARE(rig.link.parameters.last().name, std::string("parameter.phase_gain"));
        QCOMPARE(rig.link.parameters.last().value.value_or(0), suggestion.toDouble());
        rig.answerParameters();
        QVERIFY(rig.at(row, PackingFields::SuggestionRole).toString().isEmpty()); // accepted
    }

    void marksThatDoNotScatterSuggestNothing()
    {
        PackingRig rig;
        rig.setup().open();
        rig.answerParameters();
        for (int mark = 1; mark <= GainEstimate::minBags + 1; ++mark) {
            rig.packer.set("packer.marks", mark);
            rig.packer.set("packer.mark_pitch", 250);
            rig.set("packer.last_mark", 0.05);
        }
        const int row = rig.rowOf(QStringLiteral("Phase gain"));
        QVERIFY(rig.at(row, PackingFields::SuggestionRole).toString().isEmpty());
        QVERIFY(rig.at(row, PackingFields::NoteRole)
                    .toString()
                    .endsWith("no suggestion: the mark positions do not vary (150 bags)"));
    }

    void wizardCorrectsTheDistance()
    {
        PackingRig rig;
        rig.openWizard();
        QVERIFY2(rig.wizard().canGoOn(), qPrintable(rig.wizard().blockedReason()));
        rig.wizard().goOn();
        QCOMPARE(rig.wizard().step(), Step::Cutting);
        rig.cutBags(4);
        QCOMPARE(rig.wizard().step(), Step::Cutting);
        QCOMPARE(rig.wizard().progress(), 0.8);
        rig.cutBags(1);
        QCOMPARE(rig.wizard().step(), Step::Measure);
        QVERIFY(!rig.wizard().canGoOn());
        rig.wizard().addMeasurement(-2.9);
        rig.wizard().addMeasurement(-3.1);
        rig.wizard().addMeasurement(300); // longer than a bag
        rig.wizard().addMeasurement(8);
        rig.wizard().dropMeasurement();
        QCOMPARE(rig.wizard().measuredText(), "−2.90 · −3.10");
        rig.wizard().goOn();
        QCOMPARE(rig.wizard().step(), Step::Confirm);
        QCOMPARE(rig.wizard().oldText(), "900.00 mm");
        QCOMPARE(rig.wizard().newText(), "903.00 mm");
        QCOMPARE(rig.writes(), 0);
        rig.wizard().goOn();
        QCOMPARE(rig.wizard().step(), Step::Writing);
        QCOMPARE(rig.writes(), 1);
        QCOMPARE(rig.link.parameters.last().name, std::string("parameter.mark_distance"));
        QCOMPARE(rig.link.parameters.last().value, 903.0);
        rig.answerParameters();
        QCOMPARE(rig.wizard().step(), Step::Watch);
        // Read before the write, reported after it: with the old distance.
        rig.now -= 10ms;
        rig.cutBags(7, 0.0);
        rig.now += 10ms;
        rig.tell();
        rig.cutBags(6, 0.0); // their marks had already passed the sensor
        rig.cutBags(4, 3.0); // in progress
        rig.cutBags(4, 0.1);
        QCOMPARE(rig.wizard().step(), Step::Watch);
        rig.cutBags(1, 0.1);
        QCOMPARE(rig.wizard().step(), Step::Done);
        QCOMPARE(rig.wizard().newText(), "903.00 mm");
        QVERIFY(rig.fields().unsaved());
    }

    void wizardCountsOnlyBagsThatFollowTheirMarks()
    {
        PackingRig rig;
        rig.set("packer.mark_state", static_cast<double>(modbus::MarkState::Off));
        rig.openWizard();
        QVERIFY(!rig.wizard().canGoOn());
        QVERIFY(rig.wizard().blockedReason().startsWith("Mark tracking is off."));
        rig.set("packer.mark_state", static_cast<double>(modbus::MarkState::Tracking));
        rig.setState(modbus::State::Ready);
        QVERIFY(!rig.wizard().canGoOn());
        rig.setState(modbus::State::Running);
        rig.wizard().goOn();
        rig.cutBags(3);
        rig.set("packer.mark_state", static_cast<double>(modbus::MarkState::Aligning));
        rig.cutBags(3);
        rig.set("packer.mark_state", static_cast<double>(modbus::MarkState::Tracking));
        rig.cutBags(4);
        QCOMPARE(rig.wizard().step(), Step::Cutting);
        rig.cutBags(1);
        QCOMPARE(rig.wizard().step(), Step::Measure);
    }

    void correctionIsTheShortWayRound_data()
    {
        QTest::addColumn<double>("measuredMm");
        QTest::addColumn<double>("offsetMm");
        QTest::addColumn<double>("newMm");
        QTest::newRow("as wanted") << 0.0 << 0.0 << 900.0;
        QTest::newRow("too late") << 3.0 << 0.0 << 897.0;
        QTest::newRow("too early") << -3.0 << 0.0 << 903.0;
        QTest::newRow("behind a wanted offset") << 22.0 << 20.0 << 898.0;
        QTest::newRow("before a wanted offset") << 18.0 << 20.0 << 902.0;
        QTest::newRow("from the mark before") << -48.0 << 200.0 << 898.0;
        QTest::newRow("to the next mark") << 248.5 << 0.0 << 901.5;
    }
    void correctionIsTheShortWayRound()
    {
        QFETCH(double, measuredMm);
        QFETCH(double, offsetMm);
        QFETCH(double, newMm);
        PackingRig rig;
        rig.openWizard();
        emit rig.link.parameterEnded({9999, "parameter.mark_offset", link::ParameterEnd::Done, offsetMm, {}});
        rig.wizard().goOn();
        rig.cutBags(5);
        rig.wizard().addMeasurement(measuredMm);
        QVERIFY(std::abs(rig.wizard().newDistanceMm() - newMm) < 1e-9);
    }

    void canceledAtAnyStepItChangesNothing()
    {
        for (int steps = 0; steps <= 3; ++steps) {
            PackingRig rig;
            rig.openWizard();
            if (steps > 0)
                rig.wizard().goOn();
            if (steps > 1)
                rig.cutBags(5);
            if (steps > 2) {
                rig.wizard().addMeasurement(1);
                rig.wizard().goOn();
            }
            QCOMPARE(static_cast<int>(rig.wizard().step()), steps);
            rig.wizard().restart();
            QCOMPARE(rig.wizard().step(), Step::Explain);
            rig.cutBags(20);
            QCOMPARE(rig.writes(), 0);
            QVERIFY(rig.wizard().measuredText().isEmpty());
        }
    }

    void aRefusedWriteIsSaid()
    {
        PackingRig rig;
        rig.openWizard();
        rig.wizard().goOn();
        rig.cutBags(5);
        rig.wizard().addMeasurement(1);
        rig.wizard().goOn();
        rig.wizard().goOn();
        const link::ParameterRequest request = rig.link.parameters.last();
        emit rig.link.parameterEnded({request.id, request.name, link::ParameterEnd::NotSent, {}, {}});
        QCOMPARE(rig.wizard().step(), Step::Failed);
        QVERIFY(rig.wizard().text().contains("was not changed"));
    }

    void badBagsAfterTheWriteAreSaid()
    {
        PackingRig rig;
        rig.openWizard();
        rig.wizard().goOn();
        rig.cutBags(5);
        rig.wizard().addMeasurement(1);
        rig.wizard().goOn();
        rig.wizard().goOn();
        rig.answerParameters();
        rig.tell();
        rig.cutBags(6 + 1 + 20 + 5 - 1, 0.9);
        QCOMPARE(rig.wizard().step(), Step::Watch);
        rig.cutBags(1, 0.9);
        QCOMPARE(rig.wizard().step(), Step::Failed);
        QVERIFY2(rig.wizard().text().contains("0.90 mm"), qPrintable(rig.wizard().text()));
    }

    void theRulerMeasuresEachBagOnce()
    {
        PackingRig rig;
        rig.openWizard();
        rig.wizard().goOn();
        QVERIFY(!rig.wizard().canReadRuler());
        rig.cutBags(5);
        QVERIFY(rig.wizard().canReadRuler());
        rig.wizard().measureSimulatedBag();
        rig.wizard().measureSimulatedBag(); // one at a time
        QCOMPARE(rig.link.rulers, 1);
        emit rig.link.rulerRead({link::RulerEnd::Read, 250.1, -3.05});
        QCOMPARE(rig.wizard().measuredText(), "−3.05");
        rig.wizard().measureSimulatedBag();
        emit rig.link.rulerRead({link::RulerEnd::Read, 250.1, -3.05});
        QCOMPARE(rig.wizard().measuredText(), "−3.05");
        QVERIFY(rig.wizard().text().startsWith("This bag has been measured already"));
        rig.wizard().measureSimulatedBag();
        emit rig.link.rulerRead({link::RulerEnd::NoBag, 0, 0});
        QCOMPARE(rig.wizard().text(), "No bag has been cut yet.");
        rig.wizard().measureSimulatedBag();
        emit rig.link.rulerRead({link::RulerEnd::Read, 249.9, -2.95});
        QCOMPARE(rig.wizard().measuredText(), "−3.05 · −2.95");
    }
};

CAMPANEL_TEST(TestPackingSetup)

} // namespace test_packing_setup

#include "test_packing_setup.moc"
