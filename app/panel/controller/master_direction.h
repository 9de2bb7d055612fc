// SPDX-License-Identifier: Apache-2.0
// The direction of a point cam's master: the controller's setting, as read back, and whether the master has
// reached it. Forward and backward refer to the master itself, regardless of the sign of its rate.
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Parameter;

class MasterDirection : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The direction belongs to the Controller")
    // The controller's setting; Unknown until it is read.
    Q_PROPERTY(Way way READ way NOTIFY changed FINAL)
    // True during the reversal: down to zero, then up again.
    Q_PROPERTY(bool turning READ turning NOTIFY changed FINAL)
    Q_PROPERTY(bool canChange READ canChange NOTIFY changed FINAL)
    // The master's movement, or the reason why it cannot be reversed.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The net advance of the axis per cycle in this direction, "+0.5" mm; empty for a closed cam.
    Q_PROPERTY(QString advanceText READ advanceText NOTIFY changed FINAL)

public:
    enum class Way { Unknown, Forward, Backward };
    Q_ENUM(Way)

    // The controller must outlive the object.
    explicit MasterDirection(Controller& controller);

    [[nodiscard]] Way way() const;
    [[nodiscard]] bool turning() const;
    [[nodiscard]] bool canChange() const { return blockedReason().isEmpty(); }
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString advanceText() const;

    // Requests the direction; `way` changes when the controller is proven to have stored it.
    Q_INVOKABLE void turn(campanel::panel::MasterDirection::Way way);

    // Handle events of the Controller.
    void noteConnection();
    void noteProgram();
    void noteStatus(const link::StatusBatch& batch);

signals:
    void changed();
    void failed(const QString& sentence);

private:
    struct Sample {
        double angleDeg = 0;
        double speedPercent = 0;
        std::uint16_t timeMs = 0;
    };

    [[nodiscard]] QString blockedReason() const;
    // Returns the sign of the program, 1 or -1; empty while the controller runs no point cam.
    [[nodiscard]] std::optional<int> programSign() const;
    void readWhenUnknown();
    void observe(const Sample& now);

    Controller& m_controller;
    Parameter& m_parameter;        // 0 like the program's rate, 1 reversed
    std::optional<int> m_observed; // 1 or -1, from the master's angle; empty: unknown
    std::optional<Sample> m_before;
};

} // namespace campanel::panel
