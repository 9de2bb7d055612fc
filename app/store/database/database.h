// SPDX-License-Identifier: Apache-2.0
// The panel's databases: one SQLite file for data that must never be lost (recipes ...), one for bags and
// trends. Write-ahead log. Belongs to the thread that opened it.
#pragma once

#include "app/store/database/store_error.h"

#include <QList>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QStringList>
#include <QVariant>

#include <tl/expected.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace campanel::store {

class Database;

// A name that an earlier version kept, and the present one cannot: the same as another one, or partly hidden.
struct Renamed {
    QString table; // "recipe" or "user"
    QString before;
    QString after;
};

struct DatabaseFile {
    QString name;
    const std::vector<QStringList>& (*steps)() = nullptr; // steps of its schema
    // True when every confirmed transaction must be on the disk before its function returns. The whole file
    // is then checked at opening, and damaged files are never deleted. When false, a power cut may lose the
    // last transactions (never the file), damage is found when it is read, and only one damaged file is kept.
    bool isPrecious = true;
    // Sets what the steps of the schema cannot; empty: nothing. Returns the changed names.
    tl::expected<QList<Renamed>, StoreError> (*complete)(Database&) = nullptr;
};

// Returns campanel.sqlite; see logs/main_schema.cpp.
[[nodiscard]] const DatabaseFile& mainDatabase();

// Returns the newest schema of the main database that this version supports.
[[nodiscard]] int schemaVersion();

class Database {
public:
    // The result of opening. Nothing is ever deleted: a damaged file is kept under another name.
    struct Opening {
        bool isNew = false;
        int migratedFrom = 0;    // schema version, 0: none
        bool wasMissing = false; // no file or an empty one on a panel that had been set up
        QString damagedKeptAs;   // empty: it was valid, or missing
        bool fromCopy = false;   // missing or damaged, and replaced by its last good copy
        QList<Renamed> renamed;

        [[nodiscard]] bool isReplaced() const { return wasMissing || !damagedKeptAs.isEmpty(); }
    };

    // Opens or creates the file in `folder`, updates its schema and checks it. The last good copy replaces a
    // damaged file, or a missing one on a panel that had been set up. Errors: CannotOpen, NewerSchema,
    // Foreign, Full, ReadOnly, InUse.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    open(const QString& folder, const DatabaseFile& file = mainDatabase());
    // Opens the file as open() after the present one was found damaged; moves that one aside first.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openAnew(const QString& folder, const DatabaseFile& file);
    // Opens the file at `path` read-only. Its schema must be supported, possibly an older one, and the file
    // valid. Errors as for open(), and Damaged.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openReadOnly(const QString& path, const DatabaseFile& file = mainDatabase());
    // Creates a database in memory. `failure` is the reason why the users on the disk cannot be read.
    [[nodiscard]] static std::unique_ptr<Database> inMemory(const DatabaseFile& file = mainDatabase(),
                                                            std::optional<StoreError> failure = {});
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] const Opening& opening() const { return m_opening; }
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isInMemory() const;
    // Returns why the users are unknown, unless they have been copied into this database.
    [[nodiscard]] const std::optional<StoreError>& failure() const { return m_failure; }

    using Result = tl::expected<QSqlQuery, StoreError>;
    // Executes one statement with its values in the order of its question marks; an invalid QVariant is NULL.
    // Iterate over an executed query with next().
    [[nodiscard]] Result execute(const QString& statement, const QVariantList& values = {});
    // Checks why next() of a query ended: the last row, or an error.
    [[nodiscard]] tl::expected<void, StoreError> stepped(const QSqlQuery& query) const;
    // Executes all of `work` or nothing and returns its error.
    [[nodiscard]] tl::expected<void, StoreError>
    transaction(const std::function<tl::expected<void, StoreError>()>& work);

    // Returns the version of the file's schema; one that was opened read-only may have an older one.
    [[nodiscard]] tl::expected<int, StoreError> version();

    // Copies the present state to a file beside the database, which replaces a missing or damaged database.
    // An existing copy with more data than this database is kept under another name.
    [[nodiscard]] tl::expected<void, StoreError> makeCopy();

private:
    Database(QString path, const DatabaseFile& file);
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openAsFound(const QString& path, const DatabaseFile& file);
    [[nodiscard]] tl::expected<void, StoreError> connect();
    [[nodiscard]] tl::expected<void, StoreError> configure();
    [[nodiscard]] tl::expected<void, StoreError> migrate();
    // Executes the steps of the schema from one version to another.
    [[nodiscard]] tl::expected<void, StoreError> makeSteps(int from, int to);
    [[nodiscard]] tl::expected<void, StoreError> checkSound();
    // Checks that the file has the tables of its version and nothing else; see schema_check.cpp.
    [[nodiscard]] tl::expected<void, StoreError> checkSchema();
    void noteSetUp();
    void close();
    [[nodiscard]] StoreError errorOf(const QSqlError& error) const;

    QString m_path;
    DatabaseFile m_file;
    QString m_connection; // unique name for QSqlDatabase
    QSqlDatabase m_database;
    Opening m_opening;
    std::optional<StoreError> m_failure;
};

} // namespace campanel::store
