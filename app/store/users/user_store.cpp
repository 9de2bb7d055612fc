// SPDX-License-Identifier: Apache-2.0
#include "app/store/users/user_store.h"

#include "app/store/database/names.h"
#include "app/store/database/setup_marker.h"
#include "app/store/users/pin_hash.h"

#include <QDir>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr qint64 firstDelayMs = 1000;
constexpr qint64 longestDelayMs = 300'000;
constexpr int maxDoublings = 9; // beyond the maximum delay

StoreError refused(const Database& database, const QString& reason)
{
    return {StoreError::Kind::Refused, database.path(), reason};
}

User userOf(const QSqlQuery& row)
{
    return {row.value(0).toLongLong(), row.value(1).toString(),
            static_cast<UserLevel>(std::clamp(row.value(2).toInt(), 1, 3)), row.value(3).toInt(),
            row.value(4).toLongLong()};
}

tl::expected<void, StoreError> change(Database& database, const QString& statement,
                                      std::initializer_list<QVariant> values)
{
    const auto done = database.execute(statement, values);
    if (!done)
        return tl::unexpected(done.error());
    return done->numRowsAffected() == 1
               ? tl::expected<void, StoreError>()
               : tl::unexpected(refused(database, StoreErrorText::tr("this user does not exist")));
}

// Checks, in the transaction after the change, that a user of the level Service remains.
tl::expected<void, StoreError> keepOneService(Database& database)
{
    auto counted = database.execute(u"SELECT count(*), sum(level = 3) FROM user WHERE deleted = 0"_s);
    if (!counted || !counted->next())
        return tl::unexpected(counted ? StoreError{} : counted.error());
    if (counted->value(1).toInt() > 0)
        return {};
    return tl::unexpected(
        refused(database, StoreErrorText::tr("at least one user of the level Service must remain")));
}

} // namespace

qint64 delayMs(int failedAttempts)
{
    if (failedAttempts <= 0)
        return 0;
    return std::min(longestDelayMs, firstDelayMs << std::min(failedAttempts - 1, maxDoublings));
}

qint64 waitMs(const User& user, qint64 nowMs)
{
    const qint64 leftMs = user.lockedUntilMs - nowMs;
    return leftMs > delayMs(user.failedAttempts) ? 0 : std::max<qint64>(0, leftMs);
}

tl::expected<QList<User>, StoreError> users(Database& database)
{
    auto rows = database.execute(
        u"SELECT id, name, level, failed, locked_until_ms FROM user WHERE deleted = 0 ORDER BY name"_s);
    if (!rows)
        return tl::unexpected(rows.error());
    QList<User> found;
    while (rows->next())
        found << userOf(*rows);
    if (const auto read = database.stepped(*rows); !read)
        return tl::unexpected(read.error());
    if (found.isEmpty()) {
        if (database.failure())
            return tl::unexpected(*database.failure());
        if (!database.isInMemory() && readSetupMarker(database.path()) == SetUp::WithPins)
            return tl::unexpected(
                StoreError{StoreError::Kind::PinsLost, setupMarkerPath(database.path()), {}});
    }
    return found;
}

tl::expected<UserCount, StoreError> serviceUsers(Database& database)
{
    auto rows = database.execute(u"SELECT level, pin FROM user WHERE deleted = 0"_s);
    if (!rows)
        return tl::unexpected(rows.error());
    UserCount count;
    for (; rows->next(); ++count.users)
        count.withService += rows->value(0).toInt() >= 3 && isPinHash(rows->value(1).toString()) ? 1 : 0;
    return database.stepped(*rows).map([count] { return count; });
}

void borrowUsers(Database& database, const QString& folder)
{
    const QString path = QDir(folder).filePath(mainDatabase().name);
    const auto copy = Database::openReadOnly(path + u".copy"_s);
    if (!copy)
        return;
    auto rows = (*copy)->execute(
        u"SELECT id, name, level, pin, failed, locked_until_ms FROM user WHERE deleted = 0"_s);
    while (rows && rows->next())
        (void)database.execute(u"INSERT INTO user (id, name, level, pin, failed, locked_until_ms, name_key) "
                               "VALUES (?, ?, ?, ?, ?, ?, ?)"_s,
                               {rows->value(0), rows->value(1), rows->value(2), rows->value(3),
                                rows->value(4), rows->value(5), nameKey(rows->value(1).toString())});
}

