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
    const QString number = Format().compactMeasure(mm, 0, maxDecimals, QStringLiteral("mm"));
    return mm > 0 ? QLatin1Char('+') + number : number;
}

QString CamSentences::advance(double mm)
{
    return tr("The axis advances by %1 per cycle.").arg(signedMm(mm));
}

QString CamSentences::unconfirmed(double mm)
{
    return tr("The axis advances by %1 in every cycle, and no travel limit stops it.").arg(signedMm(mm));
}

QString CamSentences::ends(const profile::Program& program)
{
    if (const double mm = program::advanceMm(program); mm != 0)
        return advance(mm);
    const double errorMm = program::closingErrorMm(program);
    return errorMm == 0 ? QString()
                        : tr("The ends of the cam differ by %1; the table closes the cam.")
                              .arg(Format().compactMeasure(std::abs(errorMm), 0, 3, QStringLiteral("mm")));
}

} // namespace campanel::panel
