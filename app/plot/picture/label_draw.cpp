// SPDX-License-Identifier: Apache-2.0
#include "app/plot/picture/label_draw.h"

#include <qwt_text.h>

namespace campanel::plot {

LabelDraw::LabelDraw(Alignment alignment, const QLocale& locale, int decimals, double factor, double gap)
    : m_locale(locale)
    , m_decimals(decimals)
    , m_factor(factor)
{
    setAlignment(alignment);
    enableComponent(Backbone, false);
    enableComponent(Ticks, false);
    setSpacing(gap);
}

LabelDraw::LabelDraw(Alignment alignment, const QLocale& locale, const AxisScale& scale, double gap)
    : LabelDraw(alignment, locale, scale.decimals(), scale.factor(), gap)
{
    setScaleDiv(scale.division());
}

void LabelDraw::setSpecialLabel(double value, const QString& text)
{
    m_specialValue = value;
    m_specialText = text;
    invalidateCache();
}

QwtText LabelDraw::label(double value) const
{
    // Exact comparison: Qwt returns the same tick value.
    if (!m_specialText.isEmpty() && value == m_specialValue) {
        return QwtText(m_specialText, QwtText::PlainText);
    }
    // Qwt's engine sets the tick at zero to exactly zero.
    return QwtText(localNumber(m_locale, value * m_factor, value == 0 ? 0 : m_decimals), QwtText::PlainText);
}

QString localNumber(const QLocale& locale, double value, int decimals)
{
    QString text = locale.toString(value, 'f', decimals);
    return text.replace(locale.negativeSign(), QChar(0x2212));
}

} // namespace campanel::plot
