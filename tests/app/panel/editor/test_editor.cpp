// SPDX-License-Identifier: Apache-2.0
// The editor: pairs of inputs, undo, suggestions, dragged ratios, differences and the download.
#include "profile/cutter/limits.h"
#include "profile/laws/laws.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_editor {

using namespace campanel;
using panel::Editor;
using panel::EditorField;
using panel::ProgramDownload;
using test::PanelRig;

namespace {

// The four numbers of a cycle, as shown.
std::array<double, 4> cycleOf(Editor& editor)
{
    return {editor.bagLength()->value(), editor.rate()->value(), editor.baseSpeed()->value(),
            editor.filmSpeed()->value()};
}

EditorField* fieldAt(Editor& editor, int index)
{
    return std::array{editor.bagLength(), editor.rate(), editor.baseSpeed(),
                      editor.filmSpeed()}[static_cast<std::size_t>(index)];
}

std::shared_ptr<const profile::Curves> curvesOf(const QVariant& variant)
{
    return variant.value<std::shared_ptr<const profile::Curves>>();
}

} // namespace

class TestEditor : public QObject {
    Q_OBJECT

private slots:
    void beginsWithTheRecipeOfThePaper()
    {
        PanelRig rig;
        QVERIFY(rig.editor.solvable());
        QVERIFY(rig.editor.feasible());
        QVERIFY(!rig.editor.edited());
        QCOMPARE(rig.editor.bagLength()->text(), "250.0");
        QCOMPARE(rig.editor.k1()->text(), "4.00");
        QCOMPARE(rig.editor.k3()->text(), "1.6667");
        QVERIFY(std::abs(rig.editor.baseSpeed()->value() - 445.371) < 0.05);
        QVERIFY(rig.editor.baseSpeed()->derived());
        QVERIFY(rig.editor.bagLength()->pinned());
        QCOMPARE(rig.editor.severity(), Editor::Severity::Good);
        const auto fastest = profile::fastestRate(rig.image().cutter());
        QVERIFY(fastest);
        QVERIFY2(rig.editor.verdict().contains(QString::number(fastest->rateBagsPerMin, 'f', 1)),
                 qPrintable(rig.editor.verdict()));
        QVERIFY(curvesOf(rig.editor.plot().curves)->timeS.size() >= 1000);
    }

