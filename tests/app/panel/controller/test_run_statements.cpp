// SPDX-License-Identifier: Apache-2.0
// The sentences on Run against the controller's core: the simulated machine walks through its states, and no
// sentence stands longer than a second of its time after it is untrue. What is true is read from the core.
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/settings/settings.h"
#include "app/program/program_image.h"
#include "tests/support/core_link.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace test_run_statements {

using namespace campanel;
using panel::RunPlace;
using panel::RunRow;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::array places{RunPlace::Program, RunPlace::Bags,   RunPlace::Marks,     RunPlace::Film,
                            RunPlace::Stroke,  RunPlace::Trends, RunPlace::Downloaded};

struct Walk {
    QTemporaryDir ownFolder;
    QString folder; // of the panel's files, also after its restart
    test::CoreLink link;
    panel::Settings settings{folder + QStringLiteral("/settings.ini"), nullptr};
    panel::Controller machine{link, settings, nullptr};
    panel::Editor editor{machine, test::withStoredRecipe(folder), nullptr};
    std::uint32_t generation = 0;
    std::uint32_t bags = 0; // cut so far
    bool hasBags = false;   // one of the present program counts
    bool hadProgram = false;
    std::map<RunPlace, std::uint64_t> untrueUs;
    std::set<RunRow> reached;
    QString fault;

    explicit Walk(const controller::MachineOptions& options = {}, const QString& files = {})
        : folder(files.isEmpty() ? ownFolder.path() : files)
        , link(std::make_unique<test::Rig>(options))
    {
        machine.setClock([this] { return link.now(); });
        link.setFilmTimer(machine.packing()->findChild<QTimer*>());
    }

    ctl_core& core() { return link.rig().core(); }

    // Follows the records of the bags in the core.
    void countBags()
    {
        const ctl_packer& packer = core().packer;
        if (core().banks.generation != generation || packer.bags < bags)
            hasBags = false;
        generation = core().banks.generation;
        const bool isNew = packer.bags > bags;
        bags = packer.bags;
        if (!isNew)
            return;
        const unsigned flags = packer.records[CTL_BAG_REGISTERS * (bags % CTL_BAG_RECORDS) + 3];
        hasBags = hasBags || (flags & (1U << CTL_BAG_BIT_START_UP | 1U << CTL_BAG_BIT_CHANGE_OVER)) == 0;
    }

    [[nodiscard]] bool isTrue(RunRow row)
    {
        const std::uint16_t state = core().motion.state;
        const std::uint16_t marks = core().packer.marks.state;
        const bool isMoving = state == CTL_STATE_RUNNING || state == CTL_STATE_STOPPING;
        const bool isActive = core().banks.generation != 0;
        const bool canStart = state == CTL_STATE_READY && isActive;
        const bool isHeld = machine.startIsHeld();
        const bool runsEmpty = state == CTL_STATE_RUNNING && !hasBags;
        switch (row) {
        case RunRow::ProgramReading:
            return isActive || !link.isConnected();
        case RunRow::ProgramLost:
            return !isActive && hadProgram;
        case RunRow::ProgramAbsent:
            return !isActive && !hadProgram;
        case RunRow::BagsOffline:
            return !link.isConnected();
        case RunRow::BagsThreading:
            return runsEmpty && core().packer.threading;
        case RunRow::BagsSearching:
            return runsEmpty && marks == CTL_MARK_STATE_SEARCHING;
        case RunRow::BagsAligning:
            return runsEmpty && marks == CTL_MARK_STATE_ALIGNING;
        case RunRow::BagsFirst:
            return runsEmpty && marks != CTL_MARK_STATE_SEARCHING && marks != CTL_MARK_STATE_ALIGNING;
        case RunRow::BagsHoldStart:
            return !hasBags && canStart && isHeld;
        case RunRow::BagsStart:
            return !hasBags && canStart && !isHeld;
        case RunRow::BagsNone:
            return !hasBags && state != CTL_STATE_RUNNING;
        case RunRow::MarksOff:
            return marks == CTL_MARK_STATE_OFF &&
                   ctl_parameter16(&core().board, CTL_REG_PARAMETER_MARK_TRACKING) == 0;
        case RunRow::MarksNotYet:
            return marks == CTL_MARK_STATE_OFF &&
                   ctl_parameter16(&core().board, CTL_REG_PARAMETER_MARK_TRACKING) != 0;
        case RunRow::MarksSearching:
            return marks == CTL_MARK_STATE_SEARCHING && isMoving;
        case RunRow::MarksNotFound:
            return marks == CTL_MARK_STATE_SEARCHING && !isMoving;
        case RunRow::MarksAligning:
            return marks == CTL_MARK_STATE_ALIGNING && isMoving;
        case RunRow::MarksNotAligned:
            return marks == CTL_MARK_STATE_ALIGNING && !isMoving;
        case RunRow::MarksTracking:
            return marks == CTL_MARK_STATE_TRACKING;
        case RunRow::FilmChanging:
            return isMoving && (core().transfer.state == CTL_STAGED_STATE_ARMED || !hasBags);
        case RunRow::FilmWaiting:
            return isMoving && core().packer.film_gate.state != CTL_GATE_STATE_RUNNING;
        case RunRow::FilmThreading:
            return isMoving && core().packer.threading;
        case RunRow::KnifeWaiting:
            return isMoving && core().packer.knife_gate.state != CTL_GATE_STATE_RUNNING;
        case RunRow::StrokeHoldStart:
        case RunRow::TrendsHoldStart:
        case RunRow::DownloadedHoldStart:
            return canStart && isHeld;
        case RunRow::StrokeStart:
        case RunRow::TrendsStart:
        case RunRow::DownloadedStart:
            return canStart && !isHeld;
        case RunRow::DownloadedRuns:
            return state == CTL_STATE_RUNNING;
        case RunRow::StrokeNone:
        case RunRow::TrendsNone:
        case RunRow::DownloadedOnly:
            return true;
        case RunRow::Count:
            break;
        }
        return false;
    }

