// SPDX-License-Identifier: Apache-2.0
// The edges of the mark sensor on the film, the newest at the right, with the windows in which their marks
// were expected.
#pragma once

#include <QColor>
#include <QFont>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QQuickPaintedItem>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <limits>

namespace campanel::plot {

class EdgePicture : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The edges in mm of film, oldest first: 0 is the newest one, earlier ones are negative.
    Q_PROPERTY(QList<double> places MEMBER m_places NOTIFY changed FINAL)
    // One for each: 0 solid, 1 dashed, 2 dotted, 3 rejected.
    Q_PROPERTY(QList<int> looks MEMBER m_looks NOTIFY changed FINAL)
    // One for each, above the film.
    Q_PROPERTY(QStringList notes MEMBER m_notes NOTIFY changed FINAL)
    // The expected marks: (place, half of the window).
    Q_PROPERTY(QList<QPointF> windows MEMBER m_windows NOTIFY changed FINAL)
    // The visible length of film in mm; 0: only the signs of the edges, in the middle, as for a legend.
    Q_PROPERTY(double span MEMBER m_spanMm NOTIFY changed FINAL)
    // The film in mm that is beyond the right end.
    Q_PROPERTY(double back MEMBER m_backMm NOTIFY changed FINAL)

    Q_PROPERTY(QFont textFont MEMBER m_textFont NOTIFY changed FINAL)
    Q_PROPERTY(QString lengthUnit MEMBER m_lengthUnit NOTIFY changed FINAL)
    Q_PROPERTY(double lengthFactor MEMBER m_lengthFactor NOTIFY changed FINAL) // from mm
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY changed FINAL)
    Q_PROPERTY(QColor filmColor MEMBER m_filmColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor edgeColor MEMBER m_edgeColor NOTIFY changed FINAL) // edge of the film
    Q_PROPERTY(QColor markColor MEMBER m_markColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor windowColor MEMBER m_windowColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor rejectedColor MEMBER m_rejectedColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor textColor MEMBER m_textColor NOTIFY changed FINAL)

public:
    static constexpr double rightShare = 0.1; // of the span, right of the newest edge

    explicit EdgePicture(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Returns the place of an object at this place of the film, px from the left.
    [[nodiscard]] double xOf(double placeMm) const;

signals:
    void changed();

protected:
    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;

private:
    // The rows from top to bottom: notes, heads, the film, the scale.
    struct Rows {
        double headsTop = 0;
        double filmTop = 0;
        double filmBottom = 0;
    };

    void updateAll() { update(boundingRect().toAlignedRect()); }
    [[nodiscard]] bool isSign() const { return !(m_spanMm > 0); }
    [[nodiscard]] Rows rows() const;
    [[nodiscard]] double pxPerMm() const;
    [[nodiscard]] double gapMm(double placeMm) const; // from the nearest window's middle
    void paintFilm(QPainter& painter, const Rows& rows) const;
    void paintWindows(QPainter& painter, const Rows& rows) const;
    void paintEdge(QPainter& painter, const Rows& rows, double placeMm, int look) const;
    void paintRejected(QPainter& painter, const Rows& rows, double placeMm) const;
    void paintNotes(QPainter& painter) const;

    QList<double> m_places;
    QList<int> m_looks;
    QStringList m_notes;
    QList<QPointF> m_windows;
    double m_spanMm = 0;
    double m_backMm = 0;
    QFont m_textFont;
    QString m_lengthUnit = QStringLiteral("mm");
    double m_lengthFactor = 1;
    QLocale m_locale;
    QColor m_filmColor{Qt::white};
    QColor m_edgeColor{Qt::gray};
    QColor m_markColor{Qt::black};
    QColor m_windowColor{Qt::cyan};
    QColor m_rejectedColor{Qt::darkYellow};
    QColor m_textColor{Qt::black};
};

} // namespace campanel::plot
