// SPDX-License-Identifier: Apache-2.0
// `Commissioning` in QML: the commissioning report of a machine: recipe, machine data, limits, curves, table,
// the controller's program, the last bags. It collects texts and curves in the panel's language; the given
// printer makes a PDF.
#pragma once

#include "app/panel/kit/report_files.h"
#include "app/panel/kit/singleton.h"

#include <QDateTime>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

class Access;
class Editor;
class Controller;

struct ReportSection {
    QString title;
    QList<std::pair<QString, QString>> rows; // label and value
    QStringList lines;                       // whole sentences below the rows
    bool isList = false;                     // one row below the other, in their order
};

// A shift as a bar of states.
struct ReportBar {
    struct Stretch {
        double from = 0; // shares of the shift
        double width = 0;
        int kind = 0;
    };
    QList<Stretch> stretches;
    QList<std::pair<double, QString>> hours; // share and text
    QStringList kinds;                       // the words of each kind
};

// A code that a scanner reads.
struct ReportCode {
    QString title;
    QString code;

    bool operator==(const ReportCode&) const = default;
};

struct ReportData {
    QString title;
    QString recipe;          // name and version
    QString machine;         // which machine the report is about
    ReportBar bar;           // below the title
    QStringList signatures;  // what is written by hand at the end
    QString footer;          // author, time and version of CamPanel
    QString pageText;        // "Page %1"
    QList<ReportCode> codes; // below the title
    QList<ReportSection> sections;
    bool isFeasible = false;
    // The texts of the plots; see plot::CurvePlot.
    QString curvesTitle;
    QVariant curves;
    QStringList quantities;
    QStringList titles;
    QList<double> factors;
    QList<double> markerTimes;
    QList<QPointF> violations;
    double limitVelocity = 0;
    double limitAcceleration = 0;
    double limitFrequency = 0;
    QString limitLabel;
};

// Returns which machine a report is about, and what a person writes below it.
[[nodiscard]] QString machineText(const Controller& controller);
[[nodiscard]] QStringList signatureTexts();

class Commissioning : public QObject, public Singleton<Commissioning> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    using Printer = std::function<QByteArray(const ReportData&)>;
    using WallClock = std::function<QDateTime()>;

    // All arguments must outlive the object.
    Commissioning(Controller& controller, Editor& editor, Access& access, ReportFiles& files,
                  QObject* parent);

    void setPrinter(Printer printer) { m_printer = std::move(printer); }
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Prints the present state and offers it to the files.
    Q_INVOKABLE void offer();

    [[nodiscard]] ReportData data() const;

private:
    [[nodiscard]] QList<ReportCode> codes() const;
    [[nodiscard]] ReportSection recipeSection() const;
    [[nodiscard]] ReportSection machineSection() const;
    [[nodiscard]] ReportSection masterSection() const;
    [[nodiscard]] ReportSection verdictSection() const;
    [[nodiscard]] ReportSection tableSection() const;
    [[nodiscard]] ReportSection controllerSection() const;
    [[nodiscard]] ReportSection bagSection() const;

    Controller& m_controller;
    Editor& m_editor;
    Access& m_access;
    ReportFiles& m_files;
    WallClock m_wallClock;
    Printer m_printer;
};

} // namespace campanel::panel
