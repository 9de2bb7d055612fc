// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/editor_field.h"

#include "app/panel/kit/format.h"

#include <cmath>

namespace campanel::panel {

EditorField::EditorField(QString fieldId, QObject* parent)
    : QObject(parent)
    , m_fieldId(std::move(fieldId))
{
}

QString EditorField::check(double value) const
{
    if (!std::isfinite(value))
        return tr("Enter a number.");
    const double halfStep = std::pow(10.0, -m_view.decimals) / 2;
    const Format format;
    if (value < m_view.minimum - halfStep)
        return m_view.unit.isEmpty()
                   ? tr("The minimum is %1.").arg(format.compact(m_view.minimum, 0, m_view.decimals))
                   : tr("The minimum is %1 %2.")
                         .arg(format.compact(m_view.minimum, 0, m_view.decimals), m_view.unit);
    if (value > m_view.maximum + halfStep)
        return m_view.unit.isEmpty()
                   ? tr("The maximum is %1.").arg(format.compact(m_view.maximum, 0, m_view.decimals))
                   : tr("The maximum is %1 %2.")
                         .arg(format.compact(m_view.maximum, 0, m_view.decimals), m_view.unit);
    return {};
}

void EditorField::set(double value)
{
    if (check(value).isEmpty())
        emit setRequested(value);
}

void EditorField::togglePin()
{
    if (m_view.pinnable)
        emit pinToggleRequested();
}

void EditorField::show(FieldView view)
{
    if (m_view == view)
        return;
    m_view = std::move(view);
    emit changed();
}

} // namespace campanel::panel
