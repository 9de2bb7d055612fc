// SPDX-License-Identifier: Apache-2.0
// Access: no restrictions without PINs, waiting times after wrong PINs, automatic logout, and refusals in the
// functions themselves.
#include "app/store/users/pin_hash.h"
#include "tests/app/panel/access_rig.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace test_access {

using namespace campanel;
using panel::Access;
using test::AccessRig;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

enum class Harm { Newer, NoFile, Damaged, Deleted, UsersDeleted };

namespace {

// Creates a panel's folder with one user, closed again, and its copy.
void makeAnna(const QTemporaryDir& folder, const QString& pinHash)
{
    const auto database = store::Database::open(folder.path());
    QVERIFY(database);
    QVERIFY(store::addUser(**database, u"Anna"_s, store::UserLevel::Service, pinHash));
    QVERIFY((*database)->makeCopy());
}

void apply(Harm harm, const QString& path)
{
    const auto opened = [&path] { return *store::Database::open(QFileInfo(path).path()); };
    QFile file(path);
    switch (harm) {
    case Harm::Newer:
        QVERIFY(opened()->execute(u"PRAGMA user_version = 99"_s));
        return;
    case Harm::NoFile:
        QVERIFY(file.remove() && QDir().mkpath(path + u"/in the way"_s));
        return;
    case Harm::Damaged:
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(9000, 'x')) == 9000);
        return;
    case Harm::Deleted:
        QVERIFY(file.remove());
        return;
    case Harm::UsersDeleted:
        QVERIFY(opened()->execute(u"DELETE FROM user"_s));
        return;
    }
}

} // namespace

class TestAccess : public QObject {
    Q_OBJECT

private slots:
    void withoutPinsNothingIsRestricted()
    {
        AccessRig rig;
        QVERIFY(!rig.access.protectedByPins());
        QCOMPARE(rig.access.level(), Access::Service);
        QVERIFY(rig.access.ask(Access::Service));
        rig.editor.k1()->set(6.5);
        QCOMPARE(rig.editor.k1()->value(), 6.5);
    }

    void pinsThatAreGuessedAreRefused_data()
    {
        QTest::addColumn<QString>("pin");
        QTest::addColumn<bool>("isGood");
        QTest::addColumn<bool>("isGoodForService");
        for (const char* bad :
             {"", "123", "123456789", "12a4", "0000", "77777777", "1234", "4321", "345678", "98765432"})
            QTest::newRow(bad) << QString::fromLatin1(bad) << false << false;
        for (const char* good : {"2580", "1470", "1235", "00001", "13579"})
            QTest::newRow(good) << QString::fromLatin1(good) << true << false;
        for (const char* good : {"258036", "1470258", "00000001"})
            QTest::newRow(good) << QString::fromLatin1(good) << true << true;
    }
    void pinsThatAreGuessedAreRefused()
    {
        QFETCH(QString, pin);
        QFETCH(bool, isGood);
        QFETCH(bool, isGoodForService);
        AccessRig rig;
        QCOMPARE(rig.access.pinRefusal(pin, Access::Operator).isEmpty(), isGood);
        QCOMPARE(rig.access.pinRefusal(pin, Access::Technician).isEmpty(), isGood);
        QCOMPARE(rig.access.pinRefusal(pin, Access::Service).isEmpty(), isGoodForService);
        rig.add(u"Anna"_s, Access::Operator, pin); // the first one gets the level Service
        QCOMPARE(rig.access.protectedByPins(), isGoodForService);
        QCOMPARE(rig.access.failed(), !isGoodForService);
    }

    void firstUserIsOfServiceAndLoggedIn()
    {
        AccessRig rig;
        rig.add(u"Anna"_s, Access::Operator, u"258036"_s); // any requested level
        QVERIFY(rig.access.protectedByPins());
        QCOMPARE(rig.access.userName(), u"Anna"_s);
        QCOMPARE(rig.access.level(), Access::Service);
        rig.access.logOut();
        QCOMPARE(rig.access.level(), Access::Operator);
        QVERIFY(!rig.access.loggedIn());
    }

