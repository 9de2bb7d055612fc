// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/reason_keys.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"

#include <algorithm>

namespace campanel::panel {

ReasonKeys::ReasonKeys(Settings& settings, QObject* parent)
    : QObject(parent)
    , m_settings(settings)
{
    connect(&settings, &Settings::changed, this, &ReasonKeys::update);
    LanguageNotifier::follow(this);
    update();
}

void ReasonKeys::update()
{
    const QList<StopReason> all = stopReasonsIn(m_settings.values().text("stops.reasons"));
    const auto hasReasons = [&](const QString& group) {
        return std::ranges::any_of(
            all, [&](const StopReason& each) { return each.group == group && !each.name.isEmpty(); });
    };
    if (!m_group.isEmpty() && !hasReasons(m_group))
        m_group.clear();
    QList<ReasonKeyRow> rows;
    for (const StopReason& each : all) {
        const bool isShown =
            m_group.isEmpty() ? each.name.isEmpty() : each.group == m_group && !each.name.isEmpty();
        if (isShown)
            rows << ReasonKeyRow{each, each.name.isEmpty() && hasReasons(each.group)};
    }
    m_rows.setRows(rows);
    emit changed();
}

void ReasonKeys::touch(int row)
{
    if (row < 0 || row >= m_rows.count())
        return;
    const ReasonKeyRow touched = m_rows.row(row);
    if (!touched.opens) {
        close();
        emit chosen(touched.value);
        return;
    }
    m_group = touched.value.group;
    update();
}

void ReasonKeys::close()
{
    if (m_group.isEmpty())
        return;
    m_group.clear();
    update();
}

} // namespace campanel::panel
