// SPDX-License-Identifier: Apache-2.0
// The torque of a knife over the angle of its shaft: the learned band, the last readings, the last jam. Drawn
// by Qwt into a Qt Quick item.
#pragma once

#include "app/plot/picture/axis_scale.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QQuickPaintedItem>
#include <QRectF>
#include <QtQml/qqmlregistration.h>

#include <qwt_scale_div.h>
#include <qwt_scale_map.h>

#include <limits>

namespace campanel::plot {

class BandPlot : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The middles of equal parts of the band, (angle, expected torque), by their angle, and half of the
    // band's width at each of them.
    Q_PROPERTY(QList<QPointF> expected MEMBER m_expected NOTIFY changed FINAL)
    Q_PROPERTY(QList<double> halfWidths MEMBER m_halfWidths NOTIFY changed FINAL)
    // Single readings, (angle, torque); the newest is the last one.
    Q_PROPERTY(QList<QPointF> readings MEMBER m_readings NOTIFY changed FINAL)
    // (angle, torque); NaN for none.
    Q_PROPERTY(QPointF jam MEMBER m_jam NOTIFY changed FINAL)
    // The visible angles.
    Q_PROPERTY(double from MEMBER m_from NOTIFY changed FINAL)
    Q_PROPERTY(double to MEMBER m_to NOTIFY changed FINAL)
    // The angle of the cut is 0; of the start of the monitoring: NaN for none.
    Q_PROPERTY(double closing MEMBER m_closing NOTIFY changed FINAL)
    Q_PROPERTY(QString cutLabel MEMBER m_cutLabel NOTIFY changed FINAL)
    Q_PROPERTY(QString closingLabel MEMBER m_closingLabel NOTIFY changed FINAL)

    Q_PROPERTY(QFont axisFont MEMBER m_axisFont NOTIFY changed FINAL)
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY changed FINAL)
    Q_PROPERTY(double lineWidth MEMBER m_lineWidth NOTIFY changed FINAL) // px
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor secondaryInkColor MEMBER m_secondaryInkColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor bandColor MEMBER m_bandColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor expectedColor MEMBER m_expectedColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor readingColor MEMBER m_readingColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor jamColor MEMBER m_jamColor NOTIFY changed FINAL)

public:
    explicit BandPlot(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Return px of the item, as last painted.
    [[nodiscard]] double xOfAngle(double deg) const { return m_angleMap.transform(deg); }
    [[nodiscard]] double yOfTorque(double percent) const { return m_torqueMap.transform(percent); }

signals:
    void changed();

private:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    void updateAll() { update(boundingRect().toAlignedRect()); }
    [[nodiscard]] bool hasJam() const;
    void fitScales();
    void place();
    void paintAxes(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintReadings(QPainter& painter) const;
    void paintJam(QPainter& painter) const;

    QList<QPointF> m_expected;
    QList<double> m_halfWidths;
    QList<QPointF> m_readings;
    QPointF m_jam{none, none};
    double m_from = -45;
    double m_to = 45;
    double m_closing = none;
    QString m_cutLabel;
    QString m_closingLabel;
    QFont m_axisFont;
    QLocale m_locale;
    double m_lineWidth = 3;
    QColor m_gridColor{Qt::lightGray};
    QColor m_secondaryInkColor{Qt::darkGray};
    QColor m_bandColor{Qt::cyan};
    QColor m_expectedColor{Qt::gray};
    QColor m_readingColor{Qt::blue};
    QColor m_jamColor{Qt::darkYellow};

    AxisScale m_torqueScale;
    QwtScaleDiv m_angles; // whole numbers are its ticks, its ends are any
    QRectF m_canvas;
    QwtScaleMap m_angleMap;
    QwtScaleMap m_torqueMap;
};

} // namespace campanel::plot
