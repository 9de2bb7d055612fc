// SPDX-License-Identifier: Apache-2.0
// The correction of the mark sensor's distance over the whole line: campanel-controller with a misplaced
// sensor, the panel's own classes, measurements of the simulated machine. Also taught marks.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/maintenance/maintenance.h"
#include "app/panel/settings/settings.h"
#include "tests/support/places.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <utility>

namespace test_mark_wizard {

using namespace campanel;
using panel::Controller;
using panel::Editor;
using panel::MarkWizard;
using panel::PackingLine;
using panel::ProgramDownload;
using Step = MarkWizard::Step;

namespace {

constexpr int timeoutMs = 30'000;
constexpr double trueDistanceMm = 903.0;

struct Panel {
    Panel()
    {
        // The simulated controller as started by the panel, with a different machine.
        QFile script(folder.filePath(QStringLiteral("controller.sh")));
        if (!script.open(QIODevice::WriteOnly))
            qFatal("no script");
        script.write("#!/bin/sh\nexec '" + campanel::test::programPath("campanel-controller").toUtf8() +
                     "' \"$@\" --mark-distance 903 --speed 5\n");
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        link::ConnectionSettings wanted;
        wanted.simulatorProgram = script.fileName();
        wanted.simulatorStateDir = folder.filePath(QStringLiteral("state"));
        QObject::connect(&link, &link::Link::rulerRead, &link, [this](const link::RulerOutcome& outcome) {
            if (rulers.isEmpty() || rulers.last().behindMarkMm != outcome.behindMarkMm)
                rulers << outcome;
            isRulerAsked = false;
        });
        link.connectTo(wanted);
    }

    void run()
    {
        QTRY_VERIFY_WITH_TIMEOUT(
            machine.isConnected() && machine.fresh() && editor.programDownload()->canDownload(), timeoutMs);
        editor.download();
        QTRY_COMPARE_WITH_TIMEOUT(editor.programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(machine.canStart(), timeoutMs);
        machine.start();
        QTRY_COMPARE_WITH_TIMEOUT(machine.packing()->markState(), PackingLine::MarkState::Tracking,
                                  timeoutMs);
    }

    // Measures this many different bags.
    [[nodiscard]] bool measured(int bags)
    {
        if (!std::exchange(isRulerAsked, true))
            link.measureSimulatedBag();
        return rulers.size() >= bags;
    }

    QTemporaryDir folder;
    link::ThreadedLink link{nullptr};
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    Controller machine{link, settings, nullptr};
    Editor editor{machine, test::withStoredRecipe(folder.path()), nullptr};
    panel::Maintenance maintenance{machine, settings, folder.path(), nullptr};
    QList<link::RulerOutcome> rulers;
    bool isRulerAsked = false;
};

} // namespace

class TestMarkWizard : public QObject {
    Q_OBJECT

private slots:
    void theSensorsDistanceIsFound()
    {
        Panel panel;
        panel.run();
        if (QTest::currentTestFailed())
            return;
        MarkWizard& wizard = *panel.maintenance.packing()->wizard();
        panel::PackingFields& fields = *panel.maintenance.packing()->fields();
        wizard.restart();
        QTRY_VERIFY2_WITH_TIMEOUT(wizard.canGoOn(), qPrintable(wizard.blockedReason()), timeoutMs);
        QCOMPARE(fields.value("parameter.mark_distance"), 900.0);
        wizard.goOn();
        QTRY_COMPARE_WITH_TIMEOUT(wizard.step(), Step::Measure, timeoutMs);
        while (wizard.measuredText().count(u'·') < MarkWizard::maxMeasured - 1) {
            const QString before = wizard.measuredText();
            QTRY_VERIFY_WITH_TIMEOUT((wizard.measureSimulatedBag(), wizard.measuredText() != before),
                                     timeoutMs);
        }
        wizard.goOn();
        qInfo("measured %s; %s -> %s", qPrintable(wizard.measuredText()), qPrintable(wizard.oldText()),
              qPrintable(wizard.newText()));
        QCOMPARE(wizard.step(), Step::Confirm);
        QVERIFY(std::abs(wizard.newDistanceMm() - trueDistanceMm) < 0.3);
        QCOMPARE(fields.value("parameter.mark_distance"), 900.0);
        wizard.goOn();
        QTRY_COMPARE_WITH_TIMEOUT(wizard.step(), Step::Done, timeoutMs);
        QVERIFY(std::abs(fields.value("parameter.mark_distance") - trueDistanceMm) < 0.3);

        panel.rulers.clear();
        constexpr int bags = 15;
        QTRY_VERIFY_WITH_TIMEOUT(panel.measured(bags), timeoutMs);
        double sum = 0;
        for (const link::RulerOutcome& ruler : panel.rulers) {
            QCOMPARE(ruler.end, link::RulerEnd::Read);
            QVERIFY(std::abs(ruler.lengthMm - 250.0) < 3.0); // stretched by 0.5 % at most
            sum += ruler.behindMarkMm;
        }
        const double offMm = sum / static_cast<double>(panel.rulers.size());
        qInfo("the cuts then lie %.3f mm behind their marks", offMm);
        QVERIFY(std::abs(offMm) < 0.15);
    }

    void marksAreTaughtWhileItRuns()
    {
        Panel panel;
        panel.run();
        if (QTest::currentTestFailed())
            return;
        panel::PackingSetup& setup = *panel.maintenance.packing();
        setup.open();
        QTRY_VERIFY_WITH_TIMEOUT(std::isfinite(setup.fields()->value("parameter.length_limit")), timeoutMs);
        setup.fields()->setChoice(0, 0);
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.packing()->markState(), PackingLine::MarkState::Off,
                                  timeoutMs);
        setup.teach();
        QVERIFY(setup.teaching());
        QTRY_VERIFY_WITH_TIMEOUT(!setup.teaching(), timeoutMs);
        QVERIFY2(setup.teachText().startsWith("The mark distance is 25"), qPrintable(setup.teachText()));
        QVERIFY2(setup.teachText().endsWith("the recipe cuts 250 mm."), qPrintable(setup.teachText()));
        const double pitchMm = panel.machine.packing()->teachPitchMm();
        QVERIFY2(pitchMm > 249.9 && pitchMm < 251.4, qPrintable(setup.teachText()));
    }
};

CAMPANEL_TEST(TestMarkWizard)

} // namespace test_mark_wizard

#include "test_mark_wizard.moc"
