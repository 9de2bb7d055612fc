// SPDX-License-Identifier: Apache-2.0
// Frames of the line as translated text: one line for the list, all values for the detail view.
#pragma once

#include "app/link/link_values.h"

#include <QCoreApplication>
#include <QStringList>

namespace campanel::panel {

class FrameWords {
    Q_DECLARE_TR_FUNCTIONS(FrameWords)

public:
    // Returns "Status: Running, 12.34 deg".
    [[nodiscard]] static QString line(const modbus::FrameRecord& record);
    // Returns verdict, unit and function, then each value: "status.state = Running".
    [[nodiscard]] static QStringList details(const modbus::FrameRecord& record);
    // Returns "01 03 00 00", empty without bytes.
    [[nodiscard]] static QString bytes(const modbus::FrameRecord& record);

private:
    [[nodiscard]] static QString verdict(modbus::FrameVerdict verdict);
    [[nodiscard]] static QString question(const modbus::DecodedFrame& frame);
    [[nodiscard]] static QString answer(const modbus::DecodedFrame& frame);
    [[nodiscard]] static QString exception(int code);
};

} // namespace campanel::panel