    // A place that the page does not show with this program says nothing.
    [[nodiscard]] bool isShown(RunPlace place)
    {
        const bool isPress = machine.active().kind == static_cast<int>(profile::ProgramKind::Press);
        switch (place) {
        case RunPlace::Program:
            return !machine.active().isPresent && machine.isConnected();
        case RunPlace::Bags:
        case RunPlace::Film:
            return machine.active().isPresent && !isPress;
        case RunPlace::Marks: // gray without a connection
            return machine.active().isPresent && !isPress && machine.isConnected();
        case RunPlace::Stroke:
            return machine.active().isPresent && isPress;
        case RunPlace::Trends:
            return true;
        case RunPlace::Downloaded:
            return editor.programDownload()->state() == panel::ProgramDownload::State::Applied;
        }
        return false;
    }

    void step()
    {
        link.step();
        QCoreApplication::sendPostedEvents();
        machine.setClock([this] { return link.now(); }); // as its timer does
        countBags();
        for (const RunPlace place : places) {
            const auto row = machine.run()->row(place);
            if (!isShown(place) || !row || isTrue(*row)) {
                untrueUs[place] = 0;
            } else {
                untrueUs[place] += test::CoreLink::stepUs;
                if (untrueUs[place] > second && fault.isEmpty())
                    fault = panel::RunSentences::text(*row);
            }
            if (isShown(place) && row && isTrue(*row))
                reached.insert(*row);
        }
    }
    void pass(double seconds)
    {
        for (std::uint64_t us = 0; us < static_cast<std::uint64_t>(seconds * second);
             us += test::CoreLink::stepUs)
            step();
    }
    bool passUntil(const std::function<bool()>& condition, double seconds)
    {
        for (std::uint64_t us = 0; us < static_cast<std::uint64_t>(seconds * second) && !condition();
             us += test::CoreLink::stepUs)
            step();
        return condition();
    }
    bool passUntilMarks(unsigned state)
    {
        return passUntil([&] { return core().packer.marks.state == state; }, 30);
    }
    void connect()
    {
        link.setConnected(true);
        pass(1);
    }
    bool download()
    {
        if (!editor.programDownload()->canDownload())
            return false;
        editor.download();
        const bool isActive = passUntil(
            [&] { return editor.programDownload()->state() == panel::ProgramDownload::State::Applied; }, 30);
        hadProgram = hadProgram || isActive;
        pass(0.3);
        return isActive;
    }
    void setParameter(const char* name, double value)
    {
        link.exchange({0, name, value});
        pass(0.5);
    }
    bool stop()
    {
        machine.stop();
        return passUntil([&] { return core().motion.state == CTL_STATE_READY; }, 30);
    }
};

} // namespace

