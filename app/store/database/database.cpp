// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/database.h"

#include <QSqlDriver>
#include <QSqlError>
#include <QUuid>

#include <utility>

#include <sqlite3.h>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString inMemoryPath = u":memory:"_s;

// SQLite's result codes, the lower byte of the extended ones.
enum class Code {
    Logic = 1, // a statement that does not match the tables
    Busy = 5,
    Locked = 6,
    ReadOnly = 8,
    Corrupt = 11,
    Full = 13,
    CannotOpen = 14,
    Constraint = 19,
    NotADatabase = 26
};

StoreError::Kind kindOf(int code)
{
    // The index of the write-ahead log, which a reader needs too, finds no room.
    if (code == SQLITE_IOERR_SHMSIZE)
        return StoreError::Kind::Full;
    switch (static_cast<Code>(code & 0xFF)) {
    case Code::Full:
        return StoreError::Kind::Full;
    case Code::ReadOnly:
        return StoreError::Kind::ReadOnly;
    case Code::Corrupt:
    case Code::NotADatabase:
        return StoreError::Kind::Damaged;
    case Code::CannotOpen:
        return StoreError::Kind::CannotOpen;
    case Code::Constraint:
        return StoreError::Kind::Refused;
    case Code::Busy:
    case Code::Locked:
        return StoreError::Kind::InUse;
    case Code::Logic:
        break;
    }
    return StoreError::Kind::Failed;
}

} // namespace

Database::Database(QString path, const DatabaseFile& file)
    : m_path(std::move(path))
    , m_file(file)
    , m_connection(QUuid::createUuid().toString())
    , m_database(QSqlDatabase::addDatabase(u"QSQLITE"_s, m_connection))
{
    m_database.setDatabaseName(m_path);
}

Database::~Database()
{
    close();
    m_database = {};
    QSqlDatabase::removeDatabase(m_connection);
}

bool Database::isInMemory() const
{
    return m_path == inMemoryPath;
}

void Database::close()
{
    m_database.close();
}

StoreError Database::errorOf(const QSqlError& error) const
{
    return {kindOf(error.nativeErrorCode().toInt()), m_path, error.databaseText()};
}

std::unique_ptr<Database> Database::inMemory(const DatabaseFile& file, std::optional<StoreError> failure)
{
    std::unique_ptr<Database> database(new Database(inMemoryPath, file));
    // An empty database accepts every statement.
    (void)database->connect().and_then([&] { return database->configure(); }).and_then([&] {
        return database->migrate();
    });
    database->m_opening.isNew = true;
    database->m_failure = std::move(failure);
    return database;
}

