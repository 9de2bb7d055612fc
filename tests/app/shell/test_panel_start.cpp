// SPDX-License-Identifier: Apache-2.0
// The panel passes on what its start has found: a missing disk for the data, errors of the configuration, and
// the files of the machine builder.
#include "app/shell/panel.h"
#include "tests/support/fake_link.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace test_panel_start {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelStart : public QObject {
    Q_OBJECT

private slots:
    void withoutTheDiskOfTheDataNothingIsDownloaded_data()
    {
        QTest::addColumn<QString>("reason");
        QTest::addColumn<bool>("isPossible");
        QTest::newRow("missing") << u"no such partition"_s << false;
        QTest::newRow("there") << QString() << true;
    }

    void withoutTheDiskOfTheDataNothingIsDownloaded()
    {
        QFETCH(QString, reason);
        QFETCH(bool, isPossible);
        const QTemporaryDir folder;
        test::FakeLink link;
        shell::Panel panel(link, {.settingsFile = folder.filePath(u"settings.ini"_s),
                                  .recipeFolder = folder.path(),
                                  .diskLost = reason});
        panel.open();
        link.becomeConnected();
        link.sendStatus(std::chrono::steady_clock::now());
        emit link.programRead({link.status.generation, 0, {}});
        QVERIFY2(panel.editor().programDownload()->canDownload() == isPossible,
                 qPrintable(panel.editor().programDownload()->text()));
    }

    void errorsAndFilesOfTheBuilderAreSaid()
    {
        const QTemporaryDir folder;
        const QString card = folder.filePath(u"made-ready"_s);
        QVERIFY(QDir().mkpath(card));
        QFile report(card + u"/report"_s);
        QVERIFY(report.open(QIODevice::WriteOnly) && report.write("hostname\tok\n") > 0);
        report.close();
        test::FakeLink link;
        shell::Panel panel(link, {.settingsFile = folder.filePath(u"settings.ini"_s),
                                  .recipeFolder = folder.path(),
                                  .builderFolder = card,
                                  .complaints = {u"campanel.toml:3: there is no key x; it is ignored."_s}});
        panel.open();
        QTRY_COMPARE(panel.builderFiles().notice(),
                     u"campanel.toml:3: there is no key x; it is ignored. Taken from the card: hostname."_s);
        QTRY_VERIFY(!QFile::exists(card));
    }
};

CAMPANEL_TEST(TestPanelStart)

} // namespace test_panel_start

#include "test_panel_start.moc"
