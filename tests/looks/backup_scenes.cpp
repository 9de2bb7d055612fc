// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/scene_lists.h"

#include "tests/looks/stage.h"

#include <QDir>
#include <QFile>

using namespace Qt::StringLiterals;

namespace campanel::looks {

namespace {

void openBackup(Stage& stage)
{
    stage.panel().trends().open(); // required for a backup
    stage.link().show(DemoLink::Situation::Stopped);
    stage.lookAtClock();
    for (const char* tapped : {"nav_maintenance", "servicePanel", "serviceBackup"})
        stage.tap(QString::fromLatin1(tapped));
}

void waitUntilIdle(Stage& stage)
{
    stage.waitUntil(stage.panel().backup(), &panel::Backup::changed,
                    [](const panel::Backup& backup) { return !backup.busy(); });
}

// Creates a backup of this panel and an invalid file in a folder of their own.
void fillStick(Stage& stage)
{
    panel::Backup& backup = stage.panel().backup();
    const QString folder = QFileInfo(backup.ownFolder()).dir().filePath(u"stick"_s);
    QDir().mkpath(folder);
    backup.setLooker([folder](const QString&) {
        return QList<store::Place>{{folder, u"KINGSTON"_s, false}};
    });
    QFile other(folder + u"/photos.zip"_s);
    if (!other.exists() && (!other.open(QIODevice::WriteOnly) || other.write("no archive") < 0))
        qWarning("the demonstration's stick cannot be written");
    backup.make();
    waitUntilIdle(stage);
    stage.waitFor(*backup.places());
    if (QDir(folder).entryList({u"*.zip"_s}).size() < 2)
        backup.places()->write(0);
    stage.waitFor(*backup.places());
    stage.tap(u"sheetClose"_s);
}

Scene restoring(const char* name, const QStringList& taps)
{
    return {QString::fromLatin1(name), [taps](Stage& stage) {
                openBackup(stage);
                fillStick(stage);
                stage.tap(u"backupRestore"_s);
                waitUntilIdle(stage);
                for (const QString& tapped : taps) {
                    stage.tap(tapped);
                    waitUntilIdle(stage);
                }
            }};
}

} // namespace

QList<Scene> backupScenes()
{
    // The backup is the newer of the two files.
    return {{u"backup"_s, &openBackup},
            {u"backup-places"_s,
             [](Stage& stage) {
                 stage.panel().backup().setLooker([](const QString&) {
                     return QList<store::Place>{{u"/media/panel/KINGSTON"_s, u"KINGSTON"_s, false}};
                 });
                 openBackup(stage);
                 stage.tap(u"backupMake"_s);
                 waitUntilIdle(stage);
                 stage.waitFor(*stage.panel().backup().places());
             }},
            {u"bundle-places"_s,
             [](Stage& stage) {
                 stage.panel().service().files()->setLooker([](const QString&) {
                     return QList<store::Place>{{u"/media/panel/KINGSTON"_s, u"KINGSTON"_s, false}};
                 });
                 openBackup(stage);
                 stage.tap(u"bundleMake"_s);
                 stage.waitUntil(stage.panel().bundle(), &panel::ServiceBundle::offered,
                                 [](const panel::ServiceBundle& bundle) { return !bundle.busy(); });
                 stage.waitFor(*stage.panel().service().files());
             }},
            {u"restore-none"_s,
             [](Stage& stage) {
                 stage.panel().backup().setLooker([](const QString&) { return QList<store::Place>(); });
                 openBackup(stage);
                 stage.tap(u"backupRestore"_s);
                 waitUntilIdle(stage);
             }},
            restoring("restore", {u"offer0"_s}),
            restoring("restore-foreign", {u"offer1"_s}),
            restoring("restore-question", {u"offer0"_s, u"offerGo"_s})};
}

} // namespace campanel::looks
