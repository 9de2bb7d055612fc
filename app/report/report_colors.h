// SPDX-License-Identifier: Apache-2.0
// The colors of what is printed: those of a color scheme of the screen, so that a curve has one color.
#pragma once

#include <QColor>
#include <QObject>

namespace campanel::report {

struct ReportColors {
    QColor ink{Qt::black};
    QColor secondaryInk{Qt::darkGray};
    QColor line{Qt::lightGray};
    QColor touch{Qt::blue};
    QColor acceleration{Qt::darkGray};
    QColor frequency{Qt::darkBlue};
    QColor sync{Qt::blue};
    QColor warning{Qt::darkYellow};
    QColor fault{Qt::red};

    // Returns the colors with these names of a scheme of the Theme; null: plain ones.
    [[nodiscard]] static ReportColors of(const QObject* scheme)
    {
        ReportColors colors;
        if (!scheme)
            return colors;
        colors.ink = scheme->property("ink").value<QColor>();
        colors.secondaryInk = scheme->property("secondaryInk").value<QColor>();
        colors.line = scheme->property("line").value<QColor>();
        colors.touch = scheme->property("touch").value<QColor>();
        colors.acceleration = scheme->property("acceleration").value<QColor>();
        colors.frequency = scheme->property("frequency").value<QColor>();
        colors.sync = scheme->property("sync").value<QColor>();
        colors.warning = scheme->property("warning").value<QColor>();
        colors.fault = scheme->property("fault").value<QColor>();
        return colors;
    }
};

} // namespace campanel::report
