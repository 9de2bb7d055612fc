// SPDX-License-Identifier: Apache-2.0
// The texts for the keys of the audit trail. Keys without a text, such as a register or a user, are displayed
// unchanged.
#pragma once

#include "app/store/logs/audit_log.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace campanel::panel {

class AuditWords {
    Q_DECLARE_TR_FUNCTIONS(AuditWords)

public:
    // Returns the first parts of the keys: "parameter", "user" ...
    [[nodiscard]] static QStringList areas();
    [[nodiscard]] static QString area(const QString& area);
    [[nodiscard]] static QString what(const QString& what);
    [[nodiscard]] static QString object(const store::AuditEntry& entry);
    [[nodiscard]] static QString outcome(const QString& outcome);
    [[nodiscard]] static QString who(const store::AuditEntry& entry);
    // Returns the stored keys whose text contains the word: actions, objects and results.
    [[nodiscard]] static QStringList keysWith(const QString& word);
    // Returns "900 → 903" in one line; empty when nothing has changed.
    [[nodiscard]] static QString change(const store::AuditEntry& entry);
    [[nodiscard]] static QString time(qint64 timeMs);
    // Returns the result of the chain check in whole sentences.
    [[nodiscard]] static QString chain(const store::ChainCheck& check);
};

} // namespace campanel::panel
