// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/cam_sentences.h"

#include "app/panel/kit/format.h"
#include "app/program/cam_advance.h"

#include <cmath>

namespace campanel::panel {

namespace {
constexpr int maxDecimals = 6; // grid of the advance
}

QString CamSentences::signedMm(double mm)
{
    const QString number = Format().compact(mm, 0, maxDecimals);
    return mm > 0 ? QLatin1Char('+') + number : number;
}

QString CamSentences::advance(double mm)
{
    return tr("The axis advances by %1 mm per cycle.").arg(signedMm(mm));
}

QString CamSentences::unconfirmed(double mm)
{
    return tr("The axis advances by %1 mm in every cycle, and no travel limit stops it.").arg(signedMm(mm));
}

QString CamSentences::ends(const profile::Program& program)
{
    if (const double mm = program::advanceMm(program); mm != 0)
        return advance(mm);
    const double errorMm = program::closingErrorMm(program);
    return errorMm == 0 ? QString()
                        : tr("The ends of the cam differ by %1 mm; the table closes the cam.")
                              .arg(Format().compact(std::abs(errorMm), 0, 3));
}

} // namespace campanel::panel
