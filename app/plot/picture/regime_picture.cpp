// SPDX-License-Identifier: Apache-2.0
// A limit has a color, a pattern and a number, so that no one needs the colors.
#include "app/plot/picture/regime_picture.h"

#include "app/plot/picture/label_draw.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <qwt_painter.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_engine.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::plot {
namespace {

constexpr int refusedEntry = -1;
constexpr int markEntry = -2;
constexpr double headroom = 1.15;      // above the fastest rate
constexpr double headroomOfDot = 1.08; // above the recipe's rate
constexpr int maxLengthTicks = 7;
constexpr double minimumLengthMm = 10; // of an empty map
constexpr double minimumRate = 10;     // bags/min
constexpr float tintOpacity = 0.22F;   // below the pattern
constexpr float patternOpacity = 0.55F;
constexpr double swatchShare = 1.5; // width of a swatch / its height
constexpr double markShare = 0.5;   // height of a mark / height of the text
constexpr float labelOpacity = 0.8F;
constexpr double gapPx = 6;
constexpr std::array patterns{Qt::BDiagPattern, Qt::Dense6Pattern, Qt::CrossPattern,    Qt::HorPattern,
                              Qt::FDiagPattern, Qt::VerPattern,    Qt::DiagCrossPattern};

struct Line {
    const char* name; // "L_min" is drawn with a subscript
    double lengthMm;
};

// Paints a symbol and its number.
void paintSymbol(QPainter& painter, const QRectF& box, const QString& symbol, const QString& number)
{
    constexpr double subscriptSize = 0.75;
    const QFont font = painter.font();
    const QFontMetricsF metrics(font);
    const double baseline = box.top() + metrics.ascent();
    const QString letter = symbol.section(u'_', 0, 0);
    const QString subscript = symbol.section(u'_', 1);
    double x = box.left() + 2;
    painter.drawText(QPointF(x, baseline), letter);
    x += metrics.horizontalAdvance(letter);
    QFont small = font;
    small.setPixelSize(static_cast<int>(subscriptSize * font.pixelSize()));
    painter.setFont(small);
    painter.drawText(QPointF(x, baseline + metrics.descent() / 2), subscript);
    x += QFontMetricsF(small).horizontalAdvance(subscript);
    painter.setFont(font);
    painter.drawText(QPointF(x, baseline), u' ' + number);
}

} // namespace

QColor RegimePicture::colorOf(int limit) const
{
    return style.limits.isEmpty() ? style.ink : style.limits[limit % style.limits.size()];
}

void RegimePicture::layOut(const QSizeF& size)
{
    const QFontMetricsF metrics(style.font);
    layOutLegend(size.width());
    findBands();
    const auto range = content.map ? content.map->range : profile::LengthRange{0, minimumLengthMm};
    const double fastest = content.map ? content.map->maxRateBagsPerMin : 0;
    const double factor = content.lengthFactor;
    m_lengthDivision = scaled(
        QwtLinearScaleEngine().divideScale(range.fromMm * factor, range.toMm * factor, maxLengthTicks, 0),
        1 / factor);
    m_rateScale.fit(0, std::max({minimumRate, headroom * fastest, headroomOfDot * content.shownRate}),
                    minimumRate);
    LabelDraw rates(QwtScaleDraw::LeftScale, style.locale, m_rateScale);
    const double left =
        std::ceil(std::max(rates.extent(style.font), metrics.horizontalAdvance(content.rateUnit) / 2));
    const double right =
        std::ceil(metrics.horizontalAdvance(QStringLiteral("0000 ") + content.lengthUnit) / 2);
    const double top = m_legendHeight + std::ceil(1.5 * metrics.height() + gapPx); // for the unit of the rate
    const double bottom = std::ceil(metrics.height() + gapPx);
    m_canvas = QRectF(left, top, std::max(1.0, size.width() - left - right),
                      std::max(1.0, size.height() - top - bottom));
    m_lengthMap.setScaleInterval(range.fromMm, range.toMm);
    m_lengthMap.setPaintInterval(m_canvas.left(), m_canvas.right());
    m_rateMap.setScaleInterval(m_rateScale.lower(), m_rateScale.upper());
    m_rateMap.setPaintInterval(m_canvas.bottom(), m_canvas.top());
}

// Places the entries from left to right, in as many rows as they need.
void RegimePicture::layOutLegend(double width)
{
    m_legend.clear();
    m_legendHeight = 0;
    if (!content.map)
        return;
    const QFontMetricsF metrics(style.font);
    const double row = std::ceil(metrics.height() + gapPx);
    QPointF place(0, 0);
    const auto add = [&](const QString& name, int limit) {
        const double wanted =
            swatchShare * metrics.height() + gapPx + metrics.horizontalAdvance(name) + 2 * gapPx;
        if (place.x() > 0 && place.x() + wanted > width)
            place = QPointF(0, place.y() + row);
        m_legend.push_back({place, name, limit});
        place.rx() += wanted;
    };
    for (qsizetype i = 0; i < content.limitNames.size(); ++i)
        add(content.limitNames[i], static_cast<int>(i));
    if (!content.refusedName.isEmpty())
        add(content.refusedName, refusedEntry);
    if (!content.marks.isEmpty() && !content.marksName.isEmpty())
        add(content.marksName, markEntry);
    m_legendHeight = m_legend.empty() ? 0 : place.y() + row;
}

