// SPDX-License-Identifier: Apache-2.0
// The backlight of this computer's screen, as the kernel offers it
// (Documentation/ABI/stable/sysfs-class-backlight).
#pragma once

#include <QString>

#include <optional>

namespace campanel::machine {

class Backlight {
public:
    // The first one below `folder` that can be set by this user; empty: there is none.
    [[nodiscard]] static std::optional<Backlight>
    find(const QString& folder = QStringLiteral("/sys/class/backlight"));

    // Of its range, 0..100.
    [[nodiscard]] int percent() const;
    // False when the kernel refused it.
    [[nodiscard]] bool setPercent(int percent) const;

private:
    Backlight(QString device, int most)
        : m_device(std::move(device))
        , m_most(most)
    {
    }

    QString m_device; // its folder
    int m_most;
};

} // namespace campanel::machine
