// SPDX-License-Identifier: Apache-2.0
// Packages on a stick, the request to a stand-in of systemd, and what the files of campanel-update say.
#include "../panel_rig.h"
#include "app/panel/update/software_update.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"
#include "tests/support/unit_service.h"

#include <QSignalSpy>
#include <QTest>

#include <memory>

namespace test_software_update {

using namespace Qt::StringLiterals;
using namespace campanel;
using campanel::panel::Level;
using campanel::panel::OfferRow;
using campanel::panel::SoftwareUpdate;

class TestSoftwareUpdate : public QObject {
    Q_OBJECT

    std::unique_ptr<test::PanelRig> m_rig;
    std::unique_ptr<test::UnitBus> m_bus;
    std::unique_ptr<SoftwareUpdate> m_update;
    store::SigningKey m_anna = store::newSigningKey(u"Anna"_s).value();

    QString path(const QString& name) { return m_rig->folder.filePath(name); }
    void write(const QString& name, const QByteArray& bytes) { QVERIFY(test::writeFile(path(name), bytes)); }
    void addPackage(const QString& version, const QString& architecture = u"amd64"_s,
                    const QString& name = u"campanel"_s)
    {
        const QString package = test::makePackage(path(u"stick"_s), version, architecture, name);
        QVERIFY(!package.isEmpty() && test::signPackage(package, m_anna));
    }
    void writeOutcome(const QString& kind, const QString& result, const QString& reason = {},
                      const QString& utc = u"2026-01-15T14:00:00Z"_s)
    {
        write(
            u"state/outcome"_s,
            u"{\"kind\":\"%1\",\"result\":\"%2\",\"reason\":\"%3\",\"detail\":\"libfoo1\",\"data\":\"\","
            "\"from\":\"1.1.0+deb12\",\"to\":\"1.2.3+deb12\",\"utc\":\"%4\"}"_s.arg(kind, result, reason, utc)
                .toUtf8());
    }
    void writeWayBack(const QString& over, const QString& schema)
    {
        write(u"state/way-back"_s, u"{\"version\":\"1.0.0+deb12\",\"over\":\"%1\",\"schema\":\"%2\","
                                   "\"utc\":\"2026-01-13T10:00:00Z\"}"_s.arg(over, schema)
                                       .toUtf8());
    }
    void scan()
    {
        m_update->scan();
        QTRY_VERIFY(!m_update->busy());
    }
    // Returns the row of that title; the test has failed when there is none.
    OfferRow row(const QString& title)
    {
        for (const OfferRow& each : m_update->found()->rows()) {
            if (each.title == title)
                return each;
        }
        return {};
    }

private slots:
    void init()
    {
        m_rig = std::make_unique<test::PanelRig>();
        m_bus = std::make_unique<test::UnitBus>();
        m_update = std::make_unique<SoftwareUpdate>(m_rig->machine, m_rig->folder.path(), nullptr);
        m_update->setPlaces({path(u"run"_s), path(u"update"_s), path(u"state"_s), path(u"keys"_s)});
        m_update->setBus(m_bus->bus());
        m_update->setPace(std::chrono::milliseconds(10));
        m_update->setScanner([stick = path(u"stick"_s)](const QString&) {
            return QList<store::Place>{{stick, u"KINGSTON"_s, false, true}};
        });
        m_update->setInstalled([] { return store::PackageId{u"campanel"_s, u"1.1.0+deb12"_s, u"amd64"_s}; });
        write(u"keys/anna.json"_s, store::publicKeyFile(m_anna));
        QVERIFY(QDir(m_rig->folder.path()).mkpath(u"run"_s));
        QVERIFY(QDir(m_rig->folder.path()).mkpath(u"state"_s));
    }

    void cleanup()
    {
        m_update.reset();
        m_bus.reset();
        m_rig.reset();
    }

