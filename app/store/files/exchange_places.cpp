// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/exchange_places.h"

#include "app/store/files/file_error.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Replaces the characters that FAT and exFAT do not allow.
QString portableName(const QString& name)
{
    constexpr qsizetype longest = 64;
    QString kept;
    for (const QChar character : name.simplified()) {
        const bool isRefused = character.unicode() < 0x20 || u"\"*/:<>?\\|"_s.contains(character);
        kept += isRefused ? u'_' : character;
    }
    kept.truncate(longest);
    if (!kept.isEmpty() && kept.back().isHighSurrogate())
        kept.chop(1);
    while (kept.endsWith(u'.') || kept.endsWith(u' '))
        kept.chop(1);
    while (kept.startsWith(u'.') || kept.startsWith(u' '))
        kept.remove(0, 1); // hidden otherwise
    return kept.isEmpty() ? u"knots"_s : kept;
}

} // namespace

bool isRemovableMount(const QString& rootPath)
{
    const QString path = QDir::cleanPath(rootPath) + u'/';
    return path.startsWith(u"/media/"_s) || path.startsWith(u"/run/media/"_s) || path.startsWith(u"/mnt/"_s);
}

QList<Place> exchangePlaces(const QString& ownFolder)
{
    QList<Place> places;
    for (const QStorageInfo& volume : QStorageInfo::mountedVolumes()) {
        if (!isRemovableMount(volume.rootPath()) || !volume.isValid() || !volume.isReady() ||
            !QFileInfo(volume.rootPath()).isReadable())
            continue;
        const bool isReadOnly = volume.isReadOnly() || !QFileInfo(volume.rootPath()).isWritable();
        // A volume without a label has the name of its folder.
        const QString label = volume.name();
        places << Place{volume.rootPath(), label.isEmpty() ? QFileInfo(volume.rootPath()).fileName() : label,
                        isReadOnly, true};
    }
    QDir().mkpath(ownFolder);
    places << Place{QDir(ownFolder).absolutePath(), FileErrorText::tr("This panel"),
                    !QFileInfo(ownFolder).isWritable()};
    return places;
}

QFileInfoList filesIn(const Place& place, const QString& suffix, qsizetype maxFiles)
{
    return QDir(place.path).entryInfoList({u"*."_s + suffix}, QDir::Files, QDir::Time).mid(0, maxFiles);
}

QString freePath(const Place& place, const QString& name, const QString& suffix)
{
    const QDir folder(place.path);
    const QString base = portableName(name);
    QString file = base + u'.' + suffix;
    for (int number = 2; folder.exists(file); ++number)
        file = u"%1-%2.%3"_s.arg(base).arg(number).arg(suffix);
    return folder.filePath(file);
}

} // namespace campanel::store
