// SPDX-License-Identifier: Apache-2.0
// `ShiftReport` in QML: the displayed shift as a PDF: effectiveness, reasons, stops.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/reports/commissioning.h"

namespace campanel::panel {

class ShiftView;
class Stops;

class ShiftReport : public QObject, public Singleton<ShiftReport> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    // All arguments must outlive the object.
    ShiftReport(Controller& controller, Stops& stops, ReportFiles& files, QObject* parent);

    void setPrinter(Commissioning::Printer printer) { m_printer = std::move(printer); }

    // Prints the displayed shift and offers it to the files.
    Q_INVOKABLE void offer();

    [[nodiscard]] ReportData data() const;

private:
    [[nodiscard]] ReportBar bar() const;
    [[nodiscard]] ReportSection work() const;
    [[nodiscard]] ReportSection figures() const;
    [[nodiscard]] ReportSection reasons() const;
    [[nodiscard]] ReportSection stops() const;

    Controller& m_controller;
    Stops& m_stops;
    ReportFiles& m_files;
    Commissioning::Printer m_printer;
};

} // namespace campanel::panel
