// SPDX-License-Identifier: Apache-2.0
// A scanner at the window: bursts of real key events, with and without a text field that has the focus.
#include "panel_test.h"

#include "tests/support/qr_reader.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>

namespace test_panel_scan {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelScan : public test::PanelTest {
    Q_OBJECT

    auto& scan() { return m_window->panel().scan(); }
    auto& recipes() { return m_window->panel().recipes(); }
    void setScanner() { m_window->panel().settings().overrideValue("scanner.prefix", u"~~"_s); }
    void press(const QString& keys)
    {
        for (const QChar key : keys)
            QTest::sendKeyEvent(QTest::Click, &m_window->window(), QTest::asciiToKey(key.toLatin1()),
                                QString(key), key.isUpper() ? Qt::ShiftModifier : Qt::NoModifier);
    }
    void scanCode(const QString& code)
    {
        press(u"~~"_s + code);
        QTest::keyClick(&m_window->window(), Qt::Key_Return);
        m_window->settle();
    }
    void openLibrary()
    {
        m_window->panel().records().open();
        m_window->waitUntil(recipes(), &panel::Recipes::listChanged,
                            [](const panel::Recipes& each) { return each.total() > 0; });
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->checkClock();
        m_window->settle();
    }

private slots:
    void aCodeOpensTheDifferenceOnAnyPage()
    {
        setScanner();
        openLibrary();
        for (const char* page : {"nav_run", "nav_trends", "nav_settings"}) {
            tap(page);
            scanCode(recipes().chosenName());
            QVERIFY2(m_window->find(u"downloadStart"_s), page);
            QCOMPARE(scan().notice(), QString());
            tap("downloadCancel");
        }
    }

    void anUnknownCodeIsNamedInTheBanner()
    {
        setScanner();
        openLibrary();
        scanCode(u"4006381"_s);
        QVERIFY(!m_window->find(u"downloadStart"_s));
        QCOMPARE(textOf("bannerText"),
                 u"No recipe has the code 4006381. Enter the code with its recipe on the Recipes page."_s);
        tap("bannerButton");
        QCOMPARE(scan().notice(), QString());
    }

    void noKeyOfACodeReachesAFieldWithTheFocus()
    {
        setScanner();
        openLibrary();
        tap("nav_recipes");
        tap("recipeSearch");
        press(u"bis"_s);
        QCOMPARE(textOf("textInput"), u"bis"_s);
        press(u"~~400638"_s); // half a code
        m_window->link().advance(std::chrono::milliseconds(101));
        QTRY_COMPARE(textOf("bannerText"), u"The code was not read completely. Scan again."_s);
        QCOMPARE(textOf("textInput"), u"bis"_s);
        QTest::keyClick(&m_window->window(), Qt::Key_Return); // the rest of it
        scanCode(u"unknown"_s);
        QVERIFY(m_window->find(u"textInput"_s));
        QCOMPARE(textOf("textInput"), u"bis"_s);
    }

    void aSlowHandMayTypeThePrefixsKey()
    {
        setScanner();
        openLibrary();
        tap("nav_recipes");
        tap("recipeSearch");
        press(u"a~"_s);
        m_window->link().advance(std::chrono::milliseconds(101));
        QTRY_COMPARE(textOf("textInput"), u"a~"_s);
        QCOMPARE(scan().notice(), QString());
    }

    void withoutAPrefixTheKeyboardIsAKeyboard()
    {
        openLibrary();
        tap("nav_recipes");
        QVERIFY(!m_window->find(u"recipeCodes"_s));
        tap("recipeSearch");
        press(u"~~a1"_s);
        QCOMPARE(textOf("textInput"), u"~~a1"_s);
    }

