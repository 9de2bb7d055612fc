// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/format.h"

#include <cmath>

namespace campanel::panel {

namespace {
constexpr double withExponentFrom = 1e15;

// Replaces the hyphen of locales by a minus sign, which is as wide as a digit and easier to see.
QString withMinus(QString text, const QLocale& locale)
{
    return text.replace(locale.negativeSign(), QChar(0x2212));
}
} // namespace

Format::Format(QLocale locale)
    : m_locale(std::move(locale))
{
    m_locale.setNumberOptions(QLocale::OmitGroupSeparator);
}

QString Format::number(double value, int decimals) const
{
    if (!std::isfinite(value))
        return unknownText();
    if (std::abs(value) >= withExponentFrom)
        return withMinus(m_locale.toString(value, 'G', QLocale::FloatingPointShortest), m_locale);
    // A rounded negative zero would read as "-0.0".
    const double step = std::pow(10.0, -decimals);
    return withMinus(m_locale.toString(std::abs(value) < step / 2 ? 0.0 : value, 'f', decimals), m_locale);
}

QString Format::grouped(double value, int decimals) const
{
    constexpr double groupedFrom = 10000;
    if (!std::isfinite(value) || std::abs(value) < groupedFrom || std::abs(value) >= withExponentFrom)
        return number(value, decimals);
    QLocale locale = m_locale;
    locale.setNumberOptions(QLocale::DefaultNumberOptions);
    return withMinus(locale.toString(value, 'f', decimals), locale);
}

QString Format::compact(double value, int minimumDecimals, int maximumDecimals) const
{
    QString text = number(value, maximumDecimals);
    if (!std::isfinite(value) || std::abs(value) >= withExponentFrom)
        return text;
    for (int decimals = maximumDecimals; decimals > minimumDecimals && text.endsWith(m_locale.zeroDigit());
         --decimals)
        text.chop(1);
    if (text.endsWith(m_locale.decimalPoint()))
        text.chop(m_locale.decimalPoint().size());
    return text;
}

QString Format::minute(const QDateTime& moment)
{
    return moment.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString Format::second(const QDateTime& moment)
{
    return moment.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

QString Format::hexDigits(quint64 value, int digits)
{
    return QString::number(value, 16).toUpper().rightJustified(digits, u'0');
}

} // namespace campanel::panel
