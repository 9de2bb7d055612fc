// SPDX-License-Identifier: Apache-2.0
// The audit trail in the database: rows of changes and their authors, each with the hash of the previous row.
// It detects a row that was altered, inserted or removed without recomputing all later ones. It detects
// missing rows at the end by a small file beside the database with the newest row. It does not detect
// somebody who can write both and recomputes everything; an exported copy, or the newest hash written down
// elsewhere, protects against that.
#pragma once

#include "app/store/logs/table.h"

#include <QByteArray>
#include <QList>

#include <optional>

namespace campanel::store {

struct AuditEntry {
    qint64 timeMs = 0; // since 1970 UTC
    QString who{};     // empty: nobody was logged in
    int level = 0;     // 0 view, 1 Operator, 2 Technician, 3 Service
    QString what{};    // stable key: "parameter.write", "user.login" ...
    QString object{};  // the changed register, setting or user
    QString before{};  // empty: unknown, or none
    QString after{};
    QString readBack{};                       // value in the controller afterwards; empty: not read
    QString outcome = QStringLiteral("done"); // or a stable key of the failure
    bool isClockDoubtful = false;             // written while the clock was not set

    bool operator==(const AuditEntry&) const = default;
};

struct AuditRow {
    qint64 sequence = 0; // 1, 2, 3 ...
    AuditEntry entry;
    QByteArray previous; // 32 bytes, zeros before the first
    QByteArray hash;     // auditHash() of all other members

    bool operator==(const AuditRow&) const = default;
};

[[nodiscard]] const Table<AuditRow>& auditTable();

// Returns the SHA-256 of the entry and the previous hash. Sequence, time and level are eight bytes each,
// big-endian. The texts follow in their order, as four bytes of length and UTF-8, then the number 1 when the
// clock was not set, then the previous hash.
[[nodiscard]] QByteArray auditHash(qint64 sequence, const AuditEntry& entry, const QByteArray& previous);

// The limits of the trail. From `maxRows` rows on the oldest `dropped` are deleted when all of them are older
// than `keptMs`, at `hardRows` in any case: the disk is finite. A doubtful clock deletes nothing before. The
// new start of the chain is stored, and a row "audit.trimmed" tells the last deleted row and its hash: a
// start that no row tells of is a fault.
struct AuditBounds {
    qint64 maxRows = 1'000'000;
    qint64 dropped = 10'000;
    qint64 keptMs = 5 * 366 * qint64{86'400'000}; // five years
    qint64 hardRows = 5'000'000;
};

// Adds a row; when it is returned, it is on the disk. A row "audit.loss" comes before it when the file beside
// the database has newer rows than the database. A row "audit.end_unknown" comes before it when that file is
// missing or unreadable.
[[nodiscard]] tl::expected<AuditRow, StoreError> appendAudit(Database& database, const AuditEntry& entry,
                                                             const AuditBounds& bounds = {});

// Returns all names in the trail, sorted.
[[nodiscard]] tl::expected<QStringList, StoreError> auditNames(Database& database);

// The check of the chain, in steps, so that others can use the database in between.
class ChainCheck {
public:
    // The faults. EndUnknown: the chain is unbroken, but the file beside the database is missing, so that
    // rows may be missing at the end.
    enum class Fault { None, Altered, Missing, MissingAtEnd, EndUnknown };

    // Checks up to `rows` more rows; isOver() tells the end.
    [[nodiscard]] tl::expected<void, StoreError> advance(Database& database, int rows);

    [[nodiscard]] bool isOver() const { return m_isOver; }
    [[nodiscard]] Fault fault() const { return m_fault; }
    // Returns the first row that was altered, is missing or may be missing.
    [[nodiscard]] qint64 brokenSequence() const { return m_brokenSequence; }
    [[nodiscard]] qint64 rows() const { return m_rows; }
    [[nodiscard]] qint64 losses() const { return m_losses; } // rows "audit.loss" and "audit.end_unknown"
    [[nodiscard]] const QByteArray& lastHash() const { return m_previous; }

private:
    [[nodiscard]] tl::expected<void, StoreError> begin(Database& database);
    void check(const AuditRow& row);
    void noteTrimmed(const AuditEntry& entry);
    void end(Fault fault, qint64 sequence);

    bool m_isBegun = false;
    bool m_isOver = false;
    Fault m_fault = Fault::None;
    qint64 m_brokenSequence = 0;
    qint64 m_next = 1;
    qint64 m_rows = 0;
    qint64 m_losses = 0;
    QByteArray m_previous;
    qint64 m_start = 0; // the last deleted row, with its hash
    QByteArray m_startHash;
    qint64 m_trimmedUntil = 0; // as the last row "audit.trimmed" tells
    bool m_isStartTold = false;
};

// Checks the whole chain at once.
[[nodiscard]] tl::expected<ChainCheck, StoreError> verifyChain(Database& database);

} // namespace campanel::store
