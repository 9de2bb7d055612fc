// SPDX-License-Identifier: Apache-2.0
// The section [gateway] of campanel.toml as values, checked.
#pragma once

#include "app/shell/configuration.h"

#include <QString>
#include <QStringList>

namespace campanel::gateway {

struct GatewaySettings {
    QString host; // empty: nothing is published
    int port = 0;
    QString ca;
    QString certificate;
    QString key;
    QString group;
    QString node;
    QString primaryHost;
    QString user; // empty: the broker asks for none
    QString password;

    [[nodiscard]] bool isEncrypted() const { return !ca.isEmpty(); }
};

struct ReadGatewaySettings {
    GatewaySettings settings;
    QStringList warnings; // one sentence each
    // The errors with which the gateway does not start. A wrong line could be the one that asks for TLS.
    QStringList errors;
};

// Checks the values, and that the files can be read. `computer` is the node's name when none is set.
[[nodiscard]] ReadGatewaySettings gatewaySettings(const shell::ReadConfiguration& read,
                                                  const QString& computer);

} // namespace campanel::gateway
