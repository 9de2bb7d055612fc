// SPDX-License-Identifier: Apache-2.0
// The sentences about the ends of a cam: its axis advances in every cycle, or the table closes an error.
#pragma once

#include "profile/program/programs.h"

#include <QCoreApplication>

namespace campanel::panel {

class CamSentences {
    Q_DECLARE_TR_FUNCTIONS(CamSentences)

public:
    // Returns the advance with its sign: "+0.5 mm".
    [[nodiscard]] static QString signedMm(double mm);
    [[nodiscard]] static QString advance(double mm);
    // Returns what happens to an axis whose advance nobody has confirmed.
    [[nodiscard]] static QString unconfirmed(double mm);
    // Returns the advance of the cam, or its closing error; empty for ends that are the same.
    [[nodiscard]] static QString ends(const profile::Program& program);
};

} // namespace campanel::panel
