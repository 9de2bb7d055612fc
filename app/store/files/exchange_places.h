// SPDX-License-Identifier: Apache-2.0
// The places for the exchange of files: a folder of the panel and mounted removable media, such as a USB
// stick. No other part of the file system is ever offered.
#pragma once

#include <QFileInfoList>
#include <QList>
#include <QString>

#include <tl/expected.hpp>

namespace campanel::store {

struct Place {
    QString path; // absolute
    QString name; // display name
    bool isReadOnly = false;
    bool isRemovable = false; // a stick
    bool isSilent = false;    // did not answer; nothing else is known of it

    bool operator==(const Place&) const = default;
};

// Returns true for media mounted below /media, /run/media and /mnt.
[[nodiscard]] bool isRemovableMount(const QString& rootPath);

// Returns the removable media, then `ownFolder`, which is created when necessary. Waits for the media, at
// most two seconds: not for the GUI thread.
[[nodiscard]] QList<Place> exchangePlaces(const QString& ownFolder);

struct FolderFiles {
    QFileInfoList files; // newest first
    QString notice;      // what is missing and what to do, whole sentences; empty when nothing is
};

// Returns at most `maxFiles` files directly in the place, by a pattern for names in any case ("*.csv").
// Hidden files and links are skipped.
[[nodiscard]] FolderFiles filesIn(const Place& place, const QString& pattern, qsizetype maxFiles);

// Returns the sentence about a place that does not answer.
[[nodiscard]] QString silentText(const Place& place);

// Makes any text a name of a file on every medium, without suffix. Characters that FAT refuses and hidden
// ones become "_"; names of devices, such as AUX, get one in front.
[[nodiscard]] QString portableName(const QString& name);

// Returns an unused path in the place: NAME.suffix, NAME-2.suffix ... NAME is the portable name. Capitals do
// not make another name, and a link that leads nowhere uses its name.
[[nodiscard]] QString freePath(const Place& place, const QString& name, const QString& suffix);

} // namespace campanel::store
