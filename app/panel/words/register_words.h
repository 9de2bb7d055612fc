// SPDX-License-Identifier: Apache-2.0
// Registers in words: their groups, their values with unit, and why one cannot be written.
#pragma once

#include "app/link/link_values.h"

#include <QCoreApplication>

namespace campanel::machine {

class RegisterWords {
    Q_DECLARE_TR_FUNCTIONS(RegisterWords)

public:
    // "status" -> "Status"; a group without words stays as it is.
    [[nodiscard]] static QString group(const QString& group);
    // Why a register of that group is only shown; empty when it may be written.
    [[nodiscard]] static QString readOnlyReason(const QString& group);
    // "status.state", as in the register document.
    [[nodiscard]] static QString name(const modbus::RegisterInfo& info)
    {
        return QString::fromUtf8(info.name);
    }
    // "12.34 deg", "Running", "0x04D2"; names of states as in the register document.
    [[nodiscard]] static QString value(const modbus::NamedValue& value);
    // "0x0320"; empty for a text.
    [[nodiscard]] static QString raw(const modbus::NamedValue& value);
    [[nodiscard]] static QString address(quint16 address);
    // Digits after the mark that the scale has.
    [[nodiscard]] static int decimals(const modbus::RegisterInfo& info);
    [[nodiscard]] static QString type(const modbus::RegisterInfo& info);
};

} // namespace campanel::machine
