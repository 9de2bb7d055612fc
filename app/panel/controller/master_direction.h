// SPDX-License-Identifier: Apache-2.0
// Which way the master of a point cam turns: what the controller is set to, as read from it, and whether the
// master has come round to it. Forward and backward are the master's own, whatever the sign of its rate.
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::machine {

class Machine;

class MasterDirection : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The direction belongs to the Machine")
    // As the controller is set; Unknown until that was read.
    Q_PROPERTY(Way way READ way NOTIFY changed FINAL)
    // It runs the other way yet: down to zero, then up again.
    Q_PROPERTY(bool turning READ turning NOTIFY changed FINAL)
    Q_PROPERTY(bool canChange READ canChange NOTIFY changed FINAL)
    // What the master does, or why it cannot be turned round.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)

public:
    enum class Way { Unknown, Forward, Backward };
    Q_ENUM(Way)

    // The machine must outlive it.
    explicit MasterDirection(Machine& machine);

    [[nodiscard]] Way way() const;
    [[nodiscard]] bool turning() const;
    [[nodiscard]] bool canChange() const { return blockedReason().isEmpty(); }
    [[nodiscard]] QString text() const;

    // Asks the controller; `way` follows when it has proven to hold it.
    Q_INVOKABLE void turn(campanel::machine::MasterDirection::Way way);

    // For the Machine.
    void noteConnection();
    void noteProgram();
    void noteStatus(const modbus::StatusBlock& status);
    void takeOutcome(const link::ParameterOutcome& outcome);
    void retranslate() { emit changed(); }

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
    // Of the program: 1 or -1; empty while the controller runs no point cam.
    [[nodiscard]] std::optional<int> programSign() const;
    void askWhenUnknown();
    void noteOthersWrite(const link::ParameterOutcome& outcome);
    void observe(const Sample& now);

    Machine& m_machine;
    std::optional<bool> m_reversed; // the parameter of the controller; empty: not known
    std::optional<int> m_observed;  // 1 or -1, by the master's angle; empty: it cannot be told
    std::optional<Sample> m_before;
    std::uint32_t m_uptimeS = 0;
    quint32 m_readId = 0; // under way, else 0
    quint32 m_writeId = 0;
    bool m_isMissing = false; // a controller without that parameter
};

} // namespace campanel::machine
