// SPDX-License-Identifier: Apache-2.0
// The inputs of every kind but the cutter on each size of screen: in groups, all within reach, none scrolled.
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_inputs {

using campanel::looks::Variant;
using campanel::panel::EditorField;

class TestPanelInputs : public campanel::test::PanelTest {
    Q_OBJECT

    // Returns the names of the inputs on the screen; complains about a list that has to be scrolled.
    QStringList inputsInSight()
    {
        QStringList names;
        const QQuickItem* list = m_window->find(QStringLiteral("inputList"));
        if (!list || list->property("contentHeight").toReal() > list->height())
            return {QStringLiteral("a list that scrolls")};
        QStringList wanted{QStringLiteral("lawButton"), QStringLiteral("knotsButton"),
                           QStringLiteral("segmentsButton")};
        for (int choice = 0; choice < editor().choices()->count(); ++choice) {
            if (editor().choices()->row(choice).group == QStringLiteral("tools"))
                continue;
            wanted << QStringLiteral("choice%1").arg(choice);
        }
        for (const QVariant& field : editor().fields())
            wanted << QStringLiteral("field_") + field.value<EditorField*>()->fieldId();
        for (const QString& name : wanted) {
            if (m_window->find(name))
                names << name;
        }
        return names;
    }

    // Returns the names of all inputs that the program has now.
    QStringList allInputs()
    {
        QStringList names;
        if (editor().hasLaw())
            names << QStringLiteral("lawButton");
        for (int choice = 0; choice < editor().choices()->count(); ++choice) {
            if (editor().choices()->row(choice).group == QStringLiteral("tools"))
                continue;
            names << QStringLiteral("choice%1").arg(choice);
        }
        for (const QVariant& field : editor().fields()) {
            if (field.value<EditorField*>()->visible())
                names << QStringLiteral("field_") + field.value<EditorField*>()->fieldId();
        }
        return names;
    }

private slots:
    void everyInputIsReachedWithoutScrolling_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("gloves");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("groups");
        for (const bool gloves : {false, true}) {
            for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
                const auto add = [&](const char* kind, int key, int groups) {
                    QTest::addRow("%s %dx%d%s", kind, size.width(), size.height(), gloves ? " gloves" : "")
                        << size << gloves << key << groups;
                };
                add("position move", 2, 2);
                add("speed move", 3, 2);
                add("point cam", 4, 3);
                add("press", 5, 3);
                add("segment cam", 6, 3);
            }
        }
    }

    void everyInputIsReachedWithoutScrolling()
    {
        QFETCH(QSize, size);
        QFETCH(bool, gloves);
        QFETCH(int, kind);
        QFETCH(int, groups);
        m_window = std::make_unique<campanel::looks::TestWindow>(
            Variant{QStringLiteral("en"), QStringLiteral("light"), size, gloves});
        m_window->panel().settings().set("display.gloves", campanel::panel::settingText(gloves));
        editor().newProgram(kind);
        tap("nav_motion");
        QStringList reached = inputsInSight();
        if (m_window->find(QStringLiteral("nextGroup"))) {
            for (int group = 1; group < groups; ++group) {
                tap("nextGroup");
                reached += inputsInSight();
            }
            tap("nextGroup"); // the first one again
            QVERIFY(reached.contains(inputsInSight().value(0)));
        } else {
            QVERIFY2(size != QSize(800, 480) || kind == 2, "all inputs at once need a larger screen");
        }
        reached.removeAll(QStringLiteral("knotsButton"));
        reached.removeAll(QStringLiteral("segmentsButton"));
        reached.sort();
        QStringList expected = allInputs();
        expected.sort();
        QCOMPARE(reached, expected);
    }
};

CAMPANEL_TEST(TestPanelInputs)

} // namespace test_panel_inputs

#include "test_panel_inputs.moc"
