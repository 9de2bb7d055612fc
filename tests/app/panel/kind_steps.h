// SPDX-License-Identifier: Apache-2.0
// Shared steps of the editor tests for the kinds of program.
#pragma once

#include "panel_rig.h"

#include <QTest>

Q_DECLARE_METATYPE(std::shared_ptr<const campanel::profile::Curves>)

namespace campanel::test {

using panel::ChoiceModel;
using panel::Editor;
using panel::EditorField;
using panel::KnotModel;
using profile::Field;
using profile::ProgramKind;

inline QStringList idsOf(const QVariantList& fields)
{
    QStringList ids;
    for (const QVariant& each : fields)
        ids << each.value<EditorField*>()->fieldId();
    return ids;
}

inline int rowOf(const ChoiceModel& choices, const QString& name)
{
    for (int row = 0; row < choices.count(); ++row) {
        if (choices.row(row).name == name)
            return row;
    }
    return -1;
}

inline void choose(Editor& editor, const QString& name, const QString& option)
{
    const ChoiceModel& choices = *editor.choices();
    const int row = rowOf(choices, name);
    const QStringList options = choices.row(row).options;
    QVERIFY2(options.contains(option), qPrintable(options.join(", ")));
    editor.setChoice(row, static_cast<int>(options.indexOf(option)));
    QCOMPARE(choices.row(row).valueText(), option);
}

inline void enter(Editor& editor, Field field, double value)
{
    EditorField* item = editor.item(field);
    QVERIFY2(item->check(value).isEmpty(), qPrintable(item->check(value)));
    item->set(value);
    QCOMPARE(item->value(), value);
}

inline QString knotText(KnotModel& knots, int row)
{
    return knots.rows()->row(row).masterText + ' ' + knots.rows()->row(row).slaveText;
}

inline const profile::PointCamProgram& camOf(const Editor& editor)
{
    return std::get<profile::PointCamProgram>(editor.recipe().program);
}

inline void begin(PanelRig& rig, ProgramKind kind)
{
    rig.editor.newProgram(static_cast<int>(kind));
}

} // namespace campanel::test
