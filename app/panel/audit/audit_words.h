// SPDX-License-Identifier: Apache-2.0
// The keys of the audit trail in words. What has no words, a register or a user, is shown as it is.
#pragma once

#include "app/store/logs/audit_log.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace campanel::machine {

class AuditWords {
    Q_DECLARE_TR_FUNCTIONS(AuditWords)

public:
    // The first part of a key: "parameter", "user" ...
    [[nodiscard]] static QStringList areas();
    [[nodiscard]] static QString area(const QString& area);
    [[nodiscard]] static QString what(const QString& what);
    [[nodiscard]] static QString object(const store::AuditEntry& entry);
    [[nodiscard]] static QString outcome(const QString& outcome);
    [[nodiscard]] static QString who(const store::AuditEntry& entry);
    // "900 → 903", in one line; empty when nothing has changed.
    [[nodiscard]] static QString change(const store::AuditEntry& entry);
    [[nodiscard]] static QString time(qint64 timeMs);
    // What became of the check of the chain, in whole sentences.
    [[nodiscard]] static QString chain(const store::ChainCheck& check);
};

} // namespace campanel::machine
