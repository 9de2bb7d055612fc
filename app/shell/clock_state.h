// SPDX-License-Identifier: Apache-2.0
// The state of this computer's clock: records are marked while it cannot be right.
#pragma once

#include "app/store/database/clock_mark.h"

#include <QString>

#include <functional>

namespace campanel::shell {

// Returns true when the kernel's clock follows a time server.
[[nodiscard]] bool isClockSynchronized();

// Returns NotSet when the clock counts from the last shutdown, or from nothing: the kernel did not set it by
// a hardware clock (RTC), and it does not follow a time server. `rtcFolder` has a folder for each hardware
// clock.
[[nodiscard]] store::ClockState clockState(const std::function<bool()>& isSynchronized = &isClockSynchronized,
                                           const QString& rtcFolder = QStringLiteral("/sys/class/rtc"));

} // namespace campanel::shell
