// SPDX-License-Identifier: Apache-2.0
// The page of a master on a fake link: its sentences and figures, the measured delay by cuts at two speeds,
// and what its machine data cannot be.
#include "modbus/map/codec.h"
#include "modbus/map/master_status.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_master_watch {

using namespace campanel;
using modbus::MasterState;
using panel::MasterFields;
using panel::MasterWatch;

namespace {

// Texts without the marks that keep a number and its unit together.
QString plain(QString text)
{
    return text.remove(QChar(0x2060)).replace(QChar(0xA0), u' ');
}

struct MasterRig : test::PanelRig {
    std::vector<std::uint16_t> registers = std::vector<std::uint16_t>(modbus::masterStatusRegisters);
    std::map<std::string, double> parameters{{"master.source", 1}, {"master.delay", 2}};

    explicit MasterRig(std::uint16_t mapMinor = modbus::mapMinor)
    {
        connectRunning();
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.portName = QStringLiteral("/dev/fake");
        report.identity = test::FakeLink::identity();
        report.identity->mapMinor = mapMinor;
        emit link.reported(report);
        put("master_status.available", 1);
        put("master_status.state", static_cast<double>(MasterState::Engaged));
    }

    [[nodiscard]] MasterWatch& master() { return *maintenance.master(); }
    void put(const char* name, double value)
    {
        modbus::RegisterWriter writer(registers, modbus::masterStatusAddress);
        if (!writer.physical(name, value))
            qFatal("%s does not fit", name);
    }
    void answerParameters()
    {
        for (const link::ParameterRequest& request : std::exchange(link.parameters, {})) {
            if (request.value)
                parameters[request.name] = *request.value;
            const double value = parameters.contains(request.name)
                                     ? parameters[request.name]
                                     : modbus::findRegister(request.name)->defaultValue;
            emit link.parameterEnded({request.id, request.name, link::ParameterEnd::Done, value, {}});
        }
    }
    // Answers the next reading.
    void tell()
    {
        const auto asked = [this] {
            return std::ranges::count_if(link.reads, [](const link::ReadRequest& read) {
                return read.address == modbus::masterStatusAddress;
            });
        };
        master().setWatched(true);
        answerParameters();
        QTRY_VERIFY(asked() > m_told);
        m_told = asked();
        const auto last =
            std::ranges::find_if(link.reads.rbegin(), link.reads.rend(), [](const link::ReadRequest& read) {
                return read.address == modbus::masterStatusAddress;
            });
        emit link.registersRead({*last, link::ReadEnd::Done, registers, now, {}});
    }
    // Cuts a bag at this speed with a lag of 0.5 ms.
    void cut(double speed)
    {
        modbus::StatusBlock status = *machine.status();
        ++status.bagCount;
        emit link.statusReceived({{{now, status}}, 0});
        put("master_status.speed", speed);
        put("master_status.lag", 0.01 + 0.0005 * speed);
        tell();
    }
    [[nodiscard]] QString valueOf(const QString& name)
    {
        for (const panel::MasterRow& row : master().rows()->rows()) {
            if (row.name == name)
                return plain(row.value);
        }
        return {};
    }
    [[nodiscard]] QModelIndex rowOf(const QString& name)
    {
        MasterFields& fields = *master().fields();
        for (int row = 0; row < fields.rowCount(); ++row) {
            if (fields.data(fields.index(row), MasterFields::NameRole) == name)
                return fields.index(row);
        }
        return {};
    }

private:
    std::ptrdiff_t m_told = 0;
};

} // namespace

class TestMasterWatch : public QObject {
    Q_OBJECT

private slots:
    void showsFigures();
    void saysWhatTheLineDoes();
    void isEmptyWithoutAnInput();
    void canBeSetBackWithoutAnInput();
    void isWatchedWhileOneOfItsPagesIsOpen();
    void offersTheDelayOfTwoSpeeds();
    void refusesWhatCannotBe();
};

void TestMasterWatch::showsFigures()
{
    MasterRig rig;
    rig.put("master_status.counts", -12345);
    rig.put("master_status.speed", 250.4);
    rig.put("master_status.lag", -0.043);
    rig.put("master_status.passed", 1.5);
    rig.tell();
    QCOMPARE(rig.valueOf(QStringLiteral("Counts since power-up")), QStringLiteral("−12,345"));
    QCOMPARE(rig.valueOf(QStringLiteral("Speed")), QStringLiteral("250.4 mm/s"));
    QCOMPARE(rig.valueOf(QStringLiteral("Lag at the last cut")), QStringLiteral("−0.043 mm"));
    QVERIFY(rig.valueOf(QStringLiteral("Film passed uncut")).isEmpty()); // nothing passes a shaft
    rig.parameters["master.place"] = 1;
    rig.master().fields()->read();
    rig.tell();
    QCOMPARE(rig.valueOf(QStringLiteral("Film passed uncut")), QStringLiteral("1.50 m"));
}

