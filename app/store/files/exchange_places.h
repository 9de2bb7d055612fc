// SPDX-License-Identifier: Apache-2.0
// Where files are brought from and taken to: a folder of the panel's own and removable media that are
// mounted, such as a USB stick. No other part of the file system is ever offered.
#pragma once

#include <QFileInfoList>
#include <QList>
#include <QString>

#include <tl/expected.hpp>

namespace campanel::store {

struct Place {
    QString path; // absolute
    QString name; // as a person knows it
    bool isReadOnly = false;
    bool isRemovable = false; // a stick

    bool operator==(const Place&) const = default;
};

// True for what is mounted below /media, /run/media and /mnt.
[[nodiscard]] bool isRemovableMount(const QString& rootPath);

// The removable media that are ready, then `ownFolder`, which is made if need be. May take as long as a
// medium takes to answer: not for the GUI thread.
[[nodiscard]] QList<Place> exchangePlaces(const QString& ownFolder);

// Files of a place itself, not of its folders, with this suffix in any case ("csv"), newest first; at most
// `most`. Hidden ones are passed over.
[[nodiscard]] QFileInfoList filesIn(const Place& place, const QString& suffix, qsizetype most);

// A path in the place that no file has yet: NAME.suffix, NAME-2.suffix ... `name` is any text; characters
// that a stick's file system cannot keep become "_".
[[nodiscard]] QString freePath(const Place& place, const QString& name, const QString& suffix);

} // namespace campanel::store
