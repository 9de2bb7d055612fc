// SPDX-License-Identifier: Apache-2.0
// The number being typed: digits, one decimal point of the language, a sign. Reports if it is complete, and
// its value.
#pragma once

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace campanel::controls {

class NumberEntry : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QString locale READ locale WRITE setLocale NOTIFY changed FINAL)
    Q_PROPERTY(int decimals READ decimals WRITE setDecimals NOTIFY changed FINAL)
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(QString decimalPoint READ decimalPoint NOTIFY changed FINAL)
    Q_PROPERTY(bool empty READ isEmpty NOTIFY changed FINAL)
    Q_PROPERTY(bool complete READ isComplete NOTIFY changed FINAL)
    // True when a whole number got a decimal point; it is not complete until the point is deleted.
    Q_PROPERTY(bool unwantedFraction READ hasUnwantedFraction NOTIFY changed FINAL)
    Q_PROPERTY(double value READ value NOTIFY changed FINAL) // NaN while it is not a number

public:
    using QObject::QObject;

    [[nodiscard]] QString locale() const { return m_locale; }
    void setLocale(const QString& name);
    [[nodiscard]] int decimals() const { return m_decimals; }
    void setDecimals(int decimals);
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString decimalPoint() const;
    [[nodiscard]] bool isEmpty() const { return m_typed.isEmpty(); }
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] bool hasUnwantedFraction() const;
    [[nodiscard]] double value() const;

    // Handles one key: a digit, the decimal point (of the language, '.' or ','), a minus sign (toggles).
    // Ignores keys that do not fit.
    Q_INVOKABLE void type(const QString& key);
    // Returns true when more digits, or a minus sign, can bring the number between the limits.
    [[nodiscard]] Q_INVOKABLE bool canBecome(double minimum, double maximum) const;
    Q_INVOKABLE void backspace();
    Q_INVOKABLE void clear();
    Q_INVOKABLE void setValue(double value);

signals:
    void changed();

private:
    static constexpr int maximumDigits = 9;

    void typeCharacter(QChar key);
    void toggleSign();

    QString m_typed; // C notation: '-', digits, '.'
    QString m_locale = QStringLiteral("en");
    int m_decimals = 0;
};

} // namespace campanel::controls