    void eachPackageSaysWhatItIs()
    {
        addPackage(u"1.2.3+deb12"_s);
        addPackage(u"1.0.0+deb12"_s);
        addPackage(u"1.1.0+deb12"_s);
        addPackage(u"1.3.0+deb12"_s, u"arm64"_s);
        QVERIFY(!test::makePackage(path(u"stick"_s), u"1.4.0"_s).isEmpty());
        write(u"stick/campanel_2.0.0_amd64.deb"_s, "damaged");
        QVERIFY(QFile::copy(path(u"stick/campanel_1.2.3+deb12_amd64.deb.sig"_s),
                            path(u"stick/campanel_2.0.0_amd64.deb.sig"_s)));
        scan();
        QCOMPARE(m_update->found()->count(), 6);
        QVERIFY(row(u"CamPanel 1.2.3"_s).usable);
        QVERIFY(row(u"CamPanel 1.2.3"_s).note.contains(u"signed by Anna"_s));
        for (const auto& [title, reason] :
             {std::pair(u"CamPanel 1.0.0"_s, u"is older than the installed version"_s),
              std::pair(u"CamPanel 1.1.0"_s, u"is installed"_s),
              std::pair(u"CamPanel 1.3.0"_s, u"of type arm64"_s),
              std::pair(u"campanel_1.4.0_amd64.deb"_s, u"has no signature"_s),
              std::pair(u"campanel_2.0.0_amd64.deb"_s, u"is damaged"_s)}) {
            QVERIFY2(!row(title).usable, qPrintable(title));
            QVERIFY2(row(title).detail.contains(reason), qPrintable(row(title).detail));
        }
    }

    void anImageTakesWholeSystemsOnly()
    {
        m_update->setInstalled([] {
            return store::PackageId{u"campanel-system"_s, u"1.1.0-20260101"_s, u"amd64"_s};
        });
        addPackage(u"1.1.0-20260201"_s, u"amd64"_s, u"campanel-system"_s);
        addPackage(u"1.2.3+deb12"_s);
        scan();
        QVERIFY(row(u"CamPanel 1.1.0-20260201"_s).usable);
        QCOMPARE(row(u"CamPanel 1.2.3"_s).detail,
                 u"This is the package campanel; this panel takes campanel-system."_s);
        m_update->choose(1); // behind the package
        QCOMPARE(m_update->actionText(), u"Update to 1.1.0-20260201"_s);
    }

    void aMovingMachineIsNotUpdated()
    {
        addPackage(u"1.2.3+deb12"_s);
        writeWayBack(u"1.1.0+deb12"_s, store::dataSchema());
        m_rig->connectRunning();
        scan();
        QVERIFY(!row(u"CamPanel 1.2.3"_s).usable);
        QVERIFY(row(u"CamPanel 1.2.3"_s).detail.startsWith(u"The machine is moving."_s));
        const QSignalSpy chosen(m_update.get(), &SoftwareUpdate::chosen);
        m_update->choose(0);
        m_update->chooseBack();
        QCOMPARE(chosen.size(), 0);
        m_rig->link.status.state = modbus::State::Ready;
        m_rig->link.sendStatus(m_rig->now);
        QVERIFY(row(u"CamPanel 1.2.3"_s).usable);
        m_update->choose(0);
        QCOMPARE(chosen.size(), 1);
        // It starts between question and answer.
        m_rig->link.status.state = modbus::State::Running;
        m_rig->link.sendStatus(m_rig->now);
        m_update->confirm();
        QVERIFY(!m_update->busy());
        QVERIFY(m_bus->service.m_started.isEmpty());
    }

    void levelServiceIsNeeded()
    {
        addPackage(u"1.2.3+deb12"_s);
        scan();
        m_update->choose(0);
        m_rig->machine.accessCheck().setLevel(Level::Technician);
        const QSignalSpy refused(&m_rig->machine.accessCheck(), &panel::AccessCheck::refused);
        m_update->confirm();
        m_update->choose(0);
        QCOMPARE(refused.size(), 2);
        QVERIFY(m_bus->service.m_started.isEmpty());
        QVERIFY(!QFile::exists(path(u"run/update-request"_s)));
    }

