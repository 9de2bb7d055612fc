// SPDX-License-Identifier: Apache-2.0
// The packages of CamPanel at a place, such as a stick.
#pragma once

#include "app/store/files/exchange_places.h"
#include "app/store/update/signed_package.h"

#include <QHash>

namespace campanel::store {

struct PackageOffer {
    QString path;
    QString placeName;
    tl::expected<PackageSignature, PackageFault> package;
    QString notice; // which files of the place `path` are missing; empty: this is a package
};

// Results by file, with its size and time: a package is read once.
using CheckedPackages = QHash<QString, tl::expected<PackageSignature, PackageFault>>;

// Returns the files campanel_*.deb of all places, the newest version first, files with a fault last. Updates
// `checked`. Reads whole files: not for the GUI thread.
[[nodiscard]] QList<PackageOffer> offeredPackages(const QList<Place>& places, const QString& keyFolder,
                                                  CheckedPackages& checked);

} // namespace campanel::store
