// SPDX-License-Identifier: Apache-2.0
// Levels, PINs and logging in, in words.
#pragma once

#include "app/machine/gate.h"

#include <QCoreApplication>
#include <QString>

namespace campanel::machine {

class AccessSentences {
    Q_DECLARE_TR_FUNCTIONS(AccessSentences)

public:
    [[nodiscard]] static QString level(Level level);
    // What somebody of that level may do.
    [[nodiscard]] static QString permission(Level level);
    // Who may do what was just refused.
    [[nodiscard]] static QString refusal(Level needed);
    // Why it is no PIN to choose; empty when it is one.
    [[nodiscard]] static QString pinRefusal(const QString& pin);
    [[nodiscard]] static QString wrongPin(qint64 waitMs);
    [[nodiscard]] static QString mustWait(qint64 waitMs);

private:
    [[nodiscard]] static QString seconds(qint64 waitMs);
};

} // namespace campanel::machine
