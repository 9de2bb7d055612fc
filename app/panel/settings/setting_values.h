// SPDX-License-Identifier: Apache-2.0
// Values of settings, as texts in the form of the settings file, and the checks of that form.
#pragma once

#include "app/panel/settings/setting_table.h"

#include <QMap>
#include <QSize>
#include <QString>
#include <QStringList>

#include <initializer_list>
#include <string_view>

namespace campanel::panel {

// Return the key in the settings file, and its last part, by which labels and audit trail name the setting.
[[nodiscard]] QString keyOf(Setting setting);
[[nodiscard]] QString shortKeyOf(Setting setting);
// Return a value as the settings file has it.
[[nodiscard]] QString settingText(bool value);
[[nodiscard]] QString settingText(int value);
[[nodiscard]] QString settingText(double value);

// Returns the size of a text such as "1024x600"; an empty one for another text.
[[nodiscard]] QSize sizeIn(const QString& text);
// Return the choices of a setting.
[[nodiscard]] QStringList choicesOf(Setting setting);
[[nodiscard]] QList<int> numbersOf(Setting setting);
// Returns the valid values for a person: "one of en, zh_CN".
[[nodiscard]] QString validValues(Setting setting);
// Returns true when the text is a valid value.
[[nodiscard]] bool isValid(Setting setting, const QString& text);

struct SettingValue {
    Setting setting;
    QString text;
};

class SettingValues {
public:
    SettingValues() = default;
    // Takes values that have been checked.
    SettingValues(std::initializer_list<SettingValue> values);

    // Return the value, or the default.
    [[nodiscard]] QString text(Setting setting) const;
    [[nodiscard]] bool isTrue(Setting setting) const;
    [[nodiscard]] int whole(Setting setting) const;
    [[nodiscard]] double number(Setting setting) const;

    // Returns what set() would store: a number outside its range moves to the limit, another invalid text to
    // the present value.
    [[nodiscard]] QString nearest(Setting setting, const QString& text) const;
    // Returns true when the value has changed.
    bool set(Setting setting, const QString& text);
    // Replaces the values that the other ones have.
    void assign(const SettingValues& others) { m_texts.insert(others.m_texts); }

private:
    QMap<std::string_view, QString> m_texts; // by name
};

} // namespace campanel::panel
