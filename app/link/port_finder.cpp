// SPDX-License-Identifier: Apache-2.0
#include "app/link/port_finder.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QSerialPortInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::link {

namespace {

QList<Adapter> presentAdapters()
{
    QList<Adapter> adapters;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        if (!port.hasVendorIdentifier() || !port.hasProductIdentifier())
            continue;
        const QFileInfo device(u"/sys/class/tty/%1/device"_s.arg(port.portName()));
        adapters << Adapter{port.systemLocation(),
                            {port.vendorIdentifier(), port.productIdentifier(), port.serialNumber(),
                             usbPlaceOf(device.canonicalFilePath())}};
    }
    return adapters;
}

} // namespace

QList<PortDescription> availablePorts()
{
    QList<PortDescription> ports;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        const QFileInfo node(port.systemLocation());
        ports << PortDescription{port.systemLocation(), port.description(),
                                 node.isReadable() && node.isWritable(), node.group()};
    }
    return ports;
}

bool AdapterIdentity::isLike(const AdapterIdentity& other) const
{
    return vendorId == other.vendorId && productId == other.productId && serialNumber == other.serialNumber &&
           usbPlace.section(u':', 1) == other.usbPlace.section(u':', 1);
}

QString usbPlaceOf(const QString& devicePath)
{
    static const QRegularExpression place(u"/([0-9]+-[0-9.]+:[0-9]+\\.[0-9]+)(/|$)"_s);
    return place.match(devicePath).captured(1);
}

std::optional<AdapterIdentity> identityOf(const QString& path)
{
    // The path may be a symbolic link, as in /dev/serial/by-id.
    const QString node = QFileInfo(path).canonicalFilePath();
    const QList<Adapter> adapters = presentAdapters();
    const auto found = std::ranges::find(adapters, node, &Adapter::path);
    return found == adapters.end() ? std::nullopt : std::optional(found->identity);
}

QString findPort(const QString& wanted, const std::optional<AdapterIdentity>& identity)
{
    return identity ? findPort(wanted, *identity, presentAdapters()) : wanted;
}

QString findPort(const QString& wanted, const AdapterIdentity& identity, const QList<Adapter>& adapters)
{
    QStringList alike;
    QString inPlace;
    for (const Adapter& adapter : adapters) {
        if (adapter.identity.isLike(identity))
            alike << adapter.path;
        if (adapter.identity == identity)
            inPlace = adapter.path;
    }
    // Two alike in other sockets are not told apart, so neither is taken.
    const QString found = inPlace.isEmpty() && alike.size() == 1 ? alike.first() : inPlace;
    // The wanted path may be a symbolic link to it.
    return found.isEmpty() || QFileInfo(wanted).canonicalFilePath() == found ? wanted : found;
}

} // namespace campanel::link
