// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/log_filter_editor.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int minutesOfDay = 24 * 60;

QString limitText(qint64 utcMs)
{
    return utcMs == 0 ? QString() : Format::minute(QDateTime::fromMSecsSinceEpoch(utcMs));
}

} // namespace

LogFilterEditor::LogFilterEditor(QObject* parent)
    : QObject(parent)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
{
    LanguageNotifier::follow(this);
}

QDateTime LogFilterEditor::moment(Limit limit) const
{
    const qint64 setMs = limit == From ? m_filter.fromMs : m_filter.toMs;
    if (setMs != 0)
        return QDateTime::fromMSecsSinceEpoch(setMs);
    return m_wallClock().date().addDays(limit == From ? 0 : 1).startOfDay();
}

void LogFilterEditor::move(Limit limit, int minutes)
{
    const QDateTime moved = minutes % minutesOfDay == 0 ? moment(limit).addDays(minutes / minutesOfDay)
                                                        : moment(limit).addSecs(qint64{60} * minutes);
    store::LogFilter filter = m_filter;
    (limit == From ? filter.fromMs : filter.toMs) = moved.toMSecsSinceEpoch();
    if (filter.fromMs != 0 && filter.toMs != 0 && filter.fromMs >= filter.toMs) {
        if (limit == From)
            filter.toMs = moved.addDays(1).toMSecsSinceEpoch();
        else
            filter.fromMs = moved.addDays(-1).toMSecsSinceEpoch();
    }
    apply(filter);
}

void LogFilterEditor::removeLimit(Limit limit)
{
    store::LogFilter filter = m_filter;
    (limit == From ? filter.fromMs : filter.toMs) = 0;
    apply(filter);
}

void LogFilterEditor::showDay(Limit limit)
{
    // The end of a span belongs to the day before it.
    const QDate day = moment(limit).addMSecs(limit == From ? 0 : -1).date();
    store::LogFilter filter = m_filter;
    filter.fromMs = day.startOfDay().toMSecsSinceEpoch();
    filter.toMs = day.addDays(1).startOfDay().toMSecsSinceEpoch();
    apply(filter);
}

void LogFilterEditor::clear()
{
    apply({});
}

void LogFilterEditor::setId(const QString& id)
{
    store::LogFilter filter = m_filter;
    filter.id = id.left(maxTextLength).trimmed();
    apply(filter);
}

void LogFilterEditor::setWord(const QString& word)
{
    store::LogFilter filter = m_filter;
    filter.word = word.left(maxTextLength).trimmed();
    apply(filter);
}

void LogFilterEditor::apply(const store::LogFilter& filter)
{
    if (m_filter == filter)
        return;
    m_filter = filter;
    emit changed();
}

QString LogFilterEditor::fromText() const
{
    return limitText(m_filter.fromMs);
}

QString LogFilterEditor::toText() const
{
    return limitText(m_filter.toMs);
}

QString LogFilterEditor::summary() const
{
    QStringList parts;
    if (m_filter.fromMs != 0 && m_filter.toMs != 0)
        parts << tr("%1 to %2").arg(fromText(), toText());
    else if (m_filter.fromMs != 0)
        parts << tr("from %1").arg(fromText());
    else if (m_filter.toMs != 0)
        parts << tr("until %1").arg(toText());
    if (!m_filter.id.isEmpty())
        parts << m_filter.id;
    if (!m_filter.word.isEmpty())
        parts << tr("“%1”").arg(m_filter.word);
    return parts.join(u" · "_s);
}

} // namespace campanel::panel
