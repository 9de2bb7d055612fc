// SPDX-License-Identifier: Apache-2.0
// The panel's memory: one SQLite file for recipes, alarms, audit, bags and trends. Write-ahead log, each
// confirmed transaction on the disk before its function returns. Belongs to the thread that opened it.
#pragma once

#include "app/store/store_error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

#include <tl/expected.hpp>

#include <functional>
#include <initializer_list>
#include <memory>

namespace campanel::store {

// Newest schema that this version knows; see schema.h.
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

    // Opens or makes `folder`/campanel.sqlite, brings its schema up to date and checks that it is sound.
    // Errors: CannotOpen, NewerSchema, Full, ReadOnly.
    [[nodiscard]] static tl::expected<std::unique_ptr<Database>, StoreError> open(const QString& folder);
    // One that lasts as long as the object, for when the other cannot be had.
    [[nodiscard]] static std::unique_ptr<Database> inMemory();
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] const Opening& opening() const { return m_opening; }
    [[nodiscard]] const QString& path() const { return m_path; }

    using Result = tl::expected<QSqlQuery, StoreError>;
    // Executes one statement with its values in the order of its question marks. A query that was executed is
    // to be gone through with next().
    [[nodiscard]] Result execute(const QString& statement, std::initializer_list<QVariant> values = {});
    // All of `work` or nothing; what it returns as an error is returned.
    [[nodiscard]] tl::expected<void, StoreError>
    transaction(const std::function<tl::expected<void, StoreError>()>& work);

    // A copy of the present state beside the file; takes the file's place should that be damaged one day.
    [[nodiscard]] tl::expected<void, StoreError> makeCopy();

private:
    explicit Database(QString path);
    [[nodiscard]] tl::expected<void, StoreError> connect();
    [[nodiscard]] tl::expected<void, StoreError> migrate();
    [[nodiscard]] bool isSound();
    void close();
    [[nodiscard]] StoreError errorOf(const QSqlError& error) const;

    QString m_path;
    QString m_connection; // name of QSqlDatabase's, unique
    QSqlDatabase m_database;
    Opening m_opening;
};

} // namespace campanel::store
