// SPDX-License-Identifier: Apache-2.0
// The explanation of a derived number: meaning, formula, formula with numbers, result.
#pragma once

#include <QMetaType>
#include <QString>

namespace campanel::panel {

struct Explanation {
    Q_GADGET
    Q_PROPERTY(QString title MEMBER title)
    Q_PROPERTY(QString value MEMBER value)
    Q_PROPERTY(QString unit MEMBER unit)
    Q_PROPERTY(QString text READ text)

public:
    QString title;
    QString value; // in localized digits, "--" when unknown
    QString unit;  // empty for a count
    QString meaning;
    QString formula; // as text: "set length + mean deviation"
    QString numbers; // with numbers: "250.00 + 0.02"; empty while one of them is unknown

    QString result; // of the formula, which is metric; empty: value and unit

    // Sets value and unit to a metric number as it is shown. Fewer decimals than `most` omit zeros.
    void setMeasure(double number, int least, int most, const QString& metricUnit);

    // Returns all parts in lines: meaning, formula, "= numbers", "= value unit".
    [[nodiscard]] QString text() const;
};

} // namespace campanel::panel
