// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/units.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::panel {

namespace {

struct UnitRow {
    QStringView metric;
    QStringView inch;
    double factor;               // inch / metric
    std::array<int, 4> decimals; // for a metric value with 0, 1, 2, 3 decimals
};

constexpr double mmPerInch = 25.4;
constexpr double inchPerMm = 1 / mmPerInch;
constexpr double inchPerM = 1000 / mmPerInch;
constexpr double feetPerM = inchPerM / 12;

// A hundredth of a millimeter is about half a thousandth of an inch.
constexpr std::array<UnitRow, 8> unitRows{{
    {u"mm", u"in", inchPerMm, {2, 4, 4, 4}},
    {u"mm/s", u"in/s", inchPerMm, {2, 3, 3, 4}},
    {u"mm/s²", u"in/s²", inchPerMm, {1, 2, 3, 4}},
    {u"mm/°", u"in/°", inchPerMm, {2, 3, 4, 5}},
    {u"mm/°²", u"in/°²", inchPerMm, {2, 3, 4, 5}},
    {u"m/s²", u"in/s²", inchPerM, {0, 0, 1, 2}},
    {u"m/s³", u"in/s³", inchPerM, {0, 0, 1, 2}},
    {u"m", u"ft", feetPerM, {1, 1, 2, 3}},
}};

bool isInchNow = false;
bool isForScreen = false;

double onGrid(double value, int decimals)
{
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

} // namespace

int ShownUnit::decimals(int metric) const
{
    if (!inchDecimals)
        return metric;
    const int last = static_cast<int>(inchDecimals->size()) - 1;
    const int row = std::clamp(metric, 0, last);
    return (*inchDecimals)[static_cast<std::size_t>(row)] + std::max(0, metric - last);
}

void Units::setInch(bool isInch)
{
    if (std::exchange(isInchNow, isInch) == isInch)
        return;
    QEvent event(QEvent::LanguageChange);
    if (QCoreApplication* application = QCoreApplication::instance())
        QCoreApplication::sendEvent(application, &event);
}

bool Units::isInch()
{
    return isInchNow;
}

void Units::setOnScreen()
{
    isForScreen = true;
}

bool Units::isOnScreen()
{
    return isForScreen;
}

ShownUnit Units::of(const QString& unit)
{
    const auto row = std::ranges::find_if(unitRows, [&](const UnitRow& each) { return unit == each.metric; });
    if (!isInchNow || row == unitRows.end())
        return {unit};
    return {row->inch.toString(), row->factor, &row->decimals};
}

double Units::typed(double shown, const QString& unit, int metricDecimals, double present)
{
    const ShownUnit row = of(unit);
    if (!row.isConverted())
        return shown;
    const int decimals = row.decimals(metricDecimals);
    const double exact = shown / row.factor;
    for (const double metric : {present, onGrid(exact, metricDecimals)}) {
        if (std::isfinite(metric) && onGrid(metric * row.factor, decimals) == onGrid(shown, decimals))
            return metric;
    }
    return exact;
}

QVariantMap Units::rows(bool isInch)
{
    QVariantMap shown;
    for (const UnitRow& row : unitRows) {
        QVariantList decimals;
        for (const int each : row.decimals)
            decimals << each;
        if (isInch)
            shown.insert(row.metric.toString(),
                         QVariantMap{{QStringLiteral("unit"), row.inch.toString()},
                                     {QStringLiteral("factor"), row.factor},
                                     {QStringLiteral("decimals"), QVariant(decimals)}});
    }
    return shown;
}

} // namespace campanel::panel
