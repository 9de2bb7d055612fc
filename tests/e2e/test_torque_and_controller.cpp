// SPDX-License-Identifier: Apache-2.0
// The torque that campanel-controller's drive reports beside the predicted one: every kind of motion, each
// reading against what a servo of second order does, and the largest difference against the limit that
// follows.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/explain/explanations.h"
#include "app/program/solved_program.h"
#include "base/ctl_port.h"
#include "engine/ctl_cam.h"
#include "panel_window.h"
#include "profile/cam/point_cam.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace test_torque_and_controller {

using namespace campanel;
using panel::Controller;
using panel::ProgramDownload;
using panel::TorqueWatch;
using profile::Field;
using profile::ProgramKind;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;
constexpr double inertiaKgCm2 = 20;
constexpr double frictionNm = 0.25;
constexpr double ratedNm = 2.4;
// The bandwidth of the simulated drive.
constexpr double servoRadPerS = 2 * std::numbers::pi * 80;

// Starts the controller with a drive like the machine data.
QStringList drive()
{
    return {"--drive-inertia",      QString::number(inertiaKgCm2 * 1e-4),
            "--drive-friction",     QString::number(frictionNm),
            "--drive-rated-torque", QString::number(ratedNm)};
}

program::Recipe recipeOf(ProgramKind kind)
{
    program::Recipe recipe = program::defaultRecipe(kind);
    profile::Machine& machine = recipe.machine;
    machine.inertiaKgCm2 = inertiaKgCm2;
    machine.frictionNm = frictionNm;
    machine.ratedTorqueNm = ratedNm;
    machine.maxTorqueNm = 0;
    if (recipe.isCutter()) {
        recipe.cutter().bagLengthMm = 150;
        recipe.cutter().rateBagsPerMin = 120;
        machine.pulsesPerMotorRev = 40'000;
        return recipe;
    }
    machine.pulsesPerMotorRev = 20'000;
    machine.maxMotorRpm = 600;
    if (auto* move = std::get_if<profile::PositionMoveProgram>(&recipe.program)) {
        move->distanceMm = 4000;
        move->timeS = 8;
    } else if (auto* change = std::get_if<profile::SpeedMoveProgram>(&recipe.program)) {
        change->endSpeedMmPerS = 900;
        change->timeS = 5;
    } else if (auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program)) {
        cam->masterRateRevPerMin = 60;
    }
    return recipe;
}

// The torque that the drive reports over one cycle. A critically damped servo passes its command
// through 1 / (1 + s / w)^2. A command that steps by one pulse moves its speed by up to w / e pulses: below
// that, friction may have either sign.
class ServoModel {
public:
    ServoModel(const profile::MotionProfile& motion, const profile::TorqueLoad& load, double pulsesPerMm,
               bool isRepeated)
        : m_isRepeated(isRepeated)
        , m_cycleS(motion.durationS())
    {
        const double pulseMmPerS = servoRadPerS / std::numbers::e / pulsesPerMm;
        constexpr int cycles = 2; // the first one settles
        const double h = m_cycleS / steps;
        const profile::MotionPoint start = isRepeated ? motion.at(0) : profile::MotionPoint{};
        double a1 = start.accelerationMmPerS2;
        double a2 = a1;
        double v1 = start.velocityMmPerS;
        double v2 = v1;
        const double share = 1 - std::exp(-servoRadPerS * h);
        for (int i = 0; i < (isRepeated ? cycles : 1) * steps; ++i) {
            const profile::MotionPoint p = motion.at((i % steps + 0.5) * h);
            a1 += share * (p.accelerationMmPerS2 - a1);
            a2 += share * (a1 - a2);
            v1 += share * (p.velocityMmPerS - v1);
            v2 += share * (v1 - v2);
            if (i >= (isRepeated ? (cycles - 1) * steps : 0)) {
                const double predicted = load.at(p.velocityMmPerS, p.accelerationMmPerS2);
                const double percent = 100 * load.at(v2, a2) / ratedNm;
                const double reversed = 100 * load.at(-v2, a2) / ratedNm;
                const bool isNearRest = std::abs(v2) <= pulseMmPerS;
                m_low.push_back(isNearRest ? std::min(percent, reversed) : percent);
                m_high.push_back(isNearRest ? std::max(percent, reversed) : percent);
                m_largest = std::max(m_largest, std::abs(percent - 100 * predicted / ratedNm));
            }
        }
    }

