// SPDX-License-Identifier: Apache-2.0
// Properties and layout; the painting is in curve_plot_paint.cpp.
#include "app/plot/curve_plot.h"

#include "app/plot/same_number.h"

#include <QFontMetricsF>

#include <qwt_painter.h>
#include <qwt_scale_engine.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::plot {

namespace {

constexpr double timeTickSpacing = 80; // px, minimum between the ticks of the time axis
constexpr int maximumTimeSteps = 8;
constexpr double panelGap = 10;       // px between a canvas and the title below it
constexpr double cursorReach = 6;     // px on both sides of the cursor for its dots
constexpr double noTimeMaximum = 1.0; // s, the axis of an empty plot

} // namespace

CurvePlot::CurvePlot(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    // Curves are anti-aliased: rounding their points to whole pixels would cause steps.
    QwtPainter::setRoundingAlignment(false);
    m_style.axisFont.setPixelSize(13);
    m_style.titleFont.setPixelSize(14);
    connectProperties();
    invalidateLayout();
}

void CurvePlot::connectProperties()
{
    for (const auto signal :
         {&CurvePlot::curvesChanged, &CurvePlot::overlayCurvesChanged, &CurvePlot::quantitiesChanged,
          &CurvePlot::titlesChanged, &CurvePlot::limitsChanged, &CurvePlot::timeMaximumChanged}) {
        connect(this, signal, this, &CurvePlot::invalidateLayout);
    }
    const auto remeasure = [this] {
        m_labelWidth = 0;
        invalidateLayout();
    };
    connect(&m_style, &CurveStyle::fontsChanged, this, remeasure);
    connect(this, &CurvePlot::timeUnitChanged, this, remeasure);
    connect(&m_style, &CurveStyle::changed, this, &CurvePlot::invalidateImage);
    connect(this, &CurvePlot::markersChanged, this, &CurvePlot::invalidateImage);
    connect(this, &CurvePlot::limitLabelChanged, this, &CurvePlot::invalidateImage);
    connect(&m_style, &CurveStyle::traceChanged, this, &CurvePlot::updateAll);
    connect(this, &CurvePlot::cursorDotsVisibleChanged, this, &CurvePlot::updateAll);
}

void CurvePlot::invalidateLayout()
{
    m_layoutValid = false;
    polish();
    invalidateImage();
}

void CurvePlot::invalidateImage()
{
    m_imageValid = false;
    updateAll();
}

void CurvePlot::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    if (newGeometry.size() != oldGeometry.size()) {
        invalidateLayout();
    }
}

void CurvePlot::updatePolish()
{
    ensureLayout();
    if (const Mapping now = mapping(); now != m_announcedMapping) {
        m_announcedMapping = now;
        emit layoutChanged();
    }
}

CurvePlot::Mapping CurvePlot::mapping() const
{
    const PlotPanel* panel = velocityPanel();
    return {m_plotArea, panel ? panel->axis().canvas() : QRectF(), m_timeMap.s2(),
            panel ? panel->axis().scale().lower() : 0.0, panel ? panel->axis().scale().upper() : 0.0};
}

void CurvePlot::ensureLayout()
{
    if (m_layoutValid) {
        return;
    }
    m_layoutValid = true;
    m_curveSet = curveSetFrom(m_curves);
    m_overlaySet = curveSetFrom(m_overlayCurves);
    rebuildPanels();
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        m_panels[i].setFactor(m_factors.value(static_cast<qsizetype>(i), 1.0));
    for (PlotPanel& panel : m_panels) {
        const double limit = limitOf(panel.quantity()) * displayFactor(panel.quantity());
        panel.setData(m_curveSet, m_overlaySet, limit);
    }
    placePanels();
    placeTimeAxis();
}

void CurvePlot::rebuildPanels()
{
    std::vector<Quantity> wanted;
    for (const QString& name : std::as_const(m_quantities)) {
        if (const auto quantity = quantityByName(name)) {
            wanted.push_back(*quantity);
        }
    }
    if (!std::ranges::equal(wanted, m_panels, {}, {}, &PlotPanel::quantity)) {
        m_panels = std::vector<PlotPanel>(wanted.cbegin(), wanted.cend());
    }
}