// A band begins where the one before it ends, so that no gap remains between two samples.
void RegimePicture::findBands()
{
    m_bands.clear();
    if (!content.map)
        return;
    const auto& limits = content.map->limits;
    const profile::RegimePoint* before = nullptr;
    for (const profile::RegimePoint& point : content.map->points) {
        if (point.rateBagsPerMin <= 0) {
            before = nullptr;
            continue;
        }
        const QPointF top(point.bagLengthMm, point.rateBagsPerMin);
        if (before == nullptr || before->limit != point.limit) {
            if (before != nullptr)
                m_bands.back().top << top;
            m_bands.push_back(
                {static_cast<int>(std::ranges::find(limits, point.limit) - limits.begin()), {}});
        }
        m_bands.back().top << top;
        before = &point;
    }
}

void RegimePicture::paint(QPainter& painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(style.font);
    painter.fillRect(m_canvas, style.inset);
    painter.save();
    painter.setClipRect(m_canvas, Qt::IntersectClip);
    for (const Band& band : m_bands)
        paintBand(painter, band);
    painter.restore();
    paintAxes(painter);
    paintLines(painter);
    for (const double mark : content.marks) {
        if (m_lengthDivision.contains(mark))
            paintMark(painter, {m_lengthMap.transform(mark), m_canvas.bottom()});
    }
    paintLegend(painter);
    paintDot(painter);
    painter.restore();
}

void RegimePicture::paintAxes(QPainter& painter) const
{
    QwtPlotGrid grid;
    grid.setMajorPen(QPen(style.grid, 1));
    grid.setXDiv(m_lengthDivision);
    grid.setYDiv(m_rateScale.division());
    grid.draw(&painter, m_lengthMap, m_rateMap, m_canvas.adjusted(0, 0, 1, 1));

    QPalette palette;
    palette.setColor(QPalette::Text, style.secondaryInk);
    LabelDraw rates(QwtScaleDraw::LeftScale, style.locale, m_rateScale);
    rates.move(m_canvas.topLeft());
    rates.setLength(m_canvas.height());
    rates.draw(&painter, palette);

    LabelDraw lengths(QwtScaleDraw::BottomScale, style.locale, 0, content.lengthFactor);
    lengths.setScaleDiv(m_lengthDivision);
    const QList<double> ticks = m_lengthDivision.ticks(QwtScaleDiv::MajorTick);
    if (!ticks.isEmpty())
        lengths.setSpecialLabel(ticks.last(),
                                localNumber(style.locale, ticks.last() * content.lengthFactor, 0) +
                                    QLatin1Char(' ') + content.lengthUnit);
    lengths.move(m_canvas.bottomLeft());
    lengths.setLength(m_canvas.width());
    lengths.draw(&painter, palette);

    const double unitBottom = m_canvas.top() - QFontMetricsF(style.font).height() / 2;
    painter.setPen(style.secondaryInk);
    painter.drawText(QRectF(0, m_legendHeight, m_canvas.right(), unitBottom - m_legendHeight),
                     Qt::AlignLeft | Qt::AlignBottom, content.rateUnit);
}

void RegimePicture::fill(QPainter& painter, const QPolygonF& area, int limit) const
{
    QColor color = colorOf(limit);
    painter.setPen(Qt::NoPen);
    color.setAlphaF(tintOpacity);
    painter.setBrush(color);
    painter.drawPolygon(area);
    color.setAlphaF(patternOpacity);
    painter.setBrush(QBrush(color, patterns[static_cast<std::size_t>(limit) % patterns.size()]));
    painter.drawPolygon(area);
    painter.setBrush(Qt::NoBrush);
}

