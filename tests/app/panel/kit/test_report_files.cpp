// SPDX-License-Identifier: Apache-2.0
// Files written to a place: many, one that fails, a place that does not answer, and the end of the panel.
#include "app/panel/kit/report_files.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <future>
#include <memory>

namespace test_report_files {

using namespace campanel;
using namespace campanel::panel;
using namespace Qt::StringLiterals;

namespace {

QList<ReportFile> filesOf(int count)
{
    QList<ReportFile> files;
    for (int i = 0; i < count; ++i)
        files << ReportFile{u"Biscuit %1"_s.arg(i), u"json"_s, [] { return QByteArray("{}"); }};
    return files;
}

void write(ReportFiles& files, const QList<ReportFile>& wanted)
{
    files.offer(wanted);
    QTRY_VERIFY(!files.busy());
    files.write(0);
    QTRY_VERIFY(!files.busy());
}

} // namespace

class TestReportFiles : public QObject {
    Q_OBJECT

private slots:
    void manyFilesAreCounted()
    {
        const QTemporaryDir stick;
        ReportFiles files(stick.path(), nullptr);
        files.setScanner([](const QString& folder) {
            return QList<store::Place>{{folder, u"STICK"_s, false, true}};
        });
        write(files, filesOf(261));
        QVERIFY(!files.failed());
        QCOMPARE(files.message(),
                 u"Written: 261 files in %1. You can remove the stick now."_s.arg(stick.path()));
        QCOMPARE(QDir(stick.path()).entryList(QDir::Files | QDir::Hidden).size(), 261);
        write(files, filesOf(1));
        QVERIFY(files.message().contains(u"Biscuit 0-2.json"_s));
    }

    void oneThatFailsEndsNoOther()
    {
        const QTemporaryDir folder;
        ReportFiles files(folder.path(), nullptr);
        files.setScanner([](const QString& own) {
            return QList<store::Place>{{own, u"own"_s, false, false}};
        });
        QList<ReportFile> wanted = filesOf(9);
        for (const int i : {2, 4, 5, 6, 7})
            wanted[i].write = [](const QString&) { return tl::unexpected(u"reason"_s); };
        write(files, wanted);
        QVERIFY(files.failed());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 4);
        const QString message = files.message();
        QVERIFY2(message.startsWith(u"Written: 4 of 9 files. The file "_s), qPrintable(message));
        QVERIFY2(message.contains(u"Biscuit 2.json cannot be written: reason."_s), qPrintable(message));
        QVERIFY2(message.endsWith(u"Also missing: Biscuit 4, Biscuit 5, Biscuit 6, …."_s),
                 qPrintable(message));
    }

    void aSilentPlaceIsNamed()
    {
        const QTemporaryDir folder;
        ReportFiles files(folder.path(), nullptr);
        files.setScanner([](const QString& own) {
            return QList<store::Place>{{u"/mnt/share"_s, u"share"_s, false, true, true}, {own, u"own"_s}};
        });
        files.offer(filesOf(1));
        QTRY_VERIFY(!files.busy());
        QCOMPARE(files.places()->count(), 2);
        const OfferRow& row = files.places()->row(0);
        QVERIFY(!row.usable && row.note == u"/mnt/share · no answer"_s);
        QVERIFY2(row.detail.startsWith(u"/mnt/share does not answer."_s), qPrintable(row.detail));
        files.write(0);
        QVERIFY(!files.busy());
    }

    // A job that waits in the kernel cannot be ended: the panel ends without it.
    void theEndWaitsForNoDisk()
    {
        auto gate = std::make_shared<std::promise<void>>();
        const std::shared_future<void> opened = gate->get_future().share();
        const auto isBack = std::make_shared<std::promise<void>>();
        std::future<void> back = isBack->get_future();
        {
            ReportFiles files(u"/nowhere"_s, nullptr);
            files.setScanner([opened, isBack](const QString&) {
                opened.wait();
                isBack->set_value();
                return QList<store::Place>();
            });
            files.scan();
            QVERIFY(files.busy());
        }
        gate->set_value();
        back.wait();
        QTest::qWait(0); // what it sent has no receiver any more
    }
};

CAMPANEL_TEST(TestReportFiles)

} // namespace test_report_files

#include "test_report_files.moc"
