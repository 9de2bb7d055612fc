// SPDX-License-Identifier: Apache-2.0
// The page of the jams on a fake link: the band and the readings by angle, its sentences, when it reads, and
// what its machine data cannot be.
#include "packer_image.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_jam_watch {

using namespace campanel;
using modbus::JamSource;
using modbus::JamState;
using panel::Controller;
using panel::JamWatch;
using panel::PackingFields;

namespace {

// Texts without the marks that keep a number and its unit together.
QString plain(QString text)
{
    return text.remove(QChar(0x2060)).replace(QChar(0xA0), u' ');
}

struct JamRig : test::PanelRig {
    std::vector<std::uint16_t> registers = std::vector<std::uint16_t>(modbus::jamRegisters);
    std::uint16_t minor = modbus::mapMinor;

    explicit JamRig(std::uint16_t mapMinor = modbus::mapMinor)
        : minor(mapMinor)
    {
        connectRunning();
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.portName = QStringLiteral("/dev/fake");
        report.identity = test::FakeLink::identity();
        report.identity->mapMinor = minor;
        emit link.reported(report);
        std::vector<std::uint16_t> packer = test::PackerImage().registers();
        packer.resize(modbus::packerRegisters(minor));
        emit link.registersRead({{0, modbus::packerAddress, modbus::packerRegisters(minor)},
                                 link::ReadEnd::Done,
                                 packer,
                                 now,
                                 {}});
    }

    [[nodiscard]] JamWatch& jam() { return *maintenance.packing()->jam(); }
    [[nodiscard]] PackingFields& fields() { return *maintenance.packing()->fields(); }
    [[nodiscard]] qsizetype readsOf(std::uint16_t address) const
    {
        return std::ranges::count_if(
            link.reads, [address](const link::ReadRequest& read) { return read.address == address; });
    }
    void put(const char* name, int value, std::size_t at = 0)
    {
        registers[modbus::registerNamed(name).address - modbus::jamAddress + at] =
            static_cast<std::uint16_t>(value);
    }
    // Answers the last request of this group.
    void answer(std::uint16_t address, const std::vector<std::uint16_t>& with)
    {
        const auto asked = std::ranges::find_if(
            link.reads.rbegin(), link.reads.rend(),
            [address](const link::ReadRequest& read) { return read.address == address; });
        if (asked == link.reads.rend())
            qFatal("nothing was asked for");
        emit link.registersRead({*asked, link::ReadEnd::Done, with, now, {}});
    }
    void tell()
    {
        if (!jam().watched())
            jam().setWatched(true);
        else
            QTRY_VERIFY(readsOf(modbus::jamAddress) > m_told);
        answer(modbus::jamAddress, registers);
        m_told = readsOf(modbus::jamAddress);
    }
    // Reports a torque in 0.1 % at an angle of the cycle in 0.01 degrees.
    void tellTorque(int torque, int angle)
    {
        const qsizetype before = jam().readings().size();
        std::vector<std::uint16_t> io{0x000B, 0, 0, static_cast<std::uint16_t>(torque),
                                      0,      0, 0, static_cast<std::uint16_t>(angle)};
        io.resize(modbus::ioRegisters(minor));
        QTRY_VERIFY_WITH_TIMEOUT(
            (answer(modbus::ioAddress, io),
             jam().readings().size() > before || machine.state() != Controller::State::Running),
            5000);
    }
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
    void openFields()
    {
        maintenance.packing()->open();
        answerParameters();
    }
    // Returns the sentence of a refused entry; empty for one that was sent.
    QString entered(const char* name, double value)
    {
        link.parameters.clear();
        fields().write(name, value);
        const bool isSent = !link.parameters.isEmpty();
        answerParameters();
        return isSent ? QString() : plain(fields().outcomeText());
    }

private:
    qsizetype m_told = 0;
};

} // namespace

