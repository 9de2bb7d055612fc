// SPDX-License-Identifier: Apache-2.0
// The variants of the panel: colors of high contrast, keys for gloves, explained numbers, longer texts, and
// the comparison of pictures.
#include "panel_test.h"
#include "tests/looks/checks/contrast.h"
#include "tests/looks/picture_difference.h"
#include "tests/looks/checks/screen_checks.h"
#include "tests/looks/screens.h"
#include "tests/looks/variant_checks.h"
#include "tests/support/test_program.h"

#include <QAccessible>
#include <QPainter>
#include <QQmlProperty>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <cmath>

namespace test_looks {

using namespace campanel;

class TestLooks : public test::PanelTest {
    Q_OBJECT

private:
    // Returns the variants named by patterns with commas or spaces between them.
    static QSet<QString> namesOf(QString patterns)
    {
        QSet<QString> names;
        for (const looks::Variant& variant : looks::variantsNamed(patterns.replace(u' ', u',')))
            names += variant.name();
        return names;
    }
    static QSet<QString> namesOf(const char* patterns) { return namesOf(QString::fromLatin1(patterns)); }

    QString accessibleNameOf(const char* name)
    {
        QAccessibleInterface* control =
            QAccessible::queryAccessibleInterface(m_window->find(QString::fromLatin1(name)));
        return control ? control->text(QAccessible::Name) : QString();
    }

    QObject* part(const char* name) { return m_window->theme()->property(name).value<QObject*>(); }

private slots:
    // The plots paint their texts and curves themselves, invisible to the self-test: this checks their
    // colors.
    void highContrastHoldsForEveryColorThatIsReadOrFollowed()
    {
        m_window->panel().settings().set("display.theme", QStringLiteral("contrast"));
        const QObject* colors = part("color");
        for (const char* behind : {"ground", "surface", "inset", "touchTint"}) {
            const auto below = colors->property(behind).value<QColor>();
            QVERIFY(below.isValid());
            for (const char* name : {"ink", "secondaryInk", "touch", "good", "warning", "fault", "target",
                                     "disabledInk", "acceleration", "frequency", "position", "jerk"}) {
                const double ratio = looks::contrastRatio(colors->property(name).value<QColor>(), below);
                QVERIFY2(ratio >= (qstrcmp(behind, "touchTint") == 0 ? 6 : 7),
                         qPrintable(QStringLiteral("%1 on %2: %3").arg(name, behind).arg(ratio)));
            }
        }
        for (const auto& [ink, key] : {std::pair("stopInk", "stop"), std::pair("stopInk", "stopPressed"),
                                       std::pair("touchInk", "touch"), std::pair("touchInk", "touchPressed")})
            QVERIFY2(looks::contrastRatio(colors->property(ink).value<QColor>(),
                                          colors->property(key).value<QColor>()) >= 7,
                     key);
    }

    void glovesMakeKeysAQuarterLarger()
    {
        const double touch = part("size")->property("touch").toDouble();
        const double command = part("size")->property("commandKey").toDouble();
        const double stop = m_window->find(QStringLiteral("stopKey"))->width();
        tap("nav_settings");
        tap("glovesOn");
        QVERIFY(m_window->panel().settings().values().isTrue("display.gloves"));
        QVERIFY(std::abs(part("size")->property("touch").toDouble() / touch - 1.25) < 0.01);
        QVERIFY(std::abs(part("size")->property("commandKey").toDouble() / command - 1.25) < 0.01);
        QVERIFY(std::abs(m_window->find(QStringLiteral("stopKey"))->width() / stop - 1.25) < 0.01);
        tap("glovesOff");
        QCOMPARE(part("size")->property("touch").toDouble(), touch);
    }

