// SPDX-License-Identifier: Apache-2.0
// An encoder leads the machine: the panel says so, and refuses what does not fit.
#include "app/panel/reports/commissioning.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/register_words.h"
#include "tests/app/panel/access_rig.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <map>

namespace test_master_setting {

using namespace campanel;
using namespace campanel::test;
using panel::MasterSetting;
using panel::ProgramDownload;
using panel::SimulatedFaults;
using program::RecipeMaster;

namespace {

// A controller of the present map, with an input for an encoder unless it is said otherwise.
struct MasterRig : AccessRig {
    std::map<std::string, double> registers{{"master.source", 0}, {"master_status.available", 1}};

    explicit MasterRig(bool isLed, bool hasInput = true)
    {
        registers["master.source"] = isLed ? 1 : 0;
        registers["master_status.available"] = hasInput ? 1 : 0;
    }

    void connectIdle()
    {
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.simulator = link::SimulatorState::Serving;
        report.identity = FakeLink::identity();
        report.identity->mapMinor = modbus::mapMinor;
        emit link.reported(report);
        link.sendStatus(now);
        emit link.programRead({link.status.generation, 0, {}});
        answer();
    }

    void connectRunning()
    {
        connectIdle();
        link.activate(image(), now);
        link.status.state = modbus::State::Running;
        link.status.masterSpeedPercent = 100;
        link.sendStatus(now);
        answer();
    }

    void answer()
    {
        for (; m_answered < link.parameters.size(); ++m_answered) {
            const link::ParameterRequest request = link.parameters[m_answered];
            const auto found = registers.find(request.name);
            const double value =
                found != registers.end() ? found->second : modbus::findRegister(request.name)->defaultValue;
            if (request.value)
                registers[request.name] = *request.value;
            emit link.parameterEnded(
                {request.id, request.name, link::ParameterEnd::Done, request.value.value_or(value), {}});
        }
    }

    void setSource(double source)
    {
        machine.parameter("master.source").write(source, {});
        answer();
    }

    [[nodiscard]] MasterSetting& master() { return *machine.masterSetting(); }
    [[nodiscard]] QString downloadText() { return editor.programDownload()->text(); }
    void enterMaster(int option) { editor.setChoice(editor.choices()->count() - 1, option); }

private:
    qsizetype m_answered = 0;
};

} // namespace

class TestMasterSetting : public QObject {
    Q_OBJECT

private slots:
    void isReadWhereTheControllerHasIt()
    {
        PanelRig older;
        older.connectRunning();
        QVERIFY(std::ranges::none_of(older.link.parameters, [](const link::ParameterRequest& each) {
            return each.name.starts_with("master");
        }));
        QVERIFY(!older.machine.masterSetting()->machine());
        QVERIFY(!older.machine.masterSetting()->leads());
        QCOMPARE(older.machine.masterSetting()->text(), "Clock of the controller");

        MasterRig rig(true);
        rig.registers["master.place"] = 1;
        QCOMPARE(rig.master().text(), "--");
        rig.connectIdle();
        QVERIFY2(rig.master().text().startsWith("Encoder · Wheel · 10,000"), qPrintable(rig.master().text()));
        QVERIFY(rig.master().followsEncoder() && rig.master().hasInput());
        QVERIFY(!rig.master().leads()); // there is no program
        rig.connectRunning();
        QVERIFY(rig.master().leads());
        rig.setSource(0);
        QVERIFY(!rig.master().leads());
        QVERIFY(rig.master().rateText().isEmpty());
        QCOMPARE(rig.master().text(), "Clock of the controller");
    }

