// SPDX-License-Identifier: Apache-2.0
// Sentences about the master of a recipe and of the machine.
#pragma once

#include "app/link/link_values.h"
#include "app/program/recipe_master.h"

#include <QCoreApplication>

namespace campanel::panel {

class MasterSentences {
    Q_DECLARE_TR_FUNCTIONS(MasterSentences)

public:
    // Returns an empty text for None.
    [[nodiscard]] static QString refusal(program::MasterRefusal refusal);
    [[nodiscard]] static QString title();                            // "Master"
    [[nodiscard]] static QString name(program::RecipeMaster master); // "Encoder"
    // Returns the name of a parameter of the group `master`, empty for another one; and its value in words,
    // "--" for NaN.
    [[nodiscard]] static QString parameter(const QString& name);
    [[nodiscard]] static QString value(const modbus::RegisterInfo& info, double value);
    // Returns why the rate is not entered while an encoder leads.
    [[nodiscard]] static QString rateOfLine();
};

} // namespace campanel::panel
