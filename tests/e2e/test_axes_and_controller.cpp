// SPDX-License-Identifier: Apache-2.0
// A machine that is not as it was set, made right by finger: the film motor has other pulses and less film
// per turn, and the infeed runs backward. campanel-controller is the real one, its machine's truth in its
// options.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QTest>

#include <cmath>

namespace test_axes_and_controller {

using namespace campanel;
using panel::Controller;
using test::ControllerProcess;
using test::PanelWindow;
using Step = panel::AxisMeasurement::Step;

namespace {

constexpr int timeoutMs = 90'000;

QStringList otherMachine()
{
    return {QStringLiteral("--control"), QStringLiteral("--film-pulses"),
            QStringLiteral("10237"),     QStringLiteral("--film-feed"),
            QStringLiteral("147"),       QStringLiteral("--film-stretch"),
            QStringLiteral("0"),         QStringLiteral("--reversed"),
            QStringLiteral("4"),         QStringLiteral("--product-missing"),
            QStringLiteral("1"),         QStringLiteral("--speed"),
            QStringLiteral("3")};
}

} // namespace

class TestAxesAndController : public QObject {
    Q_OBJECT

    static panel::AxisMeasurement& measurement(PanelWindow& panel)
    {
        return *panel.maintenance().measurement();
    }
    static void openAxes(PanelWindow& panel)
    {
        for (const char* name : {"nav_settings", "section2", "openAxes"})
            panel.tap(name);
        QTRY_VERIFY_WITH_TIMEOUT(measurement(panel).fields()->value("parameter.film_feed") > 0, timeoutMs);
    }

private slots:
    void initTestCase() { shell::applyFonts(); }

    void theMachineIsMeasuredByFinger()
    {
        ControllerProcess controller(otherMachine());
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        const auto setting = [&panel](const char* name) { return measurement(panel).fields()->value(name); };

        // Without an index sensor nothing moves.
        openAxes(panel);
        panel.tap("axes3measure");
        panel.hold("axisStart");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Failed, timeoutMs);
        QVERIFY2(panel.texts().contains(QStringLiteral("This axis has no index sensor.")),
                 qPrintable(panel.texts()));
        QCOMPARE(panel.controller().state(), Controller::State::Ready);