    void lastPagesAreBehindMoreWhereGlovesNeedTheRoom()
    {
        QVERIFY(!m_window->find(QStringLiteral("nav_more")));
        m_window->panel().settings().set("display.gloves", panel::settingText(true));
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("nav_maintenance")));
        tap("nav_more");
        tap("choice_maintenance");
        QCOMPARE(m_window->frame()->property("page").toString(), "maintenance");
        QVERIFY(!m_window->find(QStringLiteral("choice_maintenance"))); // the chooser is gone
        QVERIFY(m_window->find(QStringLiteral("nav_more"))->property("checked").toBool());
        tap("nav_motion");
        QCOMPARE(m_window->frame()->property("page").toString(), "motion");
    }

    void groupsOfServiceAreBehindOneKeyWhereGlovesNeedTheRoom()
    {
        tap("nav_maintenance");
        tap("maintenanceMachine");
        m_window->panel().settings().set("display.gloves", panel::settingText(true));
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("maintenancePanel")));
        QCOMPARE(textOf("maintenanceGroup"), QStringLiteral("Machine"));
        tap("maintenanceGroup");
        tap("choice_2");
        QVERIFY(m_window->find(QStringLiteral("maintenanceBackup")));
        m_window->panel().settings().set("display.gloves", panel::settingText(false));
        m_window->settle();
        QCOMPARE(textOf("maintenancePanel"), QStringLiteral("Panel"));
        QVERIFY(!m_window->find(QStringLiteral("maintenanceGroup")));
    }

    void heldNumbersSayHowTheyComeAbout()
    {
        m_window->hold(QStringLiteral("packingRate"));
        const QString text = textOf("explanationText");
        QVERIFY2(text.contains(QStringLiteral("rate of the program × master speed")), qPrintable(text));
        const auto& machine = m_window->panel().controller();
        const QString sum = QStringLiteral("= %1 × %2 %\n= %3 bags/min");
        QVERIFY2(text.contains(sum.arg(machine.active().rateBagsPerMin, 0, 'f', 1)
                                   .arg(machine.live().masterSpeedPercent, 0, 'f', 0)
                                   .arg(machine.live().rateBagsPerMin, 0, 'f', 1)),
                 qPrintable(text));
        tap("sheetClose");
        tap("nav_motion");
        m_window->hold(QStringLiteral("verdictNumbers"));
        QVERIFY2(textOf("explanationText").contains(QStringLiteral("rounded down")),
                 qPrintable(textOf("explanationText")));
    }

    void linesEndNeitherBeforeNorWithinAUnit_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<double>("rate");
        QTest::addColumn<QString>("unit");
        QTest::newRow("English") << QStringLiteral("en") << 390.0 << QStringLiteral(" m/s²");
        QTest::newRow("Chinese") << QStringLiteral("zh_CN") << 60.0 << QStringLiteral(" 袋/分");
    }
    void linesEndNeitherBeforeNorWithinAUnit()
    {
        QFETCH(QString, language);
        QFETCH(double, rate);
        QFETCH(QString, unit);
        m_window->panel().settings().overrideValue("display.language", language);
        m_window->settle();
        editor().rate()->set(rate);
        tap("nav_motion");
        QVERIFY2(plain(editor().verdict()).contains(unit), qPrintable(editor().verdict()));
        const QString told = propertyOf("verdict", "text");
        static const QRegularExpression breakable(
            QStringLiteral(R"(\d [%A-Za-z\x{4e00}-\x{9fff}]|/[^\x{2060}])"));
        QVERIFY2(!told.isEmpty() && !breakable.match(told).hasMatch(), qPrintable(told));
    }

    void timesOfAnswersSayHowTheyComeAbout()
    {
        tap("nav_maintenance");
        tap("maintenanceLine");
        tap("maintenance1");
        m_window->hold(QStringLiteral("figuresTimes"));
        const auto& latency = m_window->panel().maintenance().figures()->report()->figures.latency();
        const auto told = m_window->panel().explanations().of(panel::Explanations::Answers99);
        QCOMPARE(told.value.toDouble(),
                 std::round(static_cast<double>(latency.percentile(0.99).count()) / 100.0) / 10);
        const auto rank = static_cast<qulonglong>(std::ceil(0.99 * static_cast<double>(latency.count())));
        QString numbers = told.numbers;
        QCOMPARE(numbers.remove(u','),
                 QStringLiteral("time of response %1 of %2").arg(rank).arg(latency.count()));
        QVERIFY2(textOf("explanationText").contains(QStringLiteral("at 50 % of their number")),
                 qPrintable(textOf("explanationText")));
        tap("sheetClose");
        m_window->hold(QStringLiteral("figuresExchanges"));
        QVERIFY2(textOf("explanationText").contains(QStringLiteral(" s / ")),
                 qPrintable(textOf("explanationText")));
    }

    // A screen reader speaks the panel's language; a control without a name is a fault of the screen.
    void everyControlHasAnAccessibleName()
    {
        QCOMPARE(accessibleNameOf("startKey"), QStringLiteral("Start"));
        m_window->panel().settings().set("display.language", QStringLiteral("zh_CN"));
        m_window->settle();
        QCOMPARE(accessibleNameOf("startKey"), QStringLiteral("启动"));
        const looks::ScreenLimits anySize;
        QCOMPARE(looks::checkScreen(m_window->root(), anySize, m_window->grab()), QStringList());
        QQuickItem* start = m_window->find(QStringLiteral("startKey"));
        QVERIFY(QQmlProperty(start, QStringLiteral("Accessible.name"), qmlContext(start)).write(QString()));
        const QStringList faults = looks::checkScreen(m_window->root(), anySize, m_window->grab());
        QCOMPARE(faults.size(), 1);
        QVERIFY2(faults.constFirst().endsWith(QStringLiteral("has no accessible name")),
                 qPrintable(faults.constFirst()));
    }

    void textsThatShrinkBelowALimitAreFaults()
    {
        looks::ScreenLimits limits;
        limits.textPx = 10;
        QCOMPARE(looks::checkScreen(m_window->root(), limits, m_window->grab()), QStringList());
        QQuickItem* title = m_window->find(QStringLiteral("recipeTitle"));
        QQmlProperty(title, QStringLiteral("minimumPixelSize")).write(6);
        QQmlProperty(title, QStringLiteral("width")).write(title->width() * 0.45);
        QCOMPARE(looks::checkScreen(m_window->root(), limits, m_window->grab()).size(), 1);
    }

    void unknownNumbersAreExplainedWithoutNumbers()
    {
        m_window->link().show(looks::DemoLink::Situation::Empty);
        m_window->settle();
        const panel::Explanations& explanations = m_window->panel().explanations();
        for (int quantity = panel::Explanations::Rate; quantity <= panel::Explanations::AnswerAllowance;
             ++quantity) {
            if (quantity >= panel::Explanations::FastestRate &&
                quantity <= panel::Explanations::PeakFrequency)
                continue; // of the recipe, thus known
            const panel::Explanation told = explanations.of(quantity);
            QVERIFY(!told.title.isEmpty() && !told.meaning.isEmpty() && !told.formula.isEmpty());
            QVERIFY2(told.numbers.isEmpty(), qPrintable(told.text()));
            QVERIFY2(!told.text().contains(QStringLiteral("nan")), qPrintable(told.text()));
        }
    }

    void everyLookIsEachOfThemTogether()
    {
        constexpr qsizetype languagesThemesSizesGloves = 4 * 3 * 4 * 2;
        QCOMPARE(namesOf("*").size(), languagesThemesSizesGloves);
    }

    void looksAreNamedByPatterns()
    {
        QCOMPARE(namesOf("light-en-1024x600"), QSet{QStringLiteral("light-en-1024x600")});
        QCOMPARE(namesOf("light-en-*,light-zh_CN-*").size(), 16);
        QCOMPARE(namesOf("*-800x480,dark-*").size(), 12 + 32 - 4);
        QCOMPARE(namesOf("light-fr-*"), QSet<QString>());
        constexpr qsizetype usualInEachSize = 7;
        QCOMPARE(namesOf("usual").size(), 4 * usualInEachSize);
        QCOMPARE(namesOf("usual,light-zh_CN-1024x600-gloves").size(), 4 * usualInEachSize + 1);
        QCOMPARE(looks::screensNamed(QStringLiteral("run,motion")).size(), 2);
    }

    void everyLanguageAndSizeIsInASelfTest()
    {
        const QSet<QString> tested = namesOf(CAMPANEL_SELF_TESTS);
        for (const looks::Variant& variant : looks::variantsNamed(QStringLiteral("*"))) {
            const looks::Variant plain{variant.language, QStringLiteral("light"), variant.size};
            const bool isRoomy = variant.size.width() == 1920 && variant.language != u"en";
            QVERIFY2(variant.isLong() || isRoomy || tested.contains(plain.name()), qPrintable(plain.name()));
        }
    }

    void everyCalmScreenIsThere()
    {
        const QStringList calm = looks::calmScreens();
        QCOMPARE(looks::screensNamed(calm.join(u',')).size(), calm.size());
    }

    void redAndAmberAreCounted()
    {
        QImage picture(200, 100, QImage::Format_RGB32);
        picture.fill(QColor(0x0A6C9E));
        QCOMPARE(looks::checkCalm(picture), QStringList());
        for (const char* alarm : {"#B3261E", "#8F5500", "#F0B03F", "#FF8A8A"}) {
            QPainter(&picture).fillRect(0, 0, 20, 20, QColor(QLatin1String(alarm)));
            QCOMPARE(looks::checkCalm(picture).size(), 1);
        }
    }

    void everyLookIsInOneTest()
    {
        const QStringList tests = QStringLiteral(CAMPANEL_EVERY_VARIANT_TESTS).split(u' ');
        for (const QString& name : namesOf("*")) {
            const auto times = std::ranges::count_if(
                tests, [&name](const QString& test) { return namesOf(test).contains(name); });
            QVERIFY2(times == 1, qPrintable(name));
        }
    }

    void longerTextsKeepTheirValues()
    {
        QCOMPARE(looks::longText(QStringLiteral("Run")), QStringLiteral("[Rüñ]"));
        const QString text = QStringLiteral("%1 to %L2 of %n bags, now %3 %");
        const QString longer = looks::longText(text);
        for (const char* value : {"%1", "%L2", "%n", "%3 %"})
            QVERIFY2(longer.contains(QLatin1String(value)), qPrintable(longer));
        QCOMPARE(longer.size(), (7 * text.size() + 4) / 5);
    }

    void picturesDifferByWhatAPersonSees()
    {
        QImage wanted(200, 100, QImage::Format_RGB32);
        wanted.fill(Qt::white);
        QImage found = wanted;
        found.setPixel(20, 20, qRgb(200, 200, 200)); // a glyph's rim
        QVERIFY(looks::differenceOf(wanted, found).isNone());
        QPainter(&found).fillRect(64, 32, 16, 8, Qt::black);
        const looks::PictureDifference difference = looks::differenceOf(wanted, found);
        QCOMPARE(difference.squares, 2);
        QCOMPARE(difference.around, QRect(64, 32, 16, 8));
        QCOMPARE(difference.picture.size(), found.size());
        QVERIFY(looks::differenceOf(wanted, found.copy(0, 0, 100, 100)).isOtherSize);
    }
};

CAMPANEL_TEST(TestLooks)

} // namespace test_looks

#include "test_looks.moc"