void CurvePlot::placePanels()
{
    const PlotStyle plotStyle = style();
    const QFontMetricsF axisMetrics(m_style.axisFont);
    const QFontMetricsF titleMetrics(m_style.titleFont);
    m_labelWidth = std::max(m_labelWidth, axisMetrics.horizontalAdvance(QStringLiteral("0000")) + labelGap);
    for (const PlotPanel& panel : m_panels) {
        m_labelWidth = std::max(m_labelWidth, std::ceil(panel.axis().labelWidth(plotStyle)));
    }
    const bool titled =
        std::any_of(m_titles.cbegin(), m_titles.cend(), [](const QString& t) { return !t.isEmpty(); });
    const double head = titled ? titleMetrics.height() + titleGap : 0.0;
    const double top = std::ceil(std::max(head, axisMetrics.height() / 2));
    const double gap = std::ceil(std::max(head + panelGap, axisMetrics.height() + 2));
    const double bottom = std::ceil(axisMetrics.height() + labelGap);
    const double right = std::ceil(axisMetrics.horizontalAdvance(QStringLiteral("0.000 ") + m_timeUnit) / 2);
    const auto count = static_cast<double>(std::max<std::size_t>(1, m_panels.size()));
    const double panelHeight =
        std::max(1.0, std::floor((height() - top - bottom - (count - 1) * gap) / count));
    const double canvasWidth = std::max(1.0, width() - m_labelWidth - right);
    double y = top;
    for (PlotPanel& panel : m_panels) {
        panel.setCanvas(QRectF(m_labelWidth, y, canvasWidth, panelHeight));
        y += panelHeight + gap;
    }
    m_plotArea = QRectF(m_labelWidth, top, canvasWidth, count * panelHeight + (count - 1) * gap);
}

void CurvePlot::placeTimeAxis()
{
    double end = m_timeMaximum;
    if (!(end > 0)) {
        end = m_curveSet     ? timesOf(m_curveSet).back()
              : m_overlaySet ? timesOf(m_overlaySet).back()
                             : noTimeMaximum;
    }
    m_timeMap.setScaleInterval(0, end);
    m_timeMap.setPaintInterval(m_plotArea.left(), m_plotArea.right());

    const QwtLinearScaleEngine engine;
    const int steps = std::clamp(static_cast<int>(m_plotArea.width() / timeTickSpacing), 1, maximumTimeSteps);
    m_timeDivision = engine.divideScale(0, end, steps, 0);
    QList<double> ticks = m_timeDivision.ticks(QwtScaleDiv::MajorTick);
    // The axis ends with T itself; a round number too close to it is removed.
    while (!ticks.isEmpty() &&
           m_timeMap.transform(end) - m_timeMap.transform(ticks.last()) < timeTickSpacing / 2) {
        ticks.removeLast();
    }
    ticks.append(end);
    m_timeDivision.setTicks(QwtScaleDiv::MajorTick, ticks);
}

double CurvePlot::xOfTime(double timeS)
{
    ensureLayout();
    return m_timeMap.transform(timeS);
}

double CurvePlot::timeOfX(double x)
{
    ensureLayout();
    return m_timeMap.invTransform(x);
}

double CurvePlot::yOfVelocity(double velocityMmPerS)
{
    ensureLayout();
    const PlotPanel* panel = velocityPanel();
    return panel ? panel->axis().map().transform(velocityMmPerS) : none;
}

double CurvePlot::yOfValue(int index, double value)
{
    ensureLayout();
    const auto i = static_cast<std::size_t>(index);
    return i < m_panels.size() ? m_panels[i].axis().map().transform(value) : none;
}

double CurvePlot::valuePerPixel(int index)
{
    ensureLayout();
    const auto i = static_cast<std::size_t>(index);
    if (i >= m_panels.size())
        return none;
    const QwtScaleMap& map = m_panels[i].axis().map();
    return std::abs(map.invTransform(1) - map.invTransform(0));
}

double CurvePlot::panelTop(int index)
{
    ensureLayout();
    const auto i = static_cast<std::size_t>(index);
    return i < m_panels.size() ? m_panels[i].axis().canvas().top() : none;
}

