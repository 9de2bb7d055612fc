// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/network_address.h"

#include <QStringList>

#include <algorithm>
#include <bit>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int bitsOfAddress = 32;
constexpr int maxPrefix = 30; // two bits: subnet, broadcast, and two devices

quint32 maskOf(int prefix)
{
    return ~quint32{0} << (bitsOfAddress - prefix);
}

// Returns false for addresses that no device has: 0.x, 127.x, and from 224.0.0.0 on.
bool isOfDevice(quint32 address)
{
    const quint32 first = address >> 24;
    return first > 0 && first != 127 && first < 224;
}

QString firstHost(quint32 address, quint32 mask)
{
    return ipv4Text((address & mask) + 1);
}

QString lastHost(quint32 address, quint32 mask)
{
    return ipv4Text((address | ~mask) - 1);
}

} // namespace

std::optional<quint32> ipv4From(const QString& text)
{
    const QStringList parts = text.split(u'.');
    if (parts.size() != 4)
        return {};
    quint32 address = 0;
    for (const QString& part : parts) {
        const bool isDigits =
            !part.isEmpty() && part.size() <= 3 &&
            std::ranges::all_of(part, [](QChar each) { return each >= u'0' && each <= u'9'; });
        if (!isDigits || part.toUInt() > 255)
            return {};
        address = address << 8 | part.toUInt();
    }
    return address;
}

QString ipv4Text(quint32 address)
{
    return u"%1.%2.%3.%4"_s.arg(address >> 24)
        .arg(address >> 16 & 255)
        .arg(address >> 8 & 255)
        .arg(address & 255);
}

std::optional<int> prefixFrom(const QString& text)
{
    bool isNumber = false;
    int prefix = text.toInt(&isNumber);
    if (!isNumber) {
        const std::optional<quint32> mask = ipv4From(text);
        prefix = mask ? std::popcount(*mask) : 0;
        if (prefix == 0 || *mask != maskOf(prefix))
            return {};
    }
    return prefix >= 1 && prefix <= maxPrefix ? std::optional(prefix) : std::nullopt;
}

QString maskText(int prefix)
{
    return ipv4Text(maskOf(prefix));
}

QString NetworkAddress::label(Field field)
{
    switch (field) {
    case Address:
        return tr("Address");
    case Mask:
        return tr("Subnet mask");
    case Gateway:
        return tr("Gateway");
    case NameServer:
        return tr("DNS server");
    }
    return {};
}

QString NetworkAddress::hint(Field field)
{
    switch (field) {
    case Address:
        return tr("Four numbers from 0 to 255, such as 192.168.1.20. Each device has its own.");
    case Mask:
        return tr("A mask, such as 255.255.255.0, or its length, such as 24.");
    case Gateway:
        return tr("The device that leads to other networks. Empty: none.");
    case NameServer:
        return tr("The device that knows the names of computers. Empty: none.");
    }
    return {};
}

QString NetworkAddress::refusal(Field field, const QString& text)
{
    if (text.isEmpty() && (field == Gateway || field == NameServer))
        return {};
    if (field == Mask) {
        return prefixFrom(text) ? QString()
                                : tr("Not a subnet mask. Enter a mask from 128.0.0.0 to 255.255.255.252, or "
                                     "its length from 1 to 30.");
    }
    for (const QString& each : text.split(listSeparator)) { // a DHCP server may name several DNS servers
        const std::optional<quint32> address = ipv4From(each);
        if (!address)
            return tr("Not an IPv4 address. Enter four numbers from 0 to 255 with points between them.");
        if (!isOfDevice(*address))
            return tr("No device has this address. The first number is from 1 to 223, and not 127.");
    }
    return {};
}

QString NetworkAddress::refusal() const
{
    if (method != Method::Fixed)
        return {};
    for (const Field field : allFields) {
        const QString wrong = refusal(field, fields.at(field));
        if (!wrong.isEmpty())
            return u"%1: %2"_s.arg(label(field), wrong);
    }
    const quint32 address = *ipv4From(fields[Address]);
    const quint32 mask = maskOf(*prefixFrom(fields[Mask]));
    if ((address & ~mask) == 0)
        return tr("%1 is the subnet itself. Enter an address from %2 to %3, or another mask.")
            .arg(fields[Address], firstHost(address, mask), lastHost(address, mask));
    if ((address | mask) == ~quint32{0})
        return tr("%1 is the broadcast address. Enter an address from %2 to %3, or another mask.")
            .arg(fields[Address], firstHost(address, mask), lastHost(address, mask));
    return fields[Gateway].isEmpty() ? QString() : gatewayRefusal(address, mask);
}

QString NetworkAddress::gatewayRefusal(quint32 address, quint32 mask) const
{
    const quint32 gateway = *ipv4From(fields[Gateway]);
    if (gateway == address)
        return tr("The gateway has the address of this panel. Enter the gateway's address, or none.");
    const bool isHost = (gateway & ~mask) != 0 && (gateway | mask) != ~quint32{0};
    if ((gateway & mask) == (address & mask) && isHost)
        return {};
    return tr("The gateway is not in the subnet. Enter a gateway from %1 to %2, or another mask.")
        .arg(firstHost(address, mask), lastHost(address, mask));
}

QString NetworkAddress::text() const
{
    if (method != Method::Fixed)
        return method == Method::Dhcp ? u"DHCP"_s : u"other"_s;
    QString line = u"%1/%2"_s.arg(fields[Address], QString::number(prefixFrom(fields[Mask]).value_or(0)));
    if (!fields[Gateway].isEmpty())
        line += u", gateway "_s + fields[Gateway];
    if (!fields[NameServer].isEmpty())
        line += u", DNS "_s + fields[NameServer];
    return line;
}

} // namespace campanel::panel
