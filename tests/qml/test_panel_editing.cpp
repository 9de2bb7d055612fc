// SPDX-License-Identifier: Apache-2.0
// Editing by touch: the halves of Motion, the page of the inputs stays, a compared law is seen and ends, no
// text leaves its field.
#include "panel_test.h"

#include "tests/support/test_program.h"

#include <QJSValue>
#include <QQuickWindow>

#include <array>

namespace test_panel_editing {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelEditing : public test::PanelTest {
    Q_OBJECT

    void open(const QSize& size, int kind, const QString& language = u"en"_s)
    {
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{language, u"light"_s, size});
        editor().newProgram(kind);
        tap("nav_motion");
    }
    // Returns the texts below the item that are wider than their place or smaller than a person reads.
    static QStringList badTexts(const QQuickItem& below)
    {
        QStringList bad;
        if (!below.isVisible())
            return bad;
        const double smallestPx = below.window()->width() < 1000 ? 10 : 12;
        const QString text = below.property("text").toString();
        if (below.inherits("QQuickText") && !text.isEmpty()) {
            const double size =
                below.property("fontInfo").value<QJSValue>().property(u"pixelSize"_s).toNumber();
            if (below.property("contentWidth").toDouble() > below.width() + 1 || size < smallestPx)
                bad << u"%1: %2 px, %3 wide in %4"_s.arg(text)
                           .arg(size)
                           .arg(below.property("contentWidth").toDouble())
                           .arg(below.width());
        }
        for (const QQuickItem* child : below.childItems())
            bad += badTexts(*child);
        return bad;
    }
    QRectF placeOf(const char* name)
    {
        const QQuickItem* item = m_window->find(QString::fromLatin1(name));
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }
    QStringList missing(const QStringList& names)
    {
        QStringList found;
        for (const QString& name : names) {
            if (!m_window->find(name))
                found << name;
        }
        return found;
    }
    static void addSizes()
    {
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)})
            QTest::addRow("%dx%d", size.width(), size.height()) << size;
    }

