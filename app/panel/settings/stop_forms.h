// SPDX-License-Identifier: Apache-2.0
// The forms of three settings: when shifts begin, on which days, and the reasons of a stop.
#pragma once

#include <QList>
#include <QString>
#include <QTime>

namespace campanel::panel {

inline constexpr int maxShifts = 6;

// Returns the times of a text such as "06:00 14:00 22:00": one to six quarters of an hour, ascending; empty
// for another text.
[[nodiscard]] QList<QTime> shiftStartsIn(const QString& text);
[[nodiscard]] QString shiftStartsText(const QList<QTime>& starts);
// Returns the days of a text such as "12345", 1: Monday; empty for another text.
[[nodiscard]] QList<int> workingDaysIn(const QString& text);
[[nodiscard]] QString workingDaysText(const QList<int>& days);

// One reason of a stop, or a group of reasons. The words of "material" and others are translated; every
// other text is shown as it is.
struct StopReason {
    QString group;
    QString name; // within the group; empty: the group itself
    bool isPlanned = false;

    // Returns "group" or "group/name", which is stored with a stop.
    [[nodiscard]] QString key() const { return name.isEmpty() ? group : group + u'/' + name; }
    bool operator==(const StopReason&) const = default;
};

inline constexpr int maxReasons = 8; // in the list of groups, and in each group
inline constexpr int maxReasonLength = 24;

// Returns the reasons of a text with one per line, "group", "group/name" or "planned:group"; the standard
// ones for an empty text; none when it is not of this form. A group comes before its reasons, and no reason
// twice.
[[nodiscard]] QList<StopReason> stopReasonsIn(const QString& text);
[[nodiscard]] QString stopReasonsText(const QList<StopReason>& reasons);

} // namespace campanel::panel
