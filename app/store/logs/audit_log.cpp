// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/audit_log.h"

#include "app/store/files/files.h"
#include "app/store/files/private_files.h"

#include <QCryptographicHash>
#include <QtEndian>

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const QString trimmedKey = u"audit.trimmed"_s;

// A link of the chain: a row, and its hash.
struct Link {
    qint64 sequence = 0;
    QByteArray hash = QByteArray(32, '\0');
};

void addNumber(QByteArray& bytes, qint64 value)
{
    const qint64 wire = qToBigEndian(value);
    bytes.append(reinterpret_cast<const char*>(&wire), sizeof wire);
}

void addText(QByteArray& bytes, const QString& text)
{
    const QByteArray utf8 = text.toUtf8();
    const auto length = qToBigEndian(static_cast<quint32>(utf8.size()));
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.append(utf8);
}

// Returns a member of the entry of a row.
template <typename Type> auto ofEntry(Type AuditEntry::*member)
{
    return [member](auto& row) -> auto&
    {
        return row.entry.*member;
    };
}

QString anchorPath(const Database& database)
{
    return database.path() + u".audit"_s;
}

bool isOnDisk(const Database& database)
{
    return database.path() != u":memory:";
}

std::optional<Link> anchor(const Database& database)
{
    const auto line = isOnDisk(database) ? readBytes(anchorPath(database)) : tl::unexpected(FileError{});
    if (!line)
        return std::nullopt;
    const QList<QByteArray> words = line->trimmed().split(' ');
    Link link{words.first().toLongLong(), QByteArray::fromHex(words.last())};
    return link.sequence > 0 && link.hash.size() == 32 ? std::optional(link) : std::nullopt;
}

tl::expected<void, StoreError> setAnchor(const Database& database, const Link& link)
{
    if (!isOnDisk(database))
        return {};
    const QByteArray line = QByteArray::number(link.sequence) + ' ' + link.hash.toHex() + '\n';
    const QString path = anchorPath(database);
    const auto written = replaceBytes(path, line).map_error([](const FileError& error) {
        return StoreError{StoreError::Kind::Failed, error.path, error.found};
    });
    if (written)
        makePrivate(path);
    return written;
}

// Returns the start of the chain: the last deleted row.
tl::expected<Link, StoreError> beginning(Database& database)
{
    auto found = database.execute(u"SELECT sequence, hash FROM audit_start"_s);
    if (!found)
        return tl::unexpected(found.error());
    return found->next() ? Link{found->value(0).toLongLong(), found->value(1).toByteArray()} : Link{};
}

tl::expected<Link, StoreError> newest(Database& database)
{
    auto found = database.execute(u"SELECT sequence, hash FROM audit ORDER BY sequence DESC LIMIT 1"_s);
    if (!found)
        return tl::unexpected(found.error());
    return found->next() ? Link{found->value(0).toLongLong(), found->value(1).toByteArray()}
                         : beginning(database);
}

tl::expected<AuditRow, StoreError> add(Database& database, const Link& last, const AuditEntry& entry)
{
    AuditRow row{last.sequence + 1, entry, last.hash, {}};
    row.hash = auditHash(row.sequence, row.entry, row.previous);
    return auditTable().insert(database, row).map([&row] { return row; });
}

AuditEntry ownEntry(const AuditEntry& like, const QString& what)
{
    AuditEntry entry;
    entry.timeMs = like.timeMs;
    entry.isClockDoubtful = like.isClockDoubtful;
    entry.what = what;
    return entry;
}

// Returns true when the end of the trail needs the file beside the database. The file is written after the
// first row: a process killed in between leaves one row without it.
bool mustKnowEnd(const Database& database, qint64 lastSequence)
{
    return isOnDisk(database) && lastSequence > 1;
}

// Records a loss: the file beside the database has newer rows, or is missing.
tl::expected<Link, StoreError> noteLoss(Database& database, const Link& last, const AuditEntry& before)
{
    const auto known = anchor(database);
    const bool isGone = !known && mustKnowEnd(database, last.sequence);
    const bool isShort = known && known->sequence > last.sequence;
    if (!isGone && !isShort)
        return last;
    AuditEntry loss = ownEntry(before, isGone ? u"audit.end_unknown"_s : u"audit.loss"_s);
    if (isShort) {
        loss.object = u"%1..%2"_s.arg(last.sequence + 1).arg(known->sequence);
        loss.before = QString::fromLatin1(known->hash.toHex());
    }
    return add(database, last, loss).map([](const AuditRow& row) { return Link{row.sequence, row.hash}; });
}

