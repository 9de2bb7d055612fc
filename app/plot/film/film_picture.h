// SPDX-License-Identifier: Apache-2.0
// The film of a packing machine from the mark sensor on the left to the knife on the right: printed marks,
// the expected mark, products, the next cuts. Between two reports advance() moves it at the film's speed.
#pragma once

#include "app/plot/film/film_motion.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <limits>

namespace campanel::plot {

class FilmPicture : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The places in mm before the knife with the film motor at `position`; negative: past the knife. Cuts are
    // (distance, kind), marks (distance, 1 when calculated), products (leading edge, trailing edge). Kinds of
    // a cut are 0, 1 when skipped, 2 of the next program, 3 the same at the end of a bag that is scrap.
    Q_PROPERTY(QList<QPointF> cuts MEMBER m_cuts NOTIFY filmChanged FINAL)
    Q_PROPERTY(QList<QPointF> marks MEMBER m_marks NOTIFY filmChanged FINAL)
    Q_PROPERTY(QList<QPointF> products MEMBER m_products NOTIFY filmChanged FINAL)
    Q_PROPERTY(double nextMark MEMBER m_nextMarkMm NOTIFY filmChanged FINAL) // expected place; NaN: none
    Q_PROPERTY(double position MEMBER m_positionMm NOTIFY filmChanged FINAL) // NaN: unknown
    Q_PROPERTY(double speed MEMBER m_speedMmPerS NOTIFY filmChanged FINAL)   // mm/s
    // Bags that do not count: the next x before the knife, and y behind it, 0 or 1.
    Q_PROPERTY(QPointF scrap MEMBER m_scrap NOTIFY filmChanged FINAL)
    // The dimensions in mm; NaN while unknown. Without a bag length all cuts are visible.
    Q_PROPERTY(double bagLength MEMBER m_bagMm NOTIFY scaleChanged FINAL)
    Q_PROPERTY(double sensor MEMBER m_sensorMm NOTIFY scaleChanged FINAL) // before the knife; NaN: not drawn
    Q_PROPERTY(double window MEMBER m_windowMm NOTIFY scaleChanged FINAL) // in both directions from nextMark
    // True while the knife waits open.
    Q_PROPERTY(bool knifeOpen MEMBER m_isKnifeOpen NOTIFY styleChanged FINAL)
    // True when the data is old: gray and without movement.
    Q_PROPERTY(bool stale MEMBER m_isStale NOTIFY styleChanged FINAL)
    // True to follow the film's speed between two reports; when false, the last report is displayed.
    Q_PROPERTY(bool live MEMBER m_isLive NOTIFY styleChanged FINAL)

    Q_PROPERTY(QString sensorText MEMBER m_sensorText NOTIFY styleChanged FINAL)
    Q_PROPERTY(
        QString nextText MEMBER m_nextText NOTIFY styleChanged FINAL) // at the next program's first cut
    Q_PROPERTY(QString knifeText MEMBER m_knifeText NOTIFY styleChanged FINAL)
    Q_PROPERTY(QFont textFont MEMBER m_textFont NOTIFY styleChanged FINAL)
    // The unit of the scale, and its factor from mm.
    Q_PROPERTY(QString lengthUnit MEMBER m_lengthUnit NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lengthFactor MEMBER m_lengthFactor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor filmColor MEMBER m_filmColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor edgeColor MEMBER m_edgeColor NOTIFY styleChanged
                   FINAL) // edge of the film, and all that is old
    Q_PROPERTY(QColor markColor MEMBER m_markColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor windowColor MEMBER m_windowColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor productColor MEMBER m_productColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor cutColor MEMBER m_cutColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor skippedColor MEMBER m_skippedColor NOTIFY styleChanged FINAL)
    // The color of a ring around the knife; transparent: none.
    Q_PROPERTY(QColor faultColor MEMBER m_faultColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor knifeColor MEMBER m_knifeColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor textColor MEMBER m_textColor NOTIFY styleChanged FINAL)

public:
    explicit FilmPicture(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Sets a clock in seconds for tests.
    void setClock(std::function<double()> clock) { m_clock = std::move(clock); }
    // Returns the present place of an object reported at this distance, px from the left.
    [[nodiscard]] double xOf(double distanceMm) const;
    // Paints the film again when it has moved since it was painted, ten times a second at most. Returns
    // whether.
    Q_INVOKABLE bool advance();

signals:
    void filmChanged();
    void scaleChanged();
    void styleChanged();

protected:
    void updatePolish() override { takeReport(); }
    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    // The rows from top to bottom: names, heads of the cuts, the film, the scale.
    struct Rows {
        double headsTop = 0;
        double filmTop = 0;
        double filmBottom = 0;
    };

    void updateAll() { update(boundingRect().toAlignedRect()); }
    void noteFilm();
    void takeReport();
    [[nodiscard]] QColor live(const QColor& color) const { return m_isStale ? m_edgeColor : color; }
    [[nodiscard]] Rows rows() const;
    [[nodiscard]] double reachMm() const; // visible film before the knife
    [[nodiscard]] double pxPerMm() const;
    [[nodiscard]] double knifeX() const;
    [[nodiscard]] double travelledMm() const;
    [[nodiscard]] bool isDue() const;
    void paintFilm(QPainter& painter, const Rows& rows) const;
    void paintScale(QPainter& painter, const Rows& rows) const;
    [[nodiscard]] QRectF nextTextRect() const; // empty: there is none
    void paintScrap(QPainter& painter, const Rows& rows) const;
    void paintProducts(QPainter& painter, const Rows& rows) const;
    void paintWindow(QPainter& painter, const Rows& rows) const;
    void paintMarks(QPainter& painter, const Rows& rows) const;
    void paintCuts(QPainter& painter, const Rows& rows) const;
    void paintNextText(QPainter& painter) const;
    void paintSensor(QPainter& painter, const Rows& rows) const;
    void paintKnife(QPainter& painter, const Rows& rows) const;

    QList<QPointF> m_cuts;
    QList<QPointF> m_marks;
    QList<QPointF> m_products;
    double m_nextMarkMm = unknown;
    double m_positionMm = unknown;
    double m_speedMmPerS = 0;
    QPointF m_scrap;
    double m_bagMm = unknown;
    double m_sensorMm = unknown;
    double m_windowMm = unknown;
    bool m_isKnifeOpen = false;
    bool m_isStale = false;
    bool m_isLive = true;
    QString m_sensorText;
    QString m_nextText;
    QString m_knifeText;
    QFont m_textFont;
    QString m_lengthUnit = QStringLiteral("mm");
    double m_lengthFactor = 1;
    QLocale m_locale;
    QColor m_filmColor{Qt::white};
    QColor m_edgeColor{Qt::gray};
    QColor m_markColor{Qt::black};
    QColor m_windowColor{Qt::cyan};
    QColor m_productColor{Qt::darkCyan};
    QColor m_cutColor{Qt::blue};
    QColor m_skippedColor{Qt::red};
    QColor m_faultColor{Qt::transparent};
    QColor m_knifeColor{Qt::black};
    QColor m_textColor{Qt::black};

    std::function<double()> m_clock;
    FilmMotion m_motion;
    double m_paintedMm = 0; // travelledMm() in the present picture
    double m_paintedS = -std::numeric_limits<double>::infinity();
    bool m_isReportNew = false;
};

} // namespace campanel::plot
