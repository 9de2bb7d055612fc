// SPDX-License-Identifier: Apache-2.0
// Contrast of a text with what was drawn behind it, after WCAG 2.1 (success criterion 1.4.3).
#pragma once

#include <QColor>

#include <optional>

class QImage;
class QQuickItem;
class QRectF;

namespace campanel::panel {

// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, the lighter one above: 1 to 21. Alpha is not looked
// at.
[[nodiscard]] double contrastRatio(const QColor& first, const QColor& second);

// The most frequent color on the rim of `rect` (in the image's own pixels): ink rarely reaches the rim of a
// line of text. Empty when the rectangle is not wholly in the picture.
[[nodiscard]] std::optional<QColor> colorBehind(const QImage& picture, const QRectF& rect);

// The color of a Text item as it arrives on the screen: its opacity and that of its parents mixed with
// `behind`.
[[nodiscard]] QColor inkOn(const QQuickItem& text, const QColor& behind);

// 4.5, or 3 for large text: 24 px and more, bold from 19 px.
[[nodiscard]] double contrastNeeded(const QQuickItem& text);

} // namespace campanel::panel
