// SPDX-License-Identifier: Apache-2.0
// CSV files of knots and segments in the panel: preview, refusal, import as one edit, export to a place.
#include "profile/segments/segments_csv.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

namespace test_cam_files {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using panel::CamFiles;
using panel::OfferRow;

namespace {

constexpr int timeoutMs = 15'000;

// A stick and the panel's own folder, with contents set by the test.
struct Disks {
    QTemporaryDir stick;
    bool isStickReadOnly = false;

    void plugInto(PanelRig& rig) const
    {
        const store::Place place{stick.path(), u"STICK"_s, isStickReadOnly};
        rig.editor.camFiles()->setScanner([place](const QString& own, const profile::Program& cam) {
            QList<store::Place> places{place};
            for (const store::Place& each : store::exchangePlaces(own)) {
                if (each.path == own)
                    places << each;
            }
            return CamFiles::Found{places, store::offeredLists(places, cam)};
        });
    }
    void put(const QString& name, const QByteArray& bytes) const
    {
        QFile file(stick.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
};

const std::vector<profile::Knot>& knotsOf(const profile::Program& program)
{
    return std::get<profile::PointCamProgram>(program).knots;
}

const std::vector<profile::CamSegment>& segmentsOf(const panel::Editor& editor)
{
    return std::get<profile::SegmentCamProgram>(editor.recipe().program).segments;
}

} // namespace

class TestCamFiles : public QObject {
    Q_OBJECT

    static void scan(PanelRig& rig)
    {
        rig.editor.camFiles()->scan();
        QVERIFY(rig.editor.camFiles()->busy());
        QTRY_VERIFY_WITH_TIMEOUT(!rig.editor.camFiles()->busy(), timeoutMs);
    }
    static void write(PanelRig& rig, int place)
    {
        rig.editor.camFiles()->write(place);
        QTRY_VERIFY_WITH_TIMEOUT(!rig.editor.camFiles()->busy(), timeoutMs);
    }

private slots:
    void aFileIsLookedAtThenTakenAsOneEdit()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        const auto before = camOf(rig.editor).knots;
        const Disks disks;
        disks.plugInto(rig);
        disks.put(u"cam.csv"_s, "master_deg;slave_mm\n0;0\n60;3,5\n120;9\n200;8\n300;-1,25\n360;0\n");
        scan(rig);
        const QList<OfferRow>& files = rig.editor.camFiles()->files()->rows();
        QCOMPARE(files.size(), 1);
        QCOMPARE(files[0].title, u"cam.csv"_s);
        QVERIFY(files[0].usable);
        QVERIFY2(files[0].note.startsWith(u"6 knots"_s) && files[0].note.endsWith(u"STICK"_s),
                 qPrintable(files[0].note));
        QVERIFY2(files[0].detail.contains(u"position −1.25 to 9 mm"_s), qPrintable(files[0].detail));
        QVERIFY(camOf(rig.editor).knots == before); // a search imports nothing
        rig.editor.camFiles()->take(0);
        QCOMPARE(rig.editor.knots()->count(), 6);
        QVERIFY(camOf(rig.editor).knots[1] == (profile::Knot{60, 3.5}));
        rig.editor.undo();
        QVERIFY(camOf(rig.editor).knots == before);
        rig.editor.redo();
        QCOMPARE(rig.editor.knots()->count(), 6);
    }

    void whatIsWrongIsSaidAndNotTaken_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("order") << QByteArray("master_deg,slave_mm\n0,0\n90,1\n80,2\n270,1\n360,0\n")
                               << u"Line 4: Knot 3 at 80"_s;
        QTest::newRow("too few") << QByteArray("master_deg,slave_mm\n0,0\n360,1\n") << u"2 knots"_s;
        QTest::newRow("a word") << QByteArray("master_deg,slave_mm\n0,0\n90,one\n")
                                << u"line 3: expected a number, found \"one\""_s;
        QTest::newRow("empty") << QByteArray() << u"line 1: expected the header"_s;
    }
    void whatIsWrongIsSaidAndNotTaken()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        const auto before = camOf(rig.editor).knots;
        const Disks disks;
        disks.plugInto(rig);
        disks.put(u"cam.csv"_s, text);
        scan(rig);
        const OfferRow row = rig.editor.camFiles()->files()->rows().value(0);
        QVERIFY(!row.usable);
        QVERIFY2(row.detail.contains(words) &&
                     row.detail.endsWith(u"Correct the file; the panel reads it again automatically."_s),
                 qPrintable(row.detail));
        for (const int index : {-1, 0, 1})
            rig.editor.camFiles()->take(index);
        QVERIFY(camOf(rig.editor).knots == before);
    }

