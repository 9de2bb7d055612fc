// SPDX-License-Identifier: Apache-2.0
// A value outside its approved window: asked about before the download, in the audit trail, and shown until
// the machine runs within the window again.
#include "app/panel/recipe/recipe_comparison.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_window_reason {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using panel::Level;
using panel::WindowReason;
using profile::Field;
using State = panel::ProgramDownload::State;

namespace {

// A machine that runs 60 bags/min, approved 55 to 70.
struct WindowRig : PanelRig {
    panel::ProgramDownload& download = *editor.programDownload();
    WindowReason& reasons = *download.windowReason();
    QList<store::AuditEntry> trail;

    WindowRig()
    {
        QObject::connect(&reasons, &WindowReason::noted, &reasons,
                         [this](const store::AuditEntry& entry) { trail << entry; });
        machine.accessCheck().setLevel(Level::Operator, u"Ana"_s);
        setWindow(55, 70);
        connectRunning();
    }
    void setWindow(double min, double max)
    {
        program::Recipe recipe = editor.storedRecipe();
        recipe.windows[Field::Rate] = {min, max};
        editor.open(recipe);
    }
    // The controller runs what was sent.
    void finish()
    {
        const program::ProgramImage sent = image();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Active;
        report.crc = sent.crc;
        link.activate(sent, now);
        emit link.downloadReported(report);
    }
};

} // namespace

