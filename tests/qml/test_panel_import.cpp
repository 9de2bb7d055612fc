// SPDX-License-Identifier: Apache-2.0
// Importing many recipes from a stick at once, by touch, and messages that end.
#include "panel_test.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>

namespace test_panel_import {

using namespace Qt::StringLiterals;
using namespace campanel;
using namespace std::chrono_literals;

class TestPanelImport : public test::PanelTest {
    Q_OBJECT

    [[nodiscard]] bool isShown(const char* name) { return m_window->find(QString::fromLatin1(name)); }
    panel::Recipes& recipes() { return m_window->panel().recipes(); }
    // Offers these files; a name with "@N" has the version N.
    void putOnStick(const QStringList& names)
    {
        QList<store::RecipeOffer> offers;
        for (const QString& name : names) {
            program::Recipe recipe;
            recipe.name = name.section(u'@', 0, 0).toStdString();
            recipe.version = std::max(1, name.section(u'@', 1).toInt());
            recipe.cutter().bagLengthMm = 200 + recipe.version;
            store::RecipeOffer offer;
            offer.path = u"/media/stick/"_s + name + u".json"_s;
            offer.placeName = u"USB stick"_s;
            offer.changed = QDateTime(QDate(2026, 1, 15), QTime(12, 0));
            offer.recipe = recipe;
            offers << offer;
        }
        recipes().files()->setScanner([offers](const QString&) { return offers; });
    }

private slots:
    void allOfAStickTakeTwoTouches()
    {
        m_window->panel().records().open();
        QTRY_VERIFY(recipes().ready());
        const int before = recipes().total();
        QStringList names{u"Wafer@2"_s, u"Wafer@1"_s};
        for (int i = 1; i <= 60; ++i)
            names << u"Pouch %1"_s.arg(i, 2, 10, QLatin1Char('0'));
        putOnStick(names);
        tap("nav_recipes");
        tap("recipeImport");
        QTRY_VERIFY(isShown("offer0"));
        QCOMPARE(m_window->find(u"offer0"_s)->property("text").toString(), u"Wafer, version 2"_s);
        QVERIFY2(m_window->find(u"offer0"_s)->property("note").toString().startsWith(u"new"),
                 "what it would be is told before it is chosen");
        tap("offerAll");
        QTRY_COMPARE(recipes().total(), before + 61);
        QCOMPARE(textOf("recipeMessage"), u"62 recipes were imported."_s);
        const store::RecipeVersion* wafer = recipes().named(u"Wafer"_s);
        QVERIFY(wafer);
        QCOMPARE(wafer->version, 2);

        // Again: nothing is new, and each row says so.
        tap("recipeImport");
        QTRY_VERIFY(isShown("offer0"));
        QVERIFY(!isShown("offerAll"));
        QVERIFY(m_window->find(u"offer0"_s)->property("note").toString().startsWith(u"is here already"));
    }

    void aNextVersionNamesItsDifferences()
    {
        m_window->panel().records().open();
        QTRY_VERIFY(recipes().ready());
        putOnStick({u"Wafer@1"_s});
        tap("nav_recipes");
        tap("recipeImport");
        tap("offer0");
        tap("offerGo");
        QTRY_VERIFY(recipes().named(u"Wafer"_s));
        putOnStick({u"Wafer@2"_s});
        tap("recipeImport");
        tap("offer0");
        QTRY_VERIFY2(textOf("offerDetail").contains(u"Bag length 201.0 mm to 202.0 mm"),
                     qPrintable(textOf("offerDetail")));
    }

    void aMessageAboutWhatWasDoneEnds()
    {
        m_window->panel().records().open();
        QTRY_VERIFY(recipes().ready());
        recipes().setMessageTime(50ms);
        tap("nav_recipes");
        recipes().save();
        QTRY_VERIFY(!recipes().message().isEmpty());
        QTRY_VERIFY(recipes().message().isEmpty());
        m_window->settle();
        QVERIFY(!isShown("recipeMessage"));
    }

    void theMessageOfAnExportEnds()
    {
        const QTemporaryDir stick;
        m_window->panel().records().open();
        QTRY_VERIFY(recipes().ready());
        putOnStick({u"Wafer"_s, u"Pouch"_s});
        tap("nav_recipes");
        tap("recipeImport");
        tap("offerAll");
        QTRY_COMPARE(recipes().total(), 3);
        panel::ReportFiles& files = *recipes().exports();
        files.setScanner([&stick](const QString&) {
            return QList<store::Place>{{stick.path(), u"KINGSTON"_s, false, true}};
        });
        files.setMessageTime(50ms);
        QStringList shown;
        connect(&files, &panel::FileExchange::changed, this, [&] { shown << textOf("offerDetail"); });
        tap("recipeExportAll");
        QTRY_VERIFY(isShown("offer0"));
        const QString hint = textOf("offerDetail");
        tap("offer0");
        tap("offerGo");
        const QString written = u"Written: %1 files in %2. You can remove the stick now."_s.arg(
            QString::number(recipes().total()), stick.path());
        QTRY_VERIFY2(shown.contains(written), qPrintable(shown.join(u'\n')));
        QTRY_COMPARE(textOf("offerDetail"), hint);
        QCOMPARE(QDir(stick.path()).entryList({u"*.json"_s}).size(), recipes().total());

        QDir(stick.path()).removeRecursively(); // an error stays
        tap("offer0");
        tap("offerGo");
        QTRY_VERIFY2(textOf("offerDetail").contains(u"cannot be"_s), qPrintable(textOf("offerDetail")));
        QTest::qWait(200);
        QVERIFY(textOf("offerDetail").contains(u"cannot be"_s));
        files.disconnect(this);
    }
};

CAMPANEL_TEST(TestPanelImport)

} // namespace test_panel_import

#include "test_panel_import.moc"
