// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

#include <QDir>
#include <QFile>

using namespace Qt::StringLiterals;

namespace campanel::looks {

namespace {

void openBackup(TestWindow& window)
{
    window.panel().trends().open(); // required for a backup
    window.link().show(DemoLink::Situation::Stopped);
    window.checkClock();
    for (const char* tapped : {"nav_maintenance", "maintenancePanel", "maintenanceBackup"})
        window.tap(QString::fromLatin1(tapped));
}

void waitUntilIdle(TestWindow& window)
{
    window.waitUntil(window.panel().backup(), &panel::Backup::changed,
                     [](const panel::Backup& backup) { return !backup.busy(); });
}

// Creates a backup of this panel and an invalid file in a folder of their own.
void fillStick(TestWindow& window)
{
    panel::Backup& backup = window.panel().backup();
    const QString folder = QFileInfo(backup.ownFolder()).dir().filePath(u"stick"_s);
    QDir().mkpath(folder);
    backup.setScanner([folder](const QString&) {
        return QList<store::Place>{{folder, u"KINGSTON"_s, false}};
    });
    QFile other(folder + u"/photos.zip"_s);
    if (!other.exists() && (!other.open(QIODevice::WriteOnly) || other.write("no archive") < 0))
        qWarning("the demonstration's stick cannot be written");
    backup.make();
    waitUntilIdle(window);
    window.waitFor(*backup.places());
    if (QDir(folder).entryList({u"*.zip"_s}).size() < 2)
        backup.places()->write(0);
    window.waitFor(*backup.places());
    window.tap(u"sheetClose"_s);
}

Screen restoring(const char* name, const QStringList& taps)
{
    return {QString::fromLatin1(name), [taps](TestWindow& window) {
                openBackup(window);
                fillStick(window);
                window.tap(u"backupRestore"_s);
                waitUntilIdle(window);
                for (const QString& tapped : taps) {
                    window.tap(tapped);
                    waitUntilIdle(window);
                }
            }};
}

} // namespace

QList<Screen> backupScreens()
{
    // The backup is the newer of the two files.
    return {{u"scanner"_s,
             [](TestWindow& window) {
                 for (const char* tapped : {"nav_maintenance", "maintenancePanel", "maintenanceScanner"})
                     window.tap(QString::fromLatin1(tapped));
             }},
            {u"backup"_s, &openBackup},
            {u"backup-places"_s,
             [](TestWindow& window) {
                 window.panel().backup().setScanner([](const QString&) {
                     return QList<store::Place>{{u"/media/panel/KINGSTON"_s, u"KINGSTON"_s, false}};
                 });
                 openBackup(window);
                 window.tap(u"backupMake"_s);
                 waitUntilIdle(window);
                 window.waitFor(*window.panel().backup().places());
             }},
            {u"bundle-places"_s,
             [](TestWindow& window) {
                 window.panel().maintenance().files()->setScanner([](const QString&) {
                     return QList<store::Place>{{u"/media/panel/KINGSTON"_s, u"KINGSTON"_s, false}};
                 });
                 openBackup(window);
                 window.tap(u"bundleMake"_s);
                 window.waitUntil(window.panel().bundle(), &panel::ServiceBundle::offered,
                                  [](const panel::ServiceBundle& bundle) { return !bundle.busy(); });
                 window.waitFor(*window.panel().maintenance().files());
             }},
            {u"restore-none"_s,
             [](TestWindow& window) {
                 window.panel().backup().setScanner([](const QString&) { return QList<store::Place>(); });
                 openBackup(window);
                 window.tap(u"backupRestore"_s);
                 waitUntilIdle(window);
             }},
            restoring("restore", {u"offer0"_s}),
            restoring("restore-foreign", {u"offer1"_s}),
            restoring("restore-question", {u"offer0"_s, u"offerGo"_s})};
}

} // namespace campanel::looks
