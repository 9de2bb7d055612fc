// SPDX-License-Identifier: Apache-2.0
// Times are milliseconds since 1970 UTC, lengths micrometers, rates thousandths of a bag per minute. Integers
// throughout: SQLite keeps a small one in one to three bytes, and 0 and 1 in none.
#include "app/store/logs/trend_schema.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Returns the statement for a table of buckets. slot: start of the bucket in units of its length, times 8,
// plus the quantity.
QString bucketTable(const QString& name)
{
    return uR"(CREATE TABLE %1 (
                    slot INTEGER PRIMARY KEY,
                    count INTEGER NOT NULL,
                    sum INTEGER NOT NULL,
                    squares INTEGER NOT NULL,
                    low INTEGER NOT NULL,
                    high INTEGER NOT NULL,
                    inside INTEGER NOT NULL))"_s.arg(name);
}

QString firstEra(const QString& name, const QString& key)
{
    return uR"(INSERT INTO ring_era
                    SELECT '%1', 0, (SELECT min(%2) FROM %1), (SELECT max(%2) FROM %1)
                    WHERE EXISTS (SELECT 1 FROM %1))"_s.arg(name, key);
}

const std::vector<QStringList>& steps()
{
    static const std::vector<QStringList> all{
        {
            uR"(CREATE TABLE program (
                    id INTEGER PRIMARY KEY,
                    name TEXT NOT NULL,
                    version INTEGER NOT NULL,
                    length_um INTEGER NOT NULL,
                    last_ms INTEGER NOT NULL,
                    UNIQUE (name, version, length_um)))"_s,
            // The time is the key: a bag at a taken time gets the next free millisecond.
            uR"(CREATE TABLE bag (
                    time_ms INTEGER PRIMARY KEY,
                    program INTEGER NOT NULL,
                    deviation_um INTEGER NOT NULL,
                    lengths INTEGER NOT NULL,
                    mark_error_um INTEGER,
                    following_error_um INTEGER,
                    rate INTEGER,
                    flags INTEGER NOT NULL))"_s,
            bucketTable(u"trend_second"_s),
            bucketTable(u"trend_minute"_s),
            bucketTable(u"trend_hour"_s),
            // The number of rows of each table: counting ten million takes seconds.
            u"CREATE TABLE ring (name TEXT PRIMARY KEY, held INTEGER NOT NULL) WITHOUT ROWID"_s,
            u"INSERT INTO ring VALUES ('bag', 0), ('trend_second', 0), ('trend_minute', 0), ('trend_hour', 0)"_s,
        },
        {
            // The spans with bags that were recorded while the clock was not set.
            u"CREATE TABLE clock_unset (begin_ms INTEGER PRIMARY KEY, end_ms INTEGER NOT NULL)"_s,
        },
        {
            // The order in which rows were written; see ring.h. All rows of today are of the first era.
            u"ALTER TABLE bag ADD COLUMN era INTEGER NOT NULL DEFAULT 0"_s,
            u"ALTER TABLE trend_second ADD COLUMN era INTEGER NOT NULL DEFAULT 0"_s,
            u"ALTER TABLE trend_minute ADD COLUMN era INTEGER NOT NULL DEFAULT 0"_s,
            u"ALTER TABLE trend_hour ADD COLUMN era INTEGER NOT NULL DEFAULT 0"_s,
            uR"(CREATE TABLE ring_era (
                    name TEXT NOT NULL,
                    era INTEGER NOT NULL,
                    first INTEGER NOT NULL,
                    last INTEGER NOT NULL,
                    PRIMARY KEY (name, era)) WITHOUT ROWID)"_s,
            firstEra(u"bag"_s, u"time_ms"_s),
            firstEra(u"trend_second"_s, u"slot"_s),
            firstEra(u"trend_minute"_s, u"slot"_s),
            firstEra(u"trend_hour"_s, u"slot"_s),
        },
    };
    return all;
}

} // namespace

const DatabaseFile& trendDatabase()
{
    static const DatabaseFile file{u"trends.sqlite"_s, &steps, false};
    return file;
}

} // namespace campanel::store
