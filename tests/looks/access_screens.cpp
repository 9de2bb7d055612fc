// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "app/store/database/setup_marker.h"
#include "app/store/logs/audit_log.h"
#include "app/store/users/user_store.h"

#include <QCoreApplication>
#include <QFile>
#include <QLoggingCategory>

#include <functional>

using namespace Qt::StringLiterals;

namespace campanel::looks {

namespace {

using store::UserLevel;

const QString anna = u"Anna"_s;
const QString liWei = u"Li Wei"_s;

qint64 timeMs(int minute)
{
    return QDateTime(QDate(2026, 1, 15), QTime(13, minute, 7)).toMSecsSinceEpoch();
}

void waitUntil(const std::function<bool()>& isSo)
{
    while (!isSo())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

// Runs the job and waits for it and all earlier ones.
void inStore(TestWindow& window, const std::function<void(store::Database&)>& job)
{
    bool isDone = false;
    window.panel().records().store().run(
        &window.panel().records(),
        [job](store::Database& database) {
            job(database);
            return true;
        },
        [&isDone](bool) { isDone = true; });
    waitUntil([&isDone] { return isDone; });
}

void deleteUsersAndAudit(store::Database& database)
{
    for (const char* table : {"user", "audit", "audit_start"})
        (void)database.execute(u"DELETE FROM %1"_s.arg(QLatin1String(table)));
    for (const auto suffix : {".audit"_L1, ".setup"_L1, ".copy"_L1})
        QFile::remove(database.path() + suffix);
}

void emptyStore(TestWindow& window)
{
    // What an earlier tap still writes must be in the store before it is emptied.
    inStore(window, [](store::Database&) {});
    inStore(window, deleteUsersAndAudit);
}

void reloadUsers(TestWindow& window)
{
    window.panel().access().open();
    inStore(window, [](store::Database&) {});
    window.settle();
}

void addUsers(TestWindow& window)
{
    // The hash of scenePin with libsodium's minimum effort: the normal effort takes a noticeable time, by
    // design.
    static const QString hash =
        u"$argon2id$v=19$m=8,t=1,p=1$8yYBaYPM+R3w4b3kUB7MRw$mLOp+RvpUsfFLzUtbAH1lgnGr+Nf4v9EsIee/4j4IB8"_s;
    emptyStore(window);
    inStore(window, [](store::Database& database) {
        (void)store::addUser(database, anna, UserLevel::Service, hash);
        (void)store::addUser(database, liWei, UserLevel::Technician, hash);
        (void)store::addUser(database, u"Tom"_s, UserLevel::Operator, hash);
    });
    reloadUsers(window);
}

int idOf(TestWindow& window, const QString& name)
{
    for (const QVariant& user : window.panel().access().users()) {
        if (user.toMap().value(u"name"_s).toString() == name)
            return user.toMap().value(u"id"_s).toInt();
    }
    return 0;
}

void logIn(TestWindow& window, const QString& name, const QString& pin)
{
    panel::Access& access = window.panel().access();
    access.choose(idOf(window, name));
    access.login(pin);
    waitUntil([&access] { return !access.busy(); });
    window.settle();
}

void addRows(store::Database& database)
{
    const QString program = u"Biscuit 250 · v%1 · CRC-32 %2"_s;
    const QString proof = u"generation 14 · CRC-32 9C41E07D"_s;
    const QList<store::AuditEntry> rows{
        {timeMs(2), anna, 3, u"user.add"_s, liWei, {}, u"technician"_s, {}, u"done"_s},
        {timeMs(9), {}, 1, u"user.login"_s, liWei, {}, {}, {}, u"wrong_pin"_s},
        {timeMs(10), liWei, 2, u"user.login"_s, liWei, {}, {}, {}, u"done"_s},
        {timeMs(12), liWei, 2, u"parameter.write"_s, u"parameter.mark_distance"_s, u"900"_s, u"903.02"_s,
         u"903.02"_s, u"done"_s},
        {timeMs(14),
         liWei,
         2,
         u"parameter.write"_s,
         u"parameter.phase_gain"_s,
         u"0.25"_s,
         u"0.1"_s,
         {},
         u"not_sent"_s},
        {timeMs(20), {}, 1, u"setting.change"_s, u"language"_s, u"zh_CN"_s, u"en"_s, {}, u"done"_s},
        {timeMs(31),
         {},
         1,
         u"program.download"_s,
         u"Biscuit 250"_s,
         program.arg(3).arg(u"5A0B11C2"_s),
         program.arg(4).arg(u"9C41E07D"_s),
         proof,
         u"done"_s},
        {timeMs(31),
         {},
         1,
         u"program.value"_s,
         u"program.bag_length"_s,
         u"250"_s,
         u"320"_s,
         proof,
         u"done"_s},
        {timeMs(32), {}, 1, u"command.start"_s, u"Biscuit 250"_s, {}, {}, {}, u"done"_s},
    };
    for (const store::AuditEntry& row : rows)
        (void)store::appendAudit(database, row);
}

void waitForTrail(TestWindow& window)
{
    panel::Audit& audit = window.panel().audit();
    waitUntil([&audit] { return !audit.log()->loading() && !audit.checking(); });
    window.settle();
}

void openTrail(TestWindow& window)
{
    window.panel().audit().log()->filter()->clear();
    window.tap(u"nav_settings"_s);
    window.tap(u"sectionUsers"_s);
    window.tap(u"auditButton"_s);
    waitForTrail(window);
}

void openUsers(TestWindow& window, const QStringList& taps)
{
    window.tap(u"nav_settings"_s);
    window.tap(u"sectionUsers"_s);
    for (const QString& tapped : taps)
        window.tap(tapped);
}

// Opens the users, with Anna logged in, then taps. She stays logged in for the next one of these: her PIN's
// check takes a noticeable time, by design.
Screen users(const char* name, const QStringList& taps)
{
    return {QString::fromLatin1(name),
            [taps](TestWindow& window) {
                if (window.panel().access().userName() != anna) {
                    addUsers(window);
                    logIn(window, anna, QString::fromLatin1(screenPin));
                }
                openUsers(window, taps);
            },
            true};
}

Screen trail(const char* name, const QStringList& taps, const QString& tamper = {})
{
    return {QString::fromLatin1(name), [taps, tamper](TestWindow& window) {
                emptyStore(window);
                inStore(window, addRows);
                if (!tamper.isEmpty())
                    inStore(window, [tamper](store::Database& database) { (void)database.execute(tamper); });
                openTrail(window);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

// Opens the technician's half of Motion as anybody.
void openCurves(TestWindow& window)
{
    window.tap(u"nav_motion"_s);
    if (window.find(u"curvesButton"_s))
        window.tap(u"curvesButton"_s);
}

// Requests an action for technicians, then taps.
Screen login(const char* name, const QStringList& taps, int wrongPins = 0)
{
    return {QString::fromLatin1(name), [taps, wrongPins](TestWindow& window) {
                addUsers(window);
                window.panel().access().setWallClock([] { return timeMs(0); });
                openCurves(window);
                window.tap(u"field_base_speed_mm_per_s"_s);
                window.tap(u"login_Li Wei"_s);
                for (int i = 0; i < wrongPins; ++i)
                    logIn(window, liWei, u"1111"_s);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

} // namespace

void forgetUsers(TestWindow& window)
{
    if (!window.panel().access().protectedByPins())
        return;
    window.panel().access().logOut();
    inStore(window, deleteUsersAndAudit);
    reloadUsers(window);
}

QList<Screen> lockedScreens(const QList<Screen>& all)
{
    const QStringList names{u"motion"_s,
                            u"ratios"_s,
                            u"laws"_s,
                            u"tools"_s,
                            u"choice"_s,
                            u"settings-machine"_s,
                            u"settings-master"_s,
                            u"settings-serial"_s,
                            u"settings-clock"_s,
                            u"settings-system"_s,
                            u"settings-stops-shifts"_s,
                            u"users-none"_s,
                            u"jog"_s,
                            u"io-standstill"_s,
                            u"homing-press"_s,
                            u"doctor"_s,
                            u"figures"_s,
                            u"faults"_s,
                            u"packing"_s,
                            u"recipes"_s,
                            u"run-stopped"_s,
                            u"run-cam"_s,
                            u"run-stop-question"_s,
                            u"alarms"_s,
                            u"start-question"_s};
    QList<Screen> locked;
    for (const Screen& screen : all) {
        if (names.contains(screen.name))
            locked << Screen{screen.name + lockedSuffix, [enter = screen.enter](TestWindow& window) {
                                 enter(window);
                                 window.setLevel(panel::Level::Viewer);
                             }};
    }
    return locked;
}

QList<Screen> accessScreens()
{
    return {{u"users-none"_s, [](TestWindow& window) { openUsers(window, {}); }},
            {u"user-first"_s, [](TestWindow& window) { openUsers(window, {u"userAdd"_s}); }},
            users("users", {}),
            users("user", {u"user_Li Wei"_s}),
            users("user-remove", {u"user_Li Wei"_s, u"userRemove"_s}),
            users("user-new", {u"userAdd"_s, u"level2"_s}),
            users("user-name", {u"userAdd"_s, u"newUserName"_s}),
            users("user-pin",
                  {u"userAdd"_s, u"userPin"_s, u"pin1"_s, u"pin2"_s, u"pin3"_s, u"pin4"_s, u"pinAccept"_s}),
            users("auto-logout", {u"autoLogout"_s}),
            users("without-login", {u"withoutLogin"_s}),
            users("run-user", {u"nav_run"_s}),
            login("login", {u"pin2"_s, u"pin5"_s}),
            login("login-wait", {}, 1),
            // Removes the users: nobody can log in.
            {u"login-locked"_s,
             [](TestWindow& window) {
                 emptyStore(window);
                 inStore(window, [](store::Database& database) {
                     (void)store::writeSetupMarker(database.path(), store::SetUp::WithPins);
                 });
                 QLoggingCategory::setFilterRules(u"campanel.store=false"_s); // the loss is intended
                 reloadUsers(window);
                 QLoggingCategory::setFilterRules({});
                 window.panel().records().dismissNotice();
                 openCurves(window);
                 window.tap(u"field_base_speed_mm_per_s"_s);
             }},
            {u"disk-lost"_s,
             [](TestWindow& window) {
                 QLoggingCategory::setFilterRules(u"campanel.store=false"_s); // the loss is intended
                 window.panel().records().reportError(
                     {store::StoreError::Kind::DiskLost, {}, u"/dev/mmcblk0p3 is damaged"_s});
                 QLoggingCategory::setFilterRules({});
                 window.settle();
             }},
            {u"login-short-pin"_s,
             [](TestWindow& window) {
                 addUsers(window);
                 logIn(window, anna, QString::fromLatin1(screenPin));
                 emit window.panel().access().newPinWanted(idOf(window, anna));
                 window.settle();
             }},
            {u"users-logged-out"_s,
             [](TestWindow& window) {
                 addUsers(window);
                 openUsers(window, {});
             }},
            trail("audit", {}),
            trail("audit-who", {u"auditWho"_s}),
            trail("audit-what", {u"auditArea"_s}),
            trail("audit-detail", {u"audit2"_s}),
            {u"audit-filtered"_s,
             [](TestWindow& window) {
                 emptyStore(window);
                 inStore(window, addRows);
                 openTrail(window);
                 window.tap(u"auditFilter"_s);
                 window.tap(u"filterDay"_s);
                 window.panel().audit().log()->filter()->setWord(u"mark"_s);
                 window.tap(u"filterShow"_s);
                 waitForTrail(window);
             }},
            trail("audit-broken", {}, u"UPDATE audit SET after = '930' WHERE sequence = 4"_s),
            {u"audit-empty"_s, [](TestWindow& window) {
                 emptyStore(window);
                 openTrail(window);
             }}};
}

} // namespace campanel::looks