// Makes space for new rows.
tl::expected<Link, StoreError> trim(Database& database, const Link& last, const AuditEntry& before,
                                    const AuditBounds& bounds)
{
    const auto start = beginning(database);
    if (!start)
        return tl::unexpected(start.error());
    if (last.sequence - start->sequence < bounds.maxRows)
        return last;
    const qint64 until = start->sequence + bounds.dropped;
    if (last.sequence - start->sequence < bounds.hardRows) {
        auto newest = database.execute(
            u"SELECT max(time_ms) FROM audit WHERE sequence <= ? AND clock_doubtful = 0"_s, {until});
        if (!newest)
            return tl::unexpected(newest.error());
        if (before.isClockDoubtful || (newest->next() && !newest->isNull(0) &&
                                       before.timeMs - newest->value(0).toLongLong() < bounds.keptMs))
            return last;
    }
    for (const auto& [statement, values] :
         {std::pair{u"DELETE FROM audit_start"_s, QVariantList{}},
          {u"INSERT INTO audit_start (sequence, hash) SELECT sequence, hash FROM audit WHERE sequence = ?"_s,
           {until}},
          {u"DELETE FROM audit WHERE sequence <= ?"_s, {until}}}) {
        if (const auto done = database.execute(statement, values); !done)
            return tl::unexpected(done.error());
    }
    AuditEntry trimmed = ownEntry(before, trimmedKey);
    trimmed.object = u"%1..%2"_s.arg(start->sequence + 1).arg(until);
    const auto cut = beginning(database);
    if (!cut)
        return tl::unexpected(cut.error());
    trimmed.after = QString::fromLatin1(cut->hash.toHex());
    return add(database, last, trimmed).map([](const AuditRow& row) { return Link{row.sequence, row.hash}; });
}

} // namespace

const Table<AuditRow>& auditTable()
{
    using Row = AuditRow;
    using Entry = AuditEntry;
    static const Table<Row> table{
        u"audit"_s,
        4,
        {{.name = u"sequence"_s, .member = &Row::sequence, .sought = Sought::Number},
         {.name = u"time_ms"_s,
          .member = ofEntry(&Entry::timeMs),
          .heading = u"time_utc"_s,
          .form = csvUtc,
          .sought = Sought::Time},
         {.name = u"who"_s, .member = ofEntry(&Entry::who), .sought = Sought::Person | Sought::Word},
         {.name = u"level"_s, .member = ofEntry(&Entry::level)},
         {.name = u"what"_s,
          .member = ofEntry(&Entry::what),
          .sought = Sought::Area | Sought::Name | Sought::Key},
         {.name = u"object"_s,
          .member = ofEntry(&Entry::object),
          .sought = Sought::Name | Sought::Word | Sought::Key},
         {.name = u"before"_s, .member = ofEntry(&Entry::before), .form = csvValue, .sought = Sought::Word},
         {.name = u"after"_s, .member = ofEntry(&Entry::after), .form = csvValue, .sought = Sought::Word},
         {.name = u"read_back"_s,
          .member = ofEntry(&Entry::readBack),
          .form = csvValue,
          .sought = Sought::Word},
         {.name = u"outcome"_s,
          .member = ofEntry(&Entry::outcome),
          .sought = Sought::Word | Sought::FirstKey},
         {.name = u"previous"_s, .member = &Row::previous},
         {.name = u"hash"_s, .member = &Row::hash},
         {.name = u"clock_doubtful"_s,
          .member = ofEntry(&Entry::isClockDoubtful),
          .heading = u"clock"_s,
          .form = csvClock,
          .since = 6}}};
    return table;
}

