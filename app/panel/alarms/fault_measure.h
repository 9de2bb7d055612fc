// SPDX-License-Identifier: Apache-2.0
// The measure that broke a limit, as a fault shows it: how much it was, and the limit.
#pragma once

#include <QtQml/qqmlregistration.h>

#include <cmath>

namespace campanel::panel {

struct FaultMeasure {
    Q_GADGET
    QML_VALUE_TYPE(faultMeasure)
    Q_PROPERTY(double value MEMBER value FINAL)
    Q_PROPERTY(double limit MEMBER limit FINAL) // in the unit of the value

public:
    double value = std::nan(""); // NaN: unknown
    double limit = std::nan("");
};

} // namespace campanel::panel