class TestJamWatch : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void readsWhileItIsWatched()
    {
        JamRig rig;
        QTest::qWait(700); // twice the period
        QCOMPARE(rig.readsOf(modbus::jamAddress), 0);
        rig.jam().setWatched(true);
        QCOMPARE(rig.readsOf(modbus::jamAddress), 1);
        QTest::qWait(700);
        QCOMPARE(rig.readsOf(modbus::jamAddress), 1); // one at a time
        rig.answer(modbus::jamAddress, rig.registers);
        QTRY_COMPARE(rig.readsOf(modbus::jamAddress), 2);
        rig.jam().setWatched(false);
        rig.answer(modbus::jamAddress, rig.registers);
        QTest::qWait(700);
        QCOMPARE(rig.readsOf(modbus::jamAddress), 2);
    }

    void anOldControllerHasOneSentence()
    {
        JamRig rig(5);
        rig.jam().setWatched(true);
        QCOMPARE(rig.readsOf(modbus::jamAddress), 0);
        QVERIFY2(
            rig.jam().emptyText().startsWith("This controller does not monitor the torque of its knife."),
            qPrintable(rig.jam().emptyText()));
        JamRig newer;
        QCOMPARE(newer.jam().emptyText(), QString());
        test::PanelRig offline;
        QVERIFY(offline.maintenance.packing()->jam()->emptyText().startsWith("No packing machine data."));
    }

    void eachStateHasASentence_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<QString>("begin");
        QTest::addColumn<bool>("blind");
        const auto row = [](const char* name, int state, const char* begin, bool isBlind) {
            QTest::newRow(name) << state << QString::fromLatin1(begin) << isBlind;
        };
        row("off", int(JamState::Off), "Off. Switch jam detection on", false);
        row("silent drive", int(JamState::NotReported),
            "The drive reports no torque: a jam cannot be seen. Connect its torque-limit output", true);
        row("slow drive", int(JamState::TooSlow),
            "The drive reports its torque too seldom: a jam cannot be seen. Connect its torque-limit output",
            true);
        row("learning", int(JamState::Learning),
            "Learning the torque of this program. Cycles at full speed until armed: 13", false);
        row("armed", int(JamState::Armed), "Armed. ", false);
        row("later version", 77, "The controller reports a state that this panel does not know.", false);
    }

    void eachStateHasASentence()
    {
        QFETCH(const int, state);
        QFETCH(const QString, begin);
        QFETCH(const bool, blind);
        JamRig rig;
        rig.put("jam.state", state);
        rig.put("jam.cycles_left", 13);
        QCOMPARE(rig.jam().stateText(), QStringLiteral("--"));
        rig.tell();
        QVERIFY2(rig.jam().stateText().startsWith(begin), qPrintable(rig.jam().stateText()));
        QCOMPARE(rig.jam().blind(), blind);
    }

    void theLastJamIsToldInWords()
    {
        JamRig rig;
        rig.tell();
        QCOMPARE(rig.jam().lastText(), QStringLiteral("No jam since power-up."));
        QCOMPARE(rig.jam().intervalText(), QStringLiteral("--"));
        QVERIFY(std::isnan(rig.jam().jam().x()));
        rig.put("jam.interval", 125);
        rig.put("jam.number", 3);
        rig.put("jam.source", int(JamSource::Torque));
        rig.put("jam.angle", -1230);
        rig.put("jam.torque", 875);
        rig.put("jam.limit", 412);
        rig.put("jam.run_on", 560);
        rig.tell();
        QCOMPARE(
            plain(rig.jam().lastText()),
            QStringLiteral("Torque 87.5 %, 12.3° before the cut; the band ends at 41.2 %. The knife stood "
                           "after another 5.6°."));
        QCOMPARE(rig.jam().countText(), QStringLiteral("3"));
        QCOMPARE(plain(rig.jam().intervalText()), QStringLiteral("1.25 ms"));
        QCOMPARE(rig.jam().jam(), QPointF(-12.3, 87.5));
        rig.put("jam.source", int(JamSource::TorqueLimit));
        rig.put("jam.angle", 150);
        rig.tell();
        QCOMPARE(plain(rig.jam().lastText()),
                 QStringLiteral("Torque-limit input on 1.5° behind the cut. The knife stood after another "
                                "5.6°."));
        QVERIFY(std::isnan(rig.jam().jam().x())); // its torque says nothing
    }

    void theResidueIsRecordedOnly()
    {
        JamRig rig;
        rig.put("jam.residue", 25);
        rig.tell();
        QVERIFY(rig.jam().residueText().startsWith("Not known before"));
        rig.put("jam.residue_number", 1, 1);
        rig.tell();
        QVERIFY2(plain(rig.jam().residueText()).startsWith("+0.25 %: mean torque at the cut"),
                 qPrintable(plain(rig.jam().residueText())));
        QVERIFY(rig.jam().residueText().contains("nothing is concluded"));
    }

    // A record is told once, and not that of the time before the panel.
    void eachNewResidueIsRecorded()
    {
        JamRig rig;
        rig.put("jam.residue_number", 7, 1);
        rig.put("jam.residue", 10);
        QList<double> recorded;
        QObject::connect(&rig.jam(), &JamWatch::residueRecorded, &rig.jam(),
                         [&recorded](double percent) { recorded << percent; });
        rig.tell();
        rig.tell();
        QVERIFY(recorded.isEmpty());
        rig.put("jam.residue_number", 8, 1);
        rig.put("jam.residue", -15);
        rig.tell();
        rig.tell();
        QCOMPARE(recorded, QList<double>{-0.15});
    }

    void theBandIsItsLearnedParts()
    {
        JamRig rig;
        rig.tell();
        QVERIFY(rig.jam().expected().isEmpty());
        QCOMPARE(rig.jam().toDeg(), 45.0);
        rig.put("jam.band_from", -3200);
        rig.put("jam.band_to", 3200);
        rig.put("jam.expected", 105, 4);
        rig.put("jam.width", 21, 4);
        rig.tell();
        QCOMPARE(rig.jam().fromDeg(), -32.0);
        QCOMPARE(rig.jam().toDeg(), 32.0);
        QCOMPARE(rig.jam().expected(), QList<QPointF>{QPointF(-23, 10.5)});
        QCOMPARE(rig.jam().halfWidths(), QList<double>{2.1});
        rig.link.activate(rig.image(), rig.now); // another program has another torque
        QVERIFY(rig.jam().expected().isEmpty());
    }

    // The middle of the sync window is the cut: a reading there is at 0, half a cycle later at half a turn.
    void aReadingIsAtItsAngleFromTheCut()
    {
        JamRig rig;
        rig.tell();
        const auto header = rig.machine.program()->registers;
        const double cutDeg = modbus::RegisterReader(header, 0).physical("bank.cut_angle");
        rig.tellTorque(317, static_cast<int>(std::lround(cutDeg * 100)));
        QCOMPARE(rig.jam().readings().size(), 1);
        QVERIFY2(std::abs(rig.jam().readings()[0].x()) < 0.1,
                 qPrintable(QString::number(rig.jam().readings()[0].x())));
        QCOMPARE(rig.jam().readings()[0].y(), 31.7);
        rig.tellTorque(100, static_cast<int>(std::lround((cutDeg > 180 ? cutDeg - 10 : cutDeg + 10) * 100)));
        const double knifeDeg = rig.jam().readings().last().x();
        QVERIFY2(std::abs(knifeDeg) > 2 && std::abs(knifeDeg) < 60 && (knifeDeg < 0) == (cutDeg > 180),
                 qPrintable(QString::number(knifeDeg)));
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        rig.tellTorque(100, 0);
        QCOMPARE(rig.jam().readings().size(), 2); // of a running machine only
        rig.jam().setWatched(false);
        QVERIFY(rig.jam().readings().isEmpty());
    }

    void aBackAngleOpensTheJaws()
    {
        JamRig rig;
        rig.openFields();
        QCOMPARE(rig.entered("parameter.jaws_before", 40), QString()); // no detection: the default may stay
        QCOMPARE(rig.entered("parameter.jam_back", 40),
                 QStringLiteral("The jaws would stay closed after a jam: they close 40° before the cut. The "
                                "knife must go back by more than that."));
        QVERIFY(!rig.entered("parameter.jam_detection", 1).isEmpty());
        QCOMPARE(rig.entered("parameter.jam_back", 40.5), QString());
        QCOMPARE(rig.entered("parameter.jam_detection", 1), QString());
        QVERIFY(!rig.entered("parameter.jaws_before", 41).isEmpty());
        QCOMPARE(rig.entered("parameter.jaws_before", 39), QString());
        QCOMPARE(rig.entered("parameter.jam_detection", 0), QString());
    }

    // The knife stops from its speed at the cut, that of the film, with the acceleration of its machine data.
    void aStopTimeIsNotBelowTheKnifesOwn()
    {
        JamRig rig;
        rig.openFields();
        rig.editor.field(QStringLiteral("max_knife_acceleration_mm_per_s2"))->set(7'000);
        QTRY_VERIFY(rig.machine.torque()->machineData());
        QTRY_COMPARE(rig.machine.torque()->machineData()->maxKnifeAccelerationMmPerS2, 7'000.0);
        const program::Recipe& recipe = rig.machine.program()->recipe;
        const auto solved = program::solveProgram(recipe);
        const double leastMs = 1000 * solved->cutter->cycle.filmSpeedMmPerS /
                               rig.editor.recipe().machine.maxKnifeAccelerationMmPerS2;
        QVERIFY(leastMs > 5 && leastMs < 1000);
        const QString refused = rig.entered("parameter.jam_stop_time", std::floor(leastMs));
        QVERIFY2(
            refused.startsWith(QStringLiteral("Too short for the knife: with its maximum acceleration it "
                                              "needs %1 ms")
                                   .arg(std::ceil(leastMs))),
            qPrintable(refused));
        QCOMPARE(rig.entered("parameter.jam_stop_time", std::ceil(leastMs)), QString());
    }
};

CAMPANEL_TEST(TestJamWatch)

} // namespace test_jam_watch

#include "test_jam_watch.moc"
