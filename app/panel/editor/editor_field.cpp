// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/editor_field.h"

#include <utility>

namespace campanel::panel {

EditorField::EditorField(QString fieldId, QObject* parent)
    : Value(parent)
    , m_fieldId(std::move(fieldId))
{
}

void EditorField::togglePin()
{
    if (m_view.pinnable)
        emit pinToggleRequested();
}

void EditorField::show(const FieldView& view)
{
    if (m_view == view)
        return;
    m_view = view;
    if (!Value::show(view))
        emit changed();
}

} // namespace campanel::panel
