// SPDX-License-Identifier: Apache-2.0
// `Controller.masterSetting` in QML: what the cycles follow by the controller's settings, as read last. While
// it is unknown, or the controller has no such setting, they follow the clock. Watched, it reads the line
// that an encoder leads by.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/watched.h"
#include "app/program/recipe_master.h"

#include <QList>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Parameter;

class MasterSetting : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The setting belongs to the Controller")
    // True when an encoder leads the active program.
    Q_PROPERTY(bool leads READ leads NOTIFY changed FINAL)
    // True when the controller has an input for an encoder.
    Q_PROPERTY(bool available READ hasInput NOTIFY changed FINAL)
    // The clock that leads the machine, or the encoder with its place and counts.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The state of the line and its speed; empty while nothing leads.
    Q_PROPERTY(QString lineText READ lineText NOTIFY lineChanged FINAL)

public:
    // The controller must outlive the object.
    explicit MasterSetting(Controller& controller);

    [[nodiscard]] bool leads() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString lineText() const;
    // Returns the reason why the rate cannot be entered; empty while it can.
    [[nodiscard]] QString rateText() const;
    // Returns an empty value while it is unknown.
    [[nodiscard]] std::optional<program::MachineMaster> machine() const;
    [[nodiscard]] bool hasInput() const;
    [[nodiscard]] bool followsEncoder() const;
    // Returns the maximum speed of the master, as a share of the program's rate.
    [[nodiscard]] double maxSpeedShare() const;
    // Returns the film that passes per revolution of the encoder.
    [[nodiscard]] double revolutionMm() const;
    // Returns the parameters of the group `master`; their values are known where an encoder leads.
    [[nodiscard]] QList<const Parameter*> parameters() const;
    // Returns why the machine cannot execute the recipe with its master; empty: it can, or the setting is
    // unknown.
    [[nodiscard]] QString refusal(const program::Recipe& recipe) const;

    // Returns the line as read last; empty: not since the connection.
    [[nodiscard]] const std::optional<modbus::MasterStatus>& line() const { return m_line; }
    // Reads it unless that is under way. lineChanged() follows.
    void readLine();

    // Shows why the rate cannot be entered, with all that is known of the line.
    Q_INVOKABLE void explainRate();

signals:
    void changed();
    void lineChanged();
    void explained(const QString& sentence);

private:
    void read();
    void takeLine(const link::ReadOutcome& outcome);

    Controller& m_controller;
    Parameter& m_source;
    Parameter& m_available;
    Parameter& m_speedMax;
    Parameter& m_revolution;
    std::optional<modbus::MasterStatus> m_line;
    bool m_isAsked = false;
    QList<Parameter*> m_ofEncoder; // those that only an encoder needs
};

} // namespace campanel::panel
