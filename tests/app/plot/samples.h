// SPDX-License-Identifier: Apache-2.0
// Curve sets and painting helpers for the plot tests.
#pragma once

#include "app/plot/quantity.h"
#include "profile/cutter/sampling.h"

#include <QImage>
#include <QPainter>
#include <QQuickPaintedItem>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace campanel::plot::test {

inline constexpr int samplePoints = 1000;

// Returns one cycle of timeS seconds with the given velocity; the other quantities follow a fixed pattern.
inline std::shared_ptr<profile::Curves> makeCurves(const std::function<double(double)>& velocity,
                                                   double timeS = 1.0)
{
    auto curves = std::make_shared<profile::Curves>();
    for (int i = 0; i <= samplePoints; ++i) {
        const double t = timeS * i / samplePoints;
        curves->timeS.push_back(t);
        curves->positionMm.push_back(300 * t);
        curves->velocityMmPerS.push_back(velocity(t));
        curves->accelerationMmPerS2.push_back(2000 * std::sin(2 * std::numbers::pi * t / timeS));
        curves->jerkMmPerS3.push_back(10000 * std::cos(2 * std::numbers::pi * t / timeS));
        curves->frequencyHz.push_back(velocity(t) * 26.5);
    }
    return curves;
}

inline QVariant curveVariant(const std::function<double(double)>& velocity, double timeS = 1.0)
{
    return QVariant::fromValue<CurveSet>(makeCurves(velocity, timeS));
}

inline QImage paintItem(QQuickPaintedItem& item, double pixelRatio = 1)
{
    QImage image((item.size() * pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixelRatio);
    image.fill(Qt::white);
    QPainter painter(&image);
    item.paint(&painter);
    return image;
}

// Returns the number of pixels in the rectangle with nearly this color (anti-aliased edges count if they are
// mostly of it).
inline int inkIn(const QImage& image, const QRect& area, const QColor& color)
{
    constexpr int tolerance = 60;
    int count = 0;
    for (int y = area.top(); y <= area.bottom(); ++y) {
        for (int x = area.left(); x <= area.right(); ++x) {
            if (!image.rect().contains(x, y)) {
                continue;
            }
            const QColor pixel = image.pixelColor(x, y);
            const int difference = std::abs(pixel.red() - color.red()) +
                                   std::abs(pixel.green() - color.green()) +
                                   std::abs(pixel.blue() - color.blue());
            count += difference < tolerance ? 1 : 0;
        }
    }
    return count;
}

inline QRect around(double x, double y, int reach)
{
    return {qRound(x) - reach, qRound(y) - reach, 2 * reach + 1, 2 * reach + 1};
}

} // namespace campanel::plot::test
