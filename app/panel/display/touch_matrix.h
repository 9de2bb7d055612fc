// SPDX-License-Identifier: Apache-2.0
// The calibration of a touchscreen: an affine map of places on the screen, in shares of its width and height
// from its upper left corner as it is wired. It is what libinput reads from the udev property
// LIBINPUT_CALIBRATION_MATRIX.
#pragma once

#include <QList>
#include <QPointF>
#include <QString>

#include <tl/expected.hpp>

#include <array>
#include <optional>

namespace campanel::panel {

// Row by row, (a b c d e f): x' = a x + b y + c, y' = d x + e y + f.
using TouchMatrix = std::array<double, 6>;

inline constexpr TouchMatrix plainTouch{1, 0, 0, 0, 1, 0};

[[nodiscard]] QPointF mapped(const TouchMatrix& matrix, QPointF place);
// Returns the map that applies `first` and then `second`.
[[nodiscard]] TouchMatrix composed(const TouchMatrix& second, const TouchMatrix& first);

// Return six numbers with six decimals, and the numbers of such a text; also of one with other decimals.
[[nodiscard]] QString matrixText(const TouchMatrix& matrix);
[[nodiscard]] std::optional<TouchMatrix> matrixIn(const QString& text);
// Returns true when campanel-touch accepts the matrix: no number beyond 4, and no map that leaves hardly an
// area.
[[nodiscard]] bool isUsable(const TouchMatrix& matrix);

struct TouchPair {
    QPointF touched; // where the touchscreen has reported the finger
    QPointF cross;   // where the cross is
};

enum class TouchFault {
    Missed,      // the touches fit no map: at least one of them was not on its cross
    Implausible, // the touches fit a map that no touchscreen has
};

// Returns the map from the touches to the crosses with the least squares of the distances. At least four
// crosses, not on one line, so that a missed one is seen.
[[nodiscard]] tl::expected<TouchMatrix, TouchFault> fitTouches(const QList<TouchPair>& pairs);

} // namespace campanel::panel
