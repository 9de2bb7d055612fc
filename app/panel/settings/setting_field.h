// SPDX-License-Identifier: Apache-2.0
// One setting as a person reads and changes it, by its row of the table. Settings owns it and alone updates
// it.
#pragma once

#include "app/panel/kit/value.h"
#include "app/panel/settings/languages.h"
#include "app/panel/settings/setting_values.h"

#include <QVariant>

namespace campanel::panel {

struct SettingView : ValueView {
    QVariant key;         // the value: true or false, a number or a text
    QString shown;        // the same as a tile shows it
    QVariantList choices; // {key, text, note} each; empty: a number or a text is entered

    bool operator==(const SettingView&) const = default;
};

// Returns what is shown of a setting with this value; `standard` has the defaults.
[[nodiscard]] SettingView viewOf(Setting setting, const QString& text, const SettingValues& standard,
                                 const QList<Language>& languages);

class SettingField : public campanel::panel::Value {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Fields belong to Settings")

    Q_PROPERTY(QVariant key READ key NOTIFY changed FINAL)
    Q_PROPERTY(QString shown READ shown NOTIFY changed FINAL)
    Q_PROPERTY(QVariantList choices READ choices NOTIFY changed FINAL)
    // True: it is entered with the keyboard.
    Q_PROPERTY(bool isText READ isText CONSTANT FINAL)

public:
    SettingField(Setting setting, QObject* parent);

    [[nodiscard]] Setting setting() const { return m_setting; }
    [[nodiscard]] QVariant key() const { return m_view.key; }
    [[nodiscard]] QString shown() const { return m_view.shown; }
    [[nodiscard]] QVariantList choices() const { return m_view.choices; }
    [[nodiscard]] bool isText() const { return m_setting->form == SettingForm::Title; }

    // Returns why this text cannot be the value, empty when it can; requests it without the spaces at its
    // ends.
    Q_INVOKABLE QString problem(const QString& text) const;
    Q_INVOKABLE void enter(const QString& text);
    // Requests the value with the key of a choice.
    Q_INVOKABLE void choose(const QString& key) { emit chosen(key); }

    // Requests the choice after the present one, the first one after the last.
    Q_INVOKABLE void chooseNext();

    // Updates the field; called by Settings.
    void show(const SettingView& view);

signals:
    void chosen(const QString& text); // as the settings file has it

private:
    Setting m_setting;
    SettingView m_view;
};

} // namespace campanel::panel
