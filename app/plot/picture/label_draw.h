// SPDX-License-Identifier: Apache-2.0
// Draws the tick labels of an axis in the panel's language, without backbone and tick marks: the grid is
// sufficient.
#pragma once

#include "app/plot/picture/axis_scale.h"
#include "app/plot/picture/plot_style.h"

#include <QLocale>

#include <qwt_scale_draw.h>

namespace campanel::plot {

class LabelDraw : public QwtScaleDraw {
public:
    LabelDraw(Alignment alignment, const QLocale& locale, int decimals, double factor = 1,
              double gap = labelGap);
    LabelDraw(Alignment alignment, const QLocale& locale, const AxisScale& scale, double gap = labelGap);

    // Sets the label of the tick at `value` to `text` instead of its number.
    void setSpecialLabel(double value, const QString& text);

    [[nodiscard]] QwtText label(double value) const override;

private:
    QLocale m_locale;
    int m_decimals = 0;
    double m_factor = 1; // number / value of the tick
    double m_specialValue = 0;
    QString m_specialText;
};

// Formats a number in the locale, with a real minus sign.
[[nodiscard]] QString localNumber(const QLocale& locale, double value, int decimals);

} // namespace campanel::plot
