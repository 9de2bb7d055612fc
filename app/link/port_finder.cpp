// SPDX-License-Identifier: Apache-2.0
#include "app/link/port_finder.h"

#include <QFileInfo>
#include <QSerialPortInfo>

namespace campanel::link {

namespace {

std::optional<AdapterIdentity> identityOf(const QSerialPortInfo& port)
{
    if (!port.hasVendorIdentifier() || !port.hasProductIdentifier() || port.serialNumber().isEmpty())
        return std::nullopt;
    return AdapterIdentity{port.vendorIdentifier(), port.productIdentifier(), port.serialNumber()};
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

std::optional<AdapterIdentity> identityOf(const QString& path)
{
    // The path may be a symbolic link, as in /dev/serial/by-id.
    const QString node = QFileInfo(path).canonicalFilePath();
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        if (port.systemLocation() == node)
            return identityOf(port);
    }
    return std::nullopt;
}

QString findPort(const QString& wanted, const std::optional<AdapterIdentity>& identity)
{
    if (!identity || (QFileInfo::exists(wanted) && identityOf(wanted) == identity))
        return wanted;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        if (identityOf(port) == identity)
            return port.systemLocation();
    }
    return wanted;
}

} // namespace campanel::link
