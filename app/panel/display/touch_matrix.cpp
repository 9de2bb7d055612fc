// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/touch_matrix.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

// A finger is 2 mm beside its cross, which is 1.3 % of a 7 inch screen. One touch beside its cross by some
// distance leaves a quarter of the distance at each of four crosses.
constexpr double maxResidual = 0.015;
constexpr double minStretch = 0.5; // of a plausible map, in any direction
constexpr double maxStretch = 2;
constexpr double minArea = 0.1;
constexpr double maxNumber = 4; // exclusive
constexpr int decimals = 6;

double determinant(const TouchMatrix& m)
{
    return m[0] * m[4] - m[1] * m[3];
}

// The singular values s and t of the linear part: s t = |det|, s^2 + t^2 = a^2 + b^2 + d^2 + e^2.
bool isStretchPlausible(const TouchMatrix& m)
{
    const double area = std::abs(determinant(m));
    const double squares = m[0] * m[0] + m[1] * m[1] + m[3] * m[3] + m[4] * m[4];
    const double largest =
        std::sqrt((squares + std::sqrt(std::max(0.0, squares * squares - 4 * area * area))) / 2);
    return largest <= maxStretch && area >= minStretch * largest;
}

} // namespace

QPointF mapped(const TouchMatrix& matrix, QPointF place)
{
    return {matrix[0] * place.x() + matrix[1] * place.y() + matrix[2],
            matrix[3] * place.x() + matrix[4] * place.y() + matrix[5]};
}

TouchMatrix composed(const TouchMatrix& second, const TouchMatrix& first)
{
    TouchMatrix both{};
    for (std::size_t row = 0; row < both.size(); row += 3) {
        for (std::size_t column = 0; column < 3; ++column)
            both[row + column] = second[row] * first[column] + second[row + 1] * first[3 + column];
        both[row + 2] += second[row + 2];
    }
    return both;
}

QString matrixText(const TouchMatrix& matrix)
{
    QStringList numbers;
    for (const double number : matrix)
        numbers << QString::number(number, 'f', decimals);
    return numbers.join(u' ');
}

std::optional<TouchMatrix> matrixIn(const QString& text)
{
    const QStringList numbers = text.split(u' ', Qt::SkipEmptyParts);
    TouchMatrix matrix{};
    if (numbers.size() != static_cast<qsizetype>(matrix.size()))
        return std::nullopt;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        bool isNumber = false;
        matrix[i] = numbers[static_cast<qsizetype>(i)].toDouble(&isNumber);
        if (!isNumber || !std::isfinite(matrix[i]))
            return std::nullopt;
    }
    return matrix;
}

bool isUsable(const TouchMatrix& matrix)
{
    const auto isSmall = [](double number) { return std::abs(number) < maxNumber - std::pow(10, -decimals); };
    return std::ranges::all_of(matrix, isSmall) && std::abs(determinant(matrix)) > minArea;
}

// With places relative to their means the offsets drop out of the normal equations; what is left for each row
// is (Sxx Sxy; Sxy Syy) (a; b) = (Sxu; Syu) with S as the sums of products, x and y touched, u a coordinate
// of the cross.
tl::expected<TouchMatrix, TouchFault> fitTouches(const QList<TouchPair>& pairs)
{
    QPointF meanTouched;
    QPointF meanCross;
    for (const TouchPair& pair : pairs) {
        meanTouched += pair.touched / static_cast<double>(pairs.size());
        meanCross += pair.cross / static_cast<double>(pairs.size());
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    QPointF xCross;
    QPointF yCross;
    for (const TouchPair& pair : pairs) {
        const QPointF at = pair.touched - meanTouched;
        const QPointF cross = pair.cross - meanCross;
        xx += at.x() * at.x();
        xy += at.x() * at.y();
        yy += at.y() * at.y();
        xCross += at.x() * cross;
        yCross += at.y() * cross;
    }
    const double divisor = xx * yy - xy * xy;
    if (!(divisor > 1e-6)) // the touches lie on a line or at one place
        return tl::unexpected(TouchFault::Implausible);
    const QPointF alongX = (yy * xCross - xy * yCross) / divisor;
    const QPointF alongY = (xx * yCross - xy * xCross) / divisor;
    TouchMatrix fit{alongX.x(), alongY.x(), 0, alongX.y(), alongY.y(), 0};
    const QPointF offset = meanCross - mapped(fit, meanTouched);
    fit[2] = offset.x();
    fit[5] = offset.y();
    const auto isHit = [&fit](const TouchPair& pair) {
        const QPointF missed = mapped(fit, pair.touched) - pair.cross;
        return std::hypot(missed.x(), missed.y()) <= maxResidual;
    };
    if (!std::ranges::all_of(pairs, isHit))
        return tl::unexpected(TouchFault::Missed);
    if (!isStretchPlausible(fit))
        return tl::unexpected(TouchFault::Implausible);
    return fit;
}

} // namespace campanel::panel