double CurvePlot::panelHeight(int index)
{
    ensureLayout();
    const auto i = static_cast<std::size_t>(index);
    return i < m_panels.size() ? m_panels[i].axis().canvas().height() : none;
}

QList<double> CurvePlot::valuesAt(double timeS)
{
    ensureLayout();
    QList<double> values;
    for (const PlotPanel& panel : m_panels) {
        values.append(valueAt(m_curveSet, panel.quantity(), timeS));
    }
    return values;
}

QRectF CurvePlot::plotArea()
{
    ensureLayout();
    return m_plotArea;
}

void CurvePlot::setTrace(const QList<QPointF>& trace)
{
    if (trace == m_trace) {
        return;
    }
    // Repaints only the differences: a trace mostly grows at its end.
    const auto [ours, theirs] = std::mismatch(m_trace.cbegin(), m_trace.cend(), trace.cbegin(), trace.cend());
    const auto same = std::distance(m_trace.cbegin(), ours);
    const double from = same > 0 ? trace[same - 1].x() : 0.0;
    const double to =
        std::max(m_trace.isEmpty() ? 0.0 : m_trace.last().x(), trace.isEmpty() ? 0.0 : trace.last().x());
    m_trace = trace;
    update(traceStrip(from, to).toAlignedRect());
    emit traceChanged();
}

void CurvePlot::setCursorTime(double timeS)
{
    if (sameNumber(timeS, m_cursorTime)) {
        return;
    }
    update(cursorStrip(std::exchange(m_cursorTime, timeS)).toAlignedRect());
    update(cursorStrip(timeS).toAlignedRect());
    emit cursorTimeChanged();
}

void CurvePlot::setLimitVelocity(double limit)
{
    changeLimit(m_limitVelocity, limit);
}

void CurvePlot::setLimitAcceleration(double limit)
{
    changeLimit(m_limitAcceleration, limit);
}

void CurvePlot::setLimitFrequency(double limit)
{
    changeLimit(m_limitFrequency, limit);
}

void CurvePlot::changeLimit(double& limit, double value)
{
    if (!sameNumber(limit, value)) {
        limit = value;
        emit limitsChanged();
    }
}

void CurvePlot::setTimeMaximum(double timeS)
{
    if (!sameNumber(timeS, m_timeMaximum)) {
        m_timeMaximum = timeS;
        emit timeMaximumChanged();
    }
}

void CurvePlot::setLimitTorque(double limit)
{
    changeLimit(m_limitTorque, limit);
}

double CurvePlot::limitOf(Quantity quantity) const
{
    switch (quantity) {
    case Quantity::Velocity:
        return m_limitVelocity;
    case Quantity::Acceleration:
        return m_limitAcceleration;
    case Quantity::Frequency:
        return m_limitFrequency;
    case Quantity::Torque:
        return m_limitTorque;
    case Quantity::Position:
    case Quantity::Jerk:
        break;
    }
    return none;
}

const PlotPanel* CurvePlot::velocityPanel() const
{
    const auto found = std::ranges::find(m_panels, Quantity::Velocity, &PlotPanel::quantity);
    return found == m_panels.end() ? nullptr : &*found;
}

QRectF CurvePlot::cursorStrip(double timeS)
{
    ensureLayout();
    if (std::isnan(timeS)) {
        return {};
    }
    const double x = m_timeMap.transform(timeS);
    return m_plotArea.adjusted(0, -cursorReach, 0, cursorReach) &
           QRectF(x - cursorReach, 0, 2 * cursorReach, height());
}

QRectF CurvePlot::traceStrip(double fromS, double toS)
{
    ensureLayout();
    const PlotPanel* panel = velocityPanel();
    if (!panel) {
        return {};
    }
    const double margin = m_style.traceLineWidth + 1;
    const QRectF canvas = panel->axis().canvas();
    return QRectF(QPointF(m_timeMap.transform(fromS), canvas.top()),
                  QPointF(m_timeMap.transform(toS), canvas.bottom()))
        .adjusted(-margin, -margin, margin, margin);
}

} // namespace campanel::plot
