// SPDX-License-Identifier: Apache-2.0
// On a panel PC without a window system: waits for the screen and chooses how Qt draws on it.
#pragma once

#include <QString>

#include <chrono>

namespace campanel::panel {

enum class ScreenAccess {
    Auto,    // what the machine has
    EglFs,   // the graphics processor, through /dev/dri
    LinuxFb, // the plain framebuffer: slower, and works on everything
};

// Where the machine shows what it has.
struct ScreenPlaces {
    QString connectors = QStringLiteral("/sys/class/drm");
    QString cards = QStringLiteral("/dev/dri");
    QString framebuffer = QStringLiteral("/dev/fb0");
    // Of the service manager, kept while it starts the panel again by itself; empty: nothing is remembered.
    QString runtimeFolder = qEnvironmentVariable("RUNTIME_DIRECTORY");
};

struct ScreenChoice {
    QString platform; // as in QT_QPA_PLATFORM; empty: there is no screen
    QString reason;   // a sentence
};

// What is there at this moment. Eglfs ends the process when it cannot draw: a try that came to nothing is
// remembered by noteScreenTried() and linuxfb taken from then on.
[[nodiscard]] ScreenChoice chooseScreen(ScreenAccess wanted, const ScreenPlaces& places);
// The same, asked again until there is a screen or the time is over. Blocks; for the time before the
// application.
[[nodiscard]] ScreenChoice waitForScreen(ScreenAccess wanted, const ScreenPlaces& places,
                                         std::chrono::milliseconds longest);
// Before the platform is loaded, and after it has painted.
void noteScreenTried(const QString& platform, const ScreenPlaces& places);
void noteScreenWorks(const ScreenPlaces& places);

} // namespace campanel::panel
