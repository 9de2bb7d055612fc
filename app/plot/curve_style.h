// SPDX-License-Identifier: Apache-2.0
// `CurvePlot.style` in QML: colors, line widths and fonts of a plot of curves.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::plot {

class CurveStyle : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The style belongs to its CurvePlot")

    Q_PROPERTY(QColor gridColor MEMBER gridColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor inkColor MEMBER inkColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor secondaryInkColor MEMBER secondaryInkColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor surfaceColor MEMBER surfaceColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor positionColor MEMBER positionColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor velocityColor MEMBER velocityColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor accelerationColor MEMBER accelerationColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor jerkColor MEMBER jerkColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor frequencyColor MEMBER frequencyColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor torqueColor MEMBER torqueColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor overlayColor MEMBER overlayColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor traceColor MEMBER traceColor NOTIFY traceChanged FINAL)
    Q_PROPERTY(QColor limitColor MEMBER limitColor NOTIFY changed FINAL)
    Q_PROPERTY(QColor violationColor MEMBER violationColor NOTIFY changed FINAL)
    Q_PROPERTY(double lineWidth MEMBER lineWidth NOTIFY changed FINAL)
    Q_PROPERTY(double overlayLineWidth MEMBER overlayLineWidth NOTIFY changed FINAL)
    Q_PROPERTY(double traceLineWidth MEMBER traceLineWidth NOTIFY traceChanged FINAL)
    Q_PROPERTY(double labelGap MEMBER labelGap NOTIFY fontsChanged FINAL)
    Q_PROPERTY(QFont axisFont MEMBER axisFont NOTIFY fontsChanged FINAL)
    Q_PROPERTY(QFont titleFont MEMBER titleFont NOTIFY fontsChanged FINAL)
    Q_PROPERTY(QLocale locale MEMBER locale NOTIFY fontsChanged FINAL)

public:
    QColor gridColor{Qt::lightGray};
    QColor inkColor{Qt::black};
    QColor secondaryInkColor{Qt::darkGray};
    QColor markerColor{Qt::gray};
    QColor surfaceColor{Qt::white};
    QColor positionColor{Qt::black};
    QColor velocityColor{Qt::black};
    QColor accelerationColor{Qt::black};
    QColor jerkColor{Qt::black};
    QColor frequencyColor{Qt::black};
    QColor torqueColor{Qt::black};
    QColor overlayColor{Qt::gray};
    QColor traceColor{Qt::blue};
    QColor limitColor{Qt::darkYellow};
    QColor violationColor{Qt::red};
    double lineWidth = 3;
    double overlayLineWidth = 2;
    double traceLineWidth = 2.5;
    double labelGap = 8; // px between the axis and its numbers
    QFont axisFont;
    QFont titleFont;
    QLocale locale;

signals:
    void changed();
    void traceChanged(); // the color or width of the trace
    void fontsChanged();
};

} // namespace campanel::plot
