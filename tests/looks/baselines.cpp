// SPDX-License-Identifier: Apache-2.0
// Compares captures with approved pictures; see baselines.h.
#include "tests/looks/baselines.h"

#include "tests/looks/capture.h"
#include "tests/looks/picture_difference.h"

#include <QDir>

#include <cstdio>
#include <cstdlib>

namespace campanel::looks {
namespace {

// Returns true when both are the same; otherwise reports it.
bool compareOne(const QDir& captured, const QDir& baselines, const QString& name)
{
    const QImage found(captured.filePath(name));
    if (found.isNull()) {
        std::fprintf(stderr, "campanel-looks: %s shows an unknown screen or variant; delete it.\n",
                     qPrintable(name));
        return false;
    }
    const PictureDifference difference = differenceOf(QImage(baselines.filePath(name)), found);
    if (difference.isNone())
        return true;
    const QString path = captured.filePath(QStringLiteral("different-") + name);
    const bool isSaved = difference.picture.save(path);
    if (difference.isOtherSize)
        std::fprintf(stderr, "campanel-looks: %s has another size\n", qPrintable(name));
    else
        std::fprintf(stderr, "campanel-looks: %s differs in %d squares within %d x %d at %d, %d%s%s\n",
                     qPrintable(name), difference.squares, difference.around.width(),
                     difference.around.height(), difference.around.x(), difference.around.y(),
                     isSaved ? "; see " : "", isSaved ? qPrintable(path) : "");
    return false;
}

bool take(const QDir& captured, const QDir& baselines, const QString& name)
{
    const QString target = baselines.filePath(name);
    return (!QFile::exists(target) || QFile::remove(target)) && QFile::copy(captured.filePath(name), target);
}

} // namespace

int compareWithBaselines(const QString& folder, const QString& baselines, bool isUpdating)
{
    const QDir approved(baselines);
    const QStringList names = approved.entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Name);
    if (names.isEmpty()) {
        std::fprintf(stderr, "campanel-looks: there is no picture in %s to compare with.\n",
                     qPrintable(baselines));
        return EXIT_FAILURE;
    }
    for (const QString& name : names)
        QFile::remove(QDir(folder).filePath(name)); // from an earlier run
    if (!captureThose(folder, allVariants(), allScreens(),
                      [&](const QString& name) { return names.contains(name); }))
        return EXIT_FAILURE;
    const QDir captured(folder);
    qsizetype wrong = 0;
    for (const QString& name : names)
        wrong += (isUpdating ? take(captured, approved, name) : compareOne(captured, approved, name)) ? 0 : 1;
    std::printf("%lld pictures %s, %lld %s\n", static_cast<long long>(names.size()),
                isUpdating ? "taken" : "compared", static_cast<long long>(wrong),
                isUpdating ? "could not be" : "differ");
    return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace campanel::looks
