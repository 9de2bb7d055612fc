// SPDX-License-Identifier: Apache-2.0
// The log of alarms as a list. Its rows change after they were written: they return, are acknowledged.
#pragma once

#include "app/panel/alarms/alarm_lists.h"
#include "app/panel/records/paged_log.h"

namespace campanel::panel {

class AlarmHistory : public PagedLog<AlarmList, &AlarmListRow::alarm> {
public:
    // The records must outlive the object.
    AlarmHistory(DatabaseService& records, QObject* parent);

    void setToday(const QDate& today);
    // Adds changes that are about to be written after all earlier ones.
    void note(const store::AlarmChanges& changes);

private:
    void applyAcknowledgement(const store::AlarmChanges::Acknowledgement& given);

    QDate m_today = QDate::currentDate();
};

} // namespace campanel::panel