    void aFileIsWrittenUnderItsOwnName()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        rig.editor.setRecipeName(u"Pusher 3/4"_s);
        const Disks disks;
        disks.plugInto(rig);
        scan(rig);
        CamFiles& files = *rig.editor.camFiles();
        QCOMPARE(files.files()->count(), 0);
        QCOMPARE(files.places()->count(), 2);
        const QString expected = disks.stick.filePath(u"Pusher 3_4.csv"_s);
        QVERIFY2(files.places()->rows()[0].detail.contains(expected),
                 qPrintable(files.places()->rows()[0].detail));
        write(rig, 0);
        QVERIFY(!files.failed());
        QVERIFY2(files.message().endsWith(expected), qPrintable(files.message()));
        QCOMPARE(files.files()->count(), 1); // offered at once
        profile::Program read = profile::PointCamProgram{};
        QVERIFY(store::readListCsv(expected, read));
        QVERIFY(knotsOf(read) == camOf(rig.editor).knots);
        rig.editor.knots()->slave()->set(1.5);
        write(rig, 0);
        QVERIFY2(files.message().endsWith(u"Pusher 3_4-2.csv"_s), qPrintable(files.message()));
        profile::Program again = profile::PointCamProgram{};
        QVERIFY(store::readListCsv(expected, again));
        QVERIFY(knotsOf(again) == knotsOf(read)); // the first one is unchanged
        write(rig, 1);
        QVERIFY2(files.message().contains(files.ownFolder()), qPrintable(files.message()));
        scan(rig);
        QVERIFY(files.message().isEmpty());
    }

    void segmentsComeFromAFileAndGoIntoOne()
    {
        PanelRig rig;
        begin(rig, ProgramKind::SegmentCam);
        rig.editor.item(profile::Field::MasterRate)->set(90);
        const auto before = segmentsOf(rig.editor);
        const Disks disks;
        disks.plugInto(rig);
        scan(rig);
        write(rig, 0);
        auto changed = QByteArray::fromStdString(profile::writeSegmentsCsv(before));
        disks.put(u"gap.csv"_s, QByteArray(changed).replace("120,180,dwell", "130,180,dwell"));
        disks.put(u"higher.csv"_s, changed.replace("quintic,50", "quintic,72.5"));
        disks.put(u"knots.csv"_s, "master_deg,slave_mm\n0,0\n");
        scan(rig);
        const QList<OfferRow> rows = rig.editor.camFiles()->files()->rows();
        QCOMPARE(rows.size(), 4);
        const auto rowOf = [&rows](const QString& title) {
            return std::ranges::find(rows, title, &OfferRow::title) - rows.begin();
        };
        const OfferRow& higher = rows[rowOf(u"higher.csv"_s)];
        QVERIFY2(higher.usable && higher.note.startsWith(u"4 segments"_s), qPrintable(higher.note));
        QVERIFY2(higher.detail.contains(u"position 0 to 72.5 mm"_s), qPrintable(higher.detail));
        const OfferRow& gap = rows[rowOf(u"gap.csv"_s)];
        QVERIFY2(!gap.usable && gap.detail.startsWith(u"Line 3: "_s), qPrintable(gap.detail));
        const OfferRow& knots = rows[rowOf(u"knots.csv"_s)];
        QVERIFY2(!knots.usable && knots.detail.contains(u"expected the header from_deg"_s),
                 qPrintable(knots.detail));
        rig.editor.camFiles()->take(static_cast<int>(rowOf(u"higher.csv"_s)));
        QCOMPARE(segmentsOf(rig.editor)[0].endMm, 72.5);
        QCOMPARE(rig.editor.item(profile::Field::MasterRate)->value(),
                 90.0); // only the list comes from the file
        rig.editor.undo();
        QVERIFY(segmentsOf(rig.editor) == before);
    }

    void aStickThatIsReadOnlyOrGoneIsSaid()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        Disks disks;
        disks.isStickReadOnly = true;
        disks.plugInto(rig);
        scan(rig);
        CamFiles& files = *rig.editor.camFiles();
        QVERIFY(!files.places()->rows()[0].usable);
        QVERIFY2(files.places()->rows()[0].detail.contains(u"is read-only"_s),
                 qPrintable(files.places()->rows()[0].detail));
        files.write(0);
        QVERIFY(!files.busy());
        disks.isStickReadOnly = false;
        disks.plugInto(rig);
        scan(rig);
        QVERIFY(disks.stick.remove()); // unplugged after the search
        write(rig, 0);
        QVERIFY(files.failed());
        QVERIFY2(files.message().contains(u"cannot be written"_s), qPrintable(files.message()));
    }
};

CAMPANEL_TEST(TestCamFiles)

} // namespace test_cam_files

#include "test_cam_files.moc"
