// SPDX-License-Identifier: Apache-2.0
#include "app/store/update/package_offers.h"

#include <QDateTime>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr qsizetype maxFound = 20; // in one place

QString stampOf(const QString& path)
{
    const QFileInfo file(path);
    return u"%1|%2|%3"_s.arg(path, QString::number(file.size()),
                             QString::number(file.lastModified().toMSecsSinceEpoch()));
}

bool isNewer(const PackageOffer& left, const PackageOffer& right)
{
    if (!left.package || !right.package)
        return left.package && !right.package;
    return compareVersions(left.package->package.version, right.package->package.version) > 0;
}

} // namespace

QList<PackageOffer> offeredPackages(const QList<Place>& places, const QString& keyFolder,
                                    CheckedPackages& checked)
{
    const QList<SignerKey> keys = signerKeys(keyFolder);
    CheckedPackages present;
    QList<PackageOffer> offers;
    for (const Place& place : places) {
        const FolderFiles found = filesIn(place, u"campanel*_*.deb"_s, maxFound);
        if (!found.notice.isEmpty())
            offers << PackageOffer{place.path, place.name, tl::unexpected(PackageFault{}), found.notice};
        for (const QFileInfo& file : found.files) {
            const QString path = file.filePath();
            const QString stamp = stampOf(path) + stampOf(signaturePath(path));
            const auto known = checked.constFind(stamp);
            const auto result = known != checked.cend() ? *known : verifyPackage(path, keys);
            present.insert(stamp, result);
            offers << PackageOffer{path, place.name, result, {}};
        }
    }
    checked = present;
    std::ranges::stable_sort(offers, isNewer);
    return offers;
}

} // namespace campanel::store
