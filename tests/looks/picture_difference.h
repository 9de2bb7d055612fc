// SPDX-License-Identifier: Apache-2.0
// How far two pictures of the same scene are from one another, in the eyes of a person: other rounding of
// glyphs and lines is nothing, a word, color or place that changed is something.
#pragma once

#include <QImage>
#include <QRect>

namespace campanel::looks {

// Pictures are compared by squares of that many pixels, a mean color each.
inline constexpr int comparedSquarePx = 8;
// A square differs when one channel of its mean is further away than this, of 255.
inline constexpr int toleratedStep = 12;

struct PictureDifference {
    bool isOtherSize = false;
    int squares = 0; // that differ
    QRect around;    // all of them, in pixels
    QImage picture;  // the second picture pale, with red where it differs; null when nothing does

    [[nodiscard]] bool isNone() const { return !isOtherSize && squares == 0; }
};

[[nodiscard]] PictureDifference differenceOf(const QImage& wanted, const QImage& found);

} // namespace campanel::looks