    void theRateIsThatOfTheLine()
    {
        MasterRig rig(true);
        rig.registers["master.speed_max"] = 120;
        rig.connectRunning();
        panel::EditorField& rate = *rig.editor.rate();
        QCOMPARE(rate.label(), "Rate at max. line speed");
        QVERIFY2(rate.explanation().contains("250.0 mm/s of film") &&
                     rate.explanation().contains("300.0 mm/s"),
                 qPrintable(rate.explanation()));
        QSignalSpy explained(&rig.master(), &MasterSetting::explained);
        rig.master().explainRate();
        QCOMPARE(explained.size(), 1);
        QCOMPARE(rig.machine.commandMessage(),
                 "The line sets the rate: an encoder leads the machine. Change the speed of the line.");
        rig.setSource(0);
        QCOMPARE(rate.label(), "Rate");
        rig.machine.dismissMessage();
        rig.master().explainRate();
        QVERIFY(rig.machine.commandMessage().isEmpty());
        // A recipe for an encoder, wherever it is edited.
        rig.enterMaster(2);
        QCOMPARE(rate.label(), "Rate at max. line speed");
        rig.enterMaster(1);
        QCOMPARE(rate.label(), "Rate");
    }

    // Its figures come twice a second: nothing else is computed again for them.
    void theLineIsReadWhileRunShowsIt()
    {
        MasterRig rig(true);
        rig.connectRunning();
        QVERIFY(rig.master().leads());
        const auto asked = [&rig] {
            return std::ranges::count(rig.link.reads, modbus::masterStatusAddress,
                                      &link::ReadRequest::address);
        };
        QCOMPARE(asked(), 0);
        rig.master().setWatched(true);
        QCOMPARE(asked(), 1);
        QVERIFY(rig.master().lineText().isEmpty());
        std::vector<std::uint16_t> registers(modbus::masterStatusRegisters);
        modbus::RegisterWriter writer(registers, modbus::masterStatusAddress);
        for (const auto& [name, value] :
             {std::pair{"master_status.available", 1.0},
              std::pair{"master_status.state", static_cast<double>(modbus::MasterState::Engaged)},
              std::pair{"master_status.speed", 250.4}, std::pair{"master_status.angle", 264.6},
              std::pair{"master_status.phase", -1.5}})
            QVERIFY(writer.physical(name, value));
        QSignalSpy changed(&rig.master(), &MasterSetting::changed);
        QSignalSpy told(&rig.master(), &MasterSetting::lineChanged);
        emit rig.link.registersRead({rig.link.reads.last(), link::ReadEnd::Done, registers, rig.now, {}});
        QCOMPARE(told.size(), 1);
        QCOMPARE(changed.size(), 0);
        QVERIFY(rig.master().lineText().startsWith("Engaged · 250"));
        QSignalSpy explained(&rig.master(), &MasterSetting::explained);
        rig.master().explainRate();
        const QString sentence = explained.at(0).at(0).toString();
        QVERIFY2(sentence.contains(QStringLiteral("265°")), qPrintable(sentence));
        QVERIFY2(sentence.contains(QStringLiteral("−1.50°")), qPrintable(sentence));
        rig.link.becomeLost();
        QVERIFY(rig.master().lineText().isEmpty());
        QVERIFY(!rig.master().line());
    }

    void theMapShowsTheSpeedOfTheLine()
    {
        MasterRig rig(true);
        rig.connectIdle();
        panel::CutterMap& map = *rig.editor.map();
        map.setWatched(true);
        const auto shown = [&map] { return map.map().value<std::shared_ptr<const profile::RegimeMap>>(); };
        QCOMPARE(map.axisUnit(), "mm/s");
        QCOMPARE(map.onAxis(), 250.0);
        const auto speeds = shown();
        QVERIFY2(map.text().startsWith("Line up to "), qPrintable(map.text()));
        QVERIFY2(map.text().endsWith("This program: 250 mm/s; the run ends above 275 mm/s."),
                 qPrintable(map.text()));
        map.drag(200, 500); // 500 mm/s are 150 bags of 200 mm
        map.endDrag();
        QCOMPARE(rig.editor.rate()->value(), 150.0);
        rig.editor.undo();
        rig.setSource(0);
        QCOMPARE(map.axisUnit(), "bags/min");
        QCOMPARE(map.onAxis(), 60.0);
        const auto rates = shown();
        QCOMPARE(rates->points.size(), speeds->points.size());
        double fastest = 0;
        for (std::size_t i = 0; i < rates->points.size(); ++i) {
            const double mmPerS = rates->points[i].bagLengthMm * rates->points[i].rateBagsPerMin / 60;
            QVERIFY(std::abs(speeds->points[i].rateBagsPerMin - mmPerS) < 1e-9);
            fastest = std::max(fastest, mmPerS);
        }
        QVERIFY(std::abs(speeds->maxRateBagsPerMin - fastest) < 1e-9);
    }

