// SPDX-License-Identifier: Apache-2.0
// How a derived number comes about, as a person reads it: what it is, the formula, the numbers put in, the
// result.
#pragma once

#include <QMetaType>
#include <QString>

namespace campanel::machine {

struct Explanation {
    Q_GADGET
    Q_PROPERTY(QString title MEMBER title)
    Q_PROPERTY(QString value MEMBER value)
    Q_PROPERTY(QString unit MEMBER unit)
    Q_PROPERTY(QString text READ text)

public:
    QString title;
    QString value; // in the language's digits, "--" when unknown
    QString unit;  // empty for a count
    QString meaning;
    QString formula; // in words: "set length + mean deviation"
    QString numbers; // the same in numbers: "250.00 + 0.02"; empty while one of them is not known

    // All of it in lines: meaning, formula, "= numbers", "= value unit".
    [[nodiscard]] QString text() const;
};

} // namespace campanel::machine
