// SPDX-License-Identifier: Apache-2.0
// An occurrence of an alarm in words, and as the roles that the lists of alarms have in common.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/logs/alarm_log.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDateTime>
#include <QHash>
#include <QVariant>

namespace campanel::machine {

class AlarmWords {
    Q_DECLARE_TR_FUNCTIONS(AlarmWords)

public:
    enum Role {
        CodeRole = Qt::UserRole + 1,
        TitleRole,
        SeverityRole, // Alarms.Severity
        TimeRole,     // when it came
        StateRole,    // "active, acknowledged", ...
        CallsRole,    // wants to be acknowledged
        LiveRole,     // active
        CountRole
    };

    [[nodiscard]] static QHash<int, QByteArray> roles();
    // `today`: what is of another day has its date.
    [[nodiscard]] static QVariant role(const store::AlarmRow& row, int role, const QDate& today);

    [[nodiscard]] static QString title(const QString& code);
    [[nodiscard]] static AlarmSeverity severity(const QString& code);
    [[nodiscard]] static QString state(const store::AlarmRow& row);
    // Of a day that is not `today` with its date.
    [[nodiscard]] static QString time(qint64 utcMs, const QDate& today);
};

} // namespace campanel::machine
