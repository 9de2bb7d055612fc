// SPDX-License-Identifier: Apache-2.0
// The users in the database. Wrong PINs are counted before the check, so that cutting the power does not
// avoid the waiting time.
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
    int failedAttempts = 0;   // consecutive
    qint64 lockedUntilMs = 0; // since 1970 UTC

    bool operator==(const User&) const = default;
};

// Returns the waiting time after this many consecutive wrong PINs: 1, 2, 4 ... seconds, at most five minutes.
[[nodiscard]] qint64 delayMs(int failedAttempts);
// Returns how long this user must still wait. More than the delay can only come from a clock that was wrong:
// such a wait is over.
[[nodiscard]] qint64 waitMs(const User& user, qint64 nowMs);

// Returns the users by name, without removed ones. PinsLost when the list is empty although there were users.
// Other errors are those of opening the database; nobody gets all rights in either case.
[[nodiscard]] tl::expected<QList<User>, StoreError> users(Database& database);
// Counts the users, and those of the level Service whose PIN can be checked.
struct UserCount {
    int users = 0;
    int withService = 0;
};
[[nodiscard]] tl::expected<UserCount, StoreError> serviceUsers(Database& database);
// Adds a user. Refused when the name is taken. The first user must have the level Service.
[[nodiscard]] tl::expected<User, StoreError> addUser(Database& database, const QString& name, UserLevel level,
                                                     const QString& pinHash);
// Copies the users of the last good copy in `folder` into a database in memory. Their PINs can then be
// checked while the one on the disk cannot be opened.
void borrowUsers(Database& database, const QString& folder);
// Stores the same PIN, hashed with the present effort.
[[nodiscard]] tl::expected<void, StoreError> renewPinHash(Database& database, qint64 id,
                                                          const QString& pinHash);
// Sets the hash and ends the waiting time.
[[nodiscard]] tl::expected<void, StoreError> setUserPin(Database& database, qint64 id,
                                                        const QString& pinHash);
// Change a user. Both functions are refused when no user of the level Service would be left.
[[nodiscard]] tl::expected<void, StoreError> setUserLevel(Database& database, qint64 id, UserLevel level);
[[nodiscard]] tl::expected<void, StoreError> removeUser(Database& database, qint64 id);

struct LoginAttempt {
    User user;
    QString pinHash;   // empty while the user must wait: the attempt was not counted
    qint64 waitMs = 0; // waiting time if the PIN is wrong
};
// Counts a wrong PIN in advance; endLogin() reverts it when the PIN was right.
[[nodiscard]] tl::expected<LoginAttempt, StoreError> beginLogin(Database& database, qint64 id, qint64 nowMs);
[[nodiscard]] tl::expected<void, StoreError> endLogin(Database& database, qint64 id);

} // namespace campanel::store