    // All six pairs: the two derived values, entered as inputs, result in the first two again.
    void everyPairLeadsToTheSameCycle_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        const std::array names{"L", "rate", "v_a", "v_b"};
        for (int first = 0; first < 4; ++first) {
            for (int second = first + 1; second < 4; ++second)
                QTest::addRow("%s and %s", names[static_cast<std::size_t>(first)],
                              names[static_cast<std::size_t>(second)])
                    << first << second;
        }
    }

    void everyPairLeadsToTheSameCycle()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        PanelRig rig;
        const auto before = cycleOf(rig.editor);
        for (const int index : {first, second}) {
            if (fieldAt(rig.editor, index)->derived())
                fieldAt(rig.editor, index)->togglePin();
        }
        // Pinning another one may have unpinned the first.
        for (const int index : {first, second}) {
            if (fieldAt(rig.editor, index)->derived())
                fieldAt(rig.editor, index)->togglePin();
        }
        QVERIFY(fieldAt(rig.editor, first)->pinned());
        QVERIFY(fieldAt(rig.editor, second)->pinned());
        const auto after = cycleOf(rig.editor);
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY2(std::abs(after[i] - before[i]) < 1e-2,
                     qPrintable(QString::number(after[i] - before[i])));
    }

    void releasesTheInputThatWasEditedLongestAgo()
    {
        PanelRig rig;
        rig.editor.rate()->set(70);
        rig.editor.bagLength()->set(260);
        rig.editor.baseSpeed()->set(500); // unpins the rate
        QVERIFY(rig.editor.baseSpeed()->pinned());
        QVERIFY(rig.editor.bagLength()->pinned());
        QVERIFY(rig.editor.rate()->derived());
        QCOMPARE(rig.editor.bagLength()->value(), 260.0);
        rig.editor.filmSpeed()->set(300); // unpins the bag length
        QVERIFY(rig.editor.filmSpeed()->pinned());
        QVERIFY(rig.editor.baseSpeed()->pinned());
    }

    void releasingAPinChangesNoNumber()
    {
        PanelRig rig;
        const auto before = cycleOf(rig.editor);
        rig.editor.bagLength()->togglePin();
        QVERIFY(rig.editor.bagLength()->derived());
        QVERIFY(rig.editor.filmSpeed()->pinned());
        const auto after = cycleOf(rig.editor);
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY(std::abs(after[i] - before[i]) < 1e-2);
    }

    void refusesEntriesOutsideTheirLimits()
    {
        PanelRig rig;
        QVERIFY(rig.editor.bagLength()->check(250).isEmpty());
        QVERIFY(rig.editor.bagLength()->check(9).contains("10 mm"));
        QVERIFY(rig.editor.bagLength()->check(2001).contains("2000 mm"));
        QVERIFY(!rig.editor.bagLength()->check(NAN).isEmpty());
        rig.editor.bagLength()->set(9);
        QCOMPARE(rig.editor.bagLength()->value(), 250.0);
        QVERIFY(!rig.editor.canUndo());
        // A ratio only between its neighbors.
        QVERIFY(!rig.editor.k2()->check(4.0).isEmpty());
        QVERIFY(!rig.editor.k2()->check(1.6667).isEmpty());
        QVERIFY(rig.editor.k2()->check(3.9).isEmpty());
    }

    void undoAndRedoWalkThroughEveryEdit()
    {
        PanelRig rig;
        const QList<double> lengths{250, 260, 270, 280};
        for (const double length : lengths.mid(1))
            rig.editor.bagLength()->set(length);
        rig.editor.setLaw("quintic");
        rig.editor.undo();
        QCOMPARE(rig.editor.lawName(), "Cubic");
        for (qsizetype i = lengths.size() - 2; i >= 0; --i) {
            rig.editor.undo();
            QCOMPARE(rig.editor.bagLength()->value(), lengths[i]);
        }
        QVERIFY(!rig.editor.canUndo());
        QVERIFY(!rig.editor.edited());
        for (const double length : lengths.mid(1)) {
            rig.editor.redo();
            QCOMPARE(rig.editor.bagLength()->value(), length);
        }
        rig.editor.redo();
        QCOMPARE(rig.editor.lawName(), "Quintic 3-4-5");
        QVERIFY(!rig.editor.canRedo());
        rig.editor.undo();
        rig.editor.rate()->set(50);
        QVERIFY(!rig.editor.canRedo());
    }

    void revertIsOneStepThatCanBeUndone()
    {
        PanelRig rig;
        rig.editor.bagLength()->set(300);
        rig.editor.rate()->set(80);
        QVERIFY(rig.editor.edited());
        rig.editor.revert();
        QVERIFY(!rig.editor.edited());
        QCOMPARE(rig.editor.bagLength()->value(), 250.0);
        rig.editor.undo();
        QCOMPARE(rig.editor.bagLength()->value(), 300.0);
        QCOMPARE(rig.editor.rate()->value(), 80.0);
    }

    void dragKeepsTheOrderAndIsOneUndoStep_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("time");
        QTest::newRow("within") << 0 << 0.2;
        QTest::newRow("past its right neighbor") << 0 << 0.9;
        QTest::newRow("past its left neighbor") << 2 << 0.1;
        QTest::newRow("before the cycle") << 0 << -5.0;
        QTest::newRow("after the cycle") << 3 << 5.0;
        QTest::newRow("nowhere") << 1 << std::numeric_limits<double>::quiet_NaN();
    }

    void dragKeepsTheOrderAndIsOneUndoStep()
    {
        QFETCH(int, index);
        QFETCH(double, time);
        PanelRig rig;
        const auto before = rig.editor.plot().ratioTimes;
        for (int step = 1; step <= 20; ++step)
            rig.editor.dragRatio(index, before[index] + (time - before[index]) * step / 20);
        const auto times = rig.editor.plot().ratioTimes;
        double last = 0;
        for (const double end : times) {
            QVERIFY(end > last);
            last = end;
        }
        QVERIFY(last < rig.editor.plot().cycleSeconds);
        rig.editor.commitDrag();
        QVERIFY(rig.editor.canUndo());
        rig.editor.undo();
        QVERIFY(!rig.editor.canUndo());
        QCOMPARE(rig.editor.plot().ratioTimes, before);
    }

    void aDragWithoutMovementLeavesNothingToUndo()
    {
        PanelRig rig;
        rig.editor.dragRatio(0, rig.editor.plot().ratioTimes.first());
        rig.editor.commitDrag();
        QVERIFY(!rig.editor.canUndo());
    }

    void namesTheBrokenLimitAndOffersWhatWorks_data()
    {
        QTest::addColumn<double>("bagLength");
        QTest::addColumn<double>("rate");
        QTest::addColumn<QString>("word");
        QTest::addColumn<bool>("solvable");
        QTest::newRow("too fast") << 100.0 << 390.0 << "acceleration" << true;
        QTest::newRow("film faster than the stroke") << 1500.0 << 60.0 << "stroke" << false;
    }

    void namesTheBrokenLimitAndOffersWhatWorks()
    {
        QFETCH(double, bagLength);
        QFETCH(double, rate);
        QFETCH(QString, word);
        QFETCH(bool, solvable);
        PanelRig rig;
        rig.editor.bagLength()->set(bagLength);
        rig.editor.rate()->set(rate);
        QVERIFY(!rig.editor.feasible());
        QCOMPARE(rig.editor.solvable(), solvable);
        QCOMPARE(rig.editor.severity(), Editor::Severity::Bad);
        QVERIFY2(rig.editor.verdict().contains(word), qPrintable(rig.editor.verdict()));
        QCOMPARE(rig.editor.plot().curves.isValid(), solvable);
        QCOMPARE(!rig.editor.plot().violations.isEmpty(), solvable);
        QCOMPARE(std::isnan(rig.editor.baseSpeed()->value()), !solvable);
        QVERIFY(!rig.editor.suggestionText().isEmpty());
        rig.editor.applySuggestion();
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        rig.editor.undo();
        QVERIFY(!rig.editor.feasible());
    }

    void suggestionsOfRandomRecipesWork()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        PanelRig rig;
        int offered = 0;
        for (int i = 0; i < 200; ++i) {
            rig.editor.bagLength()->set(10 + random.bounded(1990.0));
            rig.editor.rate()->set(1 + random.bounded(599.0));
            rig.editor.setLaw(i % 2 ? "quintic" : "cubic");
            if (rig.editor.suggestionText().isEmpty())
                continue;
            ++offered;
            rig.editor.applySuggestion();
            QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
        }
        QVERIFY(offered > 50);
    }

    // Torque and vibration have a column where the machine's data are known.
    void lawsHaveTheColumnsOfTheMachine()
    {
        PanelRig rig;
        QCOMPARE(rig.editor.laws()->count(), 0); // nothing is solved while the list is closed
        rig.editor.watchLaws(true);
        // The gentlest law is first, so the law is found by its name.
        const auto& row = [&rig] {
            int index = 0;
            while (rig.editor.laws()->row(index).lawId != "cubic")
                ++index;
            return rig.editor.laws()->row(index);
        };
        QCOMPARE(rig.editor.lawColumns().size(), 5);
        QCOMPARE(rig.editor.lawColumns()[2], "RMS"); // the column of the torque has it where it is known
        QCOMPARE(rig.editor.lawColumns().last(), "Frequency");
        QVERIFY(row().vibrationText.isEmpty());
        QVERIFY(!rig.editor.plot().hasTorque);
        QCOMPARE(rig.editor.item(profile::Field::Inertia)->text(), "--");
        rig.editor.bagLength()->set(150);
        rig.editor.rate()->set(200);
        rig.editor.item(profile::Field::Inertia)->set(10);
        rig.editor.item(profile::Field::Friction)->set(0.1);
        rig.editor.item(profile::Field::MaxTorque)->set(2);
        rig.editor.item(profile::Field::NaturalFrequency)->set(25);
        QCOMPARE(rig.editor.lawColumns().mid(3), QStringList({"Torque,\nRMS", "Error while\nsealing"}));
        QCOMPARE(row().peakFrequencyText, "0.747 Nm\nRMS 0.277");
        QCOMPARE(row().vibrationText, "1.720 mm");
        QVERIFY2(rig.editor.peakText().contains("0.747 Nm (RMS 0.277)"), qPrintable(rig.editor.peakText()));
        QVERIFY(rig.editor.plot().hasTorque);
        QCOMPARE(rig.editor.plot().limitTorque, 2.0);
        QVERIFY(std::abs(rig.editor.plot().rmsTorque - 0.2773) < 1e-4);
    }

    void listsWhatEachLawWouldDemand()
    {
        PanelRig rig;
        rig.editor.watchLaws(true);
        panel::LawModel* laws = rig.editor.laws();
        QCOMPARE(laws->count(), static_cast<int>(profile::laws().size()));
        const auto isCurrent = [](const panel::LawRow& row) { return row.current; };
        QCOMPARE(std::ranges::count_if(laws->rows(), isCurrent), 1);
        const panel::LawRow first = *std::ranges::find_if(laws->rows(), isCurrent);
        QCOMPARE(first.lawId, "cubic");
        QCOMPARE(first.peakRpmText, "71 r/min");
        QCOMPARE(first.peakAccelerationText, "1.95 m/s²");
        QCOMPARE(first.peakFrequencyText, "11.8 kHz");
        QVERIFY(rig.editor.peakText().contains("71 r/min · 1.95 m/s² · 11.8 kHz"));
        for (int row = 0; row < laws->count(); ++row) {
            QVERIFY(!laws->row(row).name.isEmpty());
            const profile::Law& law = *profile::findLaw(laws->row(row).lawId.toStdString());
            QCOMPARE(laws->row(row).strength, QString::fromUtf8(law.strength));
            QCOMPARE(laws->row(row).weakness, QString::fromUtf8(law.weakness));
        }
        QVERIFY(!rig.editor.lawParameter1()->visible());
        rig.editor.setLaw("s_curve");
        QVERIFY(rig.editor.lawParameter1()->visible());
        QVERIFY(rig.editor.lawParameter2()->visible());
        QCOMPARE(rig.editor.lawParameter1()->value(), 0.25);
        rig.editor.lawParameter1()->set(0.4);
        QCOMPARE(rig.editor.lawParameter1()->value(), 0.4);
        rig.editor.setLaw("no such law");
        QCOMPARE(rig.editor.lawName(), "Seven-segment S");
    }

    void tableAddsUpToTheCycle()
    {
        PanelRig rig;
        panel::TableModel* table = rig.editor.table();
        QVERIFY(table->count() > 100);
        qint64 pulses = 0;
        qint64 ticks = 0;
        for (int row = 0; row < table->count(); ++row) {
            const QStringList cells =
                table->data(table->index(row), panel::TableModel::CellsRole).toStringList();
            QCOMPARE(cells.size(), table->columns().size());
            pulses += cells[4].toInt();
            ticks += cells[5].toInt();
        }
        QCOMPARE(pulses, 10000);
        QCOMPARE(ticks, 8000000);
        QVERIFY(rig.editor.table()->summary().first().contains("10000 pulses"));
    }

    void downloadTakesTheRecipeIntoTheControllerAndCountsItsVersion()
    {
        PanelRig rig;
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Blocked);
        QVERIFY(!rig.editor.programDownload()->canDownload());
        rig.connectRunning();
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::NothingToDo);
        rig.editor.bagLength()->set(260);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 1);
        QCOMPARE(rig.editor.programDownload()->differences()->rows().first().activeText, "250.0 mm");
        QCOMPARE(rig.editor.programDownload()->differences()->rows().first().editedText, "260.0 mm");
        QVERIFY(rig.editor.programDownload()->controllerText().contains("1 value differs"));
        QCOMPARE(rig.editor.bagLength()->activeText(), "250.0");

        rig.editor.download();
        QCOMPARE(rig.link.banks.size(), 1);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Transferring);
        QVERIFY(!rig.editor.programDownload()->canDownload());
        link::DownloadReport report;
        report.stage = link::DownloadStage::Sealing;
        report.fraction = 0.9;
        emit rig.link.downloadReported(report);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Sealing);
        QCOMPARE(rig.editor.programDownload()->progress(), 0.9);
        report.stage = link::DownloadStage::Armed;
        emit rig.link.downloadReported(report);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Armed);

        const auto image = rig.image();
        QCOMPARE(rig.link.banks.first(), image.registers);
        ++rig.link.status.generation;
        rig.link.status.activeCrc = image.crc;
        rig.link.sendStatus(rig.now);
        report.stage = link::DownloadStage::Active;
        report.crc = image.crc;
        emit rig.link.downloadReported(report);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Applied);
        QVERIFY(!rig.editor.edited());
        QCOMPARE(rig.editor.recipeVersion(), 2);
        QCOMPARE(rig.editor.recipeName(), "Biscuit 250");
        rig.editor.bagLength()->set(261);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
    }

    // An empty controller would take the machine data of the image.
    void withoutTheDataOfThisMachineNothingIsDownloaded()
    {
        PanelRig rig;
        rig.connectIdle();
        rig.editor.bagLength()->set(260);
        QVERIFY(rig.editor.programDownload()->canDownload());
        rig.editor.programDownload()->noteDataLost();
        QVERIFY(!rig.editor.programDownload()->canDownload());
        QVERIFY2(rig.editor.programDownload()->text().contains("disk with the data"),
                 qPrintable(rig.editor.programDownload()->text()));
        rig.editor.download();
        QVERIFY(rig.link.banks.empty());
    }

    void failedDownloadSaysWhyAndCanBeRepeated()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.editor.bagLength()->set(260);
        rig.editor.download();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Failed;
        report.error = modbus::DownloadError{};
        report.error->kind = modbus::DownloadErrorKind::ChecksumDiffers;
        emit rig.link.downloadReported(report);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Failed);
        QVERIFY(rig.editor.programDownload()->text().contains("unchanged"));
        QVERIFY(rig.editor.programDownload()->canDownload());
        QCOMPARE(rig.editor.recipeVersion(), 1);
        QVERIFY(rig.editor.edited());
    }

    void machineDataChangeOnlyAtStandstill()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.editor.item(profile::Field::KnifeRadius)->set(61);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Blocked);
        QVERIFY(rig.editor.programDownload()->text().contains("standstill"));
        rig.link.status.state = modbus::State::Ready;
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
    }

    void infeasibleRecipesAreNotSent()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.editor.rate()->set(600);
        QVERIFY(!rig.editor.feasible());
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Blocked);
        rig.editor.download();
        QVERIFY(rig.link.banks.isEmpty());
    }

    void savesTheActiveProgramOnly()
    {
        PanelRig rig;
        rig.connectIdle();
        QVERIFY(!rig.editor.programDownload()->canSave());
        rig.link.activate(rig.image(), rig.now);
        QVERIFY(rig.editor.programDownload()->canSave());
        QVERIFY(!rig.editor.programDownload()->isSaved());
        rig.editor.saveToFlash();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::SaveToFlash);
        QCOMPARE(rig.link.requests.last().arguments.argument2, *rig.link.status.activeCrc);
        rig.link.status.savedCrc = rig.link.status.activeCrc;
        rig.link.sendStatus(rig.now);
        QVERIFY(rig.editor.programDownload()->isSaved());
        QVERIFY(!rig.editor.programDownload()->canSave());
    }

    void theRecipeSurvivesARestart()
    {
        QTemporaryDir folder;
        test::FakeLink link;
        panel::Settings settings(folder.filePath("settings.ini"), nullptr);
        panel::Controller machine(link, settings, nullptr);
        {
            Editor editor(machine, folder.path(), nullptr);
            editor.bagLength()->set(333);
            editor.setRecipeName("Cookies");
            editor.setLaw("quintic");
        }
        Editor editor(machine, folder.path(), nullptr);
        QCOMPARE(editor.bagLength()->value(), 333.0);
        QCOMPARE(editor.recipeName(), "Cookies");
        QCOMPARE(editor.lawName(), "Quintic 3-4-5");
        QVERIFY(editor.edited());
        QVERIFY(editor.notice().isEmpty());
        editor.revert();
        QCOMPARE(editor.bagLength()->value(), 250.0);
    }

    void explainsDerivedNumbersOnly()
    {
        PanelRig rig;
        QVERIFY(rig.editor.baseSpeed()->explanation().startsWith("v_a = "));
        QVERIFY(rig.editor.baseSpeed()->explanation().contains("445.37"));
        QVERIFY(rig.editor.bagLength()->explanation().isEmpty());
    }
};

CAMPANEL_TEST(TestEditor)

} // namespace test_editor

#include "test_editor.moc"
