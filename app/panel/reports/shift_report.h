// SPDX-License-Identifier: Apache-2.0
// `ShiftReport` in QML: the displayed shift as a PDF: effectiveness, orders, reasons, stops.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/reports/commissioning.h"
#include "app/store/logs/order_log.h"

namespace campanel::panel {

class DatabaseService;
class ShiftView;
class Stops;

class ShiftReport : public QObject, public Singleton<ShiftReport> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    // All arguments must outlive the object.
    ShiftReport(Controller& controller, Stops& stops, DatabaseService& records, ReportFiles& files,
                QObject* parent);

    void setPrinter(Commissioning::Printer printer) { m_printer = std::move(printer); }

    // Reads the orders of the displayed shift, prints it and offers it to the files.
    Q_INVOKABLE void offer();

    // Returns the displayed shift with these orders.
    [[nodiscard]] ReportData data(const QList<store::OrderRow>& orders = {}) const;

private:
    [[nodiscard]] ReportBar bar() const;
    [[nodiscard]] ReportSection work() const;
    [[nodiscard]] ReportSection figures() const;
    [[nodiscard]] ReportSection orders(const QList<store::OrderRow>& rows) const;
    [[nodiscard]] ReportSection reasons() const;
    [[nodiscard]] ReportSection stops() const;

    Controller& m_controller;
    Stops& m_stops;
    DatabaseService& m_records;
    ReportFiles& m_files;
    Commissioning::Printer m_printer;
};

} // namespace campanel::panel
