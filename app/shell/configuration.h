// SPDX-License-Identifier: Apache-2.0
// The machine builder's configuration file: the settings that have a sentence in the table. Its values hold
// until others are set on the panel; see campanel.toml(5).
#pragma once

#include "app/panel/settings/setting_values.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace campanel::shell {

struct ReadConfiguration {
    panel::SettingValues values;
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
