// SPDX-License-Identifier: Apache-2.0
// The deviations of the last bags from the set length as points between the tolerance lines, drawn by Qwt.
// The newest bag is on the right.
#pragma once

#include <QColor>
#include <QList>
#include <QPolygonF>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

#include <limits>

class QwtScaleMap;

namespace campanel::plot {

class BagChart : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The deviations in mm, oldest first; NaN leaves a gap with a line. Only the newest 60 are drawn.
    Q_PROPERTY(QList<double> values MEMBER m_values NOTIFY valuesChanged FINAL)
    // The tolerance, +- mm around zero; NaN: no lines.
    Q_PROPERTY(double tolerance READ tolerance WRITE setTolerance NOTIFY toleranceChanged FINAL)
    // The mean of the values in mm: a line in a band of +- scatter; NaN: none.
    Q_PROPERTY(double mean MEMBER m_mean NOTIFY valuesChanged FINAL)
    Q_PROPERTY(double scatter MEMBER m_scatter NOTIFY valuesChanged FINAL)
    Q_PROPERTY(bool stale MEMBER m_stale NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor backgroundColor MEMBER m_backgroundColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor pointColor MEMBER m_pointColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor staleColor MEMBER m_staleColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor toleranceColor MEMBER m_toleranceColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor violationColor MEMBER m_violationColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(double pointSize MEMBER m_pointSize NOTIFY styleChanged FINAL) // px, diameter

public:
    explicit BagChart(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    [[nodiscard]] double tolerance() const { return m_tolerance; }
    void setTolerance(double tolerance);

signals:
    void valuesChanged();
    void toleranceChanged();
    void styleChanged();

private:
    struct Points {
        QPolygonF good;
        QPolygonF bad;      // outside the tolerance
        QList<double> gaps; // their places
    };

    void updateAll() { update(boundingRect().toAlignedRect()); }
    [[nodiscard]] Points points() const;
    // Returns half of the visible value range, mm.
    [[nodiscard]] double halfRange(const Points& points) const;
    void paintMean(QPainter& painter, const QwtScaleMap& valueMap) const;
    void paintLines(QPainter& painter, const QwtScaleMap& valueMap) const;

    QList<double> m_values;
    double m_tolerance = std::numeric_limits<double>::quiet_NaN();
    double m_mean = std::numeric_limits<double>::quiet_NaN();
    double m_scatter = std::numeric_limits<double>::quiet_NaN();
    bool m_stale = false;
    QColor m_backgroundColor{Qt::transparent};
    QColor m_gridColor{Qt::lightGray};
    QColor m_pointColor{Qt::blue};
    QColor m_staleColor{Qt::gray};
    QColor m_toleranceColor{Qt::darkYellow};
    QColor m_violationColor{Qt::red};
    double m_pointSize = 6;
};

} // namespace campanel::plot
