// SPDX-License-Identifier: Apache-2.0
// The clock of the computer, set by a stand-in of systemd-timedated on a bus of its own.
#include "app/panel/kit/access_check.h"
#include "app/panel/settings/system_clock.h"
#include "tests/support/test_program.h"
#include "tests/support/time_service.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <memory>

namespace test_system_clock {

using namespace Qt::StringLiterals;
using campanel::panel::AccessCheck;
using campanel::panel::Level;
using campanel::panel::SystemClock;
using campanel::test::TimeBus;

class TestSystemClock : public QObject {
    Q_OBJECT

    std::unique_ptr<TimeBus> m_bus;
    campanel::test::TimeService* m_service = nullptr;
    AccessCheck m_check;
    std::unique_ptr<SystemClock> m_clock;

private slots:
    void init()
    {
        m_bus = std::make_unique<TimeBus>();
        m_service = &m_bus->service;
        m_check.setLevel(Level::Service);
        m_clock = std::make_unique<SystemClock>(m_check, nullptr);
        m_clock->setBus(m_bus->bus());
    }

    void cleanup()
    {
        m_clock.reset();
        m_bus.reset();
    }

    void stateIsRead()
    {
        QVERIFY(!m_clock->available());
        m_service->m_ntp = true;
        m_clock->setWatched(true);
        QTRY_VERIFY(m_clock->available());
        QCOMPARE(m_clock->zone(), u"Europe/Berlin"_s);
        QVERIFY(m_clock->canUseTimeServer());
        QVERIFY(m_clock->usesTimeServer());
        QVERIFY(!m_clock->movable());
        QCOMPARE(m_clock->stateText(), u"No time server has responded yet. Check the network."_s);
        m_service->m_isSynchronized = true;
        QTRY_COMPARE(m_clock->stateText(), u"The clock follows a time server."_s);
    }

    void everythingIsSetAndAudited()
    {
        m_clock->setWatched(true);
        QTRY_VERIFY(m_clock->movable());
        QSignalSpy noted(m_clock.get(), &SystemClock::noted);
        const QSignalSpy moved(m_clock.get(), &SystemClock::moved);
        m_clock->move(-60);
        QVERIFY(m_clock->busy() && !m_clock->movable());
        QTRY_VERIFY(!m_clock->busy());
        QCOMPARE(m_service->m_movedUs, -3'600'000'000);
        QCOMPARE(moved.size(), 1);
        m_clock->setZone(u"Asia/Shanghai"_s);
        QTRY_COMPARE(m_clock->zone(), u"Asia/Shanghai"_s);
        m_clock->setUsesTimeServer(true);
        QTRY_VERIFY(m_clock->usesTimeServer());
        QCOMPARE(m_clock->problem(), QString());
        QCOMPARE(noted.size(), 3);
        const auto zone = noted[1][0].value<campanel::store::AuditEntry>();
        QCOMPARE(zone.what, u"setting.change"_s);
        QCOMPARE(zone.object, u"time_zone"_s);
        QCOMPARE(zone.before, u"Europe/Berlin"_s);
        QCOMPARE(zone.after, u"Asia/Shanghai"_s);
        QCOMPARE(zone.outcome, u"done"_s);
    }

    void levelServiceIsNeeded()
    {
        m_check.setLevel(Level::Technician);
        m_clock->setWatched(true);
        QTRY_VERIFY(m_clock->movable());
        const QSignalSpy refused(&m_check, &AccessCheck::refused);
        m_clock->move(60);
        m_clock->setZone(u"UTC"_s);
        m_clock->setUsesTimeServer(true);
        QCOMPARE(refused.size(), 3);
        QVERIFY(!m_clock->busy());
        QCOMPARE(m_service->m_movedUs, 0);
    }

    void refusalsAreSentences()
    {
        m_clock->setWatched(true);
        QTRY_VERIFY(m_clock->movable());
        QSignalSpy noted(m_clock.get(), &SystemClock::noted);
        m_service->m_isForbidden = true;
        m_clock->move(60);
        QTRY_VERIFY(!m_clock->busy());
        QVERIFY2(m_clock->problem().contains(u"polkit"_s), qPrintable(m_clock->problem()));
        QCOMPARE(noted[0][0].value<campanel::store::AuditEntry>().outcome, u"failed"_s);
        m_service->m_isForbidden = false;
        m_service->m_ntp = true; // switched on by somebody else meanwhile
        m_clock->move(60);
        QTRY_VERIFY(!m_clock->busy());
        QCOMPARE(m_clock->problem(), u"Not set: Automatic time synchronization is enabled"_s);
        QCOMPARE(m_service->m_movedUs, 0);
    }

    void withoutTheServiceASentenceSaysSo()
    {
        m_clock->setBus({[] { return QDBusConnection(u"nowhere"_s); }, {}});
        m_clock->setWatched(true);
        QTRY_COMPARE(m_clock->stateText(),
                     u"systemd-timedated does not respond. Set the clock in the operating system."_s);
        QVERIFY(!m_clock->available() && !m_clock->movable() && !m_clock->canUseTimeServer());
    }

    void zonesHaveTheirOffsets()
    {
        const QVariantList zones = m_clock->zonesOf(u"Europe"_s);
        const auto berlin = std::find_if(zones.begin(), zones.end(), [](const QVariant& zone) {
            return zone.toMap()[u"key"_s] == u"Europe/Berlin"_s;
        });
        QVERIFY(berlin != zones.end());
        QCOMPARE(berlin->toMap()[u"text"_s], u"Berlin"_s);
        QCOMPARE(berlin->toMap()[u"note"_s], u"UTC+01:00"_s);
        for (const QString& region : SystemClock::regions())
            QVERIFY2(!m_clock->zonesOf(region).isEmpty(), qPrintable(region));
    }
};

CAMPANEL_TEST(TestSystemClock)

} // namespace test_system_clock

#include "test_system_clock.moc"
