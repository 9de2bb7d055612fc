// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/reason_editor.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

ReasonEditor::ReasonEditor(Settings& settings)
    : m_settings(settings)
{
    connect(&settings, &Settings::changed, this, &ReasonEditor::update);
    LanguageNotifier::follow(this);
    update();
}

QList<StopReason> ReasonEditor::all() const
{
    return stopReasonsIn(m_settings.values().text("stops.reasons"));
}

bool ReasonEditor::isOwn() const
{
    return all() != stopReasonsIn({});
}

void ReasonEditor::update()
{
    QList<ReasonKeyRow> rows;
    bool isKnown = m_group.isEmpty();
    const QList<StopReason> reasons = all();
    for (const StopReason& each : reasons)
        isKnown = isKnown || each.group == m_group;
    if (!isKnown)
        m_group.clear();
    for (const StopReason& each : reasons) {
        const bool isGroup = each.name.isEmpty();
        if (m_group.isEmpty() ? isGroup : !isGroup && each.group == m_group)
            rows << ReasonKeyRow{each,
                                 isGroup && std::ranges::count(reasons, each.group, &StopReason::group) > 1};
    }
    m_rows.setRows(rows);
    emit changed();
}

void ReasonEditor::openGroup(int row)
{
    if (!m_group.isEmpty() || row < 0 || row >= m_rows.count())
        return;
    m_group = m_rows.row(row).value.group;
    update();
}

void ReasonEditor::closeGroup()
{
    m_group.clear();
    update();
}

QString ReasonEditor::problemOf(int row, const QString& text) const
{
    const QString words = text.simplified();
    if (words.isEmpty())
        return tr("Enter a name.");
    if (words.size() > maxReasonLength)
        return tr("The name is longer than %1 letters.").arg(maxReasonLength);
    if (words.contains(u'/') || words.startsWith(u"planned:"_s))
        return tr("The name cannot contain a slash.");
    for (int each = 0; each < m_rows.count(); ++each) {
        const StopReason& other = m_rows.row(each).value;
        const bool isSame = words == m_rows.row(each).text() || words == other.name ||
                            (other.name.isEmpty() && words == other.group);
        if (each != row && isSame)
            return tr("This name is already in the list.");
    }
    return {};
}

void ReasonEditor::add(const QString& text)
{
    if (!canAdd() || !problemOf(-1, text).isEmpty())
        return;
    const QString words = text.simplified();
    QList<StopReason> reasons = all();
    // A group stays together.
    qsizetype place = reasons.size();
    for (qsizetype i = 0; i < reasons.size(); ++i) {
        if (!m_group.isEmpty() && reasons[i].group == m_group)
            place = i + 1;
    }
    reasons.insert(place,
                   m_group.isEmpty() ? StopReason{words, {}, false} : StopReason{m_group, words, false});
    store(reasons);
}

void ReasonEditor::rename(int row, const QString& text)
{
    if (row < 0 || row >= m_rows.count() || !problemOf(row, text).isEmpty())
        return;
    const QString words = text.simplified();
    const StopReason renamed = m_rows.row(row).value;
    QList<StopReason> reasons = all();
    for (StopReason& each : reasons) {
        if (renamed.name.isEmpty() && each.group == renamed.group)
            each.group = words;
        else if (each == renamed)
            each.name = words;
    }
    store(reasons);
}

void ReasonEditor::togglePlanned(int row)
{
    if (row < 0 || row >= m_rows.count())
        return;
    const StopReason toggled = m_rows.row(row).value;
    QList<StopReason> reasons = all();
    for (StopReason& each : reasons) {
        if (each == toggled)
            each.isPlanned = !each.isPlanned;
    }
    store(reasons);
}

void ReasonEditor::remove(int row)
{
    if (row < 0 || row >= m_rows.count() || (m_group.isEmpty() && m_rows.count() == 1))
        return;
    const StopReason removed = m_rows.row(row).value;
    QList<StopReason> reasons = all();
    reasons.removeIf([&](const StopReason& each) {
        return removed.name.isEmpty() ? each.group == removed.group : each == removed;
    });
    store(reasons);
}

void ReasonEditor::restoreStandard()
{
    m_settings.set("stops.reasons", u""_s);
}

void ReasonEditor::store(const QList<StopReason>& reasons)
{
    m_settings.set("stops.reasons", stopReasonsText(reasons));
}

} // namespace campanel::panel
