// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/ring.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

tl::expected<qint64, StoreError> rowsOf(Database& database, const QString& name)
{
    auto asked = database.execute(u"SELECT held FROM ring WHERE name = ?"_s, {name});
    if (!asked)
        return tl::unexpected(asked.error());
    if (!asked->next())
        return tl::unexpected(StoreError{StoreError::Kind::Damaged, database.path(), name});
    return asked->value(0).toLongLong();
}

Ring::Ring(Database& database, QString name, QString key, qint64 keysPerMoment)
    : m_database(&database)
    , m_name(std::move(name))
    , m_key(std::move(key))
    , m_keysPerMoment(keysPerMoment)
{
}

tl::expected<Ring, StoreError> Ring::begin(Database& database, const QString& name, const QString& key,
                                           qint64 keysPerMoment)
{
    Ring ring(database, name, key, keysPerMoment);
    const auto newest = ring.eras(u"DESC"_s);
    if (!newest)
        return tl::unexpected(newest.error());
    ring.m_eras = *newest;
    return ring;
}

qint64 Ring::momentOf(qint64 key) const
{
    return key / m_keysPerMoment - (key % m_keysPerMoment < 0 ? 1 : 0);
}

qint64 Ring::eraOf(qint64 key)
{
    if (m_eras.isEmpty() || momentOf(key) < momentOf(m_eras.last().last))
        m_eras << Era{m_eras.isEmpty() ? 0 : m_eras.last().number + 1, momentOf(key) * m_keysPerMoment, key};
    m_eras.last().last = std::max(m_eras.last().last, key);
    return m_eras.last().number;
}

// Returns the first era of the order, if there is one.
tl::expected<QList<Ring::Era>, StoreError> Ring::eras(const QString& order)
{
    auto found = m_database->execute(
        u"SELECT era, first, last FROM ring_era WHERE name = ? ORDER BY era %1 LIMIT 1"_s.arg(order),
        {m_name});
    if (!found)
        return tl::unexpected(found.error());
    QList<Era> era;
    if (found->next())
        era << Era{found->value(0).toLongLong(), found->value(1).toLongLong(), found->value(2).toLongLong()};
    return era;
}

tl::expected<void, StoreError> Ring::store(const Era& era)
{
    return m_database
        ->execute(u"INSERT OR REPLACE INTO ring_era (name, era, first, last) VALUES (?, ?, ?, ?)"_s,
                  {m_name, era.number, era.first, era.last})
        .map([](const auto&) {});
}

// Deletes at most `rows` rows of an era, and the era with its last row. Returns their number.
tl::expected<qint64, StoreError> Ring::drop(const Era& era, qint64 rows)
{
    auto found = m_database->execute(
        u"SELECT max(%2), count(*) FROM (SELECT %2 FROM %1 WHERE %2 BETWEEN ? AND ? AND era = ? ORDER BY %2 LIMIT ?)"_s
            .arg(m_name, m_key),
        {era.first, era.last, era.number, rows});
    if (!found || !found->next())
        return tl::unexpected(found ? m_database->stepped(*found).error() : found.error());
    const qint64 until = found->value(0).toLongLong();
    const qint64 count = found->value(1).toLongLong();
    found->finish();
    const auto deleted =
        m_database->execute(u"DELETE FROM %1 WHERE %2 BETWEEN ? AND ? AND era = ?"_s.arg(m_name, m_key),
                            {era.first, until, era.number});
    if (!deleted)
        return tl::unexpected(deleted.error());
    const bool isOver = (count < rows || until == era.last) && era.number != m_eras.last().number;
    const auto noted =
        isOver
            ? m_database->execute(u"DELETE FROM ring_era WHERE name = ? AND era = ?"_s, {m_name, era.number})
                  .map([](const auto&) {})
        : count > 0 ? store({era.number, until + 1, era.last})
                    : tl::expected<void, StoreError>();
    return noted.map([count] { return count; });
}

tl::expected<qint64, StoreError> Ring::dropOldest(qint64 rows)
{
    qint64 gone = 0;
    while (gone < rows) {
        const auto oldest = eras(u"ASC"_s);
        if (!oldest)
            return tl::unexpected(oldest.error());
        if (oldest->isEmpty())
            break;
        const auto dropped = drop(oldest->first(), rows - gone);
        if (!dropped)
            return tl::unexpected(dropped.error());
        gone += *dropped;
        if (gone < rows && oldest->first().number == m_eras.last().number)
            break;
    }
    return gone;
}

tl::expected<void, StoreError> Ring::end(qint64 added, qint64 kept)
{
    for (const Era& era : m_eras) {
        if (const auto stored = store(era); !stored)
            return stored;
    }
    const auto before = rowsOf(*m_database, m_name);
    if (!before)
        return tl::unexpected(before.error());
    const auto gone = dropOldest(std::max<qint64>(0, *before + added - kept));
    if (!gone)
        return tl::unexpected(gone.error());
    return m_database
        ->execute(u"UPDATE ring SET held = ? WHERE name = ?"_s, {*before + added - *gone, m_name})
        .map([](const auto&) {});
}

} // namespace campanel::store
