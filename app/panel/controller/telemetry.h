// SPDX-License-Identifier: Apache-2.0
// The numbers that a controller reports, by the names of their registers: telemetry["packer.mark_error"] in
// QML. Unit, scale and sign are those of the register's row, so that a new one is that row and the tile that
// names it.
#pragma once

#include <QQmlPropertyMap>
#include <QtQml/qqmlregistration.h>

#include <cstdint>
#include <span>

namespace campanel::panel {

class Telemetry : public QQmlPropertyMap {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Telemetry belongs to the Controller")

public:
    explicit Telemetry(QObject* parent);

    // Takes the registers of a group from `base` on. Only what has changed is notified.
    void take(std::uint16_t base, std::span<const std::uint16_t> registers);
    // Makes all numbers unknown (NaN).
    void forget();
    // Returns the number in its unit; NaN while unknown.
    [[nodiscard]] double number(const char* name) const;

    // Returns the value with its unit as a person reads it; a signed register with its sign, and "--" for
    // NaN.
    Q_INVOKABLE QString text(const QString& name, double value) const;

protected:
    // Keeps the controller's number: the screen cannot write it.
    QVariant updateValue(const QString& name, const QVariant& input) override;
};

} // namespace campanel::panel
