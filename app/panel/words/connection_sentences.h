// SPDX-License-Identifier: Apache-2.0
// The link's reports in whole translated sentences: what is wrong and what to do.
#pragma once

#include "app/link/link_values.h"

#include <QCoreApplication>
#include <QDateTime>

namespace campanel::panel {

class ConnectionSentences {
    Q_DECLARE_TR_FUNCTIONS(ConnectionSentences)

public:
    // Describes the connection. `lostAt`: the time when the connection was lost.
    [[nodiscard]] static QString connection(const link::LinkReport& report, const QDateTime& lostAt);
    [[nodiscard]] static QString error(const modbus::LinkError& error);
    // Describes a Modbus exception of the device on `port`.
    [[nodiscard]] static QString exception(const QString& port, int code);
    // Says in every case that the controller's program is unchanged.
    [[nodiscard]] static QString error(const modbus::DownloadError& error);
    [[nodiscard]] static QString refused(modbus::Command command, modbus::Refusal reason);
    // Returns an empty text when the command was executed.
    [[nodiscard]] static QString command(const link::CommandOutcome& outcome);
    // Returns the same as the audit trail stores it: "done", "refused 12" ...
    [[nodiscard]] static QString outcomeKey(const link::CommandOutcome& outcome);
    // Returns an empty text when the value was written; `what` begins the sentence.
    [[nodiscard]] static QString parameter(const QString& what, const link::ParameterOutcome& outcome);
    [[nodiscard]] static QString download(const link::DownloadReport& report);

private:
    [[nodiscard]] static QString lost(const link::LinkReport& report, const QString& since);
    [[nodiscard]] static QString simulator(const link::LinkReport& report);
    [[nodiscard]] static QString commandName(modbus::Command command);
};

} // namespace campanel::panel
