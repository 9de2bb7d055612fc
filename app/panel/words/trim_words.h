// SPDX-License-Identifier: Apache-2.0
// The words for the operator's trims: names, directions, amounts.
#pragma once

#include "app/program/recipe_trims.h"

#include <QCoreApplication>
#include <QString>

namespace campanel::panel {

class TrimWords {
    Q_DECLARE_TR_FUNCTIONS(TrimWords)

public:
    [[nodiscard]] static QString title(program::Trim trim); // "Cut"
    [[nodiscard]] static QString less(program::Trim trim);  // "Earlier"
    [[nodiscard]] static QString more(program::Trim trim);  // "Later"
    // Returns an amount in mm in words: "2.0 mm earlier", "0.0 mm"; "--" for NaN.
    [[nodiscard]] static QString amount(program::Trim trim, double mm);
};

} // namespace campanel::panel
