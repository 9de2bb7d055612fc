// SPDX-License-Identifier: Apache-2.0
// Replaces the panel's data by a backup. After a power cut at any moment either all the old or all the new
// data is in place. A backup is unpacked and checked (stageRestore), made ready in one step (commitRestore),
// and moved into place before anything is opened at the next start (finishRestore). The replaced data is
// moved into the folder "before-restore"; only the last one is kept.
#pragma once

#include "app/store/backup/backup_file.h"
#include "app/store/logs/audit_log.h"

namespace campanel::store {

// Unpacks and checks a backup; deletes the one staged before. Data in use is not touched. A backup without
// users is refused for a panel that has PINs, one without a user who can log in as Service for every panel.
[[nodiscard]] tl::expected<BackupManifest, BackupError> stageRestore(const QString& backup,
                                                                     const QString& folder);

// Writes `entry` as the next row into the staged audit trail and makes the backup ready. The error is the
// system's reason.
[[nodiscard]] tl::expected<void, QString> commitRestore(const QString& folder, const AuditEntry& entry);

void discardRestore(const QString& folder);

struct FinishedRestore {
    bool isDone = false; // a ready backup was restored
    QString problem;     // it could not be finished and will be tried again at the next start; the system's
                         // reason
    QString keptIn;      // folder of the replaced data
};

// Finishes a restore, also one interrupted by a power cut. Call it before the settings are read and the
// database of `folder` is opened.
[[nodiscard]] FinishedRestore finishRestore(const QString& folder, const QString& settingsFile);

} // namespace campanel::store