tl::expected<void, StoreError> renewPinHash(Database& database, qint64 id, const QString& pinHash)
{
    return change(database, u"UPDATE user SET pin = ? WHERE id = ? AND deleted = 0"_s, {pinHash, id});
}

tl::expected<User, StoreError> addUser(Database& database, const QString& name, UserLevel level,
                                       const QString& pinHash)
{
    User user{0, keptName(name), level, 0, 0};
    if (user.name.isEmpty() || hiddenCharacter(name))
        return tl::unexpected(
            refused(database, StoreErrorText::tr("a name has visible characters only, and at least one")));
    const auto done = database.transaction([&]() -> tl::expected<void, StoreError> {
        const auto added =
            database.execute(u"INSERT INTO user (name, level, pin, name_key) VALUES (?, ?, ?, ?)"_s,
                             {user.name, static_cast<int>(level), pinHash, nameKey(user.name)});
        if (!added)
            return tl::unexpected(added.error());
        user.id = added->lastInsertId().toLongLong();
        return keepOneService(database);
    });
    if (!done)
        return tl::unexpected(done.error());
    // After a failure the next opening writes it.
    if (!database.isInMemory())
        (void)writeSetupMarker(database.path(), SetUp::WithPins);
    return user;
}

tl::expected<void, StoreError> setUserPin(Database& database, qint64 id, const QString& pinHash)
{
    return change(database,
                  u"UPDATE user SET pin = ?, failed = 0, locked_until_ms = 0 WHERE id = ? AND deleted = 0"_s,
                  {pinHash, id});
}

tl::expected<void, StoreError> setUserLevel(Database& database, qint64 id, UserLevel level)
{
    return database.transaction([&] {
        const auto done = change(database, u"UPDATE user SET level = ? WHERE id = ? AND deleted = 0"_s,
                                 {static_cast<int>(level), id});
        return done ? keepOneService(database) : done;
    });
}

tl::expected<void, StoreError> removeUser(Database& database, qint64 id)
{
    return database.transaction([&] {
        const auto done =
            change(database, u"UPDATE user SET deleted = 1, pin = '' WHERE id = ? AND deleted = 0"_s, {id});
        return done ? keepOneService(database) : done;
    });
}

tl::expected<LoginAttempt, StoreError> beginLogin(Database& database, qint64 id, qint64 nowMs)
{
    LoginAttempt attempt;
    const auto done = database.transaction([&]() -> tl::expected<void, StoreError> {
        auto row = database.execute(u"SELECT id, name, level, failed, locked_until_ms, pin FROM user "
                                    "WHERE id = ? AND deleted = 0"_s,
                                    {id});
        if (!row)
            return tl::unexpected(row.error());
        if (!row->next())
            return tl::unexpected(refused(database, StoreErrorText::tr("this user does not exist")));
        attempt.user = userOf(*row);
        const QString hash = row->value(5).toString();
        row->finish();
        attempt.waitMs = waitMs(attempt.user, nowMs);
        if (attempt.waitMs > 0)
            return {};
        attempt.pinHash = hash;
        attempt.user.failedAttempts = std::min(attempt.user.failedAttempts + 1, 1000);
        attempt.waitMs = delayMs(attempt.user.failedAttempts);
        attempt.user.lockedUntilMs = nowMs + attempt.waitMs;
        return change(database, u"UPDATE user SET failed = ?, locked_until_ms = ? WHERE id = ?"_s,
                      {attempt.user.failedAttempts, attempt.user.lockedUntilMs, id});
    });
    if (!done)
        return tl::unexpected(done.error());
    return attempt;
}

tl::expected<void, StoreError> endLogin(Database& database, qint64 id)
{
    return change(database, u"UPDATE user SET failed = 0, locked_until_ms = 0 WHERE id = ?"_s, {id});
}

} // namespace campanel::store
