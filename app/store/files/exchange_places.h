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

    bool operator==(const Place&) const = default;
};

// Returns true for media mounted below /media, /run/media and /mnt.
[[nodiscard]] bool isRemovableMount(const QString& rootPath);

// Returns the removable media that are ready, then `ownFolder`, which is created when necessary. Waits for
// the media: not for the GUI thread.
[[nodiscard]] QList<Place> exchangePlaces(const QString& ownFolder);

// Returns at most `maxFiles` files directly in the place with this suffix in any case ("csv"), newest first.
// Hidden files are skipped.
[[nodiscard]] QFileInfoList filesIn(const Place& place, const QString& suffix, qsizetype maxFiles);

// Returns an unused path in the place: NAME.suffix, NAME-2.suffix ... `name` is any text; characters that a
// stick's file system does not allow become "_".
[[nodiscard]] QString freePath(const Place& place, const QString& name, const QString& suffix);

} // namespace campanel::store