    void aScanFillsTheEntryOfACode()
    {
        setScanner();
        openLibrary();
        tap("nav_recipes");
        tap("recipeCodes");
        tap("codeOfRecipe");
        scanCode(u"4006381"_s);
        QCOMPARE(textOf("textInput"), u"4006381"_s);
        QVERIFY(!m_window->find(u"downloadStart"_s));
        tap("textAccept");
        m_window->waitUntil(recipes(), &panel::Recipes::listChanged, [](const panel::Recipes& each) {
            return each.chosenRecipe() && each.chosenRecipe()->recipe.scanCode == "4006381";
        });
        scanCode(u"4006381"_s);
        QVERIFY(m_window->find(u"downloadStart"_s));
        const panel::ReportData report = m_window->panel().commissioning().data();
        QCOMPARE(report.codes.size(), 1);
        QCOMPARE(report.codes.first().code, u"4006381"_s);
    }

    void theCodeOnTheScreenCanBeScanned()
    {
        setScanner();
        openLibrary();
        tap("nav_recipes");
        tap("recipeCodes");
        const QTemporaryDir folder;
        const QString picture = folder.filePath(u"screen.png"_s);
        QVERIFY(m_window->window().grabWindow().save(picture));
        QCOMPARE(test::readQrCodes({picture}), QStringList{recipes().chosenName()});
    }

    void aWrongFilmReelIsOverriddenWithAReason()
    {
        setScanner();
        openLibrary();
        tap("nav_recipes");
        tap("recipeCodes");
        tap("codeOfFilm");
        scanCode(u"PE 30"_s);
        tap("textAccept");
        m_window->waitUntil(recipes(), &panel::Recipes::listChanged, [](const panel::Recipes& each) {
            return each.chosenRecipe() && each.chosenRecipe()->recipe.filmCode == "PE 30";
        });
        const auto codes = m_window->panel().commissioning().data().codes;
        QCOMPARE(codes.size(), 2);
        QCOMPARE(codes.last().code, u"PE 30"_s);
        const auto& machine = m_window->panel().controller();
        QVERIFY2(machine.canStart(), qPrintable(machine.startBlockedReason()));
        scanCode(u"PP 40"_s);
        QVERIFY(!machine.canStart());
        QCOMPARE(textOf("question"), scan().film()->blockedReason());
        tap("confirmCancel");
        tap("startKey"); // says again why
        QCOMPARE(textOf("question"), scan().film()->blockedReason());
        const QSignalSpy noted(scan().film(), &panel::FilmCheck::noted);
        tap("confirm_override");
        QVERIFY(!m_window->find(u"textAccept"_s)->isEnabled()); // no reason yet
        press(u"no other reel"_s);
        tap("textAccept");
        m_window->settle();
        QVERIFY2(machine.canStart(), qPrintable(machine.startBlockedReason()));
        QCOMPARE(noted.count(), 1);
        QCOMPARE(noted.first().first().value<store::AuditEntry>().after, u"PP 40: no other reel"_s);
    }

    void unsavedEditsAreAskedFor()
    {
        setScanner();
        openLibrary();
        const QString name = recipes().chosenName();
        editor().bagLength()->set(240);
        scanCode(name);
        QVERIFY(!m_window->find(u"downloadStart"_s));
        tap("confirm_discard");
        m_window->settle();
        QVERIFY(m_window->find(u"downloadStart"_s));
        QVERIFY(!editor().edited());
    }

    void theScannerIsSetUpAndTestedInItsSection()
    {
        openLibrary();
        tap("nav_maintenance");
        tap("maintenancePanel");
        tap("maintenanceScanner");
        tap("scannerPrefix");
        press(u"~~"_s);
        tap("textAccept");
        QCOMPARE(scan().prefix(), u"~~"_s);
        scanCode(recipes().chosenName());
        QVERIFY(!m_window->find(u"downloadStart"_s));
        QCOMPARE(m_window->find(u"scannerLast"_s)->property("value").toString(), recipes().chosenName());
    }
};

CAMPANEL_TEST(TestPanelScan)

} // namespace test_panel_scan

#include "test_panel_scan.moc"
