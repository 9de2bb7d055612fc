// SPDX-License-Identifier: Apache-2.0
#include "app/shell/kiosk.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <thread>

namespace campanel::shell {
namespace {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

constexpr auto askAgain = 200ms;

QString marker(const ScreenPlaces& places)
{
    return places.runtimeFolder + u"/eglfs-tried"_s;
}

bool hasEglfsFailed(const ScreenPlaces& places)
{
    return !places.runtimeFolder.isEmpty() && QFile::exists(marker(places));
}

// Returns the connector of a graphics card with a screen, such as "card0-HDMI-A-1"; empty: none.
QString connectedOutput(const ScreenPlaces& places)
{
    const QDir connectors(places.connectors);
    for (const QString& name : connectors.entryList({u"card*-*"_s}, QDir::AllEntries | QDir::System)) {
        QFile status(connectors.filePath(name + u"/status"_s));
        const QString card = QDir(places.cards).filePath(name.section(u'-', 0, 0));
        if (status.open(QIODevice::ReadOnly) && status.readAll().trimmed() == "connected" &&
            QFileInfo::exists(card))
            return name;
    }
    return {};
}

} // namespace

ScreenAccess screenAccess(const QString& word)
{
    return word == u"eglfs"_s     ? ScreenAccess::EglFs
           : word == u"linuxfb"_s ? ScreenAccess::LinuxFb
                                  : ScreenAccess::Auto;
}

ScreenChoice chooseScreen(ScreenAccess wanted, const ScreenPlaces& places)
{
    const QString output = connectedOutput(places);
    if (wanted != ScreenAccess::LinuxFb && !output.isEmpty()) {
        if (wanted == ScreenAccess::EglFs || !hasEglfsFailed(places))
            return {u"eglfs"_s, u"eglfs, for a screen on %1."_s.arg(output)};
    }
    if (wanted != ScreenAccess::EglFs && QFileInfo::exists(places.framebuffer)) {
        const QString why = wanted == ScreenAccess::LinuxFb ? u"as configured"_s
                            : output.isEmpty() ? u"as no screen is connected below "_s + places.connectors
                                               : u"as eglfs ended without drawing anything"_s;
        return {u"linuxfb"_s, u"linuxfb, %1."_s.arg(why)};
    }
    return {{},
            u"There is no screen: nothing connected below %1, or no card below %2, and no %3."_s.arg(
                places.connectors, places.cards, places.framebuffer)};
}

ScreenChoice waitForScreen(ScreenAccess wanted, const ScreenPlaces& places, std::chrono::milliseconds longest)
{
    const auto end = std::chrono::steady_clock::now() + longest;
    ScreenChoice choice = chooseScreen(wanted, places);
    while (choice.platform.isEmpty() && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(askAgain);
        choice = chooseScreen(wanted, places);
    }
    return choice;
}

void noteScreenTried(const QString& platform, const ScreenPlaces& places)
{
    if (platform != u"eglfs"_s || places.runtimeFolder.isEmpty())
        return;
    QFile file(marker(places));
    (void)file.open(QIODevice::WriteOnly);
}

void noteScreenWorks(const ScreenPlaces& places)
{
    // A picture by linuxfb is no proof for eglfs.
    if (!places.runtimeFolder.isEmpty() && qEnvironmentVariable("QT_QPA_PLATFORM") == u"eglfs"_s)
        QFile::remove(marker(places));
}

} // namespace campanel::shell
