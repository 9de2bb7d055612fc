// SPDX-License-Identifier: Apache-2.0
// Twenty-four hours of the line, minute by minute, in three lanes with a common time axis: answers as an
// area, errors as bars, answer times as a line. Drawn by Qwt; one pixel column displays its worst minute.
#pragma once

#include <QColor>
#include <QDateTime>
#include <QFont>
#include <QList>
#include <QQuickPaintedItem>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace campanel::plot {

class StripChart : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The figures of each minute, oldest first; NaN: unknown. Only the newest 1440 are drawn.
    Q_PROPERTY(QList<double> answers MEMBER m_answers NOTIFY dataChanged FINAL)
    Q_PROPERTY(QList<double> errors MEMBER m_errors NOTIFY dataChanged FINAL)
    Q_PROPERTY(QList<double> timesMs MEMBER m_timesMs NOTIFY dataChanged FINAL)
    Q_PROPERTY(QDateTime end MEMBER m_end NOTIFY dataChanged FINAL) // newest minute
    // The texts before the largest value of each lane, translated.
    Q_PROPERTY(QString answersTitle MEMBER m_answersTitle NOTIFY styleChanged FINAL)
    Q_PROPERTY(QString errorsTitle MEMBER m_errorsTitle NOTIFY styleChanged FINAL)
    Q_PROPERTY(QString timesTitle MEMBER m_timesTitle NOTIFY styleChanged FINAL)
    Q_PROPERTY(QString localeName MEMBER m_localeName NOTIFY styleChanged FINAL)
    Q_PROPERTY(QFont textFont MEMBER m_textFont NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor textColor MEMBER m_textColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor backgroundColor MEMBER m_backgroundColor NOTIFY styleChanged FINAL) // behind texts
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor answersColor MEMBER m_answersColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor errorsColor MEMBER m_errorsColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor timesColor MEMBER m_timesColor NOTIFY styleChanged FINAL)

public:
    static constexpr int minutes = 24 * 60;

    explicit StripChart(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

signals:
    void dataChanged();
    void styleChanged();

private:
    enum class Shape { Area, Bars, Line };
    struct Lane {
        const QList<double>& values;
        QString title;
        QColor color;
        Shape shape = Shape::Line;
        int decimals = 0;
    };

    void updateAll() { update(boundingRect().toAlignedRect()); }
    void paintLane(QPainter& painter, const Lane& lane, const QRectF& rect) const;
    void paintClock(QPainter& painter, const QRectF& rect) const;

    QList<double> m_answers;
    QList<double> m_errors;
    QList<double> m_timesMs;
    QDateTime m_end;
    QString m_answersTitle{QStringLiteral("%1")};
    QString m_errorsTitle{QStringLiteral("%1")};
    QString m_timesTitle{QStringLiteral("%1")};
    QString m_localeName;
    QFont m_textFont;
    QColor m_textColor{Qt::darkGray};
    QColor m_backgroundColor{Qt::white};
    QColor m_gridColor{Qt::lightGray};
    QColor m_answersColor{Qt::blue};
    QColor m_errorsColor{Qt::red};
    QColor m_timesColor{Qt::darkYellow};
};

// Returns the largest known value of each of `columns` equal sections of the newest `minutes` values, the
// last value in the last column. NaN where none is known.
[[nodiscard]] QList<double> worstOfColumns(const QList<double>& values, int minutes, int columns);

} // namespace campanel::plot