        // An open door in the middle: no motion is left, nothing was changed.
        measurement(panel).fields()->write("signal.film_index_contact", 0);
        QTRY_COMPARE_WITH_TIMEOUT(setting("signal.film_index_contact"), 0.0, timeoutMs);
        panel.hold("axisStart");
        QTRY_VERIFY_WITH_TIMEOUT(measurement(panel).progress() > 0, timeoutMs);
        controller.tell("pin door on");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Failed, timeoutMs);
        QVERIFY2(panel.texts().contains(QStringLiteral("The door is open. Close it. Nothing was changed.")),
                 qPrintable(panel.texts()));
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(setting("parameter.film_pulses"), 10'000.0);
        controller.tell("pin door off");

        // The film's pulses, which the shape of its index mark leaves exact.
        QTest::qWait(500);
        panel.hold("axisStart");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Result, timeoutMs);
        panel.tap("axisTake");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Done, timeoutMs);
        QVERIFY2(std::abs(setting("parameter.film_pulses") - 10'237.0) <= 5.0,
                 qPrintable(QString::number(setting("parameter.film_pulses"))));
        panel.tap("axisLeave");

        // The infeed goes the other way.
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        panel.tap("axes2measure");
        panel.hold("axisStart");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Question, timeoutMs);
        panel.tap("axisWrong");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Done, timeoutMs);
        QCOMPARE(setting("signal.infeed_reversed"), 1.0);
        panel.tap("axisLeave");

        // Bags that follow their marks are as long as they are printed, whatever the feed is set to.
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(
            panel.controller().packing()->markState() == panel::PackingLine::MarkState::Tracking, timeoutMs);
        const int wanted = panel.controller().bags().counted + 10;
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().counted >= wanted, timeoutMs);
        panel.tap("stopKey");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        openAxes(panel);
        panel.tap("axes4measure");
        QTRY_VERIFY_WITH_TIMEOUT(measurement(panel).hasBag(), timeoutMs);
        panel.tap("axisEnter");
        panel.tapDigits(QString::number(panel.controller().active().bagLengthMm));
        panel.tap("keypadAccept");
        QCOMPARE(measurement(panel).step(), Step::Result);
        panel.tap("axisTake");
        QTRY_COMPARE_WITH_TIMEOUT(measurement(panel).step(), Step::Done, timeoutMs);
        QVERIFY2(std::abs(setting("parameter.film_feed") - 147.0) < 0.5,
                 qPrintable(QString::number(setting("parameter.film_feed"))));
        panel.tap("axisLeave");
        panel.tap("axesSave");
        QTRY_VERIFY_WITH_TIMEOUT(!measurement(panel).fields()->unsaved(), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void theCommandLineMeasures()
    {
        ControllerProcess controller(otherMachine());
        const auto runs = [&controller](QStringList arguments) {
            QProcess process;
            arguments << QStringLiteral("--port") << controller.port();
            process.start(test::programPath("campanelctl"), arguments);
            process.waitForFinished(timeoutMs);
            return std::pair(process.exitCode(), QString::fromUtf8(process.readAllStandardOutput() +
                                                                   process.readAllStandardError()));
        };
        const auto [downloaded, words] = runs({QStringLiteral("download")});
        QVERIFY2(downloaded == 0, qPrintable(words));
        const auto [refused, why] =
            runs({QStringLiteral("measure"), QStringLiteral("turns"), QStringLiteral("film")});
        QCOMPARE(refused, 1);
        QVERIFY2(why.contains(QStringLiteral("no index sensor")), qPrintable(why));
        QCOMPARE(
            runs({QStringLiteral("set"), QStringLiteral("signal.film_index_contact"), QStringLiteral("0")})
                .first,
            0);
        const auto [counted, said] = runs({QStringLiteral("measure"), QStringLiteral("turns"),
                                           QStringLiteral("film"), QStringLiteral("--take")});
        QVERIFY2(counted == 0 && said.contains(QStringLiteral("film: 1023")) &&
                     said.contains(QStringLiteral("setting 10000, written")),
                 qPrintable(said));
        const auto [moved, way] =
            runs({QStringLiteral("measure"), QStringLiteral("direction"), QStringLiteral("infeed")});
        QVERIFY2(moved == 0 && way.contains(QStringLiteral("set signal.infeed_reversed 1")), qPrintable(way));
        const auto [noBag, cut] = runs({QStringLiteral("measure"), QStringLiteral("film"),
                                        QStringLiteral("--length"), QStringLiteral("180")});
        QVERIFY2(noBag == 1 && cut.contains(QStringLiteral("knows no bag")), qPrintable(cut));
        QCOMPARE(runs({QStringLiteral("measure"), QStringLiteral("weight")}).first, 2);
    }

    // The index marks of this machine are ten degrees off their places.
    void theCommandLineTakesNoUnevenTurns()
    {
        ControllerProcess controller(otherMachine()
                                     << QStringLiteral("--index-scatter") << QStringLiteral("10"));
        const auto runs = [&controller](const QString& arguments) {
            QProcess process;
            process.start(test::programPath("campanelctl"),
                          arguments.split(u' ') << QStringLiteral("--port") << controller.port());
            process.waitForFinished(timeoutMs);
            return std::pair(process.exitCode(), QString::fromUtf8(process.readAllStandardOutput() +
                                                                   process.readAllStandardError()));
        };
        QCOMPARE(runs(QStringLiteral("download")).first, 0);
        QCOMPARE(runs(QStringLiteral("set signal.film_index_contact 0")).first, 0);
        const auto [taken, said] = runs(QStringLiteral("measure turns film --take"));
        QVERIFY2(taken == 1 && said.contains(QStringLiteral("too much")), qPrintable(said));
        const auto [counted, words] = runs(QStringLiteral("measure turns film"));
        QVERIFY2(counted == 0 && words.contains(QStringLiteral("setting 10000, not written")),
                 qPrintable(words));
    }
};

CAMPANEL_TEST(TestAxesAndController)

} // namespace test_axes_and_controller

#include "test_axes_and_controller.moc"
