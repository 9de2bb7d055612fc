// SPDX-License-Identifier: Apache-2.0
// A table that keeps the rows that were written last: rows beyond a number are deleted in the order in which
// they were written. The clock may be set at will. The keys are times: as long as they ascend, their order is
// that of writing. Another era begins when the clock was set back; each row knows its own (the column era).
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

class Ring {
public:
    // Begins to write rows of the table `name`, whose times are in the column `key`: `keysPerMoment`
    // neighboring keys have the same time.
    [[nodiscard]] static tl::expected<Ring, StoreError> begin(Database& database, const QString& name,
                                                              const QString& key, qint64 keysPerMoment = 1);
    // Returns the era of a row that is written now.
    [[nodiscard]] qint64 eraOf(qint64 key);
    // Records `added` new rows and deletes the oldest ones beyond `kept`. Call it in the transaction that
    // added them.
    [[nodiscard]] tl::expected<void, StoreError> end(qint64 added, qint64 kept);

private:
    struct Era {
        qint64 number = 0;
        qint64 first = 0; // all keys before it are deleted
        qint64 last = 0;
    };

    Ring(Database& database, QString name, QString key, qint64 keysPerMoment);
    [[nodiscard]] qint64 momentOf(qint64 key) const;
    [[nodiscard]] tl::expected<QList<Era>, StoreError> eras(const QString& order);
    [[nodiscard]] tl::expected<void, StoreError> store(const Era& era);
    [[nodiscard]] tl::expected<qint64, StoreError> drop(const Era& era, qint64 rows);
    [[nodiscard]] tl::expected<qint64, StoreError> dropOldest(qint64 rows);

    Database* m_database;
    QString m_name;
    QString m_key;
    qint64 m_keysPerMoment;
    QList<Era> m_eras; // the newest one, and those that began since
};

// Returns the number of rows of the table `name`; see the table ring.
[[nodiscard]] tl::expected<qint64, StoreError> rowsOf(Database& database, const QString& name);

} // namespace campanel::store
