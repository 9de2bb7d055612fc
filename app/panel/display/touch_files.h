// SPDX-License-Identifier: Apache-2.0
// The files of a touchscreen's calibration: the devices that udev knows, the rule that campanel-touch writes,
// the request to it, and the calibration that a person has not kept yet.
#pragma once

#include "app/panel/display/touch_matrix.h"

#include <QString>

#include <optional>

namespace campanel::panel {

inline const QString noCalibration = QStringLiteral("none");

// The first two are empty outside of the kiosk.
struct TouchPlaces {
    QString requestFolder{}; // the panel's, emptied by a power cut
    QString stateFolder{};   // the panel's
    QString rule = QStringLiteral("/etc/udev/rules.d/99-campanel-touch.rules");
    QString devices = QStringLiteral("/run/udev/data");

    // Returns the places of the service that systemd has started, by its environment.
    [[nodiscard]] static TouchPlaces ofService();
};

// Matrices as texts, or noCalibration.
struct TouchTrial {
    QString before;
    QString after;
};

// Returns the matrix of the first touchscreen; std::nullopt: there is no touchscreen.
[[nodiscard]] std::optional<TouchMatrix> touchscreenMatrix(const TouchPlaces& places);
// Returns what campanel-touch was asked for the last time.
[[nodiscard]] QString setCalibration(const TouchPlaces& places);
[[nodiscard]] std::optional<TouchTrial> readTrial(const TouchPlaces& places);
// Return false after an error.
[[nodiscard]] bool writeTrial(const TouchPlaces& places, const TouchTrial& trial);
[[nodiscard]] bool writeTouchRequest(const TouchPlaces& places, const QString& wanted);
void removeTrial(const TouchPlaces& places);
void removeTouchRequest(const TouchPlaces& places);

} // namespace campanel::panel
