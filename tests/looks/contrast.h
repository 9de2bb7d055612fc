// SPDX-License-Identifier: Apache-2.0
// Contrast of a text with what was drawn behind it, after WCAG 2.1 (success criterion 1.4.3).
#pragma once

#include <QColor>

#include <optional>

class QImage;
class QQuickItem;
class QRectF;

namespace campanel::looks {

// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, the lighter one above: 1 to 21. Alpha is not looked
// at.
[[nodiscard]] double contrastRatio(const QColor& first, const QColor& second);

// The most frequent color on the rim of `rect` (in the image's own pixels): ink rarely reaches the rim of a
// line of text. Empty when the rectangle is not wholly in the picture.
[[nodiscard]] std::optional<QColor> colorBehind(const QImage& picture, const QRectF& rect);

// The color of a Text item as it arrives on the screen: its opacity and that of its parents mixed with
// `behind`.
[[nodiscard]] QColor inkOn(const QQuickItem& text, const QColor& behind);

// Least contrasts that a theme promises; by default those of level AA.
struct TextContrast {
    double small = 4.5;
    double large = 3; // 24 px and more, bold from 19 px
};

// Which of the two the text needs.
[[nodiscard]] double contrastNeeded(const QQuickItem& text, const TextContrast& least);

} // namespace campanel::looks
