// SPDX-License-Identifier: Apache-2.0
// Debian packages: what dpkg says of a file and of this computer, and the order of versions.
#pragma once

#include <QString>
#include <QStringView>

#include <compare>
#include <optional>

namespace campanel::store {

struct PackageId {
    QString name;
    QString version;
    QString architecture;

    bool operator==(const PackageId&) const = default;
};

// Returns what a package file says of itself; empty when it is none, or without dpkg-deb. Waits for the
// program: not for the GUI thread.
[[nodiscard]] std::optional<PackageId> packageIn(const QString& path);
// Returns what an update replaces: the package of CamPanel, or the system of an image, whose name and version
// are in os-release(5). Empty when CamPanel was not installed as a package. Waits for dpkg-query.
[[nodiscard]] std::optional<PackageId> installedPackage();
// Returns the version of the system of an image by its os-release(5); empty when it is none of CamPanel.
[[nodiscard]] QString imageVersion(const QString& osRelease = QStringLiteral("/etc/os-release"));

// Compares two versions as dpkg does: [epoch:]upstream[-revision], "~" before the end, letters before others.
[[nodiscard]] std::strong_ordering compareVersions(QStringView left, QStringView right);

// Returns the version that a person calls it: "1.2.3" of "1.2.3+deb12".
[[nodiscard]] QString shortVersion(const QString& version);

// Returns the schemas of the databases that this program reads and writes: "14.3". Two programs with the same
// ones read each other's data.
[[nodiscard]] QString dataSchema();

} // namespace campanel::store
