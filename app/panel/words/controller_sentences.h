// SPDX-License-Identifier: Apache-2.0
// The controller's states, faults, warnings and refusals as translated text.
#pragma once

#include "app/link/link_values.h"
#include "app/program/program_change.h"

#include <QCoreApplication>
#include <QStringList>

namespace campanel::panel {

class ControllerSentences {
    Q_DECLARE_TR_FUNCTIONS(ControllerSentences)

public:
    [[nodiscard]] static QString state(modbus::State state);
    // Returns two sentences of the alarm catalogue for each alarm: description and action. Faults come first.
    [[nodiscard]] static QStringList alarms(const modbus::StatusBlock& status);
    [[nodiscard]] static QString refusal(modbus::Refusal reason);
    // Returns what a running machine does at a change of program; rate 0: the program has no bags.
    [[nodiscard]] static QString programChange(const program::ProgramChange& change, double rateBagsPerMin);
    [[nodiscard]] static QString pressStage(modbus::PressStage stage);
    [[nodiscard]] static QString strokeResult(modbus::StrokeResult result);
    [[nodiscard]] static QString markState(modbus::MarkState state);
    [[nodiscard]] static QString skipCause(modbus::SkipCause cause);
    [[nodiscard]] static QString transferResult(const modbus::TransferAnswer& answer);

private:
    // Returns the same where no product waits under a cut.
    [[nodiscard]] static QString undisturbedChange(const program::ProgramChange& change,
                                                   double rateBagsPerMin);
};

} // namespace campanel::panel
