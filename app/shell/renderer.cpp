// SPDX-License-Identifier: Apache-2.0
#include "app/shell/renderer.h"

#include <QDir>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QQuickWindow>

#include <algorithm>
#include <array>
#include <cstdio>

namespace campanel::shell {
namespace {

using namespace Qt::StringLiterals;

bool isRendererChosen()
{
    constexpr std::array choices{"QT_QUICK_BACKEND", "QMLSCENE_DEVICE", "QSG_RHI_BACKEND", "QSG_RHI",
                                 "QT_XCB_FORCE_SOFTWARE_OPENGL"};
    return std::ranges::any_of(choices, [](const char* name) { return qEnvironmentVariableIsSet(name); }) ||
           (qEnvironmentVariableIsSet("QT_XCB_GL_INTEGRATION") && qgetenv("QT_XCB_GL_INTEGRATION") != "none");
}

// Returns true with a device of a graphics driver, without which Mesa draws in software. The last four belong
// to drivers outside the Linux kernel.
bool hasGraphicsProcessor(const QString& devices)
{
    const QDir::Filters all = QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot;
    return !QDir(devices + u"/dri"_s).entryList({u"renderD*"_s}, all).isEmpty() ||
           !QDir(devices).entryList({u"nvidia[0-9]*"_s, u"mali*"_s, u"galcore"_s, u"pvr*"_s}, all).isEmpty();
}

bool isSoftware(const QString& openGlRenderer)
{
    constexpr std::array names{"llvmpipe"_L1, "softpipe"_L1, "swrast"_L1, "software rasterizer"_L1,
                               "swiftshader"_L1};
    return std::ranges::any_of(
        names, [&](QLatin1StringView name) { return openGlRenderer.contains(name, Qt::CaseInsensitive); });
}

QString loadedOpenGlRenderer()
{
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface))
        return {};
    return QString::fromLatin1(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
}

} // namespace

QString reasonForSoftwareRenderer(const QString& platform, const RendererPlaces& places)
{
    const bool isWindowSystem = platform == u"xcb"_s || platform.startsWith(u"wayland"_s);
    if (!isWindowSystem || isRendererChosen())
        return {};
    if (!hasGraphicsProcessor(places.devices))
        return u"drawing in software, as there is no graphics processor below %1."_s.arg(places.devices);
    const QString renderer = places.openGlRenderer();
    if (renderer.isEmpty())
        return u"drawing in software, as there is no OpenGL."_s;
    return isSoftware(renderer) ? u"drawing in software, as OpenGL does (%1)."_s.arg(renderer) : QString();
}

void chooseRenderer()
{
    const QString reason =
        reasonForSoftwareRenderer(QGuiApplication::platformName(), {.openGlRenderer = &loadedOpenGlRenderer});
    if (reason.isEmpty())
        return;
    std::fprintf(stderr, "campanel: %s\n", qPrintable(reason));
    QQuickWindow::setGraphicsApi(QSGRendererInterface::Software);
}

} // namespace campanel::shell
