// SPDX-License-Identifier: Apache-2.0
// The visible difference between two pictures of the same screen. Rounding of glyphs and lines is ignored; a
// changed word, color or place counts.
#pragma once

#include <QImage>
#include <QRect>

namespace campanel::looks {

// The size of the squares in pixels whose mean colors are compared.
inline constexpr int comparedSquarePx = 8;
// The tolerance for each channel of a square's mean, of 255.
inline constexpr int toleratedStep = 12;

struct PictureDifference {
    bool isOtherSize = false;
    int squares = 0; // different squares
    QRect around;    // bounding box of all, in pixels
    QImage picture;  // the second picture, pale, with differences in red; null without differences

    [[nodiscard]] bool isNone() const { return !isOtherSize && squares == 0; }
};

[[nodiscard]] PictureDifference differenceOf(const QImage& wanted, const QImage& found);

} // namespace campanel::looks
