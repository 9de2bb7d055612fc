// SPDX-License-Identifier: Apache-2.0
// The QML module loads, and QML values reach the items.
#include "samples.h"

#include "app/plot/curve_plot.h"
#include "tests/support/test_program.h"

#include <QQmlComponent>
#include <QQmlContext>
#include <QQmlEngine>
#include <QTest>

#include <memory>

namespace campanel::plot::test_plot_module {

// Replaces the panel's objects that pass curves to QML.
class CurveSource : public QObject {
    Q_OBJECT
    Q_PROPERTY(QVariant curves MEMBER m_curves CONSTANT FINAL)
    Q_PROPERTY(QList<QPointF> trace MEMBER m_trace CONSTANT FINAL)
    QVariant m_curves = test::curveVariant([](double t) { return 300 + 100 * t; });
    QList<QPointF> m_trace{{0.0, 300.0}, {0.5, 350.0}};
};

class TestPlotModule : public QObject {
    Q_OBJECT
private slots:
    void typesLoadAndTakeValues();
};

void TestPlotModule::typesLoadAndTakeValues()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    QQmlEngine engine;
    engine.addImportPath(QStringLiteral("qrc:/qt/qml"));
    QQmlComponent component(&engine);
    component.setData(R"(
        import QtQuick
        import CamPanel.Plot
        Item {
            id: root
            required property QtObject source
            property alias plot: curvePlot
            property real handleX: { curvePlot.plotArea; return curvePlot.xOfTime(0.5) }
            CurvePlot {
                id: curvePlot
                width: 400; height: 300
                quantities: ["velocity", "frequency"]
                titles: ["Velocity mm/s", "Pulse frequency kHz"]
                curves: root.source.curves
                overlayCurves: undefined
                trace: root.source.trace
                markerTimes: [0.25, 0.5]
                violations: [Qt.point(0.1, 0.2)]
                style.locale: Qt.locale("de_DE")
                style.axisFont: Qt.font({ pixelSize: 12 })
                cursorTime: NaN
                limitVelocity: NaN
            }
            KnifeDial { angleDeg: 12; syncStartDeg: 150; syncEndDeg: 210; cutAngleDeg: 180; stale: false }
            BagChart { values: [0.1, -0.2]; tolerance: 1 }
        }
    )",
                      QUrl());
    CurveSource source;
    const std::unique_ptr<QObject> root(component.createWithInitialProperties(
        {{QStringLiteral("source"), QVariant::fromValue<QObject*>(&source)}}));
    QVERIFY2(root, qPrintable(component.errorString()));
    auto* plot = root->property("plot").value<CurvePlot*>();
    QVERIFY(plot);
    QCOMPARE(plot->valuesAt(0.5).value(0), 350.0);
    QCOMPARE(plot->trace().size(), 2);
    QCOMPARE(plot->property("markerTimes").value<QList<double>>(), QList<double>({0.25, 0.5}));
    QCOMPARE(plot->property("violations").value<QList<QPointF>>(), QList<QPointF>({{0.1, 0.2}}));
    QCOMPARE(plot->curveStyle()->property("locale").toLocale().language(), QLocale::German);
    QCOMPARE(root->property("handleX").toDouble(), plot->xOfTime(0.5));
}

CAMPANEL_TEST(TestPlotModule)

} // namespace campanel::plot::test_plot_module

#include "test_plot_module.moc"
