// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/setting_values.h"

#include "app/panel/settings/stop_forms.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

bool isWindowSize(QSize size)
{
    return size.width() >= 800 && size.width() <= 9999 && size.height() >= 480 && size.height() <= 9999;
}

// Returns true for the form of a code such as "de", "zh_CN" or "sr_Latn_RS".
bool isLanguageCode(const QString& text)
{
    static const QRegularExpression form(u"^[a-z]{2,3}(_[A-Z][a-z]{3})?(_[A-Z]{2}|_[0-9]{3})?$"_s);
    return form.match(text).hasMatch();
}

bool areRules(const QString& text)
{
    static const QRegularExpression form(u"^[A-Za-z0-9_.*]+=(true|false)$"_s);
    const QStringList rules = text.isEmpty() ? QStringList() : text.split(u'\n');
    return std::ranges::all_of(rules, [](const QString& rule) { return form.match(rule).hasMatch(); });
}

bool isTopicName(const QString& text)
{
    constexpr qsizetype maxLength = 64;
    return text.size() <= maxLength && text == text.trimmed() && std::ranges::none_of(text, [](QChar letter) {
               return !letter.isPrint() || letter == u'/' || letter == u'+' || letter == u'#';
           });
}

// Returns true for a name of DNS, also a local one with _ or with other letters, or an address: at most 253
// bytes, and 63 between two points.
bool isHost(const QString& text)
{
    constexpr qsizetype maxLength = 253;
    static const QRegularExpression form(
        u"^([\\p{L}\\p{N}_]([\\p{L}\\p{N}\\p{M}_-]{0,61}[\\p{L}\\p{N}\\p{M}_])?\\.)*"
        "[\\p{L}\\p{N}_]([\\p{L}\\p{N}\\p{M}_-]{0,61}[\\p{L}\\p{N}\\p{M}_])?\\.?$"_s,
        QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression address(u"^[0-9a-fA-F:]*:[0-9a-fA-F:.]*(%[A-Za-z0-9._-]+)?$"_s);
    return text.isEmpty() || (text.toUtf8().size() <= maxLength &&
                              (form.match(text).hasMatch() || address.match(text).hasMatch()));
}

bool isPrintable(const QString& text, qsizetype maxLength)
{
    const QList<uint> characters = text.toUcs4();
    return characters.size() <= maxLength && text == text.trimmed() &&
           std::ranges::all_of(characters, [](uint character) { return QChar::isPrint(character); });
}

bool isPrefix(const QString& text)
{
    constexpr qsizetype maxLength = 8;
    return text.size() <= maxLength &&
           std::ranges::all_of(text, [](QChar letter) { return letter > u' ' && letter <= u'~'; });
}

// Returns the number of the text; NaN when it is none of the setting's form.
double numberIn(Setting setting, const QString& text)
{
    bool isNumber = false;
    const double number =
        setting->form == SettingForm::Whole ? text.toInt(&isNumber) : text.toDouble(&isNumber);
    return isNumber ? number : std::nan("");
}

} // namespace

QString keyOf(Setting setting)
{
    return latin(setting->key);
}

QString shortKeyOf(Setting setting)
{
    return keyOf(setting).section(u'/', -1);
}

QString settingText(bool value)
{
    return value ? u"true"_s : u"false"_s;
}

QString settingText(int value)
{
    return QString::number(value);
}

