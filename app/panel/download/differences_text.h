// SPDX-License-Identifier: Apache-2.0
// The inputs that a download would change, as text: old and new value of each.
#pragma once

#include "app/panel/kit/difference_model.h"
#include "app/panel/recipe/controller_program.h"
#include "app/program/differences.h"
#include "app/program/program_image.h"

#include <QCoreApplication>

namespace campanel::panel {

class DifferencesText {
    Q_DECLARE_TR_FUNCTIONS(DifferencesText)

public:
    // Returns the rows without the version and without numbers that are derived in both programs.
    [[nodiscard]] static QList<DifferenceRow> rows(const ControllerProgram& active,
                                                   const program::ProgramImage& edited);

private:
    [[nodiscard]] static DifferenceRow row(const program::Difference& difference, profile::ProgramKind kind);
    [[nodiscard]] static QString kindText(double code);
    [[nodiscard]] static QString layoutText(double code);
    [[nodiscard]] static QString pinnedText(std::uint16_t bits);
};

} // namespace campanel::panel
