// SPDX-License-Identifier: Apache-2.0
// Finds serial ports: the list to choose from, and an adapter that came back under another name.
#pragma once

#include <QList>
#include <QString>

#include <optional>

namespace campanel::link {

struct PortDescription {
    QString path; // "/dev/ttyUSB0"
    QString description;
    bool isPermitted = true;
    QString group; // group that owns the device, for a refused user
};

[[nodiscard]] QList<PortDescription> availablePorts();

struct AdapterIdentity {
    quint16 vendorId = 0;
    quint16 productId = 0;
    QString serialNumber;

    bool operator==(const AdapterIdentity&) const = default;
};

// Returns nothing when the port is not a USB adapter with a serial number.
[[nodiscard]] std::optional<AdapterIdentity> identityOf(const QString& path);

// Returns the port to open: `wanted`, or the one with this identity when `wanted` is missing or another
// adapter.
[[nodiscard]] QString findPort(const QString& wanted, const std::optional<AdapterIdentity>& identity);

} // namespace campanel::link
