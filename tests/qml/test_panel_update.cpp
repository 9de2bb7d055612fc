// SPDX-License-Identifier: Apache-2.0
// An update by touch: the stick's packages, one question, the request; a refusal, the way back, the report.
#include "panel_test.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>

namespace test_panel_update {

using namespace Qt::StringLiterals;
using Situation = campanel::looks::DemoLink::Situation;

class TestPanelUpdate : public campanel::test::PanelTest {
    Q_OBJECT

    campanel::test::UnitService& service() { return m_window->unitService(); }
    campanel::panel::SoftwareUpdate& update() { return m_window->panel().update(); }
    void addPackage(const QString& version)
    {
        const QString package = campanel::test::makePackage(m_window->stick(), version);
        QVERIFY(campanel::test::signPackage(package, m_window->signer()));
    }
    void openUpdate()
    {
        m_window->link().show(Situation::Stopped);
        for (const char* name : {"nav_settings", "section3"})
            tap(name);
        QTRY_VERIFY(update().available());
        m_window->settle();
        tap("softwareUpdate");
        QTRY_VERIFY(!update().busy());
        m_window->settle();
    }

private slots:
    void aVersionIsInstalled()
    {
        addPackage(u"0.2.0"_s);
        openUpdate();
        tap("offer0");
        QCOMPARE(textOf("offerGo"), u"Update to 0.2.0"_s);
        tap("offerGo");
        QVERIFY2(textOf("question").contains(u"0.1.0 is replaced by 0.2.0"_s),
                 qPrintable(textOf("question")));
        QVERIFY(service().m_started.isEmpty());
        tap("confirm_update");
        QTRY_COMPARE(service().m_started.size(), 1);
        m_window->settle();
        QCOMPARE(textOf("offerDetail"), u"Preparing … The panel closes soon and comes back."_s);
        QVERIFY(!m_window->find(u"offerGo"_s)->isEnabled());
    }

    void theSheetNamesTheInstalledSystem()
    {
        update().setInstalled([] {
            return campanel::store::PackageId{u"campanel-system"_s, u"0.1.0-20260115"_s, u"amd64"_s};
        });
        openUpdate();
        QCOMPARE(textOf("sheetNote"), u"Installed: CamPanel 0.1.0-20260115"_s);
    }

    void aRefusalIsReadInTheSheet()
    {
        addPackage(u"0.2.0"_s);
        update().setPace(std::chrono::milliseconds(10));
        service().m_work = [this] {
            QVERIFY(
                campanel::test::writeFile(m_window->updateState() + u"/outcome"_s,
                                          "{\"kind\":\"update\",\"result\":\"refused\",\"reason\":\"space\","
                                          "\"detail\":\"300\",\"utc\":\"2026-01-15T14:00:00Z\"}"));
        };
        openUpdate();
        for (const char* name : {"offer0", "offerGo", "confirm_update"})
            tap(name);
        QTRY_VERIFY(update().failed());
        m_window->settle();
        QCOMPARE(textOf("offerDetail"),
                 u"Nothing was installed. 300 MB of free space are needed on this panel."_s);
    }

    void theWayBackIsOneKeyAndOneQuestion()
    {
        QVERIFY(
            campanel::test::writeFile(m_window->updateState() + u"/way-back"_s,
                                      "{\"version\":\"0.0.9\",\"over\":\"0.1.0+deb12\",\"schema\":\"1.1\","
                                      "\"utc\":\"2026-01-13T10:00:00Z\"}"));
        openUpdate();
        QCOMPARE(textOf("updateBack"), u"Back to 0.0.9"_s);
        tap("updateBack");
        QVERIFY2(textOf("question").contains(u"cannot read the present data"_s),
                 qPrintable(textOf("question")));
        tap("confirmCancel");
        QVERIFY(service().m_started.isEmpty());
        tap("softwareUpdate");
        QTRY_VERIFY(!update().busy());
        m_window->settle();
        tap("updateBack");
        tap("confirm_update");
        QTRY_COMPARE(service().m_started.size(), 1);
    }

    void theOutcomeIsABanner()
    {
        QVERIFY(campanel::test::writeFile(m_window->updateState() + u"/outcome"_s,
                                          "{\"kind\":\"update\",\"result\":\"done\",\"from\":\"0.0.9+deb12\","
                                          "\"to\":\"0.1.0+deb12\",\"utc\":\"2026-01-15T14:06:00Z\"}"));
        m_window->link().show(Situation::Stopped);
        update().open();
        QTRY_COMPARE(update().notice(), u"Updated from 0.0.9 to 0.1.0."_s);
        m_window->settle();
        QCOMPARE(textOf("banner"), u"Updated from 0.0.9 to 0.1.0."_s);
    }

    void withoutTheUnitASentenceSaysSo()
    {
        service().m_fileState.clear();
        for (const char* name : {"nav_settings", "section3"})
            tap(name);
        QTRY_COMPARE(textOf("updateState"),
                     u"Updates are installed by the package manager of this computer."_s);
        m_window->settle();
        const QQuickItem* row = m_window->find(u"softwareUpdate"_s);
        QVERIFY(!row || !row->isVisible());
    }
};

CAMPANEL_TEST(TestPanelUpdate)

} // namespace test_panel_update

#include "test_panel_update.moc"
