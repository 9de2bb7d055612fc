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

// The marks of a USB adapter. Many have no serial number, or all the same one.
struct AdapterIdentity {
    quint16 vendorId = 0;
    quint16 productId = 0;
    QString serialNumber;
    QString usbPlace; // "1-1.2:1.0": the USB socket, and the interface behind the colon

    // Returns true when it may be the same adapter, perhaps in another socket.
    [[nodiscard]] bool isLike(const AdapterIdentity& other) const;
    bool operator==(const AdapterIdentity&) const = default;
};

struct Adapter {
    QString path;
    AdapterIdentity identity;
};

// Returns the place in the path of a device in /sys; empty when it is not behind USB.
[[nodiscard]] QString usbPlaceOf(const QString& devicePath);

// Returns nothing when the port is not a USB adapter.
[[nodiscard]] std::optional<AdapterIdentity> identityOf(const QString& path);

// Returns the port to open: the adapter in the same socket, or the only one of its kind, or else `wanted`.
[[nodiscard]] QString findPort(const QString& wanted, const std::optional<AdapterIdentity>& identity);
[[nodiscard]] QString findPort(const QString& wanted, const AdapterIdentity& identity,
                               const QList<Adapter>& adapters);

} // namespace campanel::link
