// SPDX-License-Identifier: Apache-2.0
// The path of the local socket between the panel and the gateway.
#pragma once

#include <QStandardPaths>
#include <QString>

namespace campanel::plant {

// Returns the panel's path: in the folder that the service manager gives to the kiosk, else in that of the
// user's session.
[[nodiscard]] inline QString panelSocketPath()
{
    const QString ofService = qEnvironmentVariable("RUNTIME_DIRECTORY");
    const QString folder =
        ofService.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) : ofService;
    return folder + QStringLiteral("/campanel-gateway.socket");
}

} // namespace campanel::plant
