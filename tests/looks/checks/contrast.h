// SPDX-License-Identifier: Apache-2.0
// The contrast of a text with its background, after WCAG 2.1 (success criterion 1.4.3).
#pragma once

#include <QColor>

#include <optional>

class QImage;
class QQuickItem;
class QRectF;

namespace campanel::looks {

// Returns (L1 + 0.05) / (L2 + 0.05) of the relative luminances, the lighter one above: 1 to 21. Ignores
// alpha.
[[nodiscard]] double contrastRatio(const QColor& first, const QColor& second);

// Returns the most frequent color on the rim of `rect` (in pixels of the image): ink rarely reaches the rim
// of a line of text. Empty when the rectangle is not completely inside the picture.
[[nodiscard]] std::optional<QColor> colorBehind(const QImage& picture, const QRectF& rect);

// Returns the displayed color of a Text item: mixes `behind` by the opacity of the item and its parents.
[[nodiscard]] QColor inkOn(const QQuickItem& text, const QColor& behind);

// The minimum contrasts of a theme; by default those of level AA.
struct TextContrast {
    double small = 4.5;
    double large = 3; // 24 px and more, bold from 19 px
};

// Returns the minimum that applies to the text.
[[nodiscard]] double contrastNeeded(const QQuickItem& text, const TextContrast& least);

} // namespace campanel::looks