void RegimePicture::paintBand(QPainter& painter, const Band& band) const
{
    QPolygonF area;
    for (const QPointF& point : band.top)
        area << QPointF(m_lengthMap.transform(point.x()), m_rateMap.transform(point.y()));
    const double left = area.first().x();
    const double right = area.last().x();
    const QPointF middle = area[area.size() / 2];
    area << QPointF(right, m_canvas.bottom()) << QPointF(left, m_canvas.bottom());
    fill(painter, area, band.limit);

    QwtPlotCurve curve;
    curve.setSamples(band.top);
    curve.setPen(QPen(colorOf(band.limit), style.lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
    curve.draw(&painter, m_lengthMap, m_rateMap, m_canvas);

    const double height = QFontMetricsF(style.font).height();
    if (right - left > 1.5 * height && m_canvas.bottom() - middle.y() > 2.5 * height)
        paintTag(painter, {middle.x(), (middle.y() + m_canvas.bottom()) / 2}, band.limit);
}

// Paints the number of a limit, as in the legend.
void RegimePicture::paintTag(QPainter& painter, const QPointF& center, int limit) const
{
    const double size = 1.3 * QFontMetricsF(style.font).height();
    const QRectF circle(center.x() - size / 2, center.y() - size / 2, size, size);
    painter.setPen(QPen(colorOf(limit), style.lineWidth));
    painter.setBrush(style.surface);
    painter.drawEllipse(circle);
    painter.setPen(style.ink);
    painter.setBrush(Qt::NoBrush);
    painter.drawText(circle, Qt::AlignCenter, style.locale.toString(limit + 1));
}

// Paints the lines where the behavior changes, with their names above the canvas or, where two would
// overlap, one below the other.
void RegimePicture::paintLines(QPainter& painter) const
{
    if (!content.map)
        return;
    const profile::CutterLengths& lengths = content.map->lengths;
    const std::array lines{Line{"L_min", lengths.jawMm}, Line{"h/c", lengths.equalSpeedMm},
                           Line{"L_crit", lengths.dwellMm}};
    const QFontMetricsF metrics(style.font);
    QPen pen(style.ink, 1, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({4, 4});
    double taken = 0; // right end of the name before
    double y = m_canvas.top();
    for (const Line& line : lines) {
        const double x = m_lengthMap.transform(line.lengthMm);
        if (line.lengthMm <= 0 || x < m_canvas.left() || x > m_canvas.right())
            continue;
        painter.setPen(pen);
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.drawLine(QPointF(x, m_canvas.top()), QPointF(x, m_canvas.bottom()));
        painter.setRenderHint(QPainter::Antialiasing);
        const QString number = localNumber(style.locale, line.lengthMm, 0);
        const double width =
            metrics.horizontalAdvance(QStringLiteral("%1 %2").arg(QLatin1String(line.name), number)) + gapPx;
        const double left = std::min(x + 2, m_canvas.right() - width);
        y = left < taken ? y + metrics.height() : m_canvas.top();
        const QRectF box(left, y + 1, width, metrics.height());
        QColor background = style.surface;
        background.setAlphaF(labelOpacity);
        painter.fillRect(box, background);
        painter.setPen(style.ink);
        paintSymbol(painter, box, QLatin1String(line.name), number);
        taken = std::max(taken, left + width);
    }
}

void RegimePicture::paintMark(QPainter& painter, const QPointF& tip) const
{
    const double size = markShare * QFontMetricsF(style.font).height();
    painter.setPen(QPen(style.surface, 1));
    painter.setBrush(style.ink);
    painter.drawPolygon(
        QPolygonF{{tip.x(), tip.y() - size}, {tip.x() - size / 2, tip.y()}, {tip.x() + size / 2, tip.y()}});
    painter.setBrush(Qt::NoBrush);
}

void RegimePicture::paintLegend(QPainter& painter) const
{
    const QFontMetricsF metrics(style.font);
    for (const LegendEntry& entry : m_legend) {
        const QRectF swatch(entry.place.x() + 1, entry.place.y() + 1, swatchShare * metrics.height() - 2,
                            metrics.height() - 2);
        if (entry.limit == markEntry) {
            paintMark(painter, {swatch.center().x(), swatch.bottom()});
        } else {
            painter.fillRect(swatch, style.inset);
            if (entry.limit >= 0)
                fill(painter, swatch, entry.limit);
            painter.setPen(QPen(entry.limit >= 0 ? colorOf(entry.limit) : style.secondaryInk, 1));
            painter.drawRect(swatch);
        }
        painter.setPen(style.ink);
        if (entry.limit >= 0) {
            const QRectF number(swatch.center().x() - swatch.height() / 2, swatch.top() + 1, swatch.height(),
                                swatch.height() - 2);
            painter.fillRect(number, style.surface);
            painter.drawText(number, Qt::AlignCenter, style.locale.toString(entry.limit + 1));
        }
        painter.drawText(QPointF(swatch.right() + gapPx, swatch.top() - 1 + metrics.ascent()), entry.name);
    }
}

void RegimePicture::paintDot(QPainter& painter) const
{
    if (!std::isfinite(content.dot.x()))
        return;
    const QPointF center(m_lengthMap.transform(content.dot.x()), m_rateMap.transform(content.dot.y()));
    if (!m_canvas.adjusted(-1, -1, 1, 1).contains(center))
        return;
    painter.setPen(QPen(style.dot, style.lineWidth + 1));
    painter.setBrush(style.surface);
    painter.drawEllipse(center, style.dotSize / 2, style.dotSize / 2);
    painter.setBrush(Qt::NoBrush);
}

} // namespace campanel::plot
