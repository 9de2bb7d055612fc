// SPDX-License-Identifier: Apache-2.0
// The one place where numbers and moments become text: decimals and marks of the current language, "--" for
// the unknown; dates as ISO 8601 writes them, because 1/8/26 is January to one reader and August to another.
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

namespace campanel::machine {

class Format {
public:
    explicit Format(QLocale locale = QLocale()); // by default that of the language in use

    // Exactly `decimals` digits after the mark, no group separators; with a minus sign, not a hyphen.
    [[nodiscard]] QString number(double value, int decimals) const;
    // As number(), with group separators from five digits on: 50,000. For sentences, which nobody edits.
    [[nodiscard]] QString grouped(double value, int decimals) const;
    // Between the two numbers of decimals, without superfluous zeros: 2.50, 1.6667.
    [[nodiscard]] QString compact(double value, int minimumDecimals, int maximumDecimals) const;
    [[nodiscard]] const QLocale& locale() const { return m_locale; }

    // 2026-11-22 07:38, and with the seconds, of the local time.
    static QString minute(const QDateTime& moment);
    static QString second(const QDateTime& moment);

    // As many digits or more: 00FF; and with what tells that they are no decimal ones: 0x00FF.
    static QString hexDigits(quint64 value, int digits);
    static QString hex(quint64 value, int digits) { return QStringLiteral("0x") + hexDigits(value, digits); }

    static QString unknownText() { return QStringLiteral("--"); }

private:
    QLocale m_locale;
};

} // namespace campanel::machine
