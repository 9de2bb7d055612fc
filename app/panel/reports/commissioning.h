// SPDX-License-Identifier: Apache-2.0
// `Commissioning` in QML: the report that is handed over with a machine that runs: recipe, machine data,
// limits, curves, table, what the controller runs, the last bags. Gathered here as texts and curves in the
// language of the panel; the printer that is given makes a PDF of them.
#pragma once

#include "app/panel/kit/report_files.h"

#include <QDateTime>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <functional>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Access;
class Editor;
class Machine;

struct ReportSection {
    QString title;
    QList<std::pair<QString, QString>> rows; // what and its value
    QStringList lines;                       // whole sentences below them
};

struct ReportData {
    QString title;
    QString recipe;   // name and version
    QString footer;   // who, when, which CamPanel
    QString pageText; // "Page %1"
    QList<ReportSection> sections;
    bool isFeasible = false;
    // Of the plots; see plot::CurvePlot.
    QString curvesTitle;
    QVariant curves;
    QStringList quantities;
    QStringList titles;
    QList<double> markerTimes;
    QList<QPointF> violations;
    double limitVelocity = 0;
    double limitAcceleration = 0;
    double limitFrequency = 0;
    QString limitLabel;
};

class Commissioning : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    using Printer = std::function<QByteArray(const ReportData&)>;
    using WallClock = std::function<QDateTime()>;

    // All must outlive it.
    Commissioning(Machine& machine, Editor& editor, Access& access, ReportFiles& files, QObject* parent);

    // The instance that attachToEngine() gave to this engine.
    static Commissioning* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    void setPrinter(Printer printer) { m_printer = std::move(printer); }
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Prints what is so now and offers it to the files.
    Q_INVOKABLE void offer();

    [[nodiscard]] ReportData data() const;

private:
    [[nodiscard]] ReportSection recipeSection() const;
    [[nodiscard]] ReportSection machineSection() const;
    [[nodiscard]] ReportSection verdictSection() const;
    [[nodiscard]] ReportSection tableSection() const;
    [[nodiscard]] ReportSection controllerSection() const;
    [[nodiscard]] ReportSection bagSection() const;

    Machine& m_machine;
    Editor& m_editor;
    Access& m_access;
    ReportFiles& m_files;
    WallClock m_wallClock;
    Printer m_printer;
};

} // namespace campanel::machine
