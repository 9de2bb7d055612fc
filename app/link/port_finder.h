// SPDX-License-Identifier: Apache-2.0
// Finds serial ports: the list for a person to choose from, and an adapter that came back under another name.
#pragma once

#include <QList>
#include <QString>

#include <optional>

namespace campanel::link {

struct PortDescription {
    QString path; // "/dev/ttyUSB0"
    QString description;
    bool isPermitted = true;
    QString group; // that owns the device, for who is not permitted
};

[[nodiscard]] QList<PortDescription> availablePorts();

// What tells one USB adapter from all others.
struct AdapterIdentity {
    quint16 vendorId = 0;
    quint16 productId = 0;
    QString serialNumber;

    bool operator==(const AdapterIdentity&) const = default;
};

// Empty when the port is no USB adapter with a serial number.
[[nodiscard]] std::optional<AdapterIdentity> identityOf(const QString& path);

// The port to open: `wanted`, or, when that is gone or is another adapter, the one with the identity.
[[nodiscard]] QString findPort(const QString& wanted, const std::optional<AdapterIdentity>& identity);

} // namespace campanel::link