QString settingText(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QSize sizeIn(const QString& text)
{
    static const QRegularExpression form(u"^(\\d{3,5})x(\\d{3,5})$"_s);
    const auto match = form.match(text);
    return match.hasMatch() ? QSize(match.captured(1).toInt(), match.captured(2).toInt()) : QSize();
}

QStringList choicesOf(Setting setting)
{
    return latin(setting->choices).split(u' ');
}

QList<int> numbersOf(Setting setting)
{
    QList<int> numbers;
    for (const QString& choice : choicesOf(setting))
        numbers << choice.toInt();
    return numbers;
}

QString validValues(Setting setting)
{
    switch (setting->form) {
    case SettingForm::Truth:
        return u"true or false"_s;
    case SettingForm::Word:
        return u"one of \"%1\""_s.arg(choicesOf(setting).join(u"\", \""_s));
    case SettingForm::Language:
        return u"the code of an installed language, such as \"zh_CN\""_s;
    case SettingForm::Choice:
        return u"one of "_s + choicesOf(setting).join(u", "_s);
    case SettingForm::Whole:
        return u"a whole number from %1 to %2"_s.arg(setting->minimum).arg(setting->maximum);
    case SettingForm::Decimal:
        return u"a number from %1 to %2"_s.arg(setting->minimum).arg(setting->maximum);
    case SettingForm::Port:
        return u"the path of a serial port, such as \"/dev/campanel-serial\""_s;
    case SettingForm::File:
        return u"the path of a file, such as \"/etc/campanel/broker.pem\""_s;
    case SettingForm::Title:
        return u"up to 64 printable characters"_s;
    case SettingForm::Name:
        return u"up to 64 letters, without / + #"_s;
    case SettingForm::Host:
        return u"the name or address of a computer, such as \"broker.example\""_s;
    case SettingForm::User:
        return u"up to 256 printable characters"_s;
    case SettingForm::Prefix:
        return u"up to 8 printable characters of ASCII without spaces"_s;
    case SettingForm::Size:
        return u"from \"800x480\" to \"9999x9999\""_s;
    case SettingForm::Times:
        return u"from one to six quarters of an hour in their order, such as \"06:00 14:00 22:00\""_s;
    case SettingForm::Days:
        return u"days in their order, such as \"12345\" for Monday to Friday"_s;
    case SettingForm::Reasons:
        return u"a list such as [\"material\", \"material/Film change\", \"planned:Break\"]"_s;
    case SettingForm::Rules:
        break;
    }
    return u"a list of rules such as [\"campanel.link.debug=true\"]"_s;
}

bool isValid(Setting setting, const QString& text)
{
    switch (setting->form) {
    case SettingForm::Truth:
        return text == settingText(true) || text == settingText(false);
    case SettingForm::Word:
    case SettingForm::Choice:
        return choicesOf(setting).contains(text);
    case SettingForm::Whole:
    case SettingForm::Decimal: {
        const double number = numberIn(setting, text);
        return number >= setting->minimum && number <= setting->maximum;
    }
    case SettingForm::Language:
        return isLanguageCode(text);
    case SettingForm::Port:
    case SettingForm::File:
        return text.isEmpty() || text.startsWith(u'/');
    case SettingForm::Title:
        return isPrintable(text, 64);
    case SettingForm::Name:
        return isTopicName(text);
    case SettingForm::Host:
        return isHost(text);
    case SettingForm::User:
        return isPrintable(text, 256);
    case SettingForm::Prefix:
        return isPrefix(text);
    case SettingForm::Size:
        return isWindowSize(sizeIn(text));
    case SettingForm::Times:
        return !shiftStartsIn(text).isEmpty();
    case SettingForm::Days:
        return !workingDaysIn(text).isEmpty();
    case SettingForm::Reasons:
        return !stopReasonsIn(text).isEmpty();
    case SettingForm::Rules:
        break;
    }
    return areRules(text);
}

SettingValues::SettingValues(std::initializer_list<SettingValue> values)
{
    for (const auto& [setting, text] : values)
        m_texts.insert(setting->name, text);
}

QString SettingValues::text(Setting setting) const
{
    return m_texts.value(setting->name, latin(setting->standard));
}

bool SettingValues::isTrue(Setting setting) const
{
    return text(setting) == settingText(true);
}

int SettingValues::whole(Setting setting) const
{
    return text(setting).toInt();
}

double SettingValues::number(Setting setting) const
{
    return text(setting).toDouble();
}

QString SettingValues::nearest(Setting setting, const QString& text) const
{
    if (isValid(setting, text))
        return text;
    const double number = setting->maximum > setting->minimum ? numberIn(setting, text) : std::nan("");
    return std::isnan(number) ? this->text(setting)
                              : settingText(std::clamp(number, setting->minimum, setting->maximum));
}

bool SettingValues::set(Setting setting, const QString& text)
{
    const QString value = nearest(setting, text);
    const bool isNew = value != this->text(setting);
    m_texts.insert(setting->name, value);
    return isNew;
}

} // namespace campanel::panel