void TestMasterWatch::saysWhatTheLineDoes()
{
    MasterRig rig;
    rig.tell();
    QCOMPARE(rig.master().stateText(), QStringLiteral("Engaged"));
    rig.put("master_status.state", static_cast<double>(MasterState::Engaging));
    rig.put("master_status.to_engaged", 120);
    rig.tell();
    QCOMPARE(plain(rig.master().stateText()), QStringLiteral("Engaging: 120 mm of film until engaged"));
    rig.put("master_status.state", static_cast<double>(MasterState::Off));
    rig.tell();
    QCOMPARE(rig.master().stateText(), QStringLiteral("Not engaged"));
    rig.put("master_status.state", 9); // of a later controller
    rig.tell();
    QCOMPARE(rig.master().stateText(), QStringLiteral("--"));
    rig.parameters["master.source"] = 0;
    rig.master().fields()->read();
    rig.tell();
    QVERIFY(rig.master().stateText().contains(QStringLiteral("clock")));
}

void TestMasterWatch::isEmptyWithoutAnInput()
{
    MasterRig old(modbus::masterMapMinor - 1);
    old.master().setWatched(true);
    QVERIFY(old.master().emptyText().contains(QStringLiteral("1.6")));
    QVERIFY(std::ranges::none_of(old.link.reads, [](const link::ReadRequest& read) {
        return read.address == modbus::masterStatusAddress;
    }));
    MasterRig bare;
    bare.put("master_status.available", 0);
    bare.parameters["master.source"] = 0;
    bare.tell();
    QVERIFY(bare.master().emptyText().contains(QStringLiteral("no input")));
    QCOMPARE(bare.master().rows()->rows().size(), 0);
    bare.master().fields()->write("master.source", 1);
    QVERIFY(bare.master().fields()->failed());
}

// An encoder that was set by another controller's data: a person can set the clock here.
void TestMasterWatch::canBeSetBackWithoutAnInput()
{
    MasterRig rig;
    rig.put("master_status.available", 0);
    rig.tell();
    QVERIFY(rig.master().emptyText().isEmpty());
    QVERIFY2(rig.master().stateText().endsWith(
                 QStringLiteral("Set the clock as the master, or use another controller.")),
             qPrintable(rig.master().stateText()));
    rig.master().fields()->write("master.source", 0);
    rig.tell();
    QVERIFY(!rig.master().leads());
    QVERIFY(rig.master().emptyText().contains(QStringLiteral("no input")));
}

void TestMasterWatch::isWatchedWhileOneOfItsPagesIsOpen()
{
    MasterRig rig;
    QObject maintenance;
    QObject settings;
    rig.master().setWatchedBy(&maintenance, true);
    rig.master().setWatchedBy(&settings, true); // the other page goes later
    rig.master().setWatchedBy(&maintenance, false);
    QVERIFY(rig.master().watched());
    rig.master().setWatchedBy(&maintenance, false);
    QVERIFY(rig.master().watched());
    rig.master().setWatchedBy(&settings, false);
    QVERIFY(!rig.master().watched());
}

void TestMasterWatch::offersTheDelayOfTwoSpeeds()
{
    MasterRig rig;
    rig.tell(); // the bag before has an unknown lag
    const auto suggestion = [&rig] {
        return plain(rig.master()
                         .fields()
                         ->data(rig.rowOf(QStringLiteral("Delay of the drive")), MasterFields::SuggestionRole)
                         .toString());
    };
    for (int bag = 0; bag < program::MasterDelay::minCuts; ++bag)
        rig.cut(200);
    QVERIFY(rig.master().delayText().contains(QStringLiteral("10 cuts")));
    QVERIFY(rig.master().delayText().contains(QStringLiteral("a fifth faster")));
    QVERIFY(suggestion().isEmpty());
    rig.tell(); // without another bag
    QVERIFY(rig.master().delayText().contains(QStringLiteral("10 cuts")));
    for (int bag = 0; bag < program::MasterDelay::minCuts; ++bag)
        rig.cut(260);
    QVERIFY(plain(rig.master().delayText()).contains(QStringLiteral("0.500 ms")));
    QVERIFY2(suggestion().startsWith(QStringLiteral("2.5")), qPrintable(suggestion()));
    rig.parameters["master.delay"] = 2.5; // another delay is another measurement
    rig.master().fields()->read();
    rig.tell();
    QVERIFY(rig.master().delayText().contains(QStringLiteral("0 cuts")));
}

void TestMasterWatch::refusesWhatCannotBe()
{
    MasterRig rig;
    rig.parameters["master.counts"] = 100;
    rig.tell();
    rig.master().fields()->write("master.index_limit", 50);
    QVERIFY(rig.master().fields()->failed());
    QVERIFY(rig.master().fields()->outcomeText().contains(QStringLiteral("half a revolution")));
    QVERIFY(std::ranges::none_of(rig.link.parameters, [](const link::ParameterRequest& request) {
        return request.value.has_value();
    }));
    rig.parameters["master.smoothing"] = 5;
    rig.parameters["master.counts"] = 10000;
    rig.master().fields()->read();
    rig.tell();
    const QString note =
        plain(rig.master()
                  .fields()
                  ->data(rig.rowOf(QStringLiteral("Smoothing: time constant")), MasterFields::NoteRole)
                  .toString());
    QVERIFY2(note.contains(QStringLiteral("0.025 mm")), qPrintable(note)); // 1000 x 0.005^2
    QVERIFY2(note.contains(QStringLiteral("5.0 mm/s")), qPrintable(note)); // 250 / 10000 / 0.005
}

CAMPANEL_TEST(TestMasterWatch)

} // namespace test_master_watch

#include "test_master_watch.moc"
