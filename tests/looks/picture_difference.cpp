// SPDX-License-Identifier: Apache-2.0
// Compares pictures square by square; see picture_difference.h.
#include "tests/looks/picture_difference.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace campanel::looks {
namespace {

std::array<int, 3> meanOf(const QImage& picture, const QRect& square)
{
    std::array<int, 3> sum{};
    for (int y = square.top(); y <= square.bottom(); ++y) {
        for (int x = square.left(); x <= square.right(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            sum[0] += qRed(pixel);
            sum[1] += qGreen(pixel);
            sum[2] += qBlue(pixel);
        }
    }
    const int pixels = square.width() * square.height();
    for (int& channel : sum)
        channel /= pixels;
    return sum;
}

bool differs(const QImage& wanted, const QImage& found, const QRect& square)
{
    const auto one = meanOf(wanted, square);
    const auto other = meanOf(found, square);
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (std::abs(one[i] - other[i]) > toleratedStep)
            return true;
    }
    return false;
}

} // namespace

PictureDifference differenceOf(const QImage& wanted, const QImage& found)
{
    PictureDifference difference;
    if (wanted.size() != found.size()) {
        difference.isOtherSize = true;
        difference.picture = found;
        return difference;
    }
    QList<QRect> squares;
    for (int y = 0; y < found.height(); y += comparedSquarePx) {
        for (int x = 0; x < found.width(); x += comparedSquarePx) {
            const QRect square = QRect(x, y, comparedSquarePx, comparedSquarePx).intersected(found.rect());
            if (differs(wanted, found, square))
                squares << square;
        }
    }
    if (squares.isEmpty())
        return difference;
    difference.squares = static_cast<int>(squares.size());
    difference.picture = found.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&difference.picture);
    painter.fillRect(found.rect(), QColor(255, 255, 255, 160));
    for (const QRect& square : squares) {
        painter.fillRect(square, QColor(220, 0, 0, 140));
        difference.around |= square;
    }
    return difference;
}

} // namespace campanel::looks
