// SPDX-License-Identifier: Apache-2.0
// The texts for levels, PINs and logins.
#pragma once

#include "app/panel/kit/access_check.h"
#include "app/store/database/store_error.h"

#include <QCoreApplication>
#include <QString>

namespace campanel::panel {

class AccessSentences {
    Q_DECLARE_TR_FUNCTIONS(AccessSentences)

public:
    [[nodiscard]] static QString level(Level level);
    // Describes what a user of that level may do.
    [[nodiscard]] static QString permission(Level level);
    [[nodiscard]] static QString refusal(Level needed);
    // Returns why nobody can log in as more than an operator, and how to restore the logins.
    [[nodiscard]] static QString locked(const store::StoreError& reason);
    [[nodiscard]] static int minPinDigits(Level level);
    // Returns why a user of that level cannot choose this PIN; empty when they can.
    [[nodiscard]] static QString pinRefusal(const QString& pin, Level level);
    [[nodiscard]] static QString wrongPin(qint64 waitMs);
    [[nodiscard]] static QString mustWait(qint64 waitMs);

private:
    [[nodiscard]] static QString seconds(qint64 waitMs);
};

} // namespace campanel::panel
