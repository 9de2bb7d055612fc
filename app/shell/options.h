// SPDX-License-Identifier: Apache-2.0
// The command line of the panel as values.
#pragma once

#include "app/panel/settings/settings.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

class QCoreApplication;

namespace campanel::shell {

struct Options {
    std::optional<panel::ConnectionChoice> connection; // empty: from the settings
    QString language;                                  // empty: from the settings
    QString theme;
    QStringList simulatorArguments;
    std::optional<QSize> size; // empty: from the configuration
    bool isFullScreen = false;
    bool isKiosk = false;
    bool isSelfTest = false;
    bool isFirstFrameAnnounced = false; // a line on stdout, for measuring the start
};

// Reads the options. Prints and ends the process for --help, --version and for errors (exit code 2).
[[nodiscard]] Options readOptions(const QCoreApplication& application);

} // namespace campanel::shell