tl::expected<void, StoreError> Database::connect()
{
    if (!m_database.open())
        return tl::unexpected(errorOf(m_database.lastError()));
    // The schema of a file is checked later, and trusted as little as possible until then.
    const QVariant handle = m_database.driver()->handle();
    if (qstrcmp(handle.typeName(), "sqlite3*") == 0)
        sqlite3_db_config(*static_cast<sqlite3* const*>(handle.constData()), SQLITE_DBCONFIG_DEFENSIVE, 1,
                          nullptr);
    for (const QString& pragma : {u"PRAGMA trusted_schema = OFF"_s, u"PRAGMA cell_size_check = ON"_s}) {
        if (const auto done = execute(pragma); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

tl::expected<void, StoreError> Database::configure()
{
    const QString synchronous =
        m_file.isPrecious ? u"PRAGMA synchronous = FULL"_s : u"PRAGMA synchronous = NORMAL"_s;
    for (const QString& pragma : {u"PRAGMA journal_mode = WAL"_s, synchronous, u"PRAGMA foreign_keys = ON"_s,
                                  u"PRAGMA busy_timeout = 5000"_s}) {
        if (const auto done = execute(pragma); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

// Checks the file. An unreadable disk is not damage: nothing is moved aside for it.
tl::expected<void, StoreError> Database::checkSound()
{
    if (!m_file.isPrecious)
        return {};
    auto check = execute(u"PRAGMA quick_check(1)"_s);
    if (!check)
        return tl::unexpected(check.error());
    if (!check->next())
        return stepped(*check).and_then([&]() -> tl::expected<void, StoreError> {
            return tl::unexpected(StoreError{StoreError::Kind::Damaged, m_path, {}});
        });
    const QString verdict = check->value(0).toString();
    if (verdict != u"ok")
        return tl::unexpected(StoreError{StoreError::Kind::Damaged, m_path, verdict});
    return {};
}

// Returns the number of executed schema steps, checked: it is an index.
tl::expected<int, StoreError> Database::version()
{
    auto asked = execute(u"PRAGMA user_version"_s);
    if (!asked || !asked->next())
        return tl::unexpected(asked ? StoreError{StoreError::Kind::Damaged, m_path, {}} : asked.error());
    const int found = asked->value(0).toInt();
    if (found < 0)
        return tl::unexpected(StoreError{StoreError::Kind::Damaged, m_path, u"user_version %1"_s.arg(found)});
    if (found > static_cast<int>(m_file.steps().size()))
        return tl::unexpected(StoreError{StoreError::Kind::NewerSchema, m_path, QString::number(found)});
    return found;
}

tl::expected<void, StoreError> Database::migrate()
{
    const auto found = version();
    if (!found)
        return tl::unexpected(found.error());
    const int newest = static_cast<int>(m_file.steps().size());
    m_opening.migratedFrom = *found > 0 && *found < newest ? *found : 0;
    if (*found == newest)
        return {};
    return transaction([&] {
        return makeSteps(*found, newest).and_then([&] {
            // A pragma does not accept bound values.
            return execute(u"PRAGMA user_version = %1"_s.arg(newest)).map([](const auto&) {});
        });
    });
}

tl::expected<void, StoreError> Database::makeSteps(int from, int to)
{
    for (int version = from; version < to; ++version) {
        for (const QString& statement : m_file.steps()[static_cast<std::size_t>(version)]) {
            QSqlQuery step(m_database);
            if (step.exec(statement))
                continue;
            StoreError error = errorOf(step.lastError());
            // The tables do not match the version of the file.
            if (step.lastError().nativeErrorCode().toInt() == static_cast<int>(Code::Logic))
                error.kind = StoreError::Kind::Damaged;
            return tl::unexpected(error);
        }
    }
    return {};
}

Database::Result Database::execute(const QString& statement, const QVariantList& values)
{
    QSqlQuery query(m_database);
    query.setForwardOnly(true);
    if (!query.prepare(statement))
        return tl::unexpected(errorOf(query.lastError()));
    for (const QVariant& value : values) {
        // An empty text, not NULL, which is a QVariant without a value.
        const bool isEmptyText = value.typeId() == QMetaType::QString && value.toString().isEmpty();
        query.addBindValue(isEmptyText ? QVariant(u""_s) : value);
    }
    if (!query.exec())
        return tl::unexpected(errorOf(query.lastError()));
    return query;
}

tl::expected<void, StoreError> Database::stepped(const QSqlQuery& query) const
{
    if (query.lastError().type() == QSqlError::NoError)
        return {};
    return tl::unexpected(errorOf(query.lastError()));
}

tl::expected<void, StoreError>
Database::transaction(const std::function<tl::expected<void, StoreError>()>& work)
{
    if (const auto begun = execute(u"BEGIN IMMEDIATE"_s); !begun)
        return tl::unexpected(begun.error());
    auto done = work();
    if (done) {
        const auto committed = execute(u"COMMIT"_s);
        if (committed)
            return {};
        done = tl::unexpected(committed.error());
    }
    (void)execute(u"ROLLBACK"_s); // fails when the error has already rolled it back
    return done;
}

} // namespace campanel::store
