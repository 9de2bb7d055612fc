// SPDX-License-Identifier: Apache-2.0
// Writes each scene in each look; see capture.h.
#include "tests/looks/capture.h"

#include <QDir>

#include <cstdio>
#include <cstdlib>

namespace campanel::looks {
namespace {

constexpr int minFile = 0; // quality for Qt's PNG writer

// Captures one look into the folder. Returns false after an error.
bool captureLook(const QDir& target, const Look& look, const QList<Scene>& scenes)
{
    Stage stage(look);
    if (!stage.isReady())
        return false;
    for (const Scene& scene : scenes) {
        enterScene(stage, scene);
        const QString path = target.filePath(pictureName(scene, look));
        if (!stage.grab().convertToFormat(QImage::Format_RGB888).save(path, "PNG", minFile)) {
            std::fprintf(stderr,
                         "campanel-looks: %s cannot be written; is the disk full or the folder read-only?\n",
                         qPrintable(path));
            return false;
        }
    }
    for (const QString& complaint : stage.complaints())
        std::fprintf(stderr, "campanel-looks: %s: %s\n", qPrintable(look.name()), qPrintable(complaint));
    return stage.complaints().isEmpty();
}

} // namespace

QString pictureName(const Scene& scene, const Look& look)
{
    return QStringLiteral("%1-%2.png").arg(scene.name, look.name());
}

std::optional<int> captureThose(const QString& folder, const QList<Look>& looks, const QList<Scene>& scenes,
                                const std::function<bool(const QString& name)>& isWanted)
{
    const QDir target(folder);
    if (!target.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "campanel-looks: the folder %s cannot be made; choose another for --capture.\n",
                     qPrintable(folder));
        return std::nullopt;
    }
    int written = 0;
    for (const Look& look : looks) {
        QList<Scene> wanted = scenes;
        wanted.removeIf([&](const Scene& scene) { return !isWanted(pictureName(scene, look)); });
        if (wanted.isEmpty())
            continue;
        if (!captureLook(target, look, wanted))
            return std::nullopt;
        written += static_cast<int>(wanted.size());
    }
    return written;
}

int capture(const QString& folder, const QList<Look>& looks, const QList<Scene>& scenes)
{
    const auto written = captureThose(folder, looks, scenes, [](const QString&) { return true; });
    if (!written)
        return EXIT_FAILURE;
    std::printf("%d pictures in %s\n", *written, qPrintable(QDir(folder).absolutePath()));
    return EXIT_SUCCESS;
}

} // namespace campanel::looks