QByteArray auditHash(qint64 sequence, const AuditEntry& entry, const QByteArray& previous)
{
    QByteArray bytes;
    addNumber(bytes, sequence);
    addNumber(bytes, entry.timeMs);
    addNumber(bytes, entry.level);
    for (const QString& text :
         {entry.who, entry.what, entry.object, entry.before, entry.after, entry.readBack, entry.outcome})
        addText(bytes, text);
    if (entry.isClockDoubtful)
        addNumber(bytes, 1);
    bytes.append(previous);
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

tl::expected<AuditRow, StoreError> appendAudit(Database& database, const AuditEntry& entry,
                                               const AuditBounds& bounds)
{
    AuditRow row;
    const auto done = database.transaction([&]() -> tl::expected<void, StoreError> {
        auto last = newest(database);
        if (last)
            last = noteLoss(database, *last, entry);
        if (last)
            last = trim(database, *last, entry, bounds);
        if (!last)
            return tl::unexpected(last.error());
        const auto added = add(database, *last, entry);
        if (!added)
            return tl::unexpected(added.error());
        row = *added;
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    if (const auto noted = setAnchor(database, {row.sequence, row.hash}); !noted)
        return tl::unexpected(noted.error());
    return row;
}

tl::expected<QStringList, StoreError> auditNames(Database& database)
{
    auto found = database.execute(u"SELECT DISTINCT who FROM audit WHERE who <> '' ORDER BY who"_s);
    if (!found)
        return tl::unexpected(found.error());
    QStringList names;
    while (found->next())
        names << found->value(0).toString();
    return names;
}

tl::expected<void, StoreError> ChainCheck::begin(Database& database)
{
    const auto start = beginning(database);
    if (!start)
        return tl::unexpected(start.error());
    m_isBegun = true;
    m_start = start->sequence;
    m_startHash = start->hash;
    m_next = start->sequence + 1;
    m_previous = start->hash;
    return {};
}

void ChainCheck::end(Fault fault, qint64 sequence)
{
    m_isOver = true;
    m_fault = fault;
    m_brokenSequence = sequence;
}

void ChainCheck::check(const AuditRow& row)
{
    if (row.sequence != m_next)
        end(row.sequence > m_next ? Fault::Missing : Fault::Altered, std::min(row.sequence, m_next));
    else if (row.previous != m_previous || row.hash != auditHash(row.sequence, row.entry, row.previous))
        end(Fault::Altered, row.sequence);
    if (m_isOver)
        return;
    m_previous = row.hash;
    if (row.entry.what == trimmedKey)
        noteTrimmed(row.entry);
    m_losses += row.entry.what == u"audit.loss" || row.entry.what == u"audit.end_unknown" ? 1 : 0;
    ++m_next;
    ++m_rows;
}

// The rows before the start were deleted by the program if a later row tells of it. Rows of earlier versions
// have no hash; the first row of the trail has it, too.
void ChainCheck::noteTrimmed(const AuditEntry& entry)
{
    m_trimmedUntil = entry.object.section(u".."_s, 1).toLongLong();
    m_isStartTold = m_trimmedUntil == m_start &&
                    (entry.after.isEmpty() || entry.after == QString::fromLatin1(m_startHash.toHex()));
}

tl::expected<void, StoreError> ChainCheck::advance(Database& database, int rows)
{
    if (m_isOver)
        return {};
    if (!m_isBegun) {
        if (const auto begun = begin(database); !begun)
            return begun;
    }
    // The first part starts with the oldest row, even before the expected start of the chain.
    const auto found = auditTable().read(database, u"WHERE sequence >= ? ORDER BY sequence LIMIT ?"_s,
                                         {m_rows == 0 ? std::numeric_limits<qint64>::min() : m_next, rows});
    if (!found)
        return tl::unexpected(found.error());
    const auto known = anchor(database);
    for (const AuditRow& row : *found) {
        if (m_isOver)
            break;
        check(row);
        if (!m_isOver && known && known->sequence == m_next - 1 && known->hash != m_previous)
            end(Fault::Altered, known->sequence);
    }
    if (m_isOver || found->size() == rows)
        return {};
    if (m_start > 0 && !m_isStartTold)
        end(Fault::Missing, m_trimmedUntil + 1);
    else if (known && known->sequence >= m_next)
        end(Fault::MissingAtEnd, m_next);
    else if (!known && mustKnowEnd(database, m_next - 1))
        end(Fault::EndUnknown, m_next);
    else
        end(Fault::None, 0);
    return {};
}

tl::expected<ChainCheck, StoreError> verifyChain(Database& database)
{
    constexpr int part = 10'000;
    ChainCheck check;
    while (!check.isOver()) {
        if (const auto done = check.advance(database, part); !done)
            return tl::unexpected(done.error());
    }
    return check;
}

} // namespace campanel::store
