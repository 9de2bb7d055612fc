// SPDX-License-Identifier: Apache-2.0
// The curves of one cycle in stacked panels with a common time axis, drawn by Qwt into a Qt Quick item. Grid,
// curves and limits change rarely and are cached as an image; cursor and trace are painted over it. All
// properties belong to the GUI thread.
#pragma once

#include "app/plot/curve_style.h"
#include "app/plot/plot_panel.h"

#include <QImage>
#include <QQuickPaintedItem>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <limits>
#include <vector>

namespace campanel::plot {

class CurvePlot : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The curve sets: std::shared_ptr<const profile::Curves>; any other value means none.
    Q_PROPERTY(campanel::plot::CurveStyle* style READ curveStyle CONSTANT FINAL)
    Q_PROPERTY(QVariant curves MEMBER m_curves NOTIFY curvesChanged FINAL)
    Q_PROPERTY(QVariant overlayCurves MEMBER m_overlayCurves NOTIFY overlayCurvesChanged FINAL)
    // The panels from top to bottom: "position" mm, "velocity" mm/s, "acceleration" m/s2, "jerk" m/s3,
    // "frequency" kHz, "torque" Nm.
    Q_PROPERTY(QStringList quantities MEMBER m_quantities NOTIFY quantitiesChanged FINAL)
    // The factors from the panels' units to those of their axes, in inches for example; missing: 1.
    Q_PROPERTY(QList<double> factors MEMBER m_factors NOTIFY titlesChanged FINAL)
    Q_PROPERTY(QStringList titles MEMBER m_titles NOTIFY titlesChanged FINAL)
    // The measured points over the velocity panel: x cycle time in s, ascending; y in mm/s.
    Q_PROPERTY(QList<QPointF> trace READ trace WRITE setTrace NOTIFY traceChanged FINAL)
    // The cursor in s; NaN for none.
    Q_PROPERTY(double cursorTime READ cursorTime WRITE setCursorTime NOTIFY cursorTimeChanged FINAL)
    Q_PROPERTY(bool cursorDotsVisible MEMBER m_cursorDotsVisible NOTIFY cursorDotsVisibleChanged FINAL)
    Q_PROPERTY(QList<double> markerTimes MEMBER m_markerTimes NOTIFY markersChanged FINAL)
    // The limits in mm/s, mm/s2, Hz and Nm; NaN for none.
    Q_PROPERTY(double limitVelocity READ limitVelocity WRITE setLimitVelocity NOTIFY limitsChanged FINAL)
    Q_PROPERTY(
        double limitAcceleration READ limitAcceleration WRITE setLimitAcceleration NOTIFY limitsChanged FINAL)
    Q_PROPERTY(double limitFrequency READ limitFrequency WRITE setLimitFrequency NOTIFY limitsChanged FINAL)
    Q_PROPERTY(double limitTorque READ limitTorque WRITE setLimitTorque NOTIFY limitsChanged FINAL)
    // The spans that exceed a limit: x from, y to, in s.
    Q_PROPERTY(QList<QPointF> violations MEMBER m_violations NOTIFY markersChanged FINAL)
    // The text at the limit lines; empty for none.
    Q_PROPERTY(QString limitLabel MEMBER m_limitLabel NOTIFY limitLabelChanged FINAL)
    // The end of the time axis in s; NaN: the end of the curves.
    Q_PROPERTY(double timeMaximum READ timeMaximum WRITE setTimeMaximum NOTIFY timeMaximumChanged FINAL)
    Q_PROPERTY(QString timeUnit MEMBER m_timeUnit NOTIFY timeUnitChanged FINAL)
    // The canvas of all panels together, in px of the item.
    Q_PROPERTY(QRectF plotArea READ plotArea NOTIFY layoutChanged FINAL)

public:
    explicit CurvePlot(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;
    // Paints everything but cursor and trace, in the size of the item, without the cached image, so that
    // lines stay vector graphics. The item needs no window.
    void print(QPainter& painter);

    // Convert between s, values and px of the item. NaN for a missing panel; values outside are not clamped.
    // They update the layout first, so they are not const.
    [[nodiscard]] Q_INVOKABLE double xOfTime(double timeS);
    [[nodiscard]] Q_INVOKABLE double timeOfX(double x);
    [[nodiscard]] double yOfVelocity(double velocityMmPerS);
    // Returns the place of a value in the displayed unit of the panel with this index.
    [[nodiscard]] Q_INVOKABLE double yOfValue(int index, double value);
    [[nodiscard]] Q_INVOKABLE double valuePerPixel(int index);
    [[nodiscard]] double panelTop(int index);
    [[nodiscard]] Q_INVOKABLE double panelHeight(int index);
    // Returns one value per panel in its displayed unit (mm, mm/s, m/s2, m/s3, kHz, Nm); NaN outside the
    // curves.
    [[nodiscard]] Q_INVOKABLE QList<double> valuesAt(double timeS);

    [[nodiscard]] CurveStyle* curveStyle() { return &m_style; }
    [[nodiscard]] QRectF plotArea();
    [[nodiscard]] const QList<QPointF>& trace() const { return m_trace; }
    void setTrace(const QList<QPointF>& trace);
    [[nodiscard]] double cursorTime() const { return m_cursorTime; }
    void setCursorTime(double timeS);
    [[nodiscard]] double limitVelocity() const { return m_limitVelocity; }
    void setLimitVelocity(double limit);
    [[nodiscard]] double limitAcceleration() const { return m_limitAcceleration; }
    void setLimitAcceleration(double limit);
    [[nodiscard]] double limitFrequency() const { return m_limitFrequency; }
    void setLimitFrequency(double limit);
    [[nodiscard]] double limitTorque() const { return m_limitTorque; }
    void setLimitTorque(double limit);
    [[nodiscard]] double timeMaximum() const { return m_timeMaximum; }
    void setTimeMaximum(double timeS);

    // Returns how often the cached image was painted.
    [[nodiscard]] int staticPaintCount() const { return m_staticPaintCount; }

signals:
    void curvesChanged();
    void overlayCurvesChanged();
    void quantitiesChanged();
    void titlesChanged();
    void traceChanged();
    void cursorTimeChanged();
    void markersChanged();
    void limitsChanged();
    void timeMaximumChanged();
    void cursorDotsVisibleChanged();
    void limitLabelChanged();
    void timeUnitChanged();
    // Emitted when the mapping between px and values has changed.
    void layoutChanged();

protected:
    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    void updatePolish() override;

private:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    static constexpr double titleGap = 4; // px between a title and the canvas below it

    struct Mapping {
        QRectF area;
        QRectF velocityCanvas; // another panel makes it lower, also at the same scale
        double timeEnd = 0;
        double velocityLow = 0;
        double velocityHigh = 0;
        bool operator==(const Mapping&) const = default;
    };

    void connectProperties();
    void invalidateLayout();
    void invalidateImage();
    // Updates an explicit rectangle: QQuickPaintedItem ignores update() when an update(rectangle) follows
    // before the frame.
    void updateAll() { update(boundingRect().toAlignedRect()); }
    // Updates data, scales and geometry.
    void ensureLayout();
    void rebuildPanels();
    void placePanels();
    void placeTimeAxis();
    void changeLimit(double& limit, double value);
    [[nodiscard]] Mapping mapping() const;

    [[nodiscard]] PlotStyle style() const;
    [[nodiscard]] QColor colorOf(Quantity quantity) const;
    [[nodiscard]] double limitOf(Quantity quantity) const;
    [[nodiscard]] const PlotPanel* velocityPanel() const;
    [[nodiscard]] QRectF cursorStrip(double timeS);
    [[nodiscard]] QRectF traceStrip(double fromS, double toS);

    void paintImage();
    void paintStatic(QPainter& painter) const;
    void paintMarkers(QPainter& painter) const;
    void paintTints(QPainter& painter) const;
    void paintTitles(QPainter& painter) const;
    [[nodiscard]] QRectF titleRect(std::size_t panel) const;
    void paintTimeLabels(QPainter& painter, const PlotStyle& style) const;
    void paintTrace(QPainter& painter) const;
    void paintCursor(QPainter& painter) const;

    CurveStyle m_style;
    QVariant m_curves;
    QVariant m_overlayCurves;
    QStringList m_quantities{QStringLiteral("velocity")};
    QList<double> m_factors;
    QStringList m_titles;
    QList<QPointF> m_trace;
    double m_cursorTime = none;
    bool m_cursorDotsVisible = true;
    QList<double> m_markerTimes;
    double m_limitVelocity = none;
    double m_limitAcceleration = none;
    double m_limitFrequency = none;
    double m_limitTorque = none;
    QList<QPointF> m_violations;
    QString m_limitLabel;
    double m_timeMaximum = none;
    QString m_timeUnit = QStringLiteral("s");

    CurveSet m_curveSet;
    CurveSet m_overlaySet;
    std::vector<PlotPanel> m_panels;
    QRectF m_plotArea;
    QwtScaleMap m_timeMap;
    QwtScaleDiv m_timeDivision;
    double m_labelWidth =
        0; // px left of the canvas; grows only, so that the canvas does not move with the digits
    Mapping m_announcedMapping;
    bool m_layoutValid = false;
    bool m_imageValid = false;
    QImage m_image;
    int m_staticPaintCount = 0;
};

} // namespace campanel::plot
