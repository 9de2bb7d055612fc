// SPDX-License-Identifier: Apache-2.0
// The number being typed; see number_entry.h.
#include "number_entry.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace campanel::controls {
namespace {
constexpr QChar minusSign(0x2212);
constexpr QChar hyphen(u'-');
constexpr QChar point(u'.');
constexpr QChar backspaceKey(u'\b');
// In every language: a scale, a scanner or a person from elsewhere does not know that of the panel.
constexpr QStringView decimalSigns(u".,，．");
} // namespace

void NumberEntry::setLocale(const QString& name)
{
    if (m_locale == name)
        return;
    m_locale = name;
    emit changed();
}

void NumberEntry::setDecimals(int decimals)
{
    if (m_decimals == decimals)
        return;
    m_decimals = decimals;
    emit changed();
}

QString NumberEntry::text() const
{
    QString shown = m_typed;
    return shown.replace(point, decimalPoint()).replace(hyphen, minusSign);
}

QString NumberEntry::decimalPoint() const
{
    return QLocale(m_locale).decimalPoint();
}

bool NumberEntry::isComplete() const
{
    bool isNumber = false;
    (void)m_typed.toDouble(&isNumber);
    return isNumber && !hasUnwantedFraction();
}

bool NumberEntry::hasUnwantedFraction() const
{
    return m_decimals == 0 && m_typed.contains(point);
}

double NumberEntry::value() const
{
    bool isNumber = false;
    const double typed = m_typed.toDouble(&isNumber);
    return isNumber && !hasUnwantedFraction() ? typed : std::numeric_limits<double>::quiet_NaN();
}

bool NumberEntry::canBecome(double minimum, double maximum) const
{
    const double typed = std::abs(m_typed.toDouble());
    const double step = std::pow(10.0, -m_decimals);
    // The number grows to less than that of its last digit plus one.
    const auto reaches = [&](double from, double next) {
        const double to = std::max(from, next - step);
        return (to >= minimum && from <= maximum) || (minimum < 0 && -from >= minimum && -to <= maximum);
    };
    const auto pointAt = m_typed.indexOf(point);
    if (pointAt >= 0) // only its decimals grow
        return reaches(typed, typed + std::pow(10.0, -static_cast<double>(m_typed.size() - pointAt - 1)));
    double scale = 1;
    for (auto digits = m_typed.size() - m_typed.count(hyphen); digits <= maximumDigits;
         ++digits, scale *= 10) {
        if (reaches(typed * scale, (typed + 1) * scale))
            return true;
    }
    return false;
}

void NumberEntry::type(const QString& key)
{
    if (key.size() != 1)
        return;
    const QString before = m_typed;
    typeCharacter(key.front());
    if (m_typed != before)
        emit changed();
}

void NumberEntry::typeCharacter(QChar key)
{
    const auto pointAt = m_typed.indexOf(point);
    if (key >= u'0' && key <= u'9') {
        const auto digits = m_typed.size() - m_typed.count(point) - m_typed.count(hyphen);
        const bool decimalsFull = pointAt >= 0 && m_typed.size() - pointAt > m_decimals;
        if (m_typed == u"0" || m_typed == u"-0")
            m_typed.chop(1);
        if (digits < maximumDigits && !decimalsFull)
            m_typed += key;
    } else if (decimalSigns.contains(key) || QString(key) == decimalPoint()) {
        if (pointAt < 0) // also of a whole number, so that 4.2 does not become 42
            m_typed += m_typed.isEmpty() || m_typed == hyphen ? QStringLiteral("0.") : QString(point);
    } else if (key == minusSign || key == hyphen) {
        toggleSign();
    } else if (key == backspaceKey) {
        m_typed.chop(1);
    }
}

void NumberEntry::toggleSign()
{
    if (m_typed.startsWith(hyphen))
        m_typed.remove(0, 1);
    else
        m_typed.prepend(hyphen);
}

void NumberEntry::backspace()
{
    type(QString(backspaceKey));
}

void NumberEntry::clear()
{
    m_typed.clear();
    emit changed();
}

void NumberEntry::setValue(double value)
{
    m_typed = QString::number(value, 'f', m_decimals);
    emit changed();
}

} // namespace campanel::controls
