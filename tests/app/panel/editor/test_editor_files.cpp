// SPDX-License-Identifier: Apache-2.0
// The files of the editor: a slow medium keeps no key waiting, nothing is lost at the end, and a full disk is
// told.
#include "tests/app/panel/panel_rig.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <atomic>
#include <sys/syscall.h>
#include <unistd.h>

namespace test_editor_files {

std::atomic<int> syncs{0};
std::atomic<int> syncsOfPanel{0}; // in the thread of the screen

} // namespace test_editor_files

// Qt and CamPanel call this function instead of that of the C library.
extern "C" int fsync(int file)
{
    ++test_editor_files::syncs;
    if (QCoreApplication::instance() != nullptr &&
        QThread::currentThread() == QCoreApplication::instance()->thread())
        ++test_editor_files::syncsOfPanel;
    return static_cast<int>(syscall(SYS_fsync, file));
}

namespace test_editor_files {

using namespace campanel;
using test::PanelRig;

class TestEditorFiles : public QObject {
    Q_OBJECT

private slots:
    void aSlowMediumKeepsNoKeyWaiting()
    {
        PanelRig rig;
        program::Recipe recipe = rig.editor.storedRecipe();
        recipe.name = "Another";
        const int before = syncs;
        const int beforeOfPanel = syncsOfPanel;
        rig.editor.open(recipe);
        rig.editor.bagLength()->set(240);
        const QString working = rig.folder.filePath(QStringLiteral("working_copy.json"));
        QTRY_COMPARE(store::LastRecipe(working).load().recipe.cutter().bagLengthMm, 240.0);
        QVERIFY(syncs > before);
        QCOMPARE(syncsOfPanel, beforeOfPanel);
    }

    void whoWaitsForTheFileFindsIt()
    {
        PanelRig rig;
        program::Recipe recipe = rig.editor.storedRecipe();
        recipe.name = "Another";
        std::string found;
        rig.editor.takeStored(recipe, [&rig, &found] {
            found = store::readRecipe(rig.folder.filePath(QStringLiteral("recipe.json")))
                        .value_or(program::Recipe{})
                        .name;
        });
        QTRY_COMPARE(found, "Another");
    }

    void whatWasEditedIsInTheFilesAtTheEnd()
    {
        PanelRig rig;
        const QTemporaryDir folder;
        {
            panel::Editor editor(rig.machine, folder.path(), nullptr);
            program::Recipe recipe = editor.storedRecipe();
            recipe.name = "Another";
            recipe.version = 1;
            editor.open(recipe);
            editor.bagLength()->set(240);
        }
        const panel::Editor editor(rig.machine, folder.path(), nullptr);
        QCOMPARE(editor.storedRecipe().name, "Another");
        QCOMPARE(editor.recipe().cutter().bagLengthMm, 240.0);
    }

    void aFullDiskIsTold()
    {
        PanelRig rig;
        const test::FullDisk full;
        rig.editor.open(rig.editor.storedRecipe());
        QTRY_VERIFY2(rig.editor.notice().contains(QStringLiteral("recipe.json")),
                     qPrintable(rig.editor.notice()));
    }
};

CAMPANEL_TEST(TestEditorFiles)

} // namespace test_editor_files

#include "test_editor_files.moc"
