// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/value.h"

#include "app/panel/kit/format.h"

#include <cmath>

namespace campanel::panel {

QString Value::check(double value) const
{
    if (!std::isfinite(value))
        return tr("Enter a number.");
    const double halfStep = std::pow(10.0, -m_view.decimals) / 2;
    const auto limit = [this](double number) {
        const QString text = Format().compact(number, 0, m_view.decimals);
        return m_view.unit.isEmpty() ? text : text + QLatin1Char(' ') + m_view.unit;
    };
    if (value < m_view.minimum - halfStep)
        return tr("The minimum is %1.").arg(limit(m_view.minimum));
    if (value > m_view.maximum + halfStep)
        return tr("The maximum is %1.").arg(limit(m_view.maximum));
    return {};
}

void Value::set(double value)
{
    if (check(value).isEmpty())
        emit setRequested(value);
}

bool Value::show(const ValueView& view)
{
    if (m_view == view)
        return false;
    m_view = view;
    emit changed();
    return true;
}

} // namespace campanel::panel