    [[nodiscard]] double largestDifference() const { return m_largest; }
    // Returns the range of the reported torque at an angle of the master, while the command is `fromS` to
    // `toS` behind the master.
    [[nodiscard]] std::pair<double, double> at(double angleDeg, double fromS, double toS) const
    {
        const auto place = [&](double lateS) {
            return static_cast<int>(std::floor((angleDeg / 360 - lateS / m_cycleS) * steps));
        };
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (int i = place(toS); i <= place(fromS); ++i) {
            const auto step =
                static_cast<std::size_t>(m_isRepeated ? (i + steps) % steps : std::clamp(i, 0, steps - 1));
            low = std::min(low, m_low[step]);
            high = std::max(high, m_high[step]);
        }
        return {low, high};
    }

private:
    static constexpr int steps = 40'000;
    bool m_isRepeated;
    double m_cycleS;
    std::vector<double> m_low;
    std::vector<double> m_high;
    double m_largest = 0;
};

} // namespace

class TestTorqueAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void measuredIsWhatTheServoDoes_data();
    void measuredIsWhatTheServoDoes();
    void torqueIsReadWhileRunIsShown();
};

void TestTorqueAndController::measuredIsWhatTheServoDoes_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("readings");
    QTest::newRow("knife") << static_cast<int>(ProgramKind::RotaryCutter) << 40;
    QTest::newRow("position move") << static_cast<int>(ProgramKind::PositionMove) << 20;
    QTest::newRow("speed move") << static_cast<int>(ProgramKind::SpeedMove) << 25;
    QTest::newRow("point cam") << static_cast<int>(ProgramKind::PointCam) << 40;
}