class TestRunStatements : public QObject {
    Q_OBJECT

    std::set<RunRow> m_reached;

    void finish(const Walk& walk)
    {
        m_reached.insert(walk.reached.begin(), walk.reached.end());
        QVERIFY2(walk.fault.isEmpty(), qPrintable(walk.fault));
    }

private slots:
    void aCutterFromPowerUpToBags()
    {
        Walk walk;
        walk.connect();
        QVERIFY(walk.download());
        walk.pass(2);
        QVERIFY(walk.machine.canStart());
        walk.machine.start();
        QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
        walk.pass(3);
        // A new length while it runs, and the line lost before a bag of it counts.
        walk.editor.bagLength()->set(200);
        walk.pass(1); // reads the parameters that the price depends on
        QVERIFY(walk.download());
        const QString price = walk.machine.run()->film();
        QVERIFY2(price.startsWith(QStringLiteral("Changing to 200 mm: scrap ")), qPrintable(price));
        QVERIFY2(walk.passUntil([&] { return walk.machine.run()->scrapAhead() > 0; }, 10),
                 "the scrap of the change is told before it is cut");
        walk.link.setConnected(false);
        walk.pass(3);
        walk.connect();
        QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
        walk.pass(0.5);
        QVERIFY2(!walk.machine.run()->film().startsWith(QStringLiteral("Changing")), "the change is over");
        QCOMPARE(walk.machine.run()->scrapAhead(), 0);
        walk.pass(3);
        finish(walk);
    }

    // The first cut of the new length is drawn while the machine still makes bags of the old one; the place
    // is held against the film where the core made it.
    void theSpacingOfAChangeIsDrawnBefore_data()
    {
        QTest::addColumn<double>("bagMm");
        QTest::addColumn<double>("bagsPerMin");
        for (const double bagMm : {200.0, 240.0, 300.0})
            QTest::addRow("%g mm", bagMm) << bagMm << 60.0;
        QTest::newRow("faster") << 250.0 << 120.0;
        QTest::newRow("longer, faster") << 300.0 << 100.0;
    }
    void theSpacingOfAChangeIsDrawnBefore()
    {
        QFETCH(double, bagMm);
        QFETCH(double, bagsPerMin);
        Walk walk;
        walk.connect();
        QVERIFY(walk.download());
        walk.machine.start();
        QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
        walk.pass(3);
        walk.editor.bagLength()->set(bagMm);
        walk.editor.rate()->set(bagsPerMin);
        walk.pass(1);
        QVERIFY(!walk.editor.programDownload()->changeCuts().isEmpty());
        QVERIFY(walk.machine.run()->nextLength().isEmpty());
        walk.editor.download();
        std::vector<double> drawn; // film at the first cut of the new program
        const std::uint32_t generation = walk.core().banks.generation;
        const auto isMade = [&] {
            const QList<QPointF> cuts = walk.machine.run()->cuts();
            const auto first = std::ranges::find_if(cuts, [](const QPointF& cut) { return cut.y() >= 2; });
            if (first != cuts.end())
                drawn.push_back(walk.machine.packing()->filmPositionMm() + first->x());
            return walk.core().banks.generation != generation && walk.core().packer.last_cut.changed;
        };
        QVERIFY(walk.passUntil(isMade, 30));
        QVERIFY(!drawn.empty());
        const double madeMm =
            static_cast<double>(ctl_packer_um(&walk.core().packer, walk.core().packer.last_cut.at)) / 1000.0;
        qInfo("drawn %zu times, first %.1f mm, last %.1f mm from where it was made", drawn.size(),
              drawn.front() - madeMm, drawn.back() - madeMm);
        QVERIFY2(std::abs(drawn.back() - madeMm) < 5.0, qPrintable(QString::number(drawn.back() - madeMm)));
        finish(walk);
    }

    void stoppedInEachStateOfTheMarks()
    {
        for (const unsigned state : {CTL_MARK_STATE_SEARCHING, CTL_MARK_STATE_ALIGNING}) {
            Walk walk;
            walk.connect();
            QVERIFY(walk.download());
            walk.machine.start();
            QVERIFY(walk.passUntil([&] { return walk.core().motion.state == CTL_STATE_RUNNING; }, 30));
            QVERIFY(walk.passUntilMarks(state));
            QVERIFY(walk.stop());
            walk.pass(3);
            walk.machine.start();
            QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
            walk.pass(2);
            finish(walk);
        }
    }

