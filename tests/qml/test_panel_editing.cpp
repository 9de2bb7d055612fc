// SPDX-License-Identifier: Apache-2.0
// Editing by touch: the page of the inputs stays, a compared law is seen and ends, no text leaves its field.
#include "panel_test.h"

#include "tests/support/test_program.h"

#include <QJSValue>
#include <QQuickWindow>

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
    static void addSizes()
    {
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)})
            QTest::addRow("%dx%d", size.width(), size.height()) << size;
    }

private slots:
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
