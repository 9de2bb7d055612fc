// SPDX-License-Identifier: Apache-2.0
// Chooses, in a window system, between OpenGL and Qt Quick's own software renderer. A software OpenGL
// (llvmpipe) takes a whole core for what Qt Quick's renderer does with a tenth of one.
#pragma once

#include <QString>

#include <functional>

namespace campanel::shell {

// The paths of the machine's graphics devices.
struct RendererPlaces {
    QString devices = QStringLiteral("/dev");
    // Returns the name of the OpenGL renderer; empty: there is no OpenGL. Loads the driver, which takes up to
    // a second where it is software.
    std::function<QString()> openGlRenderer;
};

// Returns why Qt Quick's software renderer is to be used, as a sentence; empty: OpenGL stays. Asks for the
// name of the OpenGL renderer only where a graphics processor is found. A renderer that was chosen by an
// environment variable of Qt stays, and so does a platform without a window system.
[[nodiscard]] QString reasonForSoftwareRenderer(const QString& platform, const RendererPlaces& places);

// Chooses the renderer of all windows. Call it after the application is made and before the first window.
void chooseRenderer();

} // namespace campanel::shell
