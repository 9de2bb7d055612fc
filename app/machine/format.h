// SPDX-License-Identifier: Apache-2.0
// The one place where numbers become text: decimals and marks of the current language, "--" for the unknown.
#pragma once

#include <QLocale>
#include <QString>

namespace campanel::machine {

class Format {
public:
    explicit Format(QLocale locale = QLocale()); // by default that of the language in use

    // Exactly `decimals` digits after the mark, no group separators.
    [[nodiscard]] QString number(double value, int decimals) const;
    // As number(), with group separators from five digits on: 50,000. For sentences, which nobody edits.
    [[nodiscard]] QString grouped(double value, int decimals) const;
    // Between the two numbers of decimals, without superfluous zeros: 2.50, 1.6667.
    [[nodiscard]] QString compact(double value, int minimumDecimals, int maximumDecimals) const;
    [[nodiscard]] const QLocale& locale() const { return m_locale; }

    static QString unknownText() { return QStringLiteral("--"); }

private:
    QLocale m_locale;
};

} // namespace campanel::machine
