// SPDX-License-Identifier: Apache-2.0
// What the machine builder has set for this machine in one file: where the controller is, how the panel
// begins, what is logged. It gives the values that hold until somebody sets another one on the panel; see
// campanel.toml(5).
#pragma once

#include "app/panel/settings/settings.h"
#include "app/shell/kiosk.h"

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace campanel::panel {

struct Configuration {
    machine::StandardSettings standard;
    std::optional<QSize> windowSize;
    bool isFullScreen = false;
    ScreenAccess screen = ScreenAccess::Auto; // of the kiosk
    QStringList logRules;                     // such as "campanel.link.debug=true"
};

struct ReadConfiguration {
    Configuration values;
    // What was not understood, a sentence each with file and line; all the rest counts.
    QStringList complaints;
};

// Where it is without --config.
[[nodiscard]] QString configurationFile();
// A file that does not exist changes nothing; one that cannot be read, is no regular file or has more than 1
// MB is complained about. When what was not understood may have named the controller, none is used: the
// connection is not simulated and has no port.
[[nodiscard]] ReadConfiguration readConfiguration(const QString& file);
[[nodiscard]] ReadConfiguration configurationFrom(const QByteArray& text, const QString& file);
// Every key, as "section.key".
[[nodiscard]] QStringList configurationKeys();

} // namespace campanel::panel
