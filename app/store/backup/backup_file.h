// SPDX-License-Identifier: Apache-2.0
// A backup of all the panel's data in one file. It is a zip archive of the main database, the settings, both
// recipes and the database of bags and trends. Its manifest (JSON) lists the contents and the SHA-256 of each
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

// The parts of a backup beside the databases.
struct BackupParts {
    QByteArray settings;     // the ini file
    QByteArray storedRecipe; // JSON
    QByteArray workingCopy;  // JSON
};

struct BackupManifest {
    struct Part {
        QString name;
        qint64 bytes = 0;
        QByteArray sha256; // 32 bytes
    };

    QString program; // version of CamPanel that created it
    int schema = 0;  // schema of the main database
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
        Encrypted,   // by a password
        OtherMethod, // of compression
        Newer,       // `detail` is the version of CamPanel that created it
        Damaged,     // `detail` is the part
        Foreign,     // `detail` is what is in a database and not CamPanel's, as "trigger x"
        NoUsers,     // for a panel that has PINs
        NoService,   // nobody could log in as Service
        NotWritable, // `detail` is the system's reason
    };

    Kind kind = Kind::Damaged;
    QString path;
    QString detail;
};

class BackupErrorText {
    Q_DECLARE_TR_FUNCTIONS(BackupErrorText)

public:
    // Returns whole sentences: what is wrong with the file, and that nothing was changed.
    [[nodiscard]] static QString describe(const BackupError& error);
};

// Copies the present database to a file in `folder`, with the audit trail's file beside it. Call it in the
// thread that owns the database. Returns the database's part of the manifest.
[[nodiscard]] tl::expected<BackupManifest, StoreError> takeSnapshot(Database& database,
                                                                    const QString& folder);

// Copies the database of bags and trends; call it in the thread of that database.
[[nodiscard]] tl::expected<void, StoreError> takeTrendSnapshot(Database& database, const QString& folder);

// Writes a new file of both snapshots. `manifest` has program, made and madeBy, and the result of
// takeSnapshot(). The error is the system's reason.
[[nodiscard]] tl::expected<void, QString> writeBackup(const QString& path, BackupManifest manifest,
                                                      const QString& snapshotFolder,
                                                      const BackupParts& parts);

// Reads the manifest alone: quick, but no proof that the rest is valid.
[[nodiscard]] tl::expected<BackupManifest, BackupError> readManifest(const QString& path);

// Checks the sizes in the manifest before any part is unpacked. No part may exceed the maximum of its kind,
// and the total must not exceed 100 times the archive. All parts and a reserve must fit into `freeBytes`.
[[nodiscard]] tl::expected<void, BackupError> checkSizes(const BackupManifest& manifest, qint64 archiveBytes,
                                                         qint64 freeBytes, const QString& path);

// Unpacks all parts as files into `folder`, which must be empty. Checks each against the manifest; the
// recipes must be readable, and the databases valid with the present schema and nothing else in it. After an
// error the contents of the folder must be deleted.
[[nodiscard]] tl::expected<BackupManifest, BackupError> unpackBackup(const QString& path,
                                                                     const QString& folder);

} // namespace campanel::store
