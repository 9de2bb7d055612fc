// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/exchange_places.h"

#include "app/store/files/ask_places.h"
#include "app/store/files/file_error.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSet>
#include <QStorageInfo>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr std::chrono::seconds patience{2};

// Decodes the octal numbers of the table of mounts: "\040" is a space.
QString decoded(const QByteArray& field)
{
    QByteArray path;
    for (qsizetype i = 0; i < field.size(); ++i) {
        bool isCode = false;
        const int code = field[i] == '\\' ? field.mid(i + 1, 3).toInt(&isCode, 8) : 0;
        path += isCode ? static_cast<char>(code) : field[i];
        i += isCode ? 3 : 0;
    }
    return QFile::decodeName(path);
}

// Reads the kernel's table, which waits for no medium.
QList<Place> removableMounts()
{
    constexpr qsizetype pathField = 4;
    QList<Place> mounts;
    QFile table(u"/proc/self/mountinfo"_s);
    if (!table.open(QIODevice::ReadOnly))
        return mounts;
    for (const QByteArray& line : table.readAll().split('\n')) {
        const QString path = decoded(line.split(' ').value(pathField));
        const Place mount{path, QFileInfo(path).fileName(), true, true, true};
        if (isRemovableMount(path) && !line.contains(" - tmpfs ") && !mounts.contains(mount))
            mounts << mount;
    }
    return mounts;
}

// Waits for the medium. Returns a place without a path when nothing can be read there.
Place answeredBy(const Place& mount)
{
    const QStorageInfo volume(mount.path);
    if (!volume.isValid() || !volume.isReady() || !QFileInfo(mount.path).isReadable())
        return {};
    const bool isReadOnly = volume.isReadOnly() || !QFileInfo(mount.path).isWritable();
    // A volume without a label has the name of its folder.
    const QString label = volume.name();
    return {mount.path, label.isEmpty() ? mount.name : label, isReadOnly, true};
}

bool isNameOfDevice(const QString& name)
{
    static const QRegularExpression device(
        u"^(con|prn|aux|nul|conin\\$|conout\\$|(com|lpt)[0-9\u00B9\u00B2\u00B3])[ ]*(\\..*)?$"_s,
        QRegularExpression::CaseInsensitiveOption);
    return device.match(name).hasMatch();
}

bool isRefused(char32_t character)
{
    const QChar::Category category = QChar::category(character);
    return category == QChar::Other_Control || category == QChar::Other_Format ||
           category == QChar::Other_Surrogate || u"\"*/:<>?\\|"_s.contains(QChar::fromUcs4(character));
}

} // namespace

bool isRemovableMount(const QString& rootPath)
{
    const QString path = QDir::cleanPath(rootPath) + u'/';
    return path.startsWith(u"/media/"_s) || path.startsWith(u"/run/media/"_s) || path.startsWith(u"/mnt/"_s);
}

QList<Place> exchangePlaces(const QString& ownFolder)
{
    const QList<Place> mounts = removableMounts();
    QList<Place> asked = mounts;
    for (Place& mount : asked)
        mount.isSilent = false; // not yet
    const auto answers = askPlaces<Place>(asked, &answeredBy, patience);
    QList<Place> places;
    for (qsizetype i = 0; i < mounts.size(); ++i) {
        const Place place = answers[static_cast<std::size_t>(i)].value_or(mounts[i]);
        if (!place.path.isEmpty())
            places << place;
    }
    QDir().mkpath(ownFolder);
    places << Place{QDir(ownFolder).absolutePath(), FileErrorText::tr("This panel"),
                    !QFileInfo(ownFolder).isWritable()};
    return places;
}

QString silentText(const Place& place)
{
    return FileErrorText::tr("%1 does not answer. Check the network or plug the stick in again.")
        .arg(place.path);
}

FolderFiles filesIn(const Place& place, const QString& pattern, qsizetype maxFiles)
{
    if (place.isSilent)
        return {{}, silentText(place)};
    const QFileInfoList all =
        QDir(place.path).entryInfoList({pattern}, QDir::Files | QDir::NoSymLinks, QDir::Time);
    if (all.size() <= maxFiles)
        return {all, {}};
    return {all.first(maxFiles),
            FileErrorText::tr("%1 older files of %2 are not shown. Delete files that are "
                              "not needed, or move them into a folder.")
                .arg(all.size() - maxFiles)
                .arg(place.path)};
}

QString portableName(const QString& name)
{
    constexpr qsizetype longest = 64; // at most 192 bytes of UTF-8
    QString kept;
    for (const char32_t character : name.normalized(QString::NormalizationForm_C).simplified().toUcs4()) {
        const auto each = QChar::fromUcs4(isRefused(character) ? U'_' : character);
        if (kept.size() + QStringView(each).size() > longest)
            break;
        kept += each;
    }
    while (kept.endsWith(u'.') || kept.endsWith(u' '))
        kept.chop(1);
    while (kept.startsWith(u'.') || kept.startsWith(u' '))
        kept.remove(0, 1); // hidden otherwise
    if (isNameOfDevice(kept))
        kept.prepend(u'_');
    return kept.isEmpty() ? u"recipe"_s : kept;
}

QString freePath(const Place& place, const QString& name, const QString& suffix)
{
    const QDir folder(place.path);
    QSet<QString> taken;
    for (const QString& each : folder.entryList(
             QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot, QDir::Unsorted))
        taken << each.toCaseFolded();
    const QString base = portableName(name);
    QString file = base + u'.' + suffix;
    for (int number = 2; taken.contains(file.toCaseFolded()); ++number)
        file = u"%1-%2.%3"_s.arg(base, QString::number(number), suffix);
    return folder.filePath(file);
}

} // namespace campanel::store
