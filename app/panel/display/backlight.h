// SPDX-License-Identifier: Apache-2.0
// The backlight of this computer's screen, as the kernel offers it
// (Documentation/ABI/stable/sysfs-class-backlight).
#pragma once

#include <QString>

#include <optional>

namespace campanel::panel {

class Backlight {
public:
    // Returns the first backlight below `folder` that this user can set; empty: none.
    [[nodiscard]] static std::optional<Backlight>
    find(const QString& folder = QStringLiteral("/sys/class/backlight"));

    // Returns the brightness as a percentage of its range, 0..100.
    [[nodiscard]] int percent() const;
    // Returns false when the kernel refused the value.
    [[nodiscard]] bool setPercent(int percent) const;

private:
    Backlight(QString device, int maximum)
        : m_device(std::move(device))
        , m_maximum(maximum)
    {
    }

    QString m_device; // its folder
    int m_maximum;
};

} // namespace campanel::panel
