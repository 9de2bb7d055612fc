// SPDX-License-Identifier: Apache-2.0
// The panel's memory: one SQLite file for what must never be lost (recipes ...), one for bags and trends.
// Write-ahead log. Belongs to the thread that opened it.
#pragma once

#include "app/store/store_error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QStringList>
#include <QVariant>

#include <tl/expected.hpp>

#include <functional>
#include <initializer_list>
#include <memory>
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
        int migratedFrom = 0;  // schema version, 0: none
        QString damagedKeptAs; // empty: it was sound
        bool fromCopy = false; // damaged, and its last good copy has taken its place
    };

    // Opens or makes the file in `folder`, brings its schema up to date and checks that it is sound.
    // Errors: CannotOpen, NewerSchema, Full, ReadOnly.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    open(const QString& folder, const DatabaseFile& file = mainDatabase());
    // The same, after what is there was found damaged and moved aside.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError>
    openAnew(const QString& folder, const DatabaseFile& file);
    // One that lasts as long as the object, for when the other cannot be had.
    [[nodiscard]] static std::unique_ptr<Database> inMemory(const DatabaseFile& file = mainDatabase());
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] const Opening& opening() const { return m_opening; }
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isInMemory() const;

    using Result = tl::expected<QSqlQuery, StoreError>;
    // Executes one statement with its values in the order of its question marks; an invalid QVariant is NULL.
    // A query that was executed is to be gone through with next().
    [[nodiscard]] Result execute(const QString& statement, std::initializer_list<QVariant> values = {});
    // What ended next() of a query: the last row, or an error.
    [[nodiscard]] tl::expected<void, StoreError> stepped(const QSqlQuery& query) const;
    // All of `work` or nothing; what it returns as an error is returned.
    [[nodiscard]] tl::expected<void, StoreError>
    transaction(const std::function<tl::expected<void, StoreError>()>& work);

    // A copy of the present state beside the file; takes the file's place should that be damaged one day.
    [[nodiscard]] tl::expected<void, StoreError> makeCopy();

private:
    Database(QString path, const DatabaseFile& file);
    [[nodiscard]] tl::expected<void, StoreError> connect();
    [[nodiscard]] tl::expected<void, StoreError> migrate();
    [[nodiscard]] bool isSound();
    void close();
    [[nodiscard]] StoreError errorOf(const QSqlError& error) const;

    QString m_path;
    DatabaseFile m_file;
    QString m_connection; // name of QSqlDatabase's, unique
    QSqlDatabase m_database;
    Opening m_opening;
};

} // namespace campanel::store
