// SPDX-License-Identifier: Apache-2.0
// The audit trail in the database: who changed what, as rows of which each carries the hash of the one
// before. What it proves: a row that was altered, inserted or taken out without computing the whole rest anew
// is found, and so are rows missing at the end, by a small file beside the database that knows the newest
// one. What it does not prove: somebody who may write both and computes everything anew leaves no trace here;
// against that helps an exported copy, or the newest hash written down elsewhere.
#pragma once

#include "app/store/database/database.h"

#include <QByteArray>
#include <QList>

#include <optional>

namespace campanel::store {

struct AuditEntry {
    qint64 timeMs = 0; // since 1970 UTC
    QString who;       // empty: nobody was logged in
    int level = 0;     // 0 view, 1 Operator, 2 Technician, 3 Service
    QString what;      // stable key: "parameter.write", "user.login" ...
    QString object;    // what was changed: a register, a setting, a user
    QString before;    // empty: not known, or there is none
    QString after;
    QString readBack; // what the controller held then; empty: nothing was read
    QString outcome;  // "done", or a stable key of what kept it from being done

    bool operator==(const AuditEntry&) const = default;
};

struct AuditRow {
    qint64 sequence = 0; // 1, 2, 3 ...
    AuditEntry entry;
    QByteArray previous; // 32 bytes, zeros before the first
    QByteArray hash;     // auditHash() of all the others

    bool operator==(const AuditRow&) const = default;
};

// SHA-256 over sequence, time and level as eight bytes each, big-endian, the texts in their order as four
// bytes of length and UTF-8, and the previous hash.
[[nodiscard]] QByteArray auditHash(qint64 sequence, const AuditEntry& entry, const QByteArray& previous);

// When there are `most` rows, the oldest `dropped` go; where the chain begins from then on is kept, and a row
// "audit.trimmed" says so.
struct AuditBounds {
    qint64 most = 1'000'000;
    qint64 dropped = 10'000;
};

// When it returns a row, that is on the disk. A row "audit.loss" goes before it when the file beside knows of
// newer ones than the database has, "audit.end_unknown" when that file is gone or cannot be read.
[[nodiscard]] tl::expected<AuditRow, StoreError> appendAudit(Database& database, const AuditEntry& entry,
                                                             const AuditBounds& bounds = {});

struct AuditFilter {
    std::optional<QString> who;
    QString area; // first part of `what`, "parameter"; empty: all

    bool operator==(const AuditFilter&) const = default;
};
// Newest first, from the one before `before` on.
[[nodiscard]] tl::expected<QList<AuditRow>, StoreError>
readAudit(Database& database, const AuditFilter& filter, std::optional<qint64> before, int most);
// Everybody in the trail, by name.
[[nodiscard]] tl::expected<QStringList, StoreError> auditNames(Database& database);

// The check of the chain, a part at a time so that others get at the database in between.
class ChainCheck {
public:
    // EndUnknown: what is there is unbroken, but the file beside is gone, so that rows may be missing at the
    // end.
    enum class Fault { None, Altered, Missing, MissingAtEnd, EndUnknown };

    // Looks at up to `rows` more; over when isOver().
    [[nodiscard]] tl::expected<void, StoreError> advance(Database& database, int rows);

    [[nodiscard]] bool isOver() const { return m_isOver; }
    [[nodiscard]] Fault fault() const { return m_fault; }
    // The first that is not as it was, or that is not there, or that may have been there.
    [[nodiscard]] qint64 brokenSequence() const { return m_brokenSequence; }
    [[nodiscard]] qint64 rows() const { return m_rows; }
    [[nodiscard]] qint64 losses() const { return m_losses; } // rows "audit.loss" and "audit.end_unknown"
    [[nodiscard]] const QByteArray& lastHash() const { return m_previous; }

private:
    [[nodiscard]] tl::expected<void, StoreError> begin(Database& database);
    void look(const AuditRow& row);
    void end(Fault fault, qint64 sequence);

    bool m_isBegun = false;
    bool m_isOver = false;
    Fault m_fault = Fault::None;
    qint64 m_brokenSequence = 0;
    qint64 m_next = 1;
    qint64 m_rows = 0;
    qint64 m_losses = 0;
    QByteArray m_previous;
};

// All of it at once.
[[nodiscard]] tl::expected<ChainCheck, StoreError> verifyChain(Database& database);

} // namespace campanel::store
