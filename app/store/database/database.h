// SPDX-License-Identifier: Apache-2.0
// The panel's memory: one SQLite file for what must never be lost (recipes ...), one for bags and trends.
// Write-ahead log. Belongs to the thread that opened it.
#pragma once

#include "app/store/database/store_error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QStringList>
#include <QVariant>

#include <tl/expected.hpp>

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

namespace campanel::store {

// One of the panel's database files.
struct DatabaseFile {
    QString name;
    const std::vector<QStringList>& (*steps)() = nullptr; // of its schema, see schema.h
    // Each confirmed transaction is on the disk before its function returns, the whole file is checked at
    // opening, and a damaged one is never deleted. Otherwise a power cut may take the last transactions with
    // it (never the file), damage is found when it is read, and one damaged file is kept.
    bool isPrecious = true;
};

// campanel.sqlite.
[[nodiscard]] const DatabaseFile& mainDatabase();

// Newest schema of the main database that this version knows; see schema.h.
[[nodiscard]] int schemaVersion();

class Database {
public:
    // What was found at opening. Nothing is ever deleted: a damaged file stays beside under another name.
    struct Opening {
        bool isNew = false;
        int migratedFrom = 0;    // schema version, 0: none
        bool wasMissing = false; // there was no file or an empty one, although the panel had been set up
        QString damagedKeptAs;   // empty: it was sound, or missing
        bool fromCopy = false;   // missing or damaged, and its last good copy has taken its place

        [[nodiscard]] bool isReplaced() const { return wasMissing || !damagedKeptAs.isEmpty(); }
    };

    // Opens or makes the file in `folder`, brings its schema up to date and checks that it is sound. A file
    // that is damaged, or missing on a panel that had been set up, gives way to its last good copy. Errors:
    // CannotOpen, NewerSchema, Full, ReadOnly, InUse.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    open(const QString& folder, const DatabaseFile& file = mainDatabase());
    // The same, after what is there was found damaged and moved aside.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openAnew(const QString& folder, const DatabaseFile& file);
    // Opens the file at `path` to read it; nothing is written. Its schema is one that this version knows,
    // perhaps an older one, and it is sound. Errors as for open(), and Damaged.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openReadOnly(const QString& path, const DatabaseFile& file = mainDatabase());
    // Makes one that lasts as long as the object. `failure` is why the users on the disk cannot be read.
    [[nodiscard]] static std::unique_ptr<Database> inMemory(const DatabaseFile& file = mainDatabase(),
                                                            std::optional<StoreError> failure = {});
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] const Opening& opening() const { return m_opening; }
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isInMemory() const;
    // Why it is not known who may log in, unless users are in it.
    [[nodiscard]] const std::optional<StoreError>& failure() const { return m_failure; }

    using Result = tl::expected<QSqlQuery, StoreError>;
    // Executes one statement with its values in the order of its question marks; an invalid QVariant is NULL.
    // A query that was executed is to be gone through with next().
    [[nodiscard]] Result execute(const QString& statement, std::initializer_list<QVariant> values = {});
    // What ended next() of a query: the last row, or an error.
    [[nodiscard]] tl::expected<void, StoreError> stepped(const QSqlQuery& query) const;
    // All of `work` or nothing; what it returns as an error is returned.
    [[nodiscard]] tl::expected<void, StoreError>
    transaction(const std::function<tl::expected<void, StoreError>()>& work);

    // Makes a copy of the present state beside the file; it takes the file's place should that be missing or
    // damaged one day. A copy that holds more than this database is kept under another name.
    [[nodiscard]] tl::expected<void, StoreError> makeCopy();

private:
    Database(QString path, const DatabaseFile& file);
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openAsFound(const QString& path, const DatabaseFile& file);
    [[nodiscard]] tl::expected<void, StoreError> connect();
    [[nodiscard]] tl::expected<void, StoreError> configure();
    [[nodiscard]] tl::expected<int, StoreError> version();
    [[nodiscard]] tl::expected<void, StoreError> migrate();
    [[nodiscard]] tl::expected<void, StoreError> checkSound();
    void noteSetUp();
    void close();
    [[nodiscard]] StoreError errorOf(const QSqlError& error) const;

    QString m_path;
    DatabaseFile m_file;
    QString m_connection; // name of QSqlDatabase's, unique
    QSqlDatabase m_database;
    Opening m_opening;
    std::optional<StoreError> m_failure;
};

} // namespace campanel::store
