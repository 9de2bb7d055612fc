// SPDX-License-Identifier: Apache-2.0
#include "gateway/primary_host.h"

#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

QStringList PrimaryHost::topics() const
{
    if (m_name.isEmpty())
        return {};
    return {u"spBv1.0/STATE/"_s + m_name, u"STATE/"_s + m_name};
}

PrimaryHost::Change PrimaryHost::set(bool isOnline)
{
    if (isOnline == m_isOnline)
        return Change::None;
    m_isOnline = isOnline;
    return isOnline ? Change::Online : Change::Offline;
}

PrimaryHost::Change PrimaryHost::take(const QString& topic, const QByteArray& bytes)
{
    if (!topics().contains(topic))
        return Change::None;
    if (topic == topics().constLast()) {
        const bool isWord = bytes == "ONLINE" || bytes == "OFFLINE";
        return isWord && !m_isOfVersion3 ? set(bytes == "ONLINE") : Change::None;
    }
    const QJsonObject state = QJsonDocument::fromJson(bytes).object();
    const auto timestampMs = static_cast<std::int64_t>(state.value(u"timestamp"_s).toDouble(-1));
    if (!state.value(u"online"_s).isBool() || timestampMs < m_timestampMs)
        return Change::None;
    m_isOfVersion3 = true;
    m_timestampMs = timestampMs;
    return set(state.value(u"online"_s).toBool());
}

} // namespace campanel::gateway
