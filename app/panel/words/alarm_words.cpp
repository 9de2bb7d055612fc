// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/alarm_words.h"

#include "app/panel/kit/format.h"

#include <QDateTime>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::AlarmRow;

QString AlarmWords::title(const QString& code)
{
    const AlarmKind* kind = AlarmCatalogue::find(code);
    return kind ? kind->title() : tr("Alarm of a newer panel version");
}

AlarmSeverity AlarmWords::severity(const QString& code)
{
    const AlarmKind* kind = AlarmCatalogue::find(code);
    return kind ? kind->severity : AlarmSeverity::Warning;
}

QString AlarmWords::state(const AlarmRow& row)
{
    const bool isActive = row.end == AlarmRow::End::Active;
    const bool isUnknown = row.end == AlarmRow::End::Unknown;
    if (row.acknowledgedMs > 0)
        return isActive    ? tr("Active, acknowledged")
               : isUnknown ? tr("End unknown, acknowledged")
                           : tr("Cleared, acknowledged");
    if (row.wantsAcknowledgement)
        return isActive    ? tr("Active, not acknowledged")
               : isUnknown ? tr("End unknown, not acknowledged")
                           : tr("Cleared, not acknowledged");
    if (row.isShelved)
        return isActive    ? tr("Active, shelved")
               : isUnknown ? tr("End unknown, shelved")
                           : tr("Cleared, shelved");
    return isActive ? tr("Active") : isUnknown ? tr("End unknown") : tr("Cleared");
}

QString AlarmWords::time(qint64 utcMs, const QDate& today)
{
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(utcMs);
    return local.date() == today ? Format::local(local, u"HH:mm:ss"_s) : Format::second(local);
}

QString AlarmWords::clockNote(bool isClockDoubtful)
{
    return isClockDoubtful ? tr("clock not set") : QString();
}

QStringList AlarmWords::codesWith(const QString& word)
{
    QStringList codes;
    for (const AlarmKind& kind : AlarmCatalogue::all()) {
        if (!word.isEmpty() && kind.title().contains(word, Qt::CaseInsensitive))
            codes << kind.code();
    }
    return codes;
}

QString AlarmWords::until(qint64 utcMs, const QDate& today)
{
    return tr("until %1").arg(time(utcMs, today));
}

} // namespace campanel::panel
