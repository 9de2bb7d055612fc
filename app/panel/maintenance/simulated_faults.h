// SPDX-License-Identifier: Apache-2.0
// `Maintenance.simulatedFaults` in QML: faults of the simulated machine and of the line to it. A list of
// predefined faults, each off, sometimes or often; those of the machine are off or on. The line of somebody
// else is among them, where the controller has an encoder on its shaft. The displayed level is the one that
// the controller accepted.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/row_model.h"

#include <QList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;

struct LineFaultRow {
    Q_GADGET
    Q_PROPERTY(QString name READ name)
    Q_PROPERTY(QString note READ note)
    Q_PROPERTY(int rate MEMBER level)
    // True for a fault that is off or on: on is the level Often.
    Q_PROPERTY(bool isSwitch READ isSwitch)
    // True for the speed of the line, at the levels Off to Beyond.
    Q_PROPERTY(bool isLine READ isLine)

public:
    int fault = 0;
    int level = 0;     // SimulatedFaults.Level
    double mmPerS = 0; // speed of the line as the active program at its rate

    [[nodiscard]] QString name() const;
    [[nodiscard]] QString note() const;
    [[nodiscard]] bool isSwitch() const;
    [[nodiscard]] bool isLine() const;
    bool operator==(const LineFaultRow&) const = default;
};

class SimulatedFaults : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The line faults belong to Maintenance")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    Q_PROPERTY(int activeCount READ activeCount NOTIFY changed FINAL)
    // The active faults as text.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The reason why the last change failed; empty after a success.
    Q_PROPERTY(QString errorText READ errorText NOTIFY changed FINAL)

public:
    enum Level { Off, Sometimes, Often, Beyond };
    Q_ENUM(Level)

    using Rows = RowModel<LineFaultRow, &LineFaultRow::fault>;

    // The controller must outlive the object. Changes are for technicians.
    SimulatedFaults(Controller& controller, QObject* parent);

    // Requests another level; it becomes valid when the controller accepts it.
    Q_INVOKABLE void setLevel(int row, int level);
    Q_INVOKABLE void clear();

    [[nodiscard]] Rows* rows() { return &m_rows; }
    [[nodiscard]] int activeCount() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString errorText() const;
    [[nodiscard]] QStringList rulesInForce() const { return rules(m_levels); }

signals:
    void changed();

private:
    void send();
    void takeReport(const link::LinkReport& report);
    void takeOutcome(const link::FaultsOutcome& outcome);
    void setLevels(const QList<Level>& levels);
    void showRows();
    // Returns the rules of these levels for Link::simulateFaults().
    [[nodiscard]] QStringList rules(const QList<Level>& levels) const;
    [[nodiscard]] double programMmPerS() const;

    Controller& m_controller;
    double m_lineMmPerS = 0; // at the level Often, as it was when the line was started
    QList<Level> m_levels;   // accepted
    Rows m_rows{this};
    QList<Level> m_wanted;
    std::optional<QList<Level>> m_sent; // sent but not answered
    std::optional<link::FaultsOutcome> m_failure;
};

} // namespace campanel::panel
