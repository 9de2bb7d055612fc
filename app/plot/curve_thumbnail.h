// SPDX-License-Identifier: Apache-2.0
// A curve as a small picture without axes, from points between 0 and 1.
#pragma once

#include <QColor>
#include <QList>
#include <QPointF>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

namespace campanel::plot {

class CurveThumbnail : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The points by rising x; y is upwards. Fewer than two: nothing is drawn.
    Q_PROPERTY(QList<QPointF> points READ points WRITE setPoints NOTIFY pointsChanged FINAL)
    Q_PROPERTY(QColor color MEMBER m_color NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineWidth MEMBER m_lineWidth NOTIFY styleChanged FINAL) // px

public:
    explicit CurveThumbnail(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    [[nodiscard]] const QList<QPointF>& points() const { return m_points; }
    void setPoints(const QList<QPointF>& points);

signals:
    void pointsChanged();
    void styleChanged();

private:
    void updateAll() { update(boundingRect().toAlignedRect()); }

    QList<QPointF> m_points;
    QColor m_color{Qt::black};
    double m_lineWidth = 2;
};

} // namespace campanel::plot
