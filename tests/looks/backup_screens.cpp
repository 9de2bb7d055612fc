// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "app/store/files/system_record.h"
#include "tests/looks/test_window.h"
#include "tests/support/fake_package.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTimeZone>

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

void waitForPackages(TestWindow& window)
{
    window.waitUntil(window.panel().update(), &panel::SoftwareUpdate::changed,
                     [](const panel::SoftwareUpdate& update) { return !update.busy(); });
}

// A version for this panel, an older one, one for another computer and one without signature.
void fillPackages(TestWindow& window)
{
    if (QDir(window.stick()).exists())
        return;
    bool isDone = test::signPackage(test::makePackage(window.stick(), u"0.2.0+deb12"_s), window.signer());
    isDone &= test::signPackage(test::makePackage(window.stick(), u"0.0.9+deb12"_s), window.signer());
    isDone &=
        test::signPackage(test::makePackage(window.stick(), u"0.3.0+deb12"_s, u"arm64"_s), window.signer());
    isDone &= !test::makePackage(window.stick(), u"0.4.0+deb12"_s).isEmpty();
    if (!isDone)
        qWarning("the demonstration's packages cannot be written");
}

void openUpdate(TestWindow& window, DemoLink::Situation situation)
{
    window.link().show(situation);
    window.checkClock();
    for (const char* tapped : {"nav_settings", "section3"})
        window.tap(QString::fromLatin1(tapped));
    window.waitUntil(window.panel().update(), &panel::SoftwareUpdate::changed,
                     [](const panel::SoftwareUpdate& update) { return update.available(); });
    window.tap(u"softwareUpdate"_s);
    waitForPackages(window);
}

Screen update(const char* name, const QStringList& taps,
              DemoLink::Situation situation = DemoLink::Situation::Stopped,
              const std::function<void(TestWindow&)>& prepare = &fillPackages)
{
    return {QString::fromLatin1(name), [taps, situation, prepare](TestWindow& window) {
                prepare(window);
                openUpdate(window, situation);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

void keepEarlierVersion(TestWindow& window)
{
    fillPackages(window);
    if (!test::writeFile(window.updateState() + u"/way-back"_s,
                         "{\"version\":\"0.0.9+deb12\",\"over\":\"0.1.0+deb12\",\"schema\":\"1.1\","
                         "\"utc\":\"2026-01-13T10:00:00Z\"}"))
        qWarning("the demonstration's way back cannot be written");
}

// Opens the versions on a disk with so many free bytes. The data has grown by some 20 MB a day.
Screen versions(const char* name, qint64 freeBytes)
{
    return {QString::fromLatin1(name), [freeBytes](TestWindow& window) {
                const QString folder = QFileInfo(window.stick()).path();
                const qint64 day = QDate(2026, 1, 15).toJulianDay() - QDate(1970, 1, 1).toJulianDay();
                store::SystemRecord record;
                store::addSample(record, day - 14, 0);
                QFile ballast(folder + u"/ballast"_s); // with a hole: its size counts, nothing is written
                if (!ballast.open(QIODevice::WriteOnly) || !ballast.resize(280'000'000 - 1))
                    qWarning("the demonstration's data cannot be written");
                (void)store::writeSystemRecord(folder, record);
                panel::Versions& shown = window.panel().versions();
                shown.setFreeBytes([freeBytes](const QString&) { return freeBytes; });
                shown.setWallClock(
                    [] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7), QTimeZone::utc()); });
                shown.setGateway(u"1.2.3"_s);
                shown.open();
                window.waitUntil(shown, &panel::Versions::changed, [freeBytes](const panel::Versions& each) {
                    return each.forecast().freeBytes == freeBytes;
                });
                for (const char* tapped : {"nav_settings", "section3", "sectionVersions"})
                    window.tap(QString::fromLatin1(tapped));
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

QList<Screen> updateScreens()
{
    // The newest version first: for another computer, for this one, the older one; without signature last.
    return {
        versions("settings-versions", 64'000'000'000),
        versions("settings-versions-short", 3'000'000'000),
        update("update-none", {}, DemoLink::Situation::Stopped,
               [](TestWindow& window) { QDir(window.stick()).removeRecursively(); }),
        update("update", {u"offer1"_s}),
        update("update-other-computer", {u"offer0"_s}),
        update("update-moving", {u"offer1"_s}, DemoLink::Situation::Running),
        update("update-question", {u"offer1"_s, u"offerGo"_s}),
        update("update-back", {}, DemoLink::Situation::Stopped, &keepEarlierVersion),
        update("update-back-question", {u"updateBack"_s}, DemoLink::Situation::Stopped, &keepEarlierVersion),
        {u"update-none-here"_s,
         [](TestWindow& window) {
             window.unitService().m_fileState.clear();
             for (const char* tapped : {"nav_settings", "section3"})
                 window.tap(QString::fromLatin1(tapped));
             window.waitUntil(window.panel().update(), &panel::SoftwareUpdate::changed,
                              [](const panel::SoftwareUpdate& each) { return !each.stateText().isEmpty(); });
             window.unitService().m_fileState = u"enabled"_s;
         }},
        // Its banner stays.
        {u"update-done"_s, [](TestWindow& window) {
             window.link().show(DemoLink::Situation::Stopped);
             window.checkClock();
             if (!test::writeFile(window.updateState() + u"/outcome"_s,
                                  "{\"kind\":\"update\",\"result\":\"done\",\"from\":\"0.0.9+deb12\","
                                  "\"to\":\"0.1.0+deb12\",\"utc\":\"2026-01-15T14:06:00Z\"}"))
                 qWarning("the demonstration's outcome cannot be written");
             window.tap(u"nav_run"_s);
             window.panel().update().open();
             window.waitUntil(window.panel().update(), &panel::SoftwareUpdate::noticeChanged,
                              [](const panel::SoftwareUpdate& each) { return !each.notice().isEmpty(); });
         }}};
}

} // namespace campanel::looks
