// SPDX-License-Identifier: Apache-2.0
// The people who may log in, in the database. Wrong PINs are counted before they are looked at, so that
// pulling the plug saves nobody the wait.
#pragma once

#include "app/store/database/database.h"

#include <QList>
#include <QMetaType>

namespace campanel::store {

enum class UserLevel { Operator = 1, Technician, Service };

struct User {
    qint64 id = 0;
    QString name;
    UserLevel level = UserLevel::Operator;
    int failedAttempts = 0;   // in a row
    qint64 lockedUntilMs = 0; // since 1970 UTC

    bool operator==(const User&) const = default;
};

// After so many wrong PINs in a row: 1, 2, 4 ... seconds, at most five minutes.
[[nodiscard]] qint64 delayMs(int failedAttempts);
// How long this user still has to wait. A clock that was set back does not make it longer than the delay.
[[nodiscard]] qint64 waitMs(const User& user, qint64 nowMs);

// By name. Those that were removed are not among them. PinsLost, or what kept the database from being opened,
// when there are none although there were some, or nobody can tell: then nobody may do everything.
[[nodiscard]] tl::expected<QList<User>, StoreError> users(Database& database);
// Refused when somebody has that name. The first user must be of the level Service.
[[nodiscard]] tl::expected<User, StoreError> addUser(Database& database, const QString& name, UserLevel level,
                                                     const QString& pinHash);
// Puts the users of the last good copy in `folder` into a database that is in memory, so that their PINs can
// be checked while the one on the disk cannot be opened.
void borrowUsers(Database& database, const QString& folder);
// The same PIN, hashed with today's effort.
[[nodiscard]] tl::expected<void, StoreError> renewPinHash(Database& database, qint64 id,
                                                          const QString& pinHash);
// Also ends the wait.
[[nodiscard]] tl::expected<void, StoreError> setUserPin(Database& database, qint64 id,
                                                        const QString& pinHash);
// Both are refused when nobody of the level Service would be left.
[[nodiscard]] tl::expected<void, StoreError> setUserLevel(Database& database, qint64 id, UserLevel level);
[[nodiscard]] tl::expected<void, StoreError> removeUser(Database& database, qint64 id);

struct LoginAttempt {
    User user;
    QString pinHash;   // empty while the user has to wait: then nothing was counted
    qint64 waitMs = 0; // from now on, when the PIN is wrong
};
// Counts a wrong PIN in advance; endLogin() takes it back when the PIN was right.
[[nodiscard]] tl::expected<LoginAttempt, StoreError> beginLogin(Database& database, qint64 id, qint64 nowMs);
[[nodiscard]] tl::expected<void, StoreError> endLogin(Database& database, qint64 id);

} // namespace campanel::store
