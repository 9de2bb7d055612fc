// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/format.h"

#include "app/panel/kit/units.h"

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

QString Format::amount(double value, int decimals, const QString& unit) const
{
    const ShownUnit shown = Units::of(unit);
    return number(value * shown.factor, shown.decimals(decimals));
}

QString Format::compactAmount(double value, int minimumDecimals, int maximumDecimals,
                              const QString& unit) const
{
    const ShownUnit shown = Units::of(unit);
    return compact(value * shown.factor, minimumDecimals, shown.decimals(maximumDecimals));
}

QString Format::measure(double value, int decimals, const QString& unit, std::optional<double> beside) const
{
    const ShownUnit shown = Units::of(unit);
    const int usual = shown.decimals(decimals);
    const double number = value * shown.factor;
    return joined(grouped(number, beside ? decimalsToTell(number, *beside * shown.factor, usual) : usual),
                  shown.unit);
}

QString Format::compactMeasure(double value, int minimumDecimals, int maximumDecimals, const QString& unit,
                               std::optional<double> beside) const
{
    const ShownUnit shown = Units::of(unit);
    const int usual = shown.decimals(maximumDecimals);
    const double number = value * shown.factor;
    return joined(compact(number, minimumDecimals,
                          beside ? decimalsToTell(number, *beside * shown.factor, usual) : usual),
                  shown.unit);
}

QString Format::joined(const QString& number, const QString& unit)
{
    if (unit.isEmpty() || number == unknownText())
        return number;
    if (unit == u"°")
        return number + unit;
    return unbroken(number + u' ' + unit);
}

QString Format::unbroken(QString text)
{
    constexpr QChar wordJoiner(0x2060);
    return Units::isOnScreen()
               ? text.replace(u' ', QChar(QChar::Nbsp)).replace(u'/', QString(u'/') + wordJoiner)
               : text;
}

int Format::decimalsToTell(double first, double second, int decimals)
{
    constexpr int maxDecimals = 9;
    for (int enough = decimals; enough <= maxDecimals; ++enough) {
        const double scale = std::pow(10.0, enough);
        const double one = std::round(first * scale);
        const double other = std::round(second * scale);
        if ((first == second || one != other) && (first == 0 || one != 0) && (second == 0 || other != 0))
            return enough;
    }
    return decimals;
}

QString Format::minute(const QDateTime& moment)
{
    return local(moment, QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString Format::second(const QDateTime& moment)
{
    return local(moment, QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

QString Format::local(const QDateTime& moment, const QString& form)
{
    constexpr qint64 hour = 3600;
    const QDateTime time = moment.toLocalTime();
    const bool isRepeated =
        time.addSecs(hour).time() == time.time() || time.addSecs(-hour).time() == time.time();
    const QString text = time.toString(form);
    return isRepeated ? text + u' ' + time.timeZoneAbbreviation() : text;
}

QString Format::utcOffset(int minutes)
{
    const QTime size = QTime(0, 0).addSecs(std::abs(minutes) * 60);
    return QStringLiteral("UTC") + (minutes < 0 ? u'-' : u'+') + size.toString(QStringLiteral("HH:mm"));
}

QString Format::hexDigits(quint64 value, int digits)
{
    return QString::number(value, 16).toUpper().rightJustified(digits, u'0');
}

} // namespace campanel::panel
