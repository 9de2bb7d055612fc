// SPDX-License-Identifier: Apache-2.0
// The sentences about packages of CamPanel and their installation.
#pragma once

#include "app/store/update/signed_package.h"

#include <QCoreApplication>

namespace campanel::panel {

class PackageSentences {
    Q_DECLARE_TR_FUNCTIONS(PackageSentences)

public:
    // Returns why a file cannot be installed, and what to do.
    [[nodiscard]] static QString fault(const store::PackageFault& fault);
    // Returns why a valid package cannot be installed over the installed one; empty: it can.
    [[nodiscard]] static QString mismatch(const store::PackageId& package, const store::PackageId& installed);
    // Return the same in a few words; empty: it can be installed.
    [[nodiscard]] static QString shortFault(store::PackageFault::Kind kind);
    [[nodiscard]] static QString shortMismatch(const store::PackageId& package,
                                               const store::PackageId& installed);
    // Returns why the installation ended without the new version. `reason` and `detail` are those of
    // campanel-update.
    [[nodiscard]] static QString failure(const QString& reason, const QString& detail);
};

} // namespace campanel::panel
