// SPDX-License-Identifier: Apache-2.0
// Inches on the screen: what is typed in them is stored in mm, and what nobody changes stays as it is.
#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/refusal_sentences.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_units {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::EditorField;
using panel::Format;
using panel::Units;

namespace {

// The number that the field shows, as a person reads and types it.
double readBack(const panel::Value& value)
{
    return QString(value.text()).replace(QChar(0x2212), u'-').toDouble();
}

} // namespace

class TestUnits : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }
    void cleanup() { Units::setInch(false); }

    // A step is one of the shown unit, and ends at the limits.
    void aValueIsStepped()
    {
        panel::Value value;
        const auto show = [&value](double metric) {
            panel::ValueView view;
            view.unit = u"mm"_s;
            view.minimum = 10;
            view.maximum = 2000;
            view.decimals = 1;
            view.value = metric;
            value.show(view);
        };
        connect(&value, &panel::Value::setRequested, this, show);
        show(180);
        value.step(0.1);
        QCOMPARE(value.value(), 180.1);
        value.step(-1000);
        QCOMPARE(value.value(), 10.0);
        value.step(1e6);
        QCOMPARE(value.value(), 2000.0);
        Units::setInch(true);
        show(254);
        value.step(1);
        QCOMPARE(value.value(), 279.4);
    }

    void measures_data()
    {
        QTest::addColumn<double>("metric");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("inMetric");
        QTest::addColumn<QString>("inInch");
        QTest::newRow("length") << 180.0 << 1 << u"mm"_s << u"180.0 mm"_s << u"7.0866 in"_s;
        QTest::newRow("deviation") << 0.01 << 2 << u"mm"_s << u"0.01 mm"_s << u"0.0004 in"_s;
        QTest::newRow("speed") << 80.0 << 1 << u"mm/s"_s << u"80.0 mm/s"_s << u"3.150 in/s"_s;
        QTest::newRow("limit") << 50000.0 << 0 << u"mm/s²"_s << u"50,000 mm/s²"_s << u"1968.5 in/s²"_s;
        QTest::newRow("acceleration") << 12.7 << 2 << u"m/s²"_s << u"12.70 m/s²"_s << u"500.0 in/s²"_s;
        QTest::newRow("film") << 30.48 << 1 << u"m"_s << u"30.5 m"_s << u"100.0 ft"_s;
        QTest::newRow("slope") << 2.54 << 2 << u"mm/°"_s << u"2.54 mm/°"_s << u"0.1000 in/°"_s;
        QTest::newRow("angle") << 90.0 << 1 << u"°"_s << u"90.0°"_s << u"90.0°"_s;
        QTest::newRow("rate") << 80.0 << 1 << u"bags/min"_s << u"80.0 bags/min"_s << u"80.0 bags/min"_s;
        QTest::newRow("unknown") << qQNaN() << 1 << u"mm"_s << u"--"_s << u"--"_s;
    }
    void measures()
    {
        QFETCH(const double, metric);
        QFETCH(const int, decimals);
        QFETCH(const QString, unit);
        QTEST(Format().measure(metric, decimals, unit), "inMetric");
        Units::setInch(true);
        QTEST(Format().measure(metric, decimals, unit), "inInch");
    }

    void aLengthIsTypedInInches()
    {
        test::PanelRig rig;
        rig.settings.set("display.units", u"inch"_s);
        EditorField& length = *rig.editor.bagLength();
        QCOMPARE(length.unit(), u"in"_s);
        QCOMPARE(length.decimals(), 4);
        length.set(7.0866);
        QCOMPARE(rig.editor.recipe().cutter().bagLengthMm, 180.0);
        QCOMPARE(length.text(), u"7.0866"_s);
        length.set(7.25); // no tenth of a millimeter
        QVERIFY(std::abs(rig.editor.recipe().cutter().bagLengthMm - 184.15) < 0.5e-4 * 25.4);
        QCOMPARE(length.text(), u"7.2500"_s);
        QCOMPARE(length.check(200), u"The maximum is 78.7402 in."_s);
        length.set(length.maximum());
        QCOMPARE(rig.editor.recipe().cutter().bagLengthMm, 2000.0);
        rig.settings.set("display.units", u"metric"_s);
        QCOMPARE(length.unit(), u"mm"_s);
        QCOMPARE(length.text(), u"2000.0"_s);
    }

    // Each number of each kind is confirmed as it is shown; nothing changes, to the last bit.
    void confirmingChangesNothing()
    {
        test::PanelRig rig;
        rig.settings.set("display.units", u"inch"_s);
        int converted = 0;
        for (int kind = 1; kind <= static_cast<int>(program::kinds().size()); ++kind) {
            rig.editor.newProgram(kind);
            const auto& info = program::kindInfo(static_cast<profile::ProgramKind>(kind));
            for (const auto fields : {info.programFields, info.machineFields}) {
                for (const profile::Field field : fields) {
                    EditorField& item = *rig.editor.field(QString::fromLatin1(profile::info(field).id));
                    // A derived number becomes an input when it is typed; one that is unknown has no text.
                    if (item.derived() || item.text() == Format::unknownText() || !item.shown().isConverted())
                        continue;
                    const program::Recipe before = rig.editor.recipe();
                    const double shown = readBack(item);
                    QCOMPARE(item.check(shown), QString());
                    item.set(shown);
                    ++converted;
                    QVERIFY2(panel::sameRecipe(rig.editor.recipe(), before), qPrintable(item.fieldId()));
                }
            }
        }
        QVERIFY(converted > 20);
    }

    void knotsAndSegmentsStay()
    {
        test::PanelRig rig;
        rig.settings.set("display.units", u"inch"_s);
        for (const auto kind : {profile::ProgramKind::PointCam, profile::ProgramKind::SegmentCam}) {
            rig.editor.newProgram(static_cast<int>(kind));
            panel::CamHandles& handles = *rig.editor.handles();
            for (int i = 0; i < handles.count(); ++i) {
                handles.select(i);
                for (panel::Value* value : valuesOf(rig.editor, kind)) {
                    if (!value->shown().isConverted())
                        continue;
                    const program::Recipe before = rig.editor.recipe();
                    value->set(readBack(*value));
                    QVERIFY2(panel::sameRecipe(rig.editor.recipe(), before), qPrintable(value->label()));
                }
            }
        }
    }

    void theToleranceStays()
    {
        test::PanelRig rig;
        rig.settings.set("display.units", u"inch"_s);
        panel::SettingField& tolerance = *rig.settings.setting(u"bags.tolerance_mm"_s);
        QCOMPARE(tolerance.shown(), u"±0.0197 in"_s);
        tolerance.set(readBack(tolerance));
        QCOMPARE(rig.settings.bagToleranceMm(), 0.5);
        tolerance.set(0.01);
        QVERIFY(std::abs(rig.settings.bagToleranceMm() - 0.254) < 0.5e-4 * 25.4);
        QCOMPARE(tolerance.shown(), u"±0.0100 in"_s);
    }

    void sentencesHaveInches()
    {
        test::PanelRig rig;
        QVERIFY(panel::RefusalSentences::valueWithUnit(profile::Field::BagLength, 250).endsWith(u" mm"));
        rig.settings.set("display.units", u"inch"_s);
        QCOMPARE(panel::RefusalSentences::valueWithUnit(profile::Field::BagLength, 250), u"9.8425 in"_s);
        // Two numbers of one sentence differ in inches too.
        QVERIFY(panel::RefusalSentences::valueWithUnit(profile::Field::BagLength, 250, 250.001) !=
                panel::RefusalSentences::valueWithUnit(profile::Field::BagLength, 250.001, 250));
    }

private:
    static QList<panel::Value*> valuesOf(panel::Editor& editor, profile::ProgramKind kind)
    {
        QList<panel::Value*> values;
        if (kind == profile::ProgramKind::PointCam)
            return {editor.knots()->slave()};
        for (const QVariant& field : editor.segments()->fields())
            values << field.value<EditorField*>();
        return values;
    }
};

CAMPANEL_TEST(TestUnits)

} // namespace test_units

#include "test_units.moc"