class TestWindowReason : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::C); }

    void withinTheWindowNobodyIsAsked()
    {
        WindowRig rig;
        rig.editor.rate()->set(70);
        QCOMPARE(rig.download.state(), State::Ready);
        QCOMPARE(rig.reasons.question(), QString());
        rig.editor.download();
        QCOMPARE(rig.link.banks.size(), 1);
        rig.finish();
        QCOMPARE(rig.reasons.line(), QString());
        QVERIFY(rig.trail.isEmpty());
    }

    void outsideItAReasonIsGivenKeptAndShown()
    {
        WindowRig rig;
        rig.editor.rate()->set(80);
        QCOMPARE(rig.download.state(), State::Unapproved);
        QCOMPARE(rig.download.text(),
                 u"Outside the approved window: Rate 80.0 bags/min, approved 55.0 to 70.0 bags/min. "
                 "Give a reason, or enter an approved value."_s);
        rig.editor.download();
        QVERIFY(rig.link.banks.isEmpty());

        rig.reasons.give(u"  Late \n order "_s);
        QCOMPARE(rig.download.state(), State::Ready);
        QVERIFY2(rig.trail.isEmpty(), "nothing was sent yet");
        rig.editor.download();
        QCOMPARE(rig.link.banks.size(), 1);
        QCOMPARE(rig.trail.size(), 1);
        QCOMPARE(rig.trail.first().what, u"recipe.outside"_s);
        QCOMPARE(rig.trail.first().object, u"Biscuit 250"_s);
        QCOMPARE(rig.trail.first().before, u"rate_bags_per_min 55.0..70.0"_s);
        QCOMPARE(rig.trail.first().after, u"rate_bags_per_min 80.0: Late order"_s);
        QCOMPARE(rig.reasons.line(), QString()); // the machine still runs the program before
        rig.finish();
        const QString line = rig.reasons.line();
        QVERIFY2(line.startsWith(u"Rate 80.0 bags/min, approved 55.0 to 70.0 bags/min: by Ana since "_s) &&
                     line.endsWith(u", Late order"_s),
                 qPrintable(line));
        QVERIFY(!rig.reasons.isUnexplained());

        // A panel that was restarted shows it too; another value needs another reason.
        const WindowReason later(rig.machine, rig.folder.path(), nullptr);
        QCOMPARE(later.line(), line);
        rig.editor.rate()->set(81);
        QCOMPARE(rig.download.state(), State::Unapproved);
        rig.editor.rate()->set(65);
        QCOMPARE(rig.download.state(), State::Ready);
        rig.editor.download();
        rig.finish();
        QCOMPARE(rig.reasons.line(), QString());
        QCOMPARE(rig.trail.size(), 1);
    }

    void aDownloadThatFailsKeepsTheReasonOfWhatRuns()
    {
        WindowRig rig;
        rig.editor.rate()->set(80);
        rig.reasons.give(u"Late order"_s);
        rig.editor.download();
        rig.finish();
        const QString line = rig.reasons.line();
        rig.editor.rate()->set(90);
        rig.reasons.give(u"Later still"_s);
        rig.editor.download();
        link::DownloadReport report;
        report.stage = link::DownloadStage::Failed;
        emit rig.link.downloadReported(report);
        QCOMPARE(rig.reasons.line(), line);
        QVERIFY(rig.download.canDownload()); // the same reason for the same values
    }

    // A technician widens or narrows the window of what runs.
    void theWindowOfWhatRunsIsMoved()
    {
        WindowRig rig;
        rig.editor.rate()->set(80);
        rig.reasons.give(u"Late order"_s);
        rig.editor.download();
        rig.finish();
        QVERIFY(!rig.reasons.line().isEmpty());
        rig.setWindow(55, 80);
        QCOMPARE(rig.reasons.line(), QString());
        rig.setWindow(55, 75);
        QCOMPARE(rig.reasons.line(),
                 u"Rate 80.0 bags/min, approved 55.0 to 75.0 bags/min: no reason given."_s);
        QVERIFY(rig.reasons.isUnexplained());
        rig.reasons.give(u"Approved by phone"_s);
        QVERIFY(rig.reasons.line().endsWith(u"Approved by phone"_s));
        QCOMPARE(rig.trail.size(), 2);
    }

    void badReasonsChangeNothing()
    {
        WindowRig rig;
        rig.editor.rate()->set(80);
        for (const QString& text :
             {QString(), u" \n\t "_s, QString(5000, u'x'), u"hid\u200bden"_s, QString(QChar(0))}) {
            QVERIFY(!rig.reasons.problem(text).isEmpty());
            rig.reasons.give(text);
            QCOMPARE(rig.download.state(), State::Unapproved);
        }
        QCOMPARE(rig.reasons.problem(QString(120, u'x')), QString());
        rig.machine.accessCheck().setLevel(Level::Viewer);
        rig.reasons.give(u"Late order"_s);
        QCOMPARE(rig.download.state(), State::Unapproved);
    }

    void aDamagedFileHasNoReason()
    {
        WindowRig rig;
        rig.editor.rate()->set(80);
        rig.reasons.give(u"Late order"_s);
        rig.editor.download();
        rig.finish();
        for (const QByteArray& bytes : {QByteArray("[[1],{\"crc\":\"x\"},3"), QByteArray("[1,{},[]]")}) {
            QFile file(rig.folder.filePath(u"window_reasons.json"_s));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
            file.close();
            const WindowReason later(rig.machine, rig.folder.path(), nullptr);
            QCOMPARE(later.line(), QString());
        }
    }

    // The limits of the machine come first: no reason lets it go beyond them.
    void theMachineRefusesWhatItCannotDo()
    {
        WindowRig rig;
        rig.setWindow(55, 1000);
        rig.editor.rate()->set(390);
        QVERIFY(!rig.editor.feasible());
        QCOMPARE(rig.download.state(), State::Blocked);
        rig.reasons.give(u"Late order"_s);
        rig.editor.download();
        QVERIFY(rig.link.banks.isEmpty());
    }

    void windowsAreCompared()
    {
        program::Recipe before;
        program::Recipe after = before;
        after.windows[Field::Rate] = {55, 70};
        const auto rows = panel::RecipeComparison::rows(before, after);
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows.first().name, u"Approved: Rate"_s);
        QCOMPARE(rows.first().activeText, u"none"_s);
        QCOMPARE(rows.first().editedText, u"55.0 to 70.0 bags/min"_s);
    }
};

CAMPANEL_TEST(TestWindowReason)

} // namespace test_window_reason

#include "test_window_reason.moc"
