// SPDX-License-Identifier: Apache-2.0
// The texts of an occurrence of an alarm.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/logs/alarm_log.h"

#include <QCoreApplication>
#include <QDateTime>

namespace campanel::panel {

class AlarmWords {
    Q_DECLARE_TR_FUNCTIONS(AlarmWords)

public:
    [[nodiscard]] static QString title(const QString& code);
    [[nodiscard]] static AlarmSeverity severity(const QString& code);
    [[nodiscard]] static QString state(const store::AlarmRow& row);
    // Returns the time, with its date on a day other than `today`.
    [[nodiscard]] static QString time(qint64 utcMs, const QDate& today);
    // Returns the note on a record of a clock that was not set; empty for others.
    [[nodiscard]] static QString clockNote(bool isClockDoubtful);
    // Returns the ids of all alarms whose title contains the word.
    [[nodiscard]] static QStringList codesWith(const QString& word);
    [[nodiscard]] static QString until(qint64 utcMs, const QDate& today);
};

} // namespace campanel::panel
