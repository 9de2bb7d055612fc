// SPDX-License-Identifier: Apache-2.0
// The only place where numbers and times become text: decimals and separators of the current language, "--"
// for unknown values. Dates follow ISO 8601, because 1/8/26 is ambiguous.
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

#include <optional>

namespace campanel::panel {

class Format {
public:
    explicit Format(QLocale locale = QLocale()); // the current language by default

    // Formats with exactly `decimals` digits, without group separators, and with a minus sign instead of a
    // hyphen. From 1e15 on with an exponent.
    [[nodiscard]] QString number(double value, int decimals) const;
    // Formats as number(), with group separators from five digits on: 50,000. For texts that nobody edits.
    [[nodiscard]] QString grouped(double value, int decimals) const;
    // Formats with between the two numbers of decimals, without superfluous zeros: 2.50, 1.6667.
    [[nodiscard]] QString compact(double value, int minimumDecimals, int maximumDecimals) const;
    // Formats a metric value in the units that the panel shows, without and with the unit: "180.0 mm",
    // "7.0866 in". `beside` is the other number of the sentence, see decimalsToTell(). With groups as
    // grouped().
    [[nodiscard]] QString amount(double value, int decimals, const QString& unit) const;
    [[nodiscard]] QString compactAmount(double value, int minimumDecimals, int maximumDecimals,
                                        const QString& unit) const;
    [[nodiscard]] QString measure(double value, int decimals, const QString& unit,
                                  std::optional<double> beside = {}) const;
    [[nodiscard]] QString compactMeasure(double value, int minimumDecimals, int maximumDecimals,
                                         const QString& unit, std::optional<double> beside = {}) const;
    // Joins a number and its unit, which no line break divides. An unknown number has no unit.
    [[nodiscard]] static QString joined(const QString& number, const QString& unit);
    // Returns the text as one that no line of the screen breaks: "2 h 47 min".
    [[nodiscard]] static QString unbroken(QString text);

    // Returns how many decimals, at least `decimals`, two numbers of one sentence need: different ones read
    // differently, and none reads as zero that is not.
    [[nodiscard]] static int decimalsToTell(double first, double second, int decimals);
    [[nodiscard]] const QLocale& locale() const { return m_locale; }

    // Formats local time as 2026-11-22 07:38, and with seconds. In the hour that the end of summer time
    // repeats the zone follows.
    static QString minute(const QDateTime& moment);
    static QString second(const QDateTime& moment);
    // Formats in this form of Qt, with the zone as above.
    static QString local(const QDateTime& moment, const QString& form);

    // Formats an offset of the local time: UTC+01:00.
    static QString utcOffset(int minutes);

    // Formats with at least this many digits: 00FF, and with the prefix: 0x00FF.
    static QString hexDigits(quint64 value, int digits);
    static QString hex(quint64 value, int digits) { return QStringLiteral("0x") + hexDigits(value, digits); }

    static QString unknownText() { return QStringLiteral("--"); }

private:
    QLocale m_locale;
};

} // namespace campanel::panel
