// SPDX-License-Identifier: Apache-2.0
// campanel-generate-configuration: writes campanel.toml with every key and its default, or the section of its
// man page that describes the keys, from the table of the settings.
#include "app/panel/settings/setting_values.h"

#include <QTextStream>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

using namespace Qt::StringLiterals;
using namespace campanel::panel;

// The maximum length of a line of campanel.toml.
constexpr qsizetype lineLength = 110;

constexpr const char* preface =
    R"(# SPDX-License-Identifier: Apache-2.0
# The settings of this CamPanel machine, for the kiosk and for a panel in a window; see campanel.toml(5).
#
# A value here holds until another one is set on the panel; an option of the command line has priority over both.
# Remove the '#' before a key to set it. The lines below show the defaults. The log names each invalid key or
# value with its line ("journalctl -u campanel-kiosk") and the panel ignores it. The panel reads this file when
# it starts.
)";

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

// Returns the default as TOML.
QString standardOf(Setting setting)
{
    const QString standard = SettingValues().text(setting);
    switch (setting->form) {
    case SettingForm::Language:
        return u"\"en\""_s; // on a system in English
    case SettingForm::Word:
    case SettingForm::Port:
    case SettingForm::File:
    case SettingForm::Title:
    case SettingForm::Name:
    case SettingForm::Host:
    case SettingForm::User:
    case SettingForm::Prefix:
    case SettingForm::Size:
    case SettingForm::Times:
    case SettingForm::Days:
        return u"\"%1\""_s.arg(standard);
    case SettingForm::Rules:
    case SettingForm::Reasons:
        return u"[]"_s;
    case SettingForm::Truth:
    case SettingForm::Choice:
    case SettingForm::Whole:
    case SettingForm::Decimal:
        break;
    }
    return standard;
}

QString sentencesOf(Setting setting)
{
    const QString valid = validValues(setting);
    return u"%1 Valid: %2."_s.arg(QString::fromUtf8(setting->help), valid);
}

// Calls `section` at the start of each section of the file and `key` for each key.
void forEachKey(auto section, auto key)
{
    QString last;
    for (const SettingRow& row : settingTable) {
        if (!row.help)
            continue;
        const QString name = latin(row.name);
        if (const QString present = name.section(u'.', 0, 0); present != last)
            section(last = present);
        key(name.section(u'.', 1), Setting(row));
    }
}

void writeComment(QTextStream& out, const QString& text)
{
    QString line = u"#"_s;
    for (const QString& word : text.split(u' ')) {
        if (line.size() + word.size() >= lineLength) {
            out << line << '\n';
            line = u"#"_s;
        }
        line += u' ' + word;
    }
    out << line << '\n';
}

void writeToml(QTextStream& out)
{
    out << preface;
    forEachKey([&out](const QString& section) { out << "\n[" << section << ']'; },
               [&out](const QString& key, Setting setting) {
                   out << '\n';
                   writeComment(out, sentencesOf(setting));
                   out << '#' << key << " = " << standardOf(setting) << '\n';
               });
}

QString forMan(QString text)
{
    return text.replace(u'-', u"\\-"_s).replace(u'"', u"\\(dq"_s);
}

void writeMan(QTextStream& out)
{
    QString end;
    forEachKey(
        [&out, &end](const QString& section) {
            out << end << ".Ss [" << section << "]\n.Bl -tag -width Ds\n";
            end = u".El\n"_s;
        },
        [&out](const QString& key, Setting setting) {
            out << ".It Cm " << key << '\n'
                << forMan(sentencesOf(setting)).replace(u". "_s, u".\n"_s)
                << "\nDefault: " << forMan(standardOf(setting)) << ".\n";
        });
    out << end;
}

} // namespace

int main(int argc, char* argv[])
{
    const std::string_view form = argc == 2 ? argv[1] : "";
    QTextStream out(stdout);
    if (form == "--toml")
        writeToml(out);
    else if (form == "--man")
        writeMan(out);
    else {
        std::fputs("usage: campanel-generate-configuration --toml | --man\n", stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
