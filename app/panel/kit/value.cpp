// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/value.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

Value::Value(QObject* parent)
    : QObject(parent)
{
    LanguageNotifier::follow(this);
}

QString Value::check(double value) const
{
    if (!std::isfinite(value))
        return tr("Enter a number.");
    const double halfStep = std::pow(10.0, -decimals()) / 2;
    const auto limit = [this](double number) {
        return Format::joined(Format().compact(number, 0, decimals()), unit());
    };
    if (value < minimum() - halfStep)
        return tr("The minimum is %1.").arg(limit(minimum()));
    if (value > maximum() + halfStep)
        return tr("The maximum is %1.").arg(limit(maximum()));
    return {};
}

void Value::set(double value)
{
    if (!check(value).isEmpty())
        return;
    if (!shown().isConverted())
        emit setRequested(value);
    else
        emit setRequested(std::clamp(Units::typed(value, m_view.unit, m_view.decimals, m_view.value),
                                     m_view.minimum, m_view.maximum));
}

void Value::step(double by)
{
    const double digit = std::pow(10.0, -decimals());
    set(std::clamp(std::round((shownValue() + by) / digit) * digit, minimum(), maximum()));
}

bool Value::isInRange(double metric) const
{
    const double halfStep = std::pow(10.0, -m_view.decimals) / 2;
    return metric >= m_view.minimum - halfStep && metric <= m_view.maximum + halfStep;
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
