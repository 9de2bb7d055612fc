// SPDX-License-Identifier: Apache-2.0
// The machine builder's configuration file: connection to the controller, start of the panel, logging. It
// sets the defaults until another value is set on the panel; see campanel.toml(5).
#pragma once

#include "app/panel/settings/settings.h"
#include "app/shell/kiosk.h"

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace campanel::shell {

struct Configuration {
    panel::StandardSettings standard;
    std::optional<QSize> windowSize;
    bool isFullScreen = false;
    ScreenAccess screen = ScreenAccess::Auto; // for the kiosk
    QStringList logRules;                     // such as "campanel.link.debug=true"
};

struct ReadConfiguration {
    Configuration values;
    // The errors, one sentence each with file and line; the other values are valid.
    QStringList complaints;
};

// Returns the path used without --config.
[[nodiscard]] QString configurationFile();
// Reads the file. A missing file changes nothing. An unreadable file, anything but a regular file or more
// than 1 MB is an error. After an error that may concern the controller, no controller is used: the
// connection is not simulated and has no port.
[[nodiscard]] ReadConfiguration readConfiguration(const QString& file);
[[nodiscard]] ReadConfiguration configurationFrom(const QByteArray& text, const QString& file);
// Returns every key, as "section.key".
[[nodiscard]] QStringList configurationKeys();

} // namespace campanel::shell
