// SPDX-License-Identifier: Apache-2.0
// Puts a backup in the place of what the panel keeps, so that after a power cut at any moment it is either
// all the old or all the new. A backup is unpacked and checked beside (stageRestore), made ready in one step
// (commitRestore), and takes its place before anything is opened the next time (finishRestore). What it
// replaces is moved into the folder "before-restore"; only the last such is kept.
#pragma once

#include "app/store/backup/backup_file.h"
#include "app/store/logs/audit_log.h"

namespace campanel::store {

// Unpacks and checks; what was staged before goes. Nothing that is in use is touched.
[[nodiscard]] tl::expected<BackupManifest, BackupError> stageRestore(const QString& backup,
                                                                     const QString& folder);

// Writes `entry` as the next row into the trail of what was staged, and makes it ready. The system's reason
// on failure.
[[nodiscard]] tl::expected<void, QString> commitRestore(const QString& folder, const AuditEntry& entry);

void discardRestore(const QString& folder);

struct FinishedRestore {
    bool isDone = false; // there was one that was ready
    QString problem;     // it could not be finished and is tried again the next time; the system's reason
    QString keptIn;      // where that is which it has replaced
};

// To be called before the settings are read and the database of `folder` is opened. Also ends what a power
// cut has interrupted.
[[nodiscard]] FinishedRestore finishRestore(const QString& folder, const QString& settingsFile);

} // namespace campanel::store
