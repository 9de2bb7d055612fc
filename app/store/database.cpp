// SPDX-License-Identifier: Apache-2.0
#include "app/store/database.h"

#include "app/store/schema.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QUuid>

#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString inMemoryPath = u":memory:"_s;

// SQLite's result codes, the lower byte of the extended ones.
enum class Code {
    Busy = 5,
    ReadOnly = 8,
    Corrupt = 11,
    Full = 13,
    CannotOpen = 14,
    Constraint = 19,
    NotADatabase = 26
};

StoreError::Kind kindOf(int code)
{
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
        break;
    }
    return StoreError::Kind::Failed;
}

// The file and what its write-ahead log left, under another name; empty when it cannot be moved.
QString moveAside(const QString& path, const DatabaseFile& file)
{
    if (!file.isPrecious) {
        QDir folder = QFileInfo(path).dir();
        for (const QString& old : folder.entryList({file.name + u".damaged-*"_s}, QDir::Files))
            folder.remove(old);
    }
    const QString stamp = QDateTime::currentDateTimeUtc().toString(u"yyyyMMdd-HHmmss"_s);
    const QString aside = u"%1.damaged-%2"_s.arg(path, stamp);
    if (!QFile::rename(path, aside))
        return {};
    QFile::rename(path + u"-wal"_s, aside + u"-wal"_s);
    QFile::remove(path + u"-shm"_s);
    return aside;
}

} // namespace

const DatabaseFile& mainDatabase()
{
    static const DatabaseFile file{u"campanel.sqlite"_s, &migrations, true};
    return file;
}

int schemaVersion()
{
    return static_cast<int>(migrations().size());
}

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

tl::expected<std::unique_ptr<Database>, StoreError> Database::open(const QString& folder,
                                                                   const DatabaseFile& file)
{
    if (!QDir().mkpath(folder))
        return tl::unexpected(StoreError{StoreError::Kind::CannotOpen, folder,
                                         StoreErrorText::tr("the folder cannot be made")});
    const QString path = QDir(folder).filePath(file.name);
    const QString copy = path + u".copy"_s;
    Opening opening;
    opening.isNew = !QFileInfo::exists(path);
    for (int attempt = 0;; ++attempt) {
        std::unique_ptr<Database> database(new Database(path, file));
        const auto connected = database->connect();
        const bool isDamaged =
            connected ? !database->isSound() : connected.error().kind == StoreError::Kind::Damaged;
        if (!isDamaged) {
            database->m_opening = opening;
            const auto ready = connected ? database->migrate() : connected;
            if (!ready)
                return tl::unexpected(ready.error());
            return database;
        }
        database.reset();
        // The second time the copy is what is damaged: begin with an empty one.
        opening.damagedKeptAs = moveAside(path, file);
        if (opening.damagedKeptAs.isEmpty())
            return tl::unexpected(StoreError{StoreError::Kind::Damaged, path, {}});
        opening.fromCopy = attempt == 0 && QFile::copy(copy, path);
    }
}

tl::expected<std::unique_ptr<Database>, StoreError> Database::openAnew(const QString& folder,
                                                                       const DatabaseFile& file)
{
    const QString path = QDir(folder).filePath(file.name);
    const QString kept = moveAside(path, file);
    if (kept.isEmpty())
        return tl::unexpected(StoreError{StoreError::Kind::Damaged, path, {}});
    auto database = open(folder, file);
    if (database)
        (*database)->m_opening.damagedKeptAs = kept;
    return database;
}

std::unique_ptr<Database> Database::inMemory(const DatabaseFile& file)
{
    std::unique_ptr<Database> database(new Database(inMemoryPath, file));
    if (database->connect())
        (void)database->migrate(); // an empty one takes every statement
    database->m_opening.isNew = true;
    return database;
}

tl::expected<void, StoreError> Database::connect()
{
    if (!m_database.open())
        return tl::unexpected(errorOf(m_database.lastError()));
    const QString synchronous =
        m_file.isPrecious ? u"PRAGMA synchronous = FULL"_s : u"PRAGMA synchronous = NORMAL"_s;
    for (const QString& pragma : {u"PRAGMA journal_mode = WAL"_s, synchronous, u"PRAGMA foreign_keys = ON"_s,
                                  u"PRAGMA busy_timeout = 5000"_s}) {
        if (const auto done = execute(pragma); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

bool Database::isSound()
{
    if (!m_file.isPrecious)
        return true;
    auto check = execute(u"PRAGMA quick_check(1)"_s);
    return check && check->next() && check->value(0).toString() == u"ok";
}

tl::expected<void, StoreError> Database::migrate()
{
    auto asked = execute(u"PRAGMA user_version"_s);
    if (!asked || !asked->next())
        return tl::unexpected(asked ? StoreError{StoreError::Kind::Damaged, m_path, {}} : asked.error());
    const std::vector<QStringList>& steps = m_file.steps();
    const int newest = static_cast<int>(steps.size());
    const int found = asked->value(0).toInt();
    asked->finish();
    if (found > newest)
        return tl::unexpected(StoreError{StoreError::Kind::NewerSchema, m_path, QString::number(found)});
    m_opening.migratedFrom = found > 0 && found < newest ? found : 0;
    return transaction([&]() -> tl::expected<void, StoreError> {
        for (int version = found; version < newest; ++version) {
            for (const QString& statement : steps[static_cast<std::size_t>(version)]) {
                if (const auto done = execute(statement); !done)
                    return tl::unexpected(done.error());
            }
        }
        // A pragma takes no bound value.
        const auto noted = execute(u"PRAGMA user_version = %1"_s.arg(newest));
        return noted ? tl::expected<void, StoreError>() : tl::unexpected(noted.error());
    });
}

Database::Result Database::execute(const QString& statement, std::initializer_list<QVariant> values)
{
    QSqlQuery query(m_database);
    query.setForwardOnly(true);
    if (!query.prepare(statement))
        return tl::unexpected(errorOf(query.lastError()));
    for (const QVariant& value : values) {
        // An empty text, not NULL: that is a QVariant without a value.
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
    (void)execute(u"ROLLBACK"_s); // refused when the failure has rolled it back already
    return done;
}

tl::expected<void, StoreError> Database::makeCopy()
{
    if (isInMemory())
        return {};
    const QString copy = m_path + u".copy"_s;
    const QString fresh = copy + u".new"_s;
    QFile::remove(fresh);
    if (const auto written = execute(u"VACUUM INTO ?"_s, {fresh}); !written) {
        QFile::remove(fresh);
        return tl::unexpected(written.error());
    }
    // Between the two there is no copy for a moment; the file itself is there.
    QFile::remove(copy);
    if (!QFile::rename(fresh, copy))
        return tl::unexpected(StoreError{StoreError::Kind::Failed, copy, {}});
    return {};
}

} // namespace campanel::store
