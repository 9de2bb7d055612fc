// SPDX-License-Identifier: Apache-2.0
// The regime map of a cutter as a Qt Quick item. The recipe's dot is not painted here: it is a handle over
// the item, so that a drag does not repaint the map.
#pragma once

#include "app/plot/picture/regime_picture.h"

#include <QQuickPaintedItem>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::plot {

class RegimePlot : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The map: std::shared_ptr<const profile::RegimeMap>. Any other value means unknown.
    Q_PROPERTY(QVariant map MEMBER m_map NOTIFY dataChanged FINAL)
    Q_PROPERTY(QStringList limitNames MEMBER m_limitNames NOTIFY dataChanged FINAL)
    // Marks on the axis of the length, in mm.
    Q_PROPERTY(QList<double> marks MEMBER m_marks NOTIFY dataChanged FINAL)
    // A rate in bags/min that the scale includes.
    Q_PROPERTY(double shownRate MEMBER m_shownRate NOTIFY dataChanged FINAL)
    Q_PROPERTY(QString rateUnit MEMBER m_rateUnit NOTIFY dataChanged FINAL)
    // The unit of the lengths, and its factor from mm.
    Q_PROPERTY(QString lengthUnit MEMBER m_lengthUnit NOTIFY dataChanged FINAL)
    Q_PROPERTY(double lengthFactor MEMBER m_lengthFactor NOTIFY dataChanged FINAL)
    Q_PROPERTY(QString refusedName MEMBER m_refusedName NOTIFY dataChanged FINAL)
    Q_PROPERTY(QString marksName MEMBER m_marksName NOTIFY dataChanged FINAL)
    Q_PROPERTY(QList<QColor> limitColors MEMBER m_limitColors NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor surfaceColor MEMBER m_surfaceColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor insetColor MEMBER m_insetColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor inkColor MEMBER m_inkColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor secondaryInkColor MEMBER m_secondaryInkColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineWidth MEMBER m_lineWidth NOTIFY styleChanged FINAL) // px
    Q_PROPERTY(QFont axisFont MEMBER m_axisFont NOTIFY styleChanged FINAL)
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY styleChanged FINAL)
    // The canvas in px of the item; changes with every mapping.
    Q_PROPERTY(QRectF plotArea READ plotArea NOTIFY layoutChanged FINAL)

public:
    explicit RegimePlot(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Update the layout first, so they are not const.
    [[nodiscard]] QRectF plotArea();
    [[nodiscard]] Q_INVOKABLE double xOfLength(double lengthMm);
    [[nodiscard]] Q_INVOKABLE double yOfRate(double rateBagsPerMin);
    // Return the value at the place, kept within the canvas.
    [[nodiscard]] Q_INVOKABLE double lengthOfX(double x);
    [[nodiscard]] Q_INVOKABLE double rateOfY(double y);

signals:
    void dataChanged();
    void styleChanged();
    void layoutChanged();

private:
    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    void invalidate();
    void layOut();

    QVariant m_map;
    QStringList m_limitNames;
    QList<double> m_marks;
    double m_shownRate = 0;
    QString m_rateUnit;
    QString m_lengthUnit = QStringLiteral("mm");
    double m_lengthFactor = 1;
    QString m_refusedName;
    QString m_marksName;
    QList<QColor> m_limitColors{Qt::darkGreen, Qt::blue};
    QColor m_gridColor{Qt::lightGray};
    QColor m_surfaceColor{Qt::white};
    QColor m_insetColor{Qt::lightGray};
    QColor m_inkColor{Qt::black};
    QColor m_secondaryInkColor{Qt::darkGray};
    double m_lineWidth = 2;
    QFont m_axisFont;
    QLocale m_locale;

    RegimePicture m_picture;
    bool m_isLaidOut = false;
};

} // namespace campanel::plot
