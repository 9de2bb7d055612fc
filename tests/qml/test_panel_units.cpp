// SPDX-License-Identifier: Apache-2.0
// Every text of every page and dialog in inches, except where something is shown as it is stored.
#include "panel_test.h"

#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>

#include <array>

namespace test_panel_units {

using namespace campanel;
using namespace Qt::StringLiterals;

namespace {

struct Metric {
    const char* screens; // shell pattern of looks::Screen::name
    const char* texts;   // regular expression
    const char* reason;
};

constexpr std::array metricTexts{
    Metric{"*register*", ".*", "registers are shown as the controller has them"},
    Metric{"*frame*", ".*", "frames are shown as they went over the line"},
    Metric{"*audit*", ".*", "an entry shows what was recorded"},
    Metric{"*", "^mm, mm/s, m/s²$", "the choice of the units names them"},
    Metric{"*", "\\n= .* = ", "formulas are metric; the result is given in both"},
    Metric{"*", "pulses per mm", "a quantity of a formula"},
    Metric{"*", "s in mm and t in ms", "the polynomial of the paper"},
};

bool isMetricByReason(const QString& screen, const QString& text)
{
    return std::ranges::any_of(metricTexts, [&](const Metric& each) {
        return QRegularExpression(
                   QRegularExpression::wildcardToRegularExpression(QString::fromUtf8(each.screens)))
                   .match(screen)
                   .hasMatch() &&
               QRegularExpression(QString::fromUtf8(each.texts)).match(text).hasMatch();
    });
}

void collect(const QQuickItem& item, QStringList& texts)
{
    if (!item.isVisible())
        return;
    for (const char* name : {"text", "positionUnit", "lengthUnit"}) {
        if (const QVariant text = item.property(name); text.typeId() == QMetaType::QString)
            texts << text.toString();
    }
    if (item.inherits("campanel::plot::CurvePlot"))
        texts << item.property("titles").toStringList();
    for (const QQuickItem* child : item.childItems())
        collect(*child, texts);
}

} // namespace

class TestPanelUnits : public test::PanelTest {
    Q_OBJECT

private slots:
    void everyTextIsInInches()
    {
        const QRegularExpression metric(uR"((?<![A-Za-z])mm(?![A-Za-z])|\dm\b|m/s[²³])"_s);
        const QRegularExpression inch(uR"(\d\x{a0}in\b)"_s);
        // A window of its own: some screens type millimeters, and do not come to what is behind a refusal.
        looks::TestWindow window(looks::Variant{u"en"_s, u"light"_s, QSize(1024, 600)});
        window.panel().settings().set("display.units", u"inch"_s);
        QSet<QString> found;
        int inches = 0;
        for (const looks::Screen& screen : looks::allScreens()) {
            looks::enterScreen(window, screen);
            QStringList texts;
            collect(window.root(), texts);
            for (const QString& text : std::as_const(texts)) {
                inches += text.contains(inch);
                if (text.contains(metric) && !isMetricByReason(screen.name, text))
                    found << screen.name + u": "_s + text;
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(QStringList(found.values()).join(u'\n')));
        QVERIFY(inches > 100);
    }

    // The switch acts at once on a page that is open.
    void theUnitsChangeLive()
    {
        show(looks::DemoLink::Kind::RotaryCutter);
        tap("nav_settings");
        tap("section0");
        tap("unitsChoice");
        tap("choice_inch");
        tap("nav_motion");
        QCOMPARE(editor().bagLength()->unit(), u"in"_s);
        const QQuickItem* tile = m_window->find(u"field_bag_length_mm"_s);
        QVERIFY(tile);
        QCOMPARE(tile->property("unit").toString(), u"in"_s);
        tap("field_bag_length_mm");
        m_window->type(u"7.0866"_s);
        tap("keypadAccept");
        QCOMPARE(editor().recipe().cutter().bagLengthMm, 180.0);
        QCOMPARE(tile->property("value").toString(), u"7.0866"_s);
        m_window->panel().settings().set("display.units", u"metric"_s);
        m_window->settle();
        QCOMPARE(tile->property("value").toString(), u"180.0"_s);
        QCOMPARE(tile->property("unit").toString(), u"mm"_s);
    }

    // A knife turns one way for ever: its place is an angle, and what moves has its speed before its pulses.
    void aKnifeHasAnAngle()
    {
        show(looks::DemoLink::Kind::RotaryCutter);

        for (const looks::Screen& screen : looks::screensNamed(u"jog"_s))
            looks::enterScreen(*m_window, screen);
        QCOMPARE(propertyOf("jogPosition", "unit"), u"°"_s);
        QVERIFY(textOf("jogPosition").toDouble() < 360);
        const QString speeds = plain(propertyOf("jogState", "title"));
        QVERIFY2(QRegularExpression(uR"(^[\d.]+ mm/s · [\d,]+ Hz$)"_s).match(speeds).hasMatch(),
                 qPrintable(speeds));
        QVERIFY2(QRegularExpression(uR"(^[\d.]+ mm/s · [\d,]+ Hz$)"_s)
                     .match(plain(propertyOf("jogSpeed", "value")))
                     .hasMatch(),
                 qPrintable(propertyOf("jogSpeed", "value")));
    }

    // The report has what the screen has.
    void theReportIsInInches()
    {
        m_window->panel().settings().set("display.units", u"inch"_s);
        QString texts;
        const panel::ReportData data = m_window->panel().commissioning().data();
        for (const panel::ReportSection& section : data.sections) {
            for (const auto& [label, value] : section.rows)
                texts += label + u' ' + value + u'\n';
            texts += section.lines.join(u'\n');
        }
        texts += data.titles.join(u'\n');
        QVERIFY2(!texts.contains(QRegularExpression(uR"((?<![A-Za-z])mm(?![A-Za-z]))"_s)), qPrintable(texts));
        QVERIFY(texts.contains(u"in\n"_s));
        QVERIFY(data.titles.first().endsWith(u"in/s"_s));
        QVERIFY(data.factors.first() < 0.04);
    }
};

CAMPANEL_TEST(TestPanelUnits)

} // namespace test_panel_units

#include "test_panel_units.moc"
