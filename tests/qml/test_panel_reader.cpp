// SPDX-License-Identifier: Apache-2.0
// A screen reader is told the values, the state of the machine, alarms, and nothing of a page that was
// left.
#include "panel_test.h"
#include "tests/support/test_program.h"

#include <QAccessible>

#include <algorithm>

namespace test_panel_reader {

using namespace Qt::StringLiterals;
using Situation = campanel::looks::DemoLink::Situation;

struct Told {
    QAccessible::Role role;
    QString name;
    QString description;
};

class TestPanelReader : public campanel::test::PanelTest {
    Q_OBJECT

    static void collect(QAccessibleInterface* from, QList<Told>& told)
    {
        if (!from || from->state().invisible)
            return;
        told << Told{from->role(), from->text(QAccessible::Name), from->text(QAccessible::Description)};
        for (int i = 0; i < from->childCount(); ++i)
            collect(from->child(i), told);
    }
    // Returns what is told of the present screen.
    [[nodiscard]] QList<Told> told()
    {
        m_window->settle();
        QList<Told> all;
        collect(QAccessible::queryAccessibleInterface(&m_window->window()), all);
        return all;
    }
    [[nodiscard]] bool isTold(QAccessible::Role role, const QString& name, const QString& description = {})
    {
        const QList<Told> all = told();
        return std::ranges::any_of(all, [&](const Told& each) {
            return each.role == role && each.name == name &&
                   (description.isEmpty() || each.description == description);
        });
    }

private slots:
    void valuesAndTheStateAreTold()
    {
        m_window->link().show(Situation::Running);
        QVERIFY(isTold(QAccessible::StaticText, u"Running"_s));
        QVERIFY(isTold(QAccessible::StaticText, u"Biscuit 250 · v1"_s));
        QVERIFY(isTold(QAccessible::StaticText, u"250.0 mm"_s));
        tap("nav_motion");
        QVERIFY(isTold(QAccessible::Button, u"Bag length"_s, u"250.0 mm"_s));
        tap("nav_settings");
        QVERIFY(isTold(QAccessible::Button, u"Language"_s, u"English"_s));
    }

    void aFaultIsAnAlert()
    {
        m_window->link().show(Situation::Fault);
        const QList<Told> all = told();
        QVERIFY(std::ranges::any_of(all, [](const Told& each) {
            return each.role == QAccessible::AlertMessage && each.name.startsWith(u"The axis cannot follow");
        }));
    }

    void aPageThatWasLeftIsNotTold()
    {
        tap("nav_motion");
        QVERIFY(isTold(QAccessible::Button, u"Bag length"_s));
        tap("nav_alarms");
        QVERIFY(!isTold(QAccessible::Button, u"Bag length"_s));
    }

    void aPictureIsToldInWords()
    {
        m_window->link().show(Situation::Running);
        for (const char* name :
             {"nav_maintenance", "maintenanceMachine", "maintenancePacking", "packingEdges"})
            tap(name);
        const QList<Told> all = told();
        QVERIFY(std::ranges::any_of(all, [](const Told& each) {
            return each.role == QAccessible::Graphic && each.name == u"Edges of the mark sensor"_s &&
                   each.description.startsWith(u"60 edges (taken: ");
        }));
    }

    void everyButtonHasAName()
    {
        for (const char* page : {"nav_run", "nav_motion", "nav_recipes", "nav_trends", "nav_alarms",
                                 "nav_maintenance", "nav_settings"}) {
            tap(page);
            for (const Told& each : told())
                QVERIFY2(each.role != QAccessible::Button || !each.name.isEmpty(), page);
        }
    }
};

CAMPANEL_TEST(TestPanelReader)

} // namespace test_panel_reader

#include "test_panel_reader.moc"
