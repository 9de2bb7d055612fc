// SPDX-License-Identifier: Apache-2.0
// Waits for the screen on a panel PC without a window system and chooses how Qt draws on it.
#pragma once

#include <QString>

#include <chrono>

namespace campanel::shell {

enum class ScreenAccess {
    Auto,    // the best available one
    EglFs,   // the graphics processor, through /dev/dri
    LinuxFb, // the plain framebuffer: slower, but always possible
};

// Returns the access of a word in campanel.toml: "auto", "eglfs" or "linuxfb".
[[nodiscard]] ScreenAccess screenAccess(const QString& word);

// The paths of the machine's graphics devices.
struct ScreenPlaces {
    QString connectors = QStringLiteral("/sys/class/drm");
    QString cards = QStringLiteral("/dev/dri");
    QString framebuffer = QStringLiteral("/dev/fb0");
    // The folder of the service manager, kept over its restarts of the panel; empty: nothing is remembered.
    QString runtimeFolder = qEnvironmentVariable("RUNTIME_DIRECTORY");
};

struct ScreenChoice {
    QString platform; // as in QT_QPA_PLATFORM; empty: there is no screen
    QString reason;   // one sentence
};

// Returns the present choice. Eglfs ends the process when it cannot draw: noteScreenTried() records the
// attempt, and after a failure linuxfb is used.
[[nodiscard]] ScreenChoice chooseScreen(ScreenAccess wanted, const ScreenPlaces& places);
// Repeats chooseScreen() until there is a screen or the time is over. Blocks; for use before the application.
[[nodiscard]] ScreenChoice waitForScreen(ScreenAccess wanted, const ScreenPlaces& places,
                                         std::chrono::milliseconds longest);
// Record the attempt: before the platform is loaded, and after it has painted.
void noteScreenTried(const QString& platform, const ScreenPlaces& places);
void noteScreenWorks(const ScreenPlaces& places);

} // namespace campanel::shell
