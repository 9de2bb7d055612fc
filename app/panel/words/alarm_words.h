// SPDX-License-Identifier: Apache-2.0
// The texts of an occurrence of an alarm, and the roles that the alarm lists share.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/logs/alarm_log.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDateTime>
#include <QHash>
#include <QVariant>

namespace campanel::panel {

class AlarmWords {
    Q_DECLARE_TR_FUNCTIONS(AlarmWords)

public:
    enum Role {
        CodeRole = Qt::UserRole + 1,
        TitleRole,
        SeverityRole, // Alarms.Severity
        TimeRole,     // time of the occurrence
        StateRole,    // "active, acknowledged", ...
        CallsRole,    // needs to be acknowledged
        LiveRole,     // active
        CountRole
    };

    [[nodiscard]] static QHash<int, QByteArray> roles();
    // Returns the data of a role. Times on a day other than `today` include the date.
    [[nodiscard]] static QVariant role(const store::AlarmRow& row, int role, const QDate& today);

    [[nodiscard]] static QString title(const QString& code);
    [[nodiscard]] static AlarmSeverity severity(const QString& code);
    [[nodiscard]] static QString state(const store::AlarmRow& row);
    // Returns the time, with its date on a day other than `today`.
    [[nodiscard]] static QString time(qint64 utcMs, const QDate& today);
};

} // namespace campanel::panel