    void theUnitGetsCopiesAndTheRequest()
    {
        addPackage(u"1.2.3+deb12"_s);
        addPackage(u"1.1.0+deb12"_s);
        scan();
        m_update->choose(0);
        QVERIFY(m_update->question().contains(u"1.1.0 is replaced by 1.2.3"_s));
        QCOMPARE(m_update->actionText(), u"Update to 1.2.3"_s);
        QSignalSpy noted(m_update.get(), &SoftwareUpdate::noted);
        m_update->confirm();
        QTRY_COMPARE(m_bus->service.m_started, QStringList{u"campanel-update.service replace"_s});
        QVERIFY(m_update->busy());
        QCOMPARE(store::readBytes(path(u"run/update-request"_s)).value(), QByteArray("update\n"));
        for (const auto& [copy, original] :
             {std::pair(u"package.deb"_s, u"campanel_1.2.3+deb12_amd64.deb"_s),
              std::pair(u"package.deb.sig"_s, u"campanel_1.2.3+deb12_amd64.deb.sig"_s),
              std::pair(u"installed.deb"_s, u"campanel_1.1.0+deb12_amd64.deb"_s),
              std::pair(u"installed.deb.sig"_s, u"campanel_1.1.0+deb12_amd64.deb.sig"_s)})
            QCOMPARE(store::readBytes(path(u"update/"_s + copy)).value(),
                     store::readBytes(path(u"stick/"_s + original)).value());
        const auto entry = noted[0][0].value<store::AuditEntry>();
        QCOMPARE(entry.what, u"update.start"_s);
        QCOMPARE(entry.object, u"campanel_1.2.3+deb12_amd64.deb"_s);
        QCOMPARE(entry.after, u"1.2.3+deb12"_s);
    }

    void aRefusalOfTheUnitIsASentence()
    {
        addPackage(u"1.2.3+deb12"_s);
        scan();
        m_bus->service.m_work = [this] { writeOutcome(u"update"_s, u"refused"_s, u"dependencies"_s); };
        QSignalSpy ended(m_update.get(), &SoftwareUpdate::ended);
        m_update->choose(0);
        m_update->confirm();
        QTRY_COMPARE(ended.size(), 1);
        QTRY_VERIFY(!m_update->busy());
        QVERIFY(m_update->failed());
        QVERIFY2(
            m_update->message().contains(u"needs other packages, which the stick cannot bring: libfoo1."_s),
            qPrintable(m_update->message()));
        QVERIFY(m_update->notice().isEmpty());
        QCOMPARE(ended[0][0].value<store::AuditEntry>().outcome, u"refused"_s);
        QVERIFY(!QFile::exists(path(u"run/update-request"_s)));
    }

    void refusalsOfSystemdAreSentences()
    {
        addPackage(u"1.2.3+deb12"_s);
        scan();
        m_bus->service.m_isForbidden = true;
        m_update->choose(0);
        m_update->confirm();
        QTRY_VERIFY(!m_update->busy());
        QVERIFY2(m_update->message().contains(u"polkit"_s), qPrintable(m_update->message()));
        QVERIFY(!QFile::exists(path(u"run/update-request"_s)));
        // A stick that was pulled out meanwhile.
        m_bus->service.m_isForbidden = false;
        scan();
        m_update->choose(0);
        QVERIFY(QDir(path(u"stick"_s)).removeRecursively());
        m_update->confirm();
        QTRY_VERIFY(!m_update->busy());
        QVERIFY2(m_update->failed() && m_update->message().startsWith(u"Not updated:"_s),
                 qPrintable(m_update->message()));
        QVERIFY(m_bus->service.m_started.isEmpty());
    }

