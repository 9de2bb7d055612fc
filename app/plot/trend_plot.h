// SPDX-License-Identifier: Apache-2.0
// Up to three quantities over the time of day, stacked over one axis of local time. One finger moves the
// window, two zoom it, a tap or a held finger sets the cursor. All in the GUI thread.
#pragma once

#include "app/plot/trend_lane.h"
#include "app/plot/window_gesture.h"

#include <QImage>
#include <QQuickPaintedItem>
#include <QTimer>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <limits>
#include <vector>

namespace campanel::plot {

class TrendPlot : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The curves: std::shared_ptr<const QList<QList<QPointF>>>, for each lane means, lowest and highest
    // values over ms since 1970 UTC; a NaN as y is a gap. Any other value means unknown.
    Q_PROPERTY(QVariant curves MEMBER m_curves NOTIFY dataChanged FINAL)
    Q_PROPERTY(int lanes MEMBER m_laneCount NOTIFY dataChanged FINAL)
    Q_PROPERTY(double fromMs MEMBER m_fromMs NOTIFY dataChanged FINAL)
    Q_PROPERTY(double toMs MEMBER m_toMs NOTIFY dataChanged FINAL)
    // The tolerances of the lanes, in both directions from zero; NaN: none.
    // The factors from the data to the unit of the axis, by lane; missing: 1.
    Q_PROPERTY(QList<double> factors MEMBER m_factors NOTIFY dataChanged FINAL)
    Q_PROPERTY(QList<double> tolerances MEMBER m_tolerances NOTIFY dataChanged FINAL)
    // The cursor in ms; NaN: none.
    Q_PROPERTY(double cursorMs MEMBER m_cursorMs NOTIFY cursorChanged FINAL)
    // The space above each lane for its title, px.
    Q_PROPERTY(double headerHeight MEMBER m_headerHeight NOTIFY styleChanged FINAL)
    // The px from a lane's top in which a held finger selects the header instead of a time; 0: none.
    Q_PROPERTY(double headerReach MEMBER m_headerReach NOTIFY styleChanged FINAL)
    Q_PROPERTY(QList<QColor> laneColors MEMBER m_laneColors NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor inkColor MEMBER m_inkColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor secondaryInkColor MEMBER m_secondaryInkColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor toleranceColor MEMBER m_toleranceColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineWidth MEMBER m_lineWidth NOTIFY styleChanged FINAL)
    Q_PROPERTY(QFont axisFont MEMBER m_axisFont NOTIFY styleChanged FINAL)
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY styleChanged FINAL)
    // The canvas of all lanes together, in px of the item.
    Q_PROPERTY(QRectF plotArea READ plotArea NOTIFY layoutChanged FINAL)

public:
    explicit TrendPlot(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Update the layout first, so they are not const.
    [[nodiscard]] QRectF plotArea();
    [[nodiscard]] Q_INVOKABLE double laneTop(int lane); // top of its header
    [[nodiscard]] Q_INVOKABLE double xOfTime(double timeMs);
    [[nodiscard]] Q_INVOKABLE double timeOfX(double x);
    // Returns {lowest, mean, highest} of the lane at that time; NaN in a gap.
    [[nodiscard]] Q_INVOKABLE QList<double> valuesAt(int lane, double timeMs);
    [[nodiscard]] Q_INVOKABLE QString momentText(double timeMs) const;
    [[nodiscard]] qsizetype drawnPoints(int lane);

signals:
    void dataChanged();
    void cursorChanged();
    void styleChanged();
    void layoutChanged();
    // Emitted when a gesture requests this window.
    void windowWanted(double fromMs, double toMs);
    // Emitted when a finger selects this time.
    void cursorWanted(double timeMs);
    void headerHeld(int lane);

protected:
    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    void touchEvent(QTouchEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void touchUngrabEvent() override { endGesture(); }
    void mouseUngrabEvent() override { endGesture(); }

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    void invalidate();
    void ensureLayout();
    void putFingers(const QList<double>& x, double y);
    void moveFingers(const QList<double>& x);
    void liftLast(double x);
    void endGesture();
    void takeHold();
    void pointCursor();
    [[nodiscard]] int headerAt(double y); // -1: none
    [[nodiscard]] PlotStyle style() const;
    [[nodiscard]] QwtScaleMap timeMap() const;
    void paintPicture(QPainter& painter);
    void paintTimeAxis(QPainter& painter) const;
    void paintCursor(QPainter& painter) const;

    QVariant m_curves;
    int m_laneCount = 1;
    double m_fromMs = 0;
    double m_toMs = 1;
    QList<double> m_factors;
    QList<double> m_tolerances;
    double m_cursorMs = unknown;
    double m_headerHeight = 0;
    double m_headerReach = 0;
    QList<QColor> m_laneColors;
    QColor m_gridColor{Qt::lightGray};
    QColor m_inkColor{Qt::black};
    QColor m_secondaryInkColor{Qt::darkGray};
    QColor m_toleranceColor{Qt::darkYellow};
    double m_lineWidth = 2;
    QFont m_axisFont;
    QLocale m_locale;

    std::vector<TrendLane> m_lanes;
    bool m_isLayoutOld = true;
    QRectF m_area;
    double m_labelWidth = 0; // only grows, so that the curves do not move sideways
    WindowGesture m_gesture;
    QTimer m_holdTimer;
    double m_pressX = 0;
    double m_pressY = 0;
    bool m_isPointing = false;     // a held finger moves the cursor
    bool m_isDone = false;         // it selected a header: ignored until it is lifted
    bool m_wereTwoFingers = false; // the remaining one of two fingers does not point
};

} // namespace campanel::plot