void TestTorqueAndController::measuredIsWhatTheServoDoes()
{
    QFETCH(int, kind);
    QFETCH(int, readings);
    const ControllerProcess controller(drive());
    PanelWindow window(controller.port());
    Controller& machine = window.controller();
    panel::Editor& editor = window.editor();
    const program::Recipe recipe = recipeOf(static_cast<ProgramKind>(kind));
    editor.open(recipe);
    QVERIFY2(editor.feasible(), qPrintable(editor.verdict()));
    QTRY_VERIFY_WITH_TIMEOUT(editor.programDownload()->canDownload(), timeoutMs);
    editor.download();
    QTRY_COMPARE_WITH_TIMEOUT(editor.programDownload()->state(), ProgramDownload::State::Applied, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(machine.canStart() && machine.active().isPresent, timeoutMs);
    TorqueWatch& torque = *machine.torque();
    QVERIFY(torque.watched()); // Run is the first page
    QCOMPARE(torque.missingText(), QString());
    machine.start();
    QTRY_VERIFY2_WITH_TIMEOUT(torque.readings().size() >= readings, qPrintable(torque.text()), 60'000);

    const auto solved = program::solveProgram(recipe);
    QVERIFY(solved.has_value());
    const bool isRepeated = recipe.isCutter() || recipe.kind() == ProgramKind::PointCam;
    const auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program);
    const ServoModel servo(cam ? profile::forwardMotion(*cam) : solved->motion, solved->load,
                           solved->pulsesPerMm, isRepeated);
    // The command comes in whole pulses: a step of one is an acceleration of w^2 pulses, until the axis
    // follows.
    const double radPerPulse = 2 * std::numbers::pi / recipe.machine.pulsesPerMotorRev;
    const double pulsePercent =
        100 * servoRadPerS * servoRadPerS * radPerPulse * inertiaKgCm2 * 1e-4 / ratedNm;
    // Torque and angle are up to two slices apart. With cam points the axis moves on straight lines, each one
    // update long and one update late: its speed is that of the cam half an update to one and a half ago.
    const double apartS = 2e-6 * CTL_SLICE_US;
    const double updateS = recipe.isCutter() ? 0 : 1e-6 * CTL_CAM_UPDATE_US;
    double worst = 0;
    for (const TorqueWatch::Reading& each : torque.readings()) {
        auto [low, high] = servo.at(each.angleDeg, 0.5 * updateS - apartS, 1.5 * updateS + apartS);
        if (each.angleDeg >= 359.99) // a speed that is held
            low = std::min(low, 100 * frictionNm / ratedNm);
        const double off = std::max({low - each.measuredPercent, each.measuredPercent - high, 0.0});
        worst = std::max(worst, off);
        QVERIFY2(off <= pulsePercent + 0.1,
                 qPrintable(QStringLiteral("%1 deg: %2 %, not %3 to %4 % (%5 % a pulse)")
                                .arg(each.angleDeg)
                                .arg(each.measuredPercent)
                                .arg(low)
                                .arg(high)
                                .arg(pulsePercent)));
    }
    const double limit = servo.largestDifference() + pulsePercent + 0.1;
    qInfo("largest difference of %d readings: %.2f %% of the rated torque; the servo makes up to %.2f %%, a "
          "pulse "
          "%.2f %%; off the servo's model by up to %.2f %%",
          static_cast<int>(torque.readings().size()), torque.differencePercent(), servo.largestDifference(),
          pulsePercent, worst);
    QVERIFY(torque.differencePercent() > 0);
    QVERIFY2(torque.differencePercent() <= limit, qPrintable(QString::number(torque.differencePercent())));
    // On Run of a packing machine the words stand behind the knife's card.
    if (window.touchDriver().find(QStringLiteral("knifeCard")))
        window.tap("knifeCard");
    QVERIFY2(window.texts().contains(torque.text()) || window.texts().contains(torque.shortText()),
             qPrintable(window.texts()));
    const panel::Explanation told = window.panel().explanations().of(panel::Explanations::Torque);
    QVERIFY(told.value != panel::Format::unknownText() && !told.numbers.isEmpty());
}

void TestTorqueAndController::torqueIsReadWhileRunIsShown()
{
    const ControllerProcess controller;
    PanelWindow window(controller.port());
    TorqueWatch& torque = *window.controller().torque();
    QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), Controller::State::Idle, timeoutMs);
    QVERIFY(!torque.watched()); // there is no program
    window.editor().open(recipeOf(ProgramKind::RotaryCutter));
    QTRY_VERIFY_WITH_TIMEOUT(window.editor().programDownload()->canDownload(), timeoutMs);
    window.editor().download();
    QTRY_VERIFY_WITH_TIMEOUT(std::isfinite(torque.measuredPercent()), timeoutMs);
    QVERIFY(torque.watched());
    window.tap("nav_motion");
    QVERIFY(!torque.watched());
    QVERIFY(std::isnan(torque.measuredPercent()));
    window.tap("nav_run");
    QTRY_VERIFY_WITH_TIMEOUT(std::isfinite(torque.measuredPercent()), timeoutMs);
    // Machine data without a rated torque predict nothing.
    window.editor().item(Field::RatedTorque)->set(0);
    QCOMPARE(torque.missingText(), QStringLiteral("The rated torque is missing in Settings, Machine."));
    QVERIFY(std::isnan(torque.predictedPercent()));
    window.editor().item(Field::KnifeRadius)->set(70);
    window.editor().item(Field::RatedTorque)->set(ratedNm);
    QCOMPARE(torque.missingText(), QStringLiteral("The program was made for other machine data."));
    QCOMPARE(window.complaints(), QStringList());
}

CAMPANEL_TEST(TestTorqueAndController)

} // namespace test_torque_and_controller

#include "test_torque_and_controller.moc"