    void theOutcomeIsReportedOnceItIsThere_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("result");
        QTest::addColumn<QString>("reason");
        QTest::addColumn<QString>("notice");
        QTest::addColumn<QString>("after");
        QTest::newRow("updated") << u"update"_s << u"done"_s << QString() << u"Updated from 1.1.0 to 1.2.3."_s
                                 << u"1.2.3+deb12"_s;
        QTest::newRow("back") << u"back"_s << u"done"_s << QString() << u"Back from 1.1.0 to 1.2.3."_s
                              << u"1.2.3+deb12"_s;
        QTest::newRow("returned")
            << u"update"_s << u"returned"_s << u"not-shown"_s
            << u"CamPanel 1.2.3 could not be used. The new version did not open its window. The "
               "panel has put 1.1.0 and its data back."_s
            << u"1.1.0+deb12"_s;
        QTest::newRow("failed")
            << u"update"_s << u"failed"_s << u"not-installed"_s
            << u"CamPanel 1.2.3 could not be installed, and 1.1.0 could not be put back "
               "completely. Install CamPanel by the package manager. The new version could not "
               "be installed."_s
            << u"1.1.0+deb12"_s;
    }
    void theOutcomeIsReportedOnceItIsThere()
    {
        QFETCH(QString, kind);
        QFETCH(QString, result);
        QFETCH(QString, reason);
        QFETCH(QString, notice);
        QFETCH(QString, after);
        QSignalSpy ended(m_update.get(), &SoftwareUpdate::ended);
        write(u"state/unfinished"_s, "{}"); // the new panel is on trial
        m_update->open();
        QTest::qWait(50);
        QCOMPARE(ended.size(), 0);
        writeOutcome(kind, result, reason);
        QVERIFY(QFile::remove(path(u"state/unfinished"_s)));
        QTRY_COMPARE(m_update->notice(), notice);
        QCOMPARE(ended.size(), 1);
        const auto entry = ended[0][0].value<store::AuditEntry>();
        QCOMPARE(entry.before, u"1.1.0+deb12"_s);
        QCOMPARE(entry.after, after);
        QTRY_VERIFY(QFile::exists(path(u"update/reported"_s)));
        m_update->dismissNotice();
        m_update->open();
        QTest::qWait(50);
        QCOMPARE(m_update->notice(), QString());
        QCOMPARE(ended.size(), 1);
    }

    void theWayBackEndsWithAnotherVersion()
    {
        scan();
        QCOMPARE(m_update->backVersion(), QString());
        writeWayBack(u"1.0.9"_s, store::dataSchema());
        scan();
        QCOMPARE(m_update->backVersion(), QString());
        writeWayBack(u"1.1.0+deb12"_s, store::dataSchema());
        scan();
        QCOMPARE(m_update->backVersion(), u"1.0.0"_s);
        m_update->chooseBack();
        QVERIFY2(m_update->question().contains(u"Recipes and records stay."_s),
                 qPrintable(m_update->question()));
        m_update->confirm();
        QTRY_COMPARE(m_bus->service.m_started.size(), 1);
        QCOMPARE(store::readBytes(path(u"run/update-request"_s)).value(), QByteArray("back\n"));
        QVERIFY(!QFile::exists(path(u"update/package.deb"_s)));
    }

    void theWayBackNamesTheDataThatItPutsBack()
    {
        writeWayBack(u"1.1.0+deb12"_s, u"1.1"_s);
        scan();
        m_update->chooseBack();
        QVERIFY2(m_update->question().contains(u"cannot read the present data"_s),
                 qPrintable(m_update->question()));
        QVERIFY2(m_update->question().contains(u"2026"_s), qPrintable(m_update->question()));
    }

    void onlyTheKioskWithTheUnitUpdates()
    {
        m_update->setWatched(true);
        QTRY_VERIFY(m_update->available());
        m_update->setWatched(false);
        m_bus->service.m_fileState.clear();
        m_update->setWatched(true);
        QTRY_VERIFY(!m_update->available());
        QCOMPARE(m_update->stateText(), u"Updates are installed by the package manager of this computer."_s);
        m_bus->service.m_fileState = u"enabled"_s;
        m_update->setPlaces({});
        m_update->setWatched(false);
        m_update->setWatched(true);
        QVERIFY(!m_update->available());
    }
};

CAMPANEL_TEST(TestSoftwareUpdate)

} // namespace test_software_update

#include "test_software_update.moc"