    void aRecipeForAnotherMasterIsRefused()
    {
        MasterRig rig(false);
        rig.connectIdle();
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        rig.enterMaster(2);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Blocked);
        QVERIFY2(rig.downloadText().startsWith("This recipe is for an encoder as the master, but"),
                 qPrintable(rig.downloadText()));
        QCOMPARE(rig.editor.verdict(), rig.downloadText());
        QCOMPARE(rig.editor.severity(), panel::Editor::Severity::Warning);
        rig.setSource(1);
        QCOMPARE(rig.editor.severity(), panel::Editor::Severity::Good);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        rig.enterMaster(1);
        QVERIFY2(rig.downloadText().startsWith("This recipe is for the clock, but"),
                 qPrintable(rig.downloadText()));
        rig.enterMaster(0);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
    }

    void aControllerWithoutAnInputRefuses()
    {
        MasterRig rig(false, false);
        rig.connectIdle();
        rig.enterMaster(2);
        QVERIFY2(rig.downloadText().contains("the controller has no input for one"),
                 qPrintable(rig.downloadText()));
        rig.enterMaster(0);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        rig.link.activate(rig.image(), rig.now);
        QVERIFY2(rig.machine.canStart(), qPrintable(rig.machine.startBlockedReason()));
        rig.setSource(1);
        QCOMPARE(
            rig.machine.startBlockedReason(),
            "The controller has no input for an encoder as the master. Set the clock as the master, or use "
            "another controller.");
        QVERIFY(!rig.machine.canStart());
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Blocked);
        rig.editor.newProgram(static_cast<int>(ProgramKind::PositionMove)); // it has no master
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
    }

    void aMasterInReverseIsNotFollowed()
    {
        MasterRig rig(true);
        begin(rig, ProgramKind::PointCam);
        enter(rig.editor, Field::MasterRate, -60);
        rig.connectIdle();
        QCOMPARE(rig.downloadText(),
                 "This program cannot follow an encoder. Set the clock as the master to run it.");
        enter(rig.editor, Field::MasterRate, 60);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        QCOMPARE(rig.editor.item(Field::MasterRate)->label(), "Max. master speed");
        rig.connectRunning();
        QVERIFY(!rig.machine.direction()->canChange());
        QCOMPARE(rig.machine.direction()->text(),
                 "The line sets the direction: an encoder leads the machine.");
    }

    void aNewRecipeSaysWhichMasterItIsFor()
    {
        const auto masterOf = [](MasterRig& rig, ProgramKind kind) {
            rig.editor.newProgram(static_cast<int>(kind));
            return rig.editor.recipe().master;
        };
        MasterRig led(true);
        QCOMPARE(masterOf(led, ProgramKind::PointCam), RecipeMaster::Any); // nothing is known yet
        led.connectIdle();
        QCOMPARE(masterOf(led, ProgramKind::RotaryCutter), RecipeMaster::Encoder);
        QCOMPARE(masterOf(led, ProgramKind::SegmentCam), RecipeMaster::Encoder);
        QCOMPARE(masterOf(led, ProgramKind::Press), RecipeMaster::Any);
        MasterRig own(false);
        own.connectIdle();
        QCOMPARE(masterOf(own, ProgramKind::RotaryCutter), RecipeMaster::Clock);
        own.editor.undo();
        QCOMPARE(own.editor.recipe().master, RecipeMaster::Any);
        QVERIFY(!own.editor.edited());
        own.enterMaster(2);
        QVERIFY(own.editor.edited());
    }

    void theLineIsAmongTheFaultsWhereThereIsAnEncoder()
    {
        MasterRig without(false, false);
        without.connectRunning();
        SimulatedFaults& hidden = *without.maintenance.simulatedFaults();
        const int jam = hidden.rows()->count() - 1;
        QCOMPARE(hidden.rows()->row(jam).name(), "Something under the jaws");
        hidden.setLevel(jam + 1, SimulatedFaults::Often);
        QVERIFY(without.link.faults.isEmpty());

        MasterRig rig(true);
        rig.connectRunning();
        SimulatedFaults& faults = *rig.maintenance.simulatedFaults();
        QCOMPARE(faults.rows()->count(), jam + 6);
        const int line = jam + 1;
        QVERIFY(faults.rows()->row(line).isLine());
        QVERIFY2(faults.rows()->row(line).note().contains("250 mm/s"),
                 qPrintable(faults.rows()->row(line).note()));
        faults.setLevel(line, SimulatedFaults::Sometimes);
        QCOMPARE(rig.link.faults.last(), QStringList{"line start 125.0"});
        emit rig.link.faultsSimulated({});
        faults.setLevel(line, SimulatedFaults::Beyond);
        QCOMPARE(rig.link.faults.last(), QStringList{"line start 300.0"});
        emit rig.link.faultsSimulated({});
        faults.setLevel(jam + 5, SimulatedFaults::Beyond); // only the line has this level
        faults.setLevel(jam + 5, SimulatedFaults::Often);
        QCOMPARE(rig.link.faults.last(), (QStringList{"line start 300.0", "line noise on"}));
        emit rig.link.faultsSimulated({});
        QCOMPARE(faults.text(), "Active: Line runs, Encoder signal disturbed");
        faults.clear();
        QCOMPARE(rig.link.faults.last(), QStringList());
    }

    void reportsHaveTheMaster()
    {
        MasterRig rig(true);
        rig.registers["master.counts"] = 2500;
        rig.connectRunning();
        const auto rows = [&rig] {
            panel::Commissioning report(rig.machine, rig.editor, rig.access, *rig.maintenance.files(),
                                        nullptr);
            QMap<QString, QString> found;
            for (const panel::ReportSection& section : report.data().sections) {
                if (section.title == "Master")
                    for (const auto& [name, value] : section.rows)
                        found[name] = value;
            }
            return found;
        };
        QCOMPARE(rows()["Counts per revolution"], "2500 counts");
        QCOMPARE(rows()["Master"], "Encoder");
        QCOMPARE(rows()["Delay compensation"], "On");
        // A change is in the trail, with the name that a person reads.
        rig.setSource(0);
        rig.settle();
        const auto trail = rig.entries();
        const auto written = std::ranges::find(trail, "master.source", &store::AuditEntry::object);
        QVERIFY(written != trail.end());
        QCOMPARE(written->before, "1");
        QCOMPARE(written->after, "0");
        QCOMPARE(panel::AuditWords::object(*written), "Master");
        QVERIFY(panel::AuditWords::keysWith("Counts per rev").contains("master.counts"));
        for (const modbus::RegisterInfo& info : modbus::registers()) {
            if (info.name.starts_with("master."))
                QVERIFY2(!panel::MasterSentences::parameter(panel::RegisterWords::name(info)).isEmpty(),
                         info.name.data());
        }
    }
};

CAMPANEL_TEST(TestMasterSetting)

} // namespace test_master_setting

#include "test_master_setting.moc"
