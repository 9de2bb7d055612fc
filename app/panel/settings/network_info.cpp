// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/network_info.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"

#include <QNetworkInterface>
#include <QTimeZone>

#include <optional>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

std::optional<NetworkInfo::Fixed>& fixedFacts()
{
    static std::optional<NetworkInfo::Fixed> facts;
    return facts;
}

QStringList networksNow()
{
    QStringList lines;
    for (const QNetworkInterface& each : QNetworkInterface::allInterfaces()) {
        const auto flags = each.flags();
        if (flags.testFlag(QNetworkInterface::IsLoopBack) || !flags.testFlag(QNetworkInterface::IsRunning))
            continue;
        QStringList addresses;
        for (const QNetworkAddressEntry& entry : each.addressEntries())
            addresses << entry.ip().toString().section(u'%', 0, 0);
        if (!addresses.isEmpty())
            lines << u"%1: %2"_s.arg(each.humanReadableName(), addresses.join(u", "_s));
    }
    return lines;
}

} // namespace

NetworkInfo::NetworkInfo(QObject* parent)
    : QObject(parent)
{
    m_timer.callOnTimeout(this, &NetworkInfo::refresh);
    m_timer.start(1s);
    refresh();
    LanguageNotifier::follow(this);
}

void NetworkInfo::fix(const Fixed& facts)
{
    fixedFacts() = facts;
}

void NetworkInfo::refresh()
{
    m_now = fixedFacts() ? fixedFacts()->now : QDateTime::currentDateTime();
    m_networks = fixedFacts() ? fixedFacts()->networks : networksNow();
    emit changed();
}

QString NetworkInfo::clockText() const
{
    const QLocale locale = Format().locale();
    return locale.toString(m_now.date(), QLocale::LongFormat) + u' ' + m_now.time().toString(u"HH:mm:ss"_s);
}

QString NetworkInfo::zoneText() const
{
    const int minutes = m_now.offsetFromUtc() / 60;
    return u"%1 (%2)"_s.arg(QString::fromLatin1(m_now.timeZone().id()), Format::utcOffset(minutes));
}

} // namespace campanel::panel
