// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/store_error.h"

#include <QDir>

namespace campanel::store {

QString StoreErrorText::describe(const StoreError& error)
{
    const QString path = QDir::toNativeSeparators(error.path);
    switch (error.kind) {
    case StoreError::Kind::CannotOpen:
        return tr("The panel's database %1 cannot be opened: %2. Check the disk and its permissions.")
            .arg(path, error.detail);
    case StoreError::Kind::NewerSchema:
        return tr("The panel's database %1 was written by a newer version of CamPanel. Install that version.")
            .arg(path);
    case StoreError::Kind::Damaged:
        return tr("The panel's database %1 is damaged. Restart the panel to use the last good copy, if there "
                  "is one.")
            .arg(path);
    case StoreError::Kind::Foreign:
        return tr("The panel's database %1 was altered by another program: %2 is not of CamPanel. Move the "
                  "file "
                  "away, restart the panel and restore a backup.")
            .arg(path, error.detail);
    case StoreError::Kind::DiskLost:
        return tr("The disk with the panel's data cannot be used: %1. Replace the disk and restore a backup.")
            .arg(error.detail);
    case StoreError::Kind::InUse:
        return tr("The panel's database %1 is in use by another program. Close that program, then restart "
                  "the panel.")
            .arg(path);
    case StoreError::Kind::PinsLost:
        return tr("The users and PINs of this panel are lost; only operators can work. To start without "
                  "PINs, delete the file %1, restart the panel and restore a backup.")
            .arg(path);
    case StoreError::Kind::Full:
        return tr("The disk is full; data saved before are kept. Free some disk space and save again.");
    case StoreError::Kind::ReadOnly:
        return tr("The panel's database %1 is write-protected. Check the disk and its permissions.")
            .arg(path);
    case StoreError::Kind::TrendsAnew:
        return tr("The records of bags and trends were damaged; new records were started. The damaged file "
                  "was saved as %1.")
            .arg(QDir::toNativeSeparators(error.detail));
    case StoreError::Kind::LastVersion:
        return tr("The recipe %1 has the last version number and was not saved. Save it under another name.")
            .arg(error.detail);
    case StoreError::Kind::Refused:
    case StoreError::Kind::Failed:
        return tr("The panel's database did not accept the data: %1.").arg(error.detail);
    }
    return {};
}

} // namespace campanel::store