    void withoutMarksAndWithoutProducts()
    {
        controller::MachineOptions options;
        options.products.missing = 0.3;
        options.products.misplaced = 0.3;
        Walk walk(options);
        walk.connect();
        QVERIFY(walk.download());
        walk.setParameter("parameter.mark_tracking", 0);
        walk.setParameter("parameter.empty_bag", 1);
        walk.setParameter("parameter.skip_limit", 50);
        walk.pass(2);
        walk.machine.start();
        QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
        walk.pass(30);
        QVERIFY(walk.stop());
        walk.pass(2);
        finish(walk);
    }

    void theFilmIsThreadedUp()
    {
        Walk walk;
        walk.connect();
        QVERIFY(walk.download());
        walk.setParameter("parameter.thread_up", 1);
        walk.machine.start();
        QVERIFY(walk.passUntil([&] { return walk.hasBags; }, 60));
        walk.pass(3);
        QVERIFY(walk.reached.contains(RunRow::BagsThreading));
        finish(walk);
    }

    void faultAndLostProgram()
    {
        Walk walk;
        walk.connect();
        QVERIFY(walk.download());
        walk.machine.start();
        walk.pass(1);
        ctl_motion_fault(&walk.core().motion, CTL_FAULT_BIT_FOLLOWING_ERROR);
        walk.pass(3);
        walk.machine.resetFault();
        walk.pass(3);
        walk.link.setConnected(false);
        walk.pass(3);
        walk.link.powerUp(std::make_unique<test::Rig>());
        walk.connect();
        walk.pass(3);
        QVERIFY(walk.reached.contains(RunRow::ProgramLost));
        QVERIFY(walk.download());
        walk.pass(2);
        finish(walk);
    }

    // The panel and the controller were both switched off.
    void aProgramLostWhileThePanelWasOff()
    {
        QTemporaryDir files;
        {
            Walk walk({}, files.path());
            walk.connect();
            QVERIFY(walk.download());
            finish(walk);
        }
        Walk walk({}, files.path());
        walk.hadProgram = true;
        walk.connect();
        walk.pass(2);
        QCOMPARE(walk.machine.run()->row(RunPlace::Program), RunRow::ProgramLost);
        finish(walk);
    }

    void whereStartIsHeld()
    {
        for (const auto kind : {profile::ProgramKind::RotaryCutter, profile::ProgramKind::Press}) {
            Walk walk;
            walk.settings.overrideValue("access.hold_to_start", QStringLiteral("on"));
            walk.editor.newProgram(static_cast<int>(kind));
            walk.connect();
            QVERIFY(walk.download());
            walk.pass(2);
            walk.settings.overrideValue("access.hold_to_start", QStringLiteral("off"));
            walk.pass(2);
            finish(walk);
        }
    }

    // The refusal of Start is a sentence, and a status comes fifty times a second.
    void aStatusThatChangesNothingForStartDoesNotAskForItsRefusal()
    {
        Walk walk;
        walk.connect();
        QVERIFY(walk.download());
        int questions = 0;
        walk.machine.setStartInterlock([&questions] {
            ++questions;
            return QString();
        });
        walk.pass(10);
        QCOMPARE(questions, 0);
        walk.machine.start();
        QVERIFY(questions > 0);
    }

    void aPressBeforeItsFirstStroke()
    {
        Walk walk;
        walk.editor.newProgram(static_cast<int>(profile::ProgramKind::Press));
        walk.connect();
        QVERIFY(walk.download());
        walk.pass(2);
        walk.machine.start();
        walk.pass(5);
        finish(walk);
    }

    // A row that no walk reaches would say what nobody has checked.
    void eachRowWasReached()
    {
        QStringList missing;
        for (int row = 0; row < static_cast<int>(RunRow::Count); ++row) {
            if (!m_reached.contains(static_cast<RunRow>(row)))
                missing << panel::RunSentences::text(static_cast<RunRow>(row));
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    }
};

CAMPANEL_TEST(TestRunStatements)

} // namespace test_run_statements

#include "test_run_statements.moc"