    void eachLevelMayWhatItMay()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        QSignalSpy asked(&rig.access, &Access::loginRequested);
        QVERIFY(rig.access.ask(Access::Operator));
        QVERIFY(!rig.access.ask(Access::Technician));
        QCOMPARE(asked.takeFirst().first().toInt(), static_cast<int>(Access::Technician));
        rig.logIn(u"Bo"_s, u"1470"_s);
        QVERIFY(rig.access.ask(Access::Technician));
        QVERIFY(!rig.access.ask(Access::Service));
        rig.logIn(u"Anna"_s, u"258036"_s);
        QVERIFY(rig.access.ask(Access::Service));
    }

    // Checked in the functions, not on the screen.
    void anOperatorChangesBagLengthAndRateOnly()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.addAnnaAndBo();
        QSignalSpy asked(&rig.access, &Access::loginRequested);
        rig.editor.bagLength()->set(260);
        rig.editor.rate()->set(70);
        QCOMPARE(rig.editor.bagLength()->value(), 260.0);
        QCOMPARE(rig.editor.rate()->value(), 70.0);
        QCOMPARE(asked.count(), 0);
        const double k1 = rig.editor.k1()->value();
        rig.editor.k1()->set(6.5);
        rig.editor.dragRatio(0, 0.15);
        rig.editor.setLaw(u"harmonic"_s);
        rig.editor.newProgram(2);
        rig.editor.bagLength()->togglePin();
        rig.editor.baseSpeed()->set(250);
        rig.editor.item(profile::Field::KnifeRadius)->set(70);
        QCOMPARE(rig.editor.k1()->value(), k1);
        QCOMPARE(rig.editor.kind(), panel::Editor::Kind::RotaryCutter);
        QCOMPARE(asked.count(), 7);
        rig.editor.undo();
        QCOMPARE(rig.editor.rate()->value(), 60.0);
        rig.editor.redo();
        QCOMPARE(rig.editor.rate()->value(), 70.0);
        QCOMPARE(asked.count(), 7);
        rig.editor.download();
        QCOMPARE(rig.link.banks.size(), 1);
    }

    void whatATechnicianDidIsNotUndoneByAnOperator()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.logIn(u"Bo"_s, u"1470"_s);
        rig.editor.k1()->set(6.5);
        rig.access.logOut();
        rig.editor.undo();
        QCOMPARE(rig.editor.k1()->value(), 6.5);
    }

    void controllerAndSettingsAreGuarded()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.addAnnaAndBo();
        const auto parameters = rig.link.parameters.size();
        QVERIFY(!rig.machine.parameter("parameter.mark_distance").write(905, {}));
        rig.maintenance.packing()->fields()->write("parameter.mark_distance", 905);
        QCOMPARE(rig.link.parameters.size(), parameters);
        rig.maintenance.simulatedFaults()->setLevel(0, panel::SimulatedFaults::Often);
        QVERIFY(rig.link.faults.isEmpty());
        rig.settings.setSimulated(!rig.settings.simulated());
        QVERIFY(!rig.settings.connectionDirty());
        rig.settings.set("bags.tolerance_mm", panel::settingText(1.25));
        QVERIFY(rig.settings.bagToleranceMm() != 1.25);
        rig.settings.set("access.auto_logout_minutes", panel::settingText(30));
        QCOMPARE(rig.settings.values().whole("access.auto_logout_minutes"), 5);
        rig.settings.set("display.theme", u"dark"_s); // allowed for everybody
        QCOMPARE(rig.settings.values().text("display.theme"), u"dark"_s);
        rig.access.addUser(u"Eve"_s, Access::Service, u"864200"_s);
        rig.access.removeUser(rig.idOf(u"Bo"_s));
        rig.settle();
        QCOMPARE(rig.access.users().size(), 2);
    }

    void registersAreForServiceOnly()
    {
        AccessRig rig;
        rig.connectIdle();
        rig.addAnnaAndBo();
        auto& inspector = *rig.maintenance.inspector();
        inspector.setGroup(u"parameter"_s);
        inspector.select(0);
        QVERIFY(inspector.canWrite());
        rig.logIn(u"Bo"_s, u"1470"_s);
        const auto before = rig.link.parameters.size();
        inspector.value()->set(inspector.value()->minimum());
        QCOMPARE(rig.link.parameters.size(), before);
        rig.logIn(u"Anna"_s, u"258036"_s);
        inspector.value()->set(inspector.value()->minimum());
        QVERIFY(rig.link.parameters.size() > before);
    }

    void stopNeedsNoLogin()
    {
        AccessRig rig;
        rig.connectRunning();
        rig.add(u"Anna"_s, Access::Service, u"258036"_s);
        rig.settings.set("access.operators_log_in", panel::settingText(true));
        rig.access.logOut();
        QCOMPARE(rig.access.level(), Access::Viewer);
        rig.machine.home();
        rig.machine.resetFault();
        QVERIFY(rig.link.requests.isEmpty());
        rig.machine.stop();
        QCOMPARE(rig.link.requests.size(), 1);
        QCOMPARE(rig.link.requests.first().command, modbus::Command::StopAtCycleEnd);
        rig.editor.bagLength()->set(260);
        QCOMPARE(rig.editor.bagLength()->value(), 250.0);
    }

    void wrongPinsCostGrowingTime()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        for (const int seconds : {1, 2, 4, 8}) {
            rig.logIn(u"Anna"_s, u"258136"_s);
            QVERIFY(!rig.access.loggedIn());
            QVERIFY(rig.access.failed());
            QVERIFY(rig.access.waits());
            rig.wallMs += seconds * 1000 - 1;
            QVERIFY(rig.access.waits());
            rig.logIn(u"Anna"_s, u"258036"_s); // the right PIN, too early
            QVERIFY(!rig.access.loggedIn());
            rig.wallMs += 1;
            QVERIFY(!rig.access.waits());
        }
        // The other users do not wait.
        rig.logIn(u"Bo"_s, u"1470"_s);
        QCOMPARE(rig.access.userName(), u"Bo"_s);
        rig.logIn(u"Anna"_s, u"258036"_s);
        QCOMPARE(rig.access.userName(), u"Anna"_s);
        rig.logIn(u"Anna"_s, u"1111"_s); // counted from the start again
        QVERIFY(rig.access.waitText().contains(u"1 s"));
    }

    void waitSurvivesARestart()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        for (int i = 0; i < 3; ++i) {
            rig.logIn(u"Anna"_s, u"258136"_s);
            rig.wallMs += i < 2 ? 10'000 : 0;
        }
        panel::DatabaseService again(rig.folder.path(), nullptr);
        Access access(again, rig.machine, rig.settings, nullptr);
        access.setWallClock([&] { return rig.wallMs; });
        again.open();
        access.open();
        QCOMPARE(access.level(), Access::Operator); // while the users are unknown
        QTRY_VERIFY(access.protectedByPins());
        access.choose(rig.idOf(u"Anna"_s));
        QVERIFY(access.waits());
        QVERIFY(access.waitText().contains(u"4 s"));
        access.login(u"258036"_s);
        QTRY_VERIFY(!access.busy());
        QVERIFY(!access.loggedIn());
        rig.wallMs += 4000;
        access.login(u"258036"_s);
        QTRY_COMPARE(access.userName(), u"Anna"_s);
    }

    // A database that cannot be opened must not unlock the panel.
    void withoutTheDatabaseOperatorsWorkAndTheRestIsRefused_data()
    {
        QTest::addColumn<Harm>("harm");
        QTest::addColumn<bool>("hasCopy");
        for (const bool hasCopy : {true, false}) {
            const char* with = hasCopy ? "" : ", no copy";
            QTest::addRow("newer%s", with) << Harm::Newer << hasCopy;
            QTest::addRow("no file%s", with) << Harm::NoFile << hasCopy;
            QTest::addRow("damaged%s", with) << Harm::Damaged << hasCopy;
            QTest::addRow("deleted%s", with) << Harm::Deleted << hasCopy;
            QTest::addRow("users deleted%s", with) << Harm::UsersDeleted << hasCopy;
        }
    }
    void withoutTheDatabaseOperatorsWorkAndTheRestIsRefused()
    {
        QFETCH(Harm, harm);
        QFETCH(bool, hasCopy);
        const QTemporaryDir folder;
        static const QString pinHash = store::hashPin(u"258036"_s).value_or(QString());
        makeAnna(folder, pinHash);
        apply(harm, folder.filePath(u"campanel.sqlite"_s));
        if (!hasCopy)
            QVERIFY(QFile::remove(folder.filePath(u"campanel.sqlite.copy"_s)));
        AccessRig rig;
        panel::DatabaseService records(folder.path(), nullptr);
        Access access(records, rig.machine, rig.settings, nullptr);
        access.setWallClock([&] { return rig.wallMs; });
        records.open();
        access.open();
        QTRY_VERIFY(access.protectedByPins());
        QVERIFY(!records.notice().isEmpty());
        QCOMPARE(access.level(), Access::Operator);
        QVERIFY(!access.ask(Access::Technician));
        QVERIFY(!access.ask(Access::Service));
        rig.connectRunning();
        rig.machine.stop();
        QCOMPARE(rig.link.requests.size(), 1);
        QCOMPARE(access.locked(), !hasCopy);
        if (!hasCopy) {
            // The reason, and the way to restore the users.
            QVERIFY2(access.refusalText(Access::Service).contains(folder.path()),
                     qPrintable(access.refusalText(Access::Service)));
            return;
        }
        const auto logIn = [&](const QString& pin) {
            access.choose(access.users().first().toMap()[u"id"_s].toInt());
            access.login(pin);
            QTRY_VERIFY(!access.busy());
        };
        logIn(u"258136"_s);
        QVERIFY(!access.loggedIn());
        QVERIFY(access.waits());
        rig.wallMs += 1000;
        QVERIFY(!access.waits());
        logIn(u"258036"_s);
        QVERIFY(access.ask(Access::Service));
    }

    // It holds the PINs, and an empty folder in its place looks like a new panel.
    void withoutTheDiskOfTheDataNobodyIsMoreThanAnOperator()
    {
        const QTemporaryDir folder;
        AccessRig rig;
        panel::DatabaseService records(folder.path(), nullptr);
        records.noteDiskLost(u"no such partition"_s);
        Access access(records, rig.machine, rig.settings, nullptr);
        records.open();
        access.open();
        QTRY_VERIFY(access.locked());
        QCOMPARE(access.level(), Access::Operator);
        QVERIFY(!access.ask(Access::Technician));
        QVERIFY2(access.refusalText(Access::Service).contains(u"no such partition"),
                 qPrintable(access.refusalText(Access::Service)));
    }

    void aPinThatWasChangedIsNotInTheCopy()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.logIn(u"Anna"_s, u"258036"_s);
        rig.access.changePin(rig.idOf(u"Anna"_s), u"975310"_s);
        rig.settle();
        rig.access.removeUser(rig.idOf(u"Bo"_s));
        rig.settle(); // the change
        rig.settle(); // the copy afterwards
        const auto copy = store::Database::openReadOnly(rig.folder.filePath(u"campanel.sqlite.copy"_s));
        QVERIFY(copy);
        QCOMPARE(store::users(**copy)->size(), 1);
        auto pin = (*copy)->execute(u"SELECT pin FROM user WHERE deleted = 0"_s);
        QVERIFY(pin && pin->next());
        QVERIFY(store::isPin(pin->value(0).toString(), u"975310"_s));
    }

    // A PIN of an older version: hashed with less effort, with four digits.
    void anOldPinStillOpensAndIsToBeChanged()
    {
        AccessRig rig;
        const QString old = u"$argon2id$v=19$m=32768,t=2,p=1$3Ai72FrfFVX2G6QSnAfv/A$38Wu6EfziRZkzTB5s3Uuhn5T8"
                            "L/WVOOrV1MFIADy6dI"_s;
        QVERIFY(store::isOutdated(old));
        rig.records.store().run(
            &rig.records,
            [old](store::Database& database) {
                return store::addUser(database, u"Anna"_s, store::UserLevel::Service, old).has_value() &&
                       store::addUser(database, u"Bo"_s, store::UserLevel::Technician, old).has_value();
            },
            [](bool isAdded) { QVERIFY(isAdded); });
        rig.access.open();
        rig.settle();
        QSignalSpy wanted(&rig.access, &Access::newPinWanted);
        rig.logIn(u"Bo"_s, u"2580"_s);
        QCOMPARE(rig.access.userName(), u"Bo"_s);
        QCOMPARE(wanted.count(), 0); // four digits are enough for a technician
        rig.logIn(u"Anna"_s, u"2580"_s);
        QCOMPARE(rig.access.userName(), u"Anna"_s);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].toInt(), rig.idOf(u"Anna"_s));
        QVERIFY(!store::isOutdated(rig.hashOf(u"Anna"_s)));
        QVERIFY(store::isPin(rig.hashOf(u"Anna"_s), u"2580"_s));
        rig.access.changePin(rig.idOf(u"Anna"_s), u"258036"_s);
        rig.settle();
        rig.logIn(u"Anna"_s, u"258036"_s);
        QCOMPARE(rig.access.userName(), u"Anna"_s);
        QCOMPARE(wanted.count(), 1);
    }

    void whoLeavesIsLoggedOut()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.logIn(u"Anna"_s, u"258036"_s);
        rig.settings.set("access.auto_logout_minutes", panel::settingText(2));
        QSignalSpy alone(&rig.access, &Access::leftAlone);
        rig.now += 119s;
        rig.access.checkClock();
        QVERIFY(rig.access.loggedIn());
        QObject touched;
        QEvent touch(QEvent::MouseButtonPress);
        QCoreApplication::sendEvent(&touched, &touch);
        rig.now += 119s;
        rig.access.checkClock();
        QVERIFY(rig.access.loggedIn());
        rig.now += 1s;
        rig.access.checkClock();
        QVERIFY(!rig.access.loggedIn());
        QCOMPARE(alone.count(), 1);
        QCOMPARE(rig.access.level(), Access::Operator);
    }

    void usersAreChangedByService()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.logIn(u"Anna"_s, u"258036"_s);
        QVERIFY(!rig.access.nameRefusal(u" bo "_s).isEmpty());
        QVERIFY(!rig.access.nameRefusal(u""_s).isEmpty());
        QCOMPARE(rig.access.freeName(Access::Technician), u"Technician"_s);
        rig.add(u"Technician"_s, Access::Technician, u"2468"_s);
        QCOMPARE(rig.access.freeName(Access::Technician), u"Technician 2"_s);

        rig.access.changePin(rig.idOf(u"Bo"_s), u"9513"_s);
        rig.settle();
        rig.access.changeLevel(rig.idOf(u"Bo"_s), Access::Operator);
        rig.settle();
        rig.logIn(u"Bo"_s, u"9513"_s);
        QCOMPARE(rig.access.level(), Access::Operator);

        rig.logIn(u"Anna"_s, u"258036"_s);
        rig.access.removeUser(rig.idOf(u"Anna"_s)); // the last user of the level Service
        rig.settle();
        QVERIFY(rig.access.failed());
        QVERIFY2(rig.access.message().contains(u"Service"), qPrintable(rig.access.message()));
        QCOMPARE(rig.access.userName(), u"Anna"_s);
        rig.access.changeLevel(rig.idOf(u"Bo"_s), Access::Service);
        rig.settle();
        rig.access.removeUser(rig.idOf(u"Anna"_s));
        rig.settle();
        QVERIFY(!rig.access.loggedIn());
        QCOMPARE(rig.access.users().size(), 2);
    }
};

CAMPANEL_TEST(TestAccess)

} // namespace test_access

#include "test_access.moc"
