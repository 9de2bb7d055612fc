// SPDX-License-Identifier: Apache-2.0
// The register inspector on a fake link: what it reads and when, its texts, and writing.
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_register_inspector {

using namespace campanel;
using namespace std::chrono_literals;
using panel::RegisterModel;
using test::PanelRig;

namespace {

QString textAt(const QAbstractItemModel& model, int row, int role)
{
    return model.data(model.index(row, 0), role).toString();
}

struct InspectorRig : PanelRig {
    InspectorRig()
    {
        connectIdle();
        maintenance.inspector()->setGroup(QStringLiteral("parameter"));
        maintenance.inspector()->setVisibleRows(0, 2);
        maintenance.inspector()->setWatched(true);
    }

    [[nodiscard]] panel::RegisterInspector& inspector() { return *maintenance.inspector(); }
    [[nodiscard]] RegisterModel& registers() { return *inspector().registers(); }
    void answer(std::vector<std::uint16_t> values)
    {
        emit link.registersRead({link.reads.last(), link::ReadEnd::Done, std::move(values), now, {}});
    }
};

} // namespace

class TestRegisterInspector : public QObject {
    Q_OBJECT

private slots:
    void onlyWhatIsInSightIsRead()
    {
        InspectorRig rig;
        QCOMPARE(rig.link.reads.size(), 1); // three registers in a row
        QCOMPARE(rig.link.reads[0].address, quint16{0x80});
        QCOMPARE(rig.link.reads[0].count, quint16{3});
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "--");
        rig.answer({2000, 1, 900});
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "900 ms");
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::RawRole), "0x0384");
        QTRY_COMPARE(rig.link.reads.size(), 2); // and again
        rig.inspector().setVisibleRows(3, 4);
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "--"); // it would become old unnoticed
        rig.answer({2000, 1, 900});
        QTRY_COMPARE(rig.link.reads.size(), 3);
        QCOMPARE(rig.link.reads[2].address, quint16{0x83});
        QCOMPARE(rig.link.reads[2].count, quint16{4}); // two of two registers each
        rig.answer({0, 1000, 0, 2000});
        rig.inspector().setWatched(false);
        const qsizetype before = rig.link.reads.size();
        InspectorRig other; // long enough for several rounds
        for (int round = 2; round < 5; ++round) {
            other.answer({2000, 1, 900});
            QTRY_COMPARE(other.link.reads.size(), round);
        }
        QCOMPARE(rig.link.reads.size(), before);
    }

    void valuesGrowOldWhenNothingComes()
    {
        InspectorRig rig;
        rig.answer({2000, 1, 900});
        QVERIFY(!rig.registers().data(rig.registers().index(0), RegisterModel::StaleRole).toBool());
        rig.link.becomeLost();
        rig.now += 1100ms;
        QTRY_VERIFY(rig.registers().data(rig.registers().index(0), RegisterModel::StaleRole).toBool());
        QCOMPARE(textAt(rig.registers(), 0, RegisterModel::ValueRole), "2000 ms");
    }

    void aRegisterThatIsNotThereIsSaid()
    {
        InspectorRig rig;
        link::ReadOutcome refused{rig.link.reads.last(), link::ReadEnd::Failed, {}, rig.now, {}};
        refused.error = modbus::LinkError{modbus::LinkErrorKind::RangeNotReadable, {}, {}, {}, 0};
        emit rig.link.registersRead(refused);
        QCOMPARE(textAt(rig.registers(), 0, RegisterModel::ValueRole), "cannot be read");
    }

    void registersAreFoundByName()
    {
        PanelRig rig;
        panel::RegisterInspector& inspector = *rig.maintenance.inspector();
        inspector.setNameFilter(QStringLiteral("CRC"));
        QVERIFY(inspector.registers()->count() > 2);
        for (int i = 0; i < inspector.registers()->count(); ++i)
            QVERIFY(textAt(*inspector.registers(), i, RegisterModel::NameRole).contains("crc"));
        inspector.setNameFilter(QStringLiteral("press_force"));
        QCOMPARE(inspector.registers()->count(), 0); // no press is running
    }

    void registersFollowTheProgram()
    {
        PanelRig rig;
        rig.maintenance.inspector()->setNameFilter(QStringLiteral("bag_length"));
        QCOMPARE(rig.maintenance.inspector()->registers()->count(), 0);
        rig.connectRunning(); // a cutter
        QCOMPARE(rig.maintenance.inspector()->registers()->count(), 2);
        QCOMPARE(rig.maintenance.inspector()->registers()->rowAt(1)->address, quint16{0x4000 + 23});
    }

    void everyRegisterSaysWhetherItCanBeWritten()
    {
        PanelRig rig;
        rig.connectRunning();
        panel::RegisterInspector& inspector = *rig.maintenance.inspector();
        int writable = 0;
        for (int i = 0; i < inspector.registers()->count(); ++i) {
            inspector.select(i);
            const QString name = inspector.selectedName();
            const bool isMachineData =
                name.startsWith(u"parameter.") || name.startsWith(u"master.") || name.startsWith(u"signal.");
            QCOMPARE(inspector.canWrite(), isMachineData);
            QCOMPARE(inspector.selectedText().startsWith(u"Read only:"), !isMachineData);
            writable += isMachineData ? 1 : 0;
        }
        QVERIFY(writable > 20);
        QVERIFY(inspector.registers()->count() > 100);
    }

    void aWriteIsProvenBeforeItIsShown()
    {
        InspectorRig rig;
        panel::RegisterInspector& inspector = rig.inspector();
        inspector.select(2);
        QCOMPARE(inspector.selectedText(), "Writable: 50 ms to 10000 ms, default 800 ms.");
        QVERIFY(!inspector.value()->check(49).isEmpty() && inspector.value()->check(50).isEmpty());
        inspector.value()->set(49);
        QCOMPARE(rig.link.parameters.size(), 0);
        inspector.value()->set(900);
        QCOMPARE(rig.link.parameters.size(), 1);
        QCOMPARE(rig.link.parameters[0].name, "parameter.ramp_time");
        QCOMPARE(rig.link.parameters[0].value, std::optional(900.0));
        QVERIFY(!inspector.canWrite()); // one at a time
        emit rig.link.parameterEnded(
            {rig.link.parameters[0].id, "parameter.ramp_time", link::ParameterEnd::Done, 900.0, {}});
        QCOMPARE(inspector.selectedText(), "Written and read back from the controller: 900 ms.");
        inspector.value()->set(1000);
        emit rig.link.parameterEnded({rig.link.parameters[1].id,
                                      "parameter.ramp_time",
                                      link::ParameterEnd::OutcomeUnknown,
                                      std::nullopt,
                                      {}});
        QVERIFY(inspector.failed());
        QVERIFY2(inspector.selectedText().contains("not confirmed"), qPrintable(inspector.selectedText()));
    }

    void theInspectorTurnsTheMasterToo()
    {
        PanelRig rig;
        rig.editor.newProgram(static_cast<int>(profile::ProgramKind::PointCam));
        rig.connectRunning();
        emit rig.link.parameterEnded(
            {rig.link.parameters[0].id, "parameter.master_direction", link::ParameterEnd::Done, 0.0, {}});
        QCOMPARE(rig.machine.direction()->way(), panel::MasterDirection::Way::Forward);
        rig.maintenance.inspector()->setNameFilter(QStringLiteral("master_direction"));
        rig.maintenance.inspector()->select(0);
        rig.maintenance.inspector()->value()->set(1);
        emit rig.link.parameterEnded(
            {rig.link.parameters[1].id, "parameter.master_direction", link::ParameterEnd::Done, 1.0, {}});
        QCOMPARE(rig.machine.direction()->way(), panel::MasterDirection::Way::Backward);
    }
};

CAMPANEL_TEST(TestRegisterInspector)

} // namespace test_register_inspector

#include "test_register_inspector.moc"
