// SPDX-License-Identifier: Apache-2.0
// Writes every scene in every look; see capture.h.
#include "app/main/capture.h"

#include "app/main/scenes.h"

#include <QDir>

#include <cstdio>
#include <cstdlib>

namespace campanel::panel {

int capture(const QString& folder)
{
    const QDir target(folder);
    if (!target.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "campanel: the folder %s cannot be made; choose another for --capture.\n",
                     qPrintable(folder));
        return EXIT_FAILURE;
    }
    int written = 0;
    for (const Look& look : allLooks()) {
        Stage stage(look);
        if (!stage.isReady())
            return EXIT_FAILURE;
        for (const Scene& scene : allScenes()) {
            enterScene(stage, scene);
            const QString path = target.filePath(QStringLiteral("%1-%2.png").arg(scene.name, look.name()));
            if (!stage.grab().save(path)) {
                std::fprintf(stderr,
                             "campanel: %s cannot be written; is the disk full or the folder read-only?\n",
                             qPrintable(path));
                return EXIT_FAILURE;
            }
            ++written;
        }
        for (const QString& complaint : stage.complaints())
            std::fprintf(stderr, "campanel: %s: %s\n", qPrintable(look.name()), qPrintable(complaint));
        if (!stage.complaints().isEmpty())
            return EXIT_FAILURE;
    }
    std::printf("%d pictures in %s\n", written, qPrintable(target.absolutePath()));
    return EXIT_SUCCESS;
}

} // namespace campanel::panel
