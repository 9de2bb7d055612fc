// SPDX-License-Identifier: Apache-2.0
// The command line of the panel as values.
#pragma once

#include "app/machine/settings.h"
#include "app/main/scenes.h"

#include <QSize>
#include <QString>

#include <optional>

class QCoreApplication;

namespace campanel::panel {

struct Options {
    std::optional<machine::ConnectionChoice> connection; // empty: from the settings
    QString language;                                    // empty: from the settings
    QString theme;
    std::optional<QSize> size; // empty: from the configuration
    bool isFullScreen = false;
    bool isKiosk = false;
    QString captureFolder;  // empty: no capture
    QString baselineFolder; // pictures to compare a capture with; empty: no comparison
    bool isUpdatingBaselines = false;
    bool isSelfTest = false;
    QList<Look> looks; // for a capture or the self-test
    QList<Scene> scenes;
    bool isFirstFrameAnnounced = false; // by a line on stdout, to measure the start
};

// Reads the options. Prints and ends the process for --help, --version and for errors (exit code 2).
[[nodiscard]] Options readOptions(const QCoreApplication& application);

} // namespace campanel::panel
