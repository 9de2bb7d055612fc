// SPDX-License-Identifier: Apache-2.0
// The knife angle as a hand on a ring, with the arc of synchronous motion and the mark of the cut. 0 degrees
// at the top, clockwise.
#pragma once

#include <QColor>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

#include <limits>

namespace campanel::plot {

class KnifeDial : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The angles in degrees; NaN: unknown, not drawn.
    Q_PROPERTY(double angleDeg READ angleDeg WRITE setAngleDeg NOTIFY angleDegChanged FINAL)
    Q_PROPERTY(double syncStartDeg READ syncStartDeg WRITE setSyncStartDeg NOTIFY marksChanged FINAL)
    Q_PROPERTY(double syncEndDeg READ syncEndDeg WRITE setSyncEndDeg NOTIFY marksChanged FINAL)
    Q_PROPERTY(double cutAngleDeg READ cutAngleDeg WRITE setCutAngleDeg NOTIFY marksChanged FINAL)
    // True when the angle is old: the hand is drawn in staleColor.
    Q_PROPERTY(bool stale MEMBER m_stale NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor ringColor MEMBER m_ringColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor syncColor MEMBER m_syncColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor cutColor MEMBER m_cutColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor handColor MEMBER m_handColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor tipColor MEMBER m_tipColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor surfaceColor MEMBER m_surfaceColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor staleColor MEMBER m_staleColor NOTIFY styleChanged FINAL)

public:
    explicit KnifeDial(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    [[nodiscard]] double angleDeg() const { return m_angleDeg; }
    void setAngleDeg(double angle);
    [[nodiscard]] double syncStartDeg() const { return m_syncStartDeg; }
    void setSyncStartDeg(double angle) { changeMark(m_syncStartDeg, angle); }
    [[nodiscard]] double syncEndDeg() const { return m_syncEndDeg; }
    void setSyncEndDeg(double angle) { changeMark(m_syncEndDeg, angle); }
    [[nodiscard]] double cutAngleDeg() const { return m_cutAngleDeg; }
    void setCutAngleDeg(double angle) { changeMark(m_cutAngleDeg, angle); }

signals:
    void angleDegChanged();
    void marksChanged();
    void styleChanged();

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    // Updates an explicit rectangle: a following update(rectangle) would make Qt ignore update().
    void updateAll() { update(boundingRect().toAlignedRect()); }
    void changeMark(double& mark, double angle);
    void paintRing(QPainter& painter) const;
    void paintHand(QPainter& painter) const;
    // Return the distance of the ring's middle from the center, and the ring's width, px.
    [[nodiscard]] double ringRadius() const;
    [[nodiscard]] double ringWidth() const;
    [[nodiscard]] QPointF pointAt(double angle, double radius) const;
    // Returns the area of the hand at an angle.
    [[nodiscard]] QRect handRect(double angle) const;

    double m_angleDeg = unknown;
    double m_syncStartDeg = unknown;
    double m_syncEndDeg = unknown;
    double m_cutAngleDeg = unknown;
    bool m_stale = false;
    QColor m_ringColor{Qt::lightGray};
    QColor m_syncColor{Qt::darkGray};
    QColor m_cutColor{Qt::black};
    QColor m_handColor{Qt::black};
    QColor m_tipColor{Qt::blue};
    QColor m_surfaceColor{Qt::white};
    QColor m_staleColor{Qt::gray};
};

} // namespace campanel::plot
