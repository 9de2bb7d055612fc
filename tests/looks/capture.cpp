// SPDX-License-Identifier: Apache-2.0
// Writes each screen in each variant; see capture.h.
#include "tests/looks/capture.h"

#include <QDir>

#include <cstdio>
#include <cstdlib>

namespace campanel::looks {
namespace {

constexpr int minFile = 0; // quality for Qt's PNG writer

// Captures one variant into the folder. Returns false after an error.
bool captureVariant(const QDir& target, const Variant& variant, const QList<Screen>& screens)
{
    TestWindow window(variant);
    if (!window.isReady())
        return false;
    for (const Screen& screen : screens) {
        enterScreen(window, screen);
        const QString path = target.filePath(pictureName(screen, variant));
        if (!window.grab().convertToFormat(QImage::Format_RGB888).save(path, "PNG", minFile)) {
            std::fprintf(stderr,
                         "campanel-looks: %s cannot be written; is the disk full or the folder read-only?\n",
                         qPrintable(path));
            return false;
        }
    }
    for (const QString& complaint : window.complaints())
        std::fprintf(stderr, "campanel-looks: %s: %s\n", qPrintable(variant.name()), qPrintable(complaint));
    return window.complaints().isEmpty();
}

} // namespace

QString pictureName(const Screen& screen, const Variant& variant)
{
    return QStringLiteral("%1-%2.png").arg(screen.name, variant.name());
}

std::optional<int> captureThose(const QString& folder, const QList<Variant>& variants,
                                const QList<Screen>& screens,
                                const std::function<bool(const QString& name)>& isWanted)
{
    const QDir target(folder);
    if (!target.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "campanel-looks: the folder %s cannot be made; choose another for --capture.\n",
                     qPrintable(folder));
        return std::nullopt;
    }
    int written = 0;
    for (const Variant& variant : variants) {
        QList<Screen> wanted = screens;
        wanted.removeIf([&](const Screen& screen) { return !isWanted(pictureName(screen, variant)); });
        if (wanted.isEmpty())
            continue;
        if (!captureVariant(target, variant, wanted))
            return std::nullopt;
        written += static_cast<int>(wanted.size());
    }
    return written;
}

int capture(const QString& folder, const QList<Variant>& variants, const QList<Screen>& screens)
{
    const auto written = captureThose(folder, variants, screens, [](const QString&) { return true; });
    if (!written)
        return EXIT_FAILURE;
    std::printf("%d pictures in %s\n", *written, qPrintable(QDir(folder).absolutePath()));
    return EXIT_SUCCESS;
}

} // namespace campanel::looks
