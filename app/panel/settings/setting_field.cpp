// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/setting_field.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "app/panel/settings/settings.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

bool isWhole(Setting setting)
{
    return setting->form == SettingForm::Whole || setting->form == SettingForm::Choice;
}

bool isNumber(Setting setting)
{
    return isWhole(setting) || setting->form == SettingForm::Decimal;
}

QVariant keyIn(Setting setting, const QString& text)
{
    return setting->form == SettingForm::Truth ? QVariant(text == settingText(true))
           : isWhole(setting)                  ? QVariant(text.toInt())
           : isNumber(setting)                 ? QVariant(text.toDouble())
                                               : QVariant(text);
}

QString unitOf(Setting setting)
{
    return setting->unit ? Settings::tr(setting->unit) : QString();
}

QString numberText(Setting setting, const QString& text)
{
    return isNumber(setting) ? Format().amount(text.toDouble(), setting->decimals, unitOf(setting)) : text;
}

// Returns the values among which a person chooses, in their order.
QStringList valuesOf(Setting setting, const QList<Language>& languages)
{
    switch (setting->form) {
    case SettingForm::Truth:
        return {settingText(false), settingText(true)};
    case SettingForm::Word:
    case SettingForm::Choice:
        return choicesOf(setting);
    case SettingForm::Language:
        return languageCodes(languages);
    default:
        return {};
    }
}

QString valueText(Setting setting, const QString& text, const QList<Language>& languages)
{
    const auto language = std::ranges::find(languages, text, &Language::code);
    if (setting->form == SettingForm::Language && language != languages.end())
        return language->name;
    const qsizetype place =
        isNumber(setting) && text.toDouble() == 0 ? 0 : valuesOf(setting, languages).indexOf(text);
    const bool hasWord = place >= 0 && place < static_cast<qsizetype>(setting->words.size());
    if (const char* word = hasWord ? setting->words[static_cast<std::size_t>(place)].text : nullptr)
        return Settings::tr(word);
    if (setting->form == SettingForm::Truth)
        return text == settingText(true) ? Settings::tr("On") : Settings::tr("Off");
    const QString number = Format::joined(numberText(setting, text), Units::of(unitOf(setting)).unit);
    return setting->shown ? Settings::tr(setting->shown).arg(number) : number;
}

QVariantList choicesWithTexts(Setting setting, const QList<Language>& languages)
{
    QVariantList choices;
    for (const QString& value : valuesOf(setting, languages)) {
        QVariantMap choice{{u"key"_s, keyIn(setting, value)},
                           {u"text"_s, valueText(setting, value, languages)}};
        const auto place = static_cast<std::size_t>(choices.size());
        if (place < setting->words.size() && setting->words[place].note)
            choice.insert(u"note"_s, Settings::tr(setting->words[place].note));
        choices << choice;
    }
    return choices;
}

} // namespace

SettingView viewOf(Setting setting, const QString& text, const SettingValues& standard,
                   const QList<Language>& languages)
{
    const char* label = setting->title ? setting->title : setting->label;
    return {{label ? Settings::tr(label) : QString(), unitOf(setting), numberText(setting, text),
             setting->minimum, setting->maximum, standard.number(setting), setting->decimals,
             isNumber(setting) ? text.toDouble() : std::numeric_limits<double>::quiet_NaN()},
            keyIn(setting, text),
            valueText(setting, text, languages),
            choicesWithTexts(setting, languages)};
}

SettingField::SettingField(Setting setting, QObject* parent)
    : Value(parent)
    , m_setting(setting)
{
    setNeededLevel(setting->level);
    connect(this, &Value::setRequested, this, [this](double number) {
        emit chosen(isWhole(m_setting) ? settingText(static_cast<int>(std::lround(number)))
                                       : settingText(number));
    });
}

QString SettingField::problem(const QString& text) const
{
    return isValid(m_setting, text.trimmed())
               ? QString()
               : Settings::tr("This text is not possible. Enter up to 64 visible characters.");
}

void SettingField::enter(const QString& text)
{
    if (problem(text).isEmpty())
        emit chosen(text.trimmed());
}

void SettingField::chooseNext()
{
    const auto isPresent = [this](const QVariant& choice) { return choice.toMap()[u"key"_s] == m_view.key; };
    const auto present = std::ranges::find_if(m_view.choices, isPresent);
    if (present == m_view.choices.end())
        return;
    const auto next = present + 1 == m_view.choices.end() ? m_view.choices.begin() : present + 1;
    choose(next->toMap()[u"key"_s].toString());
}

void SettingField::show(const SettingView& view)
{
    if (m_view == view)
        return;
    m_view = view;
    if (!Value::show(view))
        emit changed();
}

} // namespace campanel::panel
