// SPDX-License-Identifier: Apache-2.0
// The findings of the link doctor in whole translated sentences: what is wrong and what to do.
#pragma once

#include "app/link/link_values.h"

#include <QCoreApplication>

namespace campanel::panel {

class DoctorSentences {
    Q_DECLARE_TR_FUNCTIONS(DoctorSentences)

public:
    // Returns "9600 baud, 8E1, unit 7".
    [[nodiscard]] static QString settings(const modbus::LineSettings& line, int unit);
    // Returns a few words: "No answer".
    [[nodiscard]] static QString condition(modbus::LineCondition condition);
    [[nodiscard]] static QString finding(const modbus::LineFinding& finding);
    // Returns "12 of 7410, at most 11 min more".
    [[nodiscard]] static QString progress(const modbus::ScanProgress& progress);

private:
    [[nodiscard]] static QString portFinding(const modbus::LineFinding& finding);
    [[nodiscard]] static QString busy(const modbus::LineFinding& finding);
};

} // namespace campanel::panel
