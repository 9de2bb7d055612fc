// SPDX-License-Identifier: Apache-2.0
// The texts of registers: their groups, their values with unit, and why one cannot be written.
#pragma once

#include "app/link/link_values.h"

#include <QCoreApplication>

namespace campanel::panel {

class RegisterWords {
    Q_DECLARE_TR_FUNCTIONS(RegisterWords)

public:
    // Returns "Status" for "status"; a group without a text is unchanged.
    [[nodiscard]] static QString group(const QString& group);
    // Returns why a register of that group is read-only; empty when it may be written.
    [[nodiscard]] static QString readOnlyReason(const QString& group);
    // Returns "status.state", as in the register document.
    [[nodiscard]] static QString name(const modbus::RegisterInfo& info)
    {
        return QString::fromUtf8(info.name);
    }
    // Returns "12.34 deg", "Running", "0x04D2"; names of states as in the register document.
    [[nodiscard]] static QString value(const modbus::NamedValue& value);
    // Returns "0x0320"; empty for a text.
    [[nodiscard]] static QString raw(const modbus::NamedValue& value);
    [[nodiscard]] static QString address(quint16 address);
    // Returns why a register cannot hold a value.
    [[nodiscard]] static QString outOfRange(const modbus::CodecError& error);
    // Returns the number of decimals of the scale.
    [[nodiscard]] static int decimals(const modbus::RegisterInfo& info);
    [[nodiscard]] static QString type(const modbus::RegisterInfo& info);
};

} // namespace campanel::panel