private slots:
    void eachHalfHasItsNumbers_data()
    {
        addSizes();
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }
    // The operator has length, rate and what is possible; the technician every field beside the three curves.
    void eachHalfHasItsNumbers()
    {
        QFETCH(QSize, size);
        const QStringList both{u"field_bag_length_mm"_s, u"field_rate_bags_per_min"_s, u"more"_s,
                               u"nextStep"_s};
        const QStringList curves{u"field_base_speed_mm_per_s"_s, u"field_film_speed_mm_per_s"_s, u"ratios"_s,
                                 u"lawButton"_s, u"motionPlot"_s};
        const QStringList bar{u"rateScale"_s, u"rateLimit"_s, u"rateMost"_s, u"curvesButton"_s};
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{u"en"_s, u"light"_s, size});
        m_window->setLevel(panel::Level::Operator);
        tap("nav_motion");
        QCOMPARE(missing(both + bar), QStringList());
        QCOMPARE(missing(curves), curves);
        const std::array places{placeOf("more"), placeOf("nextStep")};
        tap("curvesButton");
        QCOMPARE(missing(both + curves), QStringList());
        QCOMPARE(missing(bar), bar);
        QCOMPARE(placeOf("more").center(), places[0].center());
        QCOMPARE(placeOf("nextStep"), places[1]);
        const QStringList quantities = m_window->find(u"motionPlot"_s)->property("quantities").toStringList();
        QCOMPARE(quantities, QStringList({u"velocity"_s, u"acceleration"_s, u"frequency"_s}));
        tap("nav_motion"); // the key of the page leads to its beginning
        QCOMPARE(missing(both + bar), QStringList());
        m_window->setLevel(panel::Level::Technician);
        QCOMPARE(missing(bar), QStringList()); // nothing moves because somebody logs in
        tap("nav_motion");
        QCOMPARE(missing(curves), QStringList());
        tap("more");
        tap("operatorHalf");
        QCOMPARE(missing(both + bar), QStringList());
    }

    // A length that is typed moves the end of the bar, and what sets it is marked in the drawing.
    void theBarFollowsTheLength()
    {
        m_window->setLevel(panel::Level::Operator);
        tap("nav_motion");
        QCOMPARE(textOf("rateMost"), u"up to 303.5"_s);
        QCOMPARE(textOf("rateSet"), u"60.0 bags/min"_s);
        QCOMPARE(textOf("rateLimit"), u"Limit: Max. acceleration 50000 mm/s²"_s);
        QCOMPARE(propertyOf("machineDrawing", "fieldId"), u"max_knife_acceleration_mm_per_s2"_s);
        tap("field_bag_length_mm");
        m_window->type(u"320"_s);
        tap("keypadAccept");
        QCOMPARE(textOf("rateMost"), u"up to 400.0"_s);
        QCOMPARE(propertyOf("machineDrawing", "fieldId"), u"max_rate_bags_per_min"_s);
        tap("undo");
        QCOMPARE(textOf("rateMost"), u"up to 303.5"_s);
        QVERIFY(editor().feasible());
        editor().rate()->set(390);
        m_window->settle();
        QVERIFY(!editor().feasible());
        QCOMPARE(textOf("rateSet"), u"390.0 bags/min"_s);
        QVERIFY(propertyOf("rateScale", "setColor") != propertyOf("rateScale", "fill"));
        tap("nextStep"); // the nearest possible rate
        QVERIFY(editor().feasible());
    }

    // No other kind has a number for operators.
    void anOperatorSeesTheCurvesOfTheOtherKinds()
    {
        for (const int kind : {2, 3, 4, 5, 6}) {
            open(QSize(800, 480), kind);
            m_window->setLevel(panel::Level::Operator);
            tap("nav_motion");
            QVERIFY2(m_window->find(u"motionPlot"_s), qPrintable(QString::number(kind)));
            QVERIFY(!m_window->find(u"rateScale"_s));
            tap("more");
            QVERIFY(!m_window->find(u"operatorHalf"_s));
        }
    }

    void theCurveOfTheControllerIsNamed()
    {
        tap("nav_motion");
        QVERIFY(!m_window->find(u"overlayName"_s));
        editor().bagLength()->set(240);
        m_window->settle();
        QCOMPARE(textOf("overlayName"), u"running"_s);
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->settle();
        QCOMPARE(textOf("overlayName"), u"in the controller"_s);
        editor().compareLaw(u"harmonic"_s);
        m_window->settle();
        QCOMPARE(textOf("overlayName"), u"Harmonic"_s);
        editor().compareLaw({});
        editor().newProgram(2); // the controller has a cutter's
        m_window->settle();
        QVERIFY(!m_window->find(u"overlayName"_s));
    }

    void theOpenInputsStay_data() { addSizes(); }
    // In each group of each kind each choice is made: the group that shows it stays.
    void theOpenInputsStay()
    {
        QFETCH(QSize, size);
        for (const int kind : {2, 3, 4, 5, 6}) {
            open(size, kind);
            for (int choice = 0; choice < editor().choices()->count(); ++choice) {
                if (editor().choices()->row(choice).group == u"tools")
                    continue;
                const QString name = u"choice%1"_s.arg(choice);
                for (int group = 0; group < 4 && !m_window->find(name); ++group)
                    tap("nextGroup");
                QVERIFY2(m_window->find(name), qPrintable(u"kind %1: %2"_s.arg(kind).arg(name)));
                const panel::ChoiceRow row = editor().choices()->rows()[choice];
                for (int option = 0; option < row.options.size(); ++option) {
                    m_window->tap(name);
                    m_window->tap(u"choice_%1"_s.arg(option));
                    QVERIFY2(m_window->find(name),
                             qPrintable(u"kind %1: %2 is gone after option %3"_s.arg(kind).arg(row.name).arg(
                                 option)));
                }
            }
        }
    }

    void aRestoredRecipeSaysSoAndComesBack()
    {
        open(QSize(1024, 600), 1);
        editor().bagLength()->set(240);
        tap("more");
        tap("restoreStored");
        QVERIFY(!editor().edited());
        QVERIFY2(textOf("bannerText").startsWith(u"Restored the stored recipe"_s),
                 qPrintable(textOf("bannerText")));
        tap("undo");
        QCOMPARE(editor().bagLength()->value(), 240.0);
    }

    void aComparedLawIsSeenAndEnds()
    {
        open(QSize(1024, 600), 2);
        tap("lawButton");
        m_window->hold(u"law_cubic"_s);
        const QQuickItem* curves = m_window->find(u"lawCurves"_s);
        QVERIFY2(curves, "the curves of both laws stand beside the laws");
        QVERIFY(curves->property("overlayCurves").isValid());
        tap("endComparison");
        QVERIFY(!m_window->find(u"lawCurves"_s));
        QVERIFY(editor().overlayName().isEmpty());
        m_window->hold(u"law_cubic"_s);
        QVERIFY(m_window->find(u"lawCurves"_s));
        tap("sheetClose");
        QVERIFY2(editor().overlayName().isEmpty(), "a comparison ends with its sheet");
        editor().compareLaw(u"cubic"_s);
        editor().revert();
        QVERIFY2(editor().overlayName().isEmpty(), "nothing survives Restore");
    }

    void noTextLeavesItsField_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("language");
        for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
            for (const QString& language : {u"en"_s, u"de"_s, u"zh_CN"_s})
                QTest::addRow("%s %dx%d", qPrintable(language), size.width(), size.height())
                    << size << language;
        }
    }
    void noTextLeavesItsField()
    {
        QFETCH(QSize, size);
        QFETCH(QString, language);
        open(size, 6, language);
        tap("segmentsButton");
        const qsizetype motions = editor().segments()->motions().size();
        for (qsizetype motion = 0; motion < motions; ++motion) {
            editor().segments()->setMotion(static_cast<int>(motion));
            m_window->settle();
            QStringList bad;
            for (const char* name : {"segmentMotion", "segment0", "segment1"}) {
                if (const QQuickItem* row = m_window->find(QString::fromLatin1(name)))
                    bad += badTexts(*row);
            }
            QVERIFY2(bad.isEmpty(), qPrintable(bad.join(u'\n')));
        }
    }
};

CAMPANEL_TEST(TestPanelEditing)

} // namespace test_panel_editing

#include "test_panel_editing.moc"
