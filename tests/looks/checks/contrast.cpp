// SPDX-License-Identifier: Apache-2.0
// Contrast of texts; see contrast.h.
#include "tests/looks/checks/contrast.h"

#include <QFont>
#include <QHash>
#include <QImage>
#include <QJSValue>
#include <QQuickItem>

#include <algorithm>
#include <cmath>

namespace campanel::looks {
namespace {

constexpr int largePx = 24;
constexpr int largeBoldPx = 19;

// Returns the linear value of an sRGB channel, 0 to 1; WCAG 2.1, "relative luminance".
double linear(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color)
{
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

} // namespace

double contrastRatio(const QColor& first, const QColor& second)
{
    const double one = luminance(first);
    const double other = luminance(second);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

std::optional<QColor> colorBehind(const QImage& picture, const QRectF& rect)
{
    const QRect rim = rect.toAlignedRect();
    if (rim.isEmpty() || !picture.rect().contains(rim))
        return std::nullopt;
    QHash<QRgb, int> seen;
    for (int x = rim.left(); x <= rim.right(); ++x) {
        ++seen[picture.pixel(x, rim.top())];
        ++seen[picture.pixel(x, rim.bottom())];
    }
    for (int y = rim.top(); y <= rim.bottom(); ++y) {
        ++seen[picture.pixel(rim.left(), y)];
        ++seen[picture.pixel(rim.right(), y)];
    }
    return QColor(*std::max_element(seen.keyBegin(), seen.keyEnd(),
                                    [&](QRgb a, QRgb b) { return seen.value(a) < seen.value(b); }));
}

QColor inkOn(const QQuickItem& text, const QColor& behind)
{
    const auto color = text.property("color").value<QColor>();
    float opacity = color.alphaF();
    for (const QQuickItem* item = &text; item; item = item->parentItem())
        opacity *= static_cast<float>(item->opacity());
    const auto mixed = [opacity](float ink, float ground) { return opacity * ink + (1 - opacity) * ground; };
    return QColor::fromRgbF(mixed(color.redF(), behind.redF()), mixed(color.greenF(), behind.greenF()),
                            mixed(color.blueF(), behind.blueF()));
}

double contrastNeeded(const QQuickItem& text, const TextContrast& least)
{
    // A fitted text is drawn smaller than its font.
    const int px = text.property("fontInfo").value<QJSValue>().property(QStringLiteral("pixelSize")).toInt();
    const bool isBold = text.property("font").value<QFont>().bold();
    return px >= (isBold ? largeBoldPx : largePx) ? least.large : least.small;
}

} // namespace campanel::looks
