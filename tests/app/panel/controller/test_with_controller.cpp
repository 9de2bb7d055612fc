// SPDX-License-Identifier: Apache-2.0
// Machine and Editor on the real link and the real controller program: download, start, change during the
// run, save.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/settings/settings.h"
#include "tests/support/places.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace test_with_controller {

using namespace campanel;
using panel::Controller;
using panel::Editor;
using panel::ProgramDownload;

namespace {

constexpr int timeoutMs = 15000;

struct Panel {
    explicit Panel(const QTemporaryDir& folder)
        : settings(folder.filePath("settings.ini"), nullptr)
        , machine(link, settings, nullptr)
        , editor(machine, test::withStoredRecipe(folder.path()), nullptr)
    {
        settings.overrideSimulator(campanel::test::programPath("campanel-controller"),
                                   folder.filePath("flash"));
        machine.open();
    }

    link::ThreadedLink link{nullptr};
    panel::Settings settings;
    Controller machine;
    Editor editor;
};

} // namespace

class TestWithController : public QObject {
    Q_OBJECT

private slots:
    void theMainJob()
    {
        QTemporaryDir folder;
        Panel panel(folder);
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Ready,
                                  timeoutMs);
        QCOMPARE(panel.machine.state(), Controller::State::Idle);
        panel.editor.download();
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.active().isPresent, timeoutMs);
        QCOMPARE(panel.editor.programDownload()->state(), ProgramDownload::State::Applied);
        QCOMPARE(panel.machine.active().name, "Biscuit 250");
        QCOMPARE(panel.editor.programDownload()->differenceCount(), 0);

        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.canStart(), timeoutMs);
        panel.machine.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Running, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.live().rateBagsPerMin, 60.0, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.bags().series.size() >= 3, timeoutMs);
        const panel::PackingLine& line = *panel.machine.packing();
        QTRY_COMPARE_WITH_TIMEOUT(line.markState(), panel::PackingLine::MarkState::Tracking, timeoutMs);
        QVERIFY(line.fresh());
        QCOMPARE(line.sensorMm(), 900.0);
        QVERIFY(line.cuts().size() > 3);
        QTRY_VERIFY_WITH_TIMEOUT(line.seenMarks().size() >= 3, timeoutMs);
        QVERIFY(line.nextMarkMm() > line.sensorMm());
        QVERIFY(std::abs(line.filmSpeedMmPerS() - 250) < 5);
        QVERIFY(panel.machine.actualTrace().size() > 40);
        for (const QPointF& point : panel.machine.actualTrace())
            QVERIFY(point.y() > -50 && point.y() < 600);

        panel.editor.bagLength()->set(300);
        QCOMPARE(panel.editor.programDownload()->state(), ProgramDownload::State::Ready);
        const double generation = panel.machine.generation();
        panel.editor.download();
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.active().bagLengthMm, 300.0, timeoutMs);
        QCOMPARE(panel.machine.generation(), generation + 1);
        QCOMPARE(panel.machine.active().version, 2.0);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(panel.machine.bags().meanMm - 300) < 1, timeoutMs);

        QVERIFY(!panel.editor.programDownload()->isSaved());
        panel.editor.saveToFlash();
        QTRY_VERIFY_WITH_TIMEOUT(panel.editor.programDownload()->isSaved(), timeoutMs);
        panel.machine.stop();
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
        QVERIFY2(panel.machine.commandMessage().isEmpty(), qPrintable(panel.machine.commandMessage()));
        QVERIFY2(panel.machine.alarmText().isEmpty(), qPrintable(panel.machine.alarmText()));
    }

    void aRestartFindsRecipeAndSavedProgram()
    {
        QTemporaryDir folder;
        {
            Panel panel(folder);
            panel.editor.bagLength()->set(280);
            QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Ready,
                                      timeoutMs);
            panel.editor.download();
            QTRY_VERIFY_WITH_TIMEOUT(
                panel.editor.programDownload()->canSave() && panel.machine.active().isPresent, timeoutMs);
            panel.editor.saveToFlash();
            QTRY_VERIFY_WITH_TIMEOUT(panel.editor.programDownload()->isSaved(), timeoutMs);
        }
        Panel panel(folder);
        QCOMPARE(panel.editor.bagLength()->value(), 280.0);
        QCOMPARE(panel.editor.recipeVersion(), 2);
        QVERIFY(!panel.editor.edited());
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(),
                                  ProgramDownload::State::NothingToDo, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.active().bagLengthMm, 280.0, timeoutMs);
        QVERIFY(panel.editor.programDownload()->isSaved());
    }
};

CAMPANEL_TEST(TestWithController)

} // namespace test_with_controller

#include "test_with_controller.moc"
