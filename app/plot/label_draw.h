// SPDX-License-Identifier: Apache-2.0
// Tick labels of an axis in the panel's language; no backbone and no tick marks, the grid is enough.
#pragma once

#include <QLocale>

#include <qwt_scale_draw.h>

namespace campanel::plot {

class LabelDraw : public QwtScaleDraw {
public:
    LabelDraw(Alignment alignment, const QLocale& locale, int decimals);

    // The label of the tick at `value` becomes `text`, whatever its number.
    void setSpecialLabel(double value, const QString& text);

    [[nodiscard]] QwtText label(double value) const override;

private:
    QLocale m_locale;
    int m_decimals = 0;
    double m_specialValue = 0;
    QString m_specialText;
};

// A number as the locale writes it, with a real minus sign.
[[nodiscard]] QString localNumber(const QLocale& locale, double value, int decimals);

} // namespace campanel::plot
