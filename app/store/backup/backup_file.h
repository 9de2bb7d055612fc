// SPDX-License-Identifier: Apache-2.0
// Everything that the panel keeps in one file: a zip archive of the main database, the settings, both recipes
// and the database of bags and trends, with a manifest (JSON) that says what is in it and the SHA-256 of each
// part. Not for the GUI thread.
#pragma once

#include "app/store/database/database.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDateTime>
#include <QList>

namespace campanel::store {

inline constexpr int backupFormatVersion = 2;                           // 1 had no bags and trends
inline const QString backedUpSettings = QStringLiteral("settings.ini"); // the part that is the ini file

// What is put into a backup beside the databases.
struct BackupParts {
    QByteArray settings;     // the ini file
    QByteArray storedRecipe; // JSON
    QByteArray workingCopy;  // JSON
};

// What a backup says of itself.
struct BackupManifest {
    struct Part {
        QString name;
        qint64 bytes = 0;
        QByteArray sha256; // 32 bytes
    };

    QString program; // version of CamPanel that made it
    int schema = 0;  // of the main database
    QDateTime made;  // UTC
    QString madeBy;  // empty: nobody was logged in
    int recipes = 0;
    int users = 0;
    QList<Part> parts;

    [[nodiscard]] bool hasTrends() const;
};

struct BackupError {
    enum class Kind {
        NotReadable, // `detail` is the system's reason
        NotABackup,
        Newer,       // `detail` is the version of CamPanel that made it
        Damaged,     // `detail` is the part
        NotWritable, // `detail` is the system's reason
    };

    Kind kind = Kind::Damaged;
    QString path;
    QString detail;
};

class BackupErrorText {
    Q_DECLARE_TR_FUNCTIONS(BackupErrorText)

public:
    // Whole sentences: what is wrong with the file, and that nothing was changed.
    [[nodiscard]] static QString describe(const BackupError& error);
};

// The present database as a file in `folder`, together with what its audit trail knows beside it. To be
// called in the thread that owns the database. What the manifest needs to know of it comes back.
[[nodiscard]] tl::expected<BackupManifest, StoreError> takeSnapshot(Database& database,
                                                                    const QString& folder);

// The same of bags and trends, in the thread of their database.
[[nodiscard]] tl::expected<void, StoreError> takeTrendSnapshot(Database& database, const QString& folder);

// A new file of both snapshots. `manifest` tells program, made and madeBy, and what takeSnapshot() said. The
// system's reason on failure.
[[nodiscard]] tl::expected<void, QString> writeBackup(const QString& path, BackupManifest manifest,
                                                      const QString& snapshotFolder,
                                                      const BackupParts& parts);

// Looks at the manifest alone: quick, and no proof that the rest is sound.
[[nodiscard]] tl::expected<BackupManifest, BackupError> readManifest(const QString& path);

// Checks what the manifest says of its parts before any of them is unpacked: no part larger than its kind can
// be, not more than 100 times the archive, and not more than fits beside a reserve into `freeBytes`.
[[nodiscard]] tl::expected<void, BackupError> checkSizes(const BackupManifest& manifest, qint64 archiveBytes,
                                                         qint64 freeBytes, const QString& path);

// All parts as files in `folder`, which is empty: each is as the manifest says, the recipes are recipes, the
// databases open, are sound and have today's schema. Otherwise an error; what is in the folder then is to be
// thrown away.
[[nodiscard]] tl::expected<BackupManifest, BackupError> unpackBackup(const QString& path,
                                                                     const QString& folder);

} // namespace campanel::store
