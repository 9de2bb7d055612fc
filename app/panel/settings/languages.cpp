// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/languages.h"

#include "app/panel/settings/setting_values.h"

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QLoggingCategory>
#include <QStandardPaths>
#include <QTranslator>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

Q_LOGGING_CATEGORY(languageLog, "campanel.ui")

constexpr const char* nameContext = "Language";
//: The name of the language in the language itself; without it the file is not used.
constexpr const char* sourceName = QT_TRANSLATE_NOOP("Language", "English");

// Returns the language of a file; without a code when the panel cannot use the file.
Language languageOf(const QFileInfo& file)
{
    const QString code = file.completeBaseName().section(u'_', 1);
    QTranslator texts;
    const QString name = texts.load(file.filePath()) ? texts.translate(nameContext, sourceName) : QString();
    if (!name.isEmpty() && isValid("display.language", code) && QLocale(code).language() != QLocale::C)
        return {code, name, file.filePath()};
    qCWarning(languageLog, "%s is not used: it is damaged or does not name its language",
              qPrintable(file.filePath()));
    return {};
}

const Language* find(const QList<Language>& languages, const QString& code)
{
    const auto found = std::ranges::find(languages, code, &Language::code);
    return found != languages.end() ? &*found : nullptr;
}

} // namespace

QStringList languageFolders()
{
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + u"/languages"_s,
            QCoreApplication::applicationDirPath() + u"/../share/campanel/languages"_s};
}

QList<Language> languagesIn(const QStringList& folders)
{
    QList<Language> languages{{u"en"_s, QString::fromLatin1(sourceName), {}}};
    for (const QString& folder : folders) {
        for (const QFileInfo& file : QDir(folder).entryInfoList({u"campanel_*.qm"_s}, QDir::Files)) {
            const Language language = languageOf(file);
            if (!language.code.isEmpty() && !find(languages, language.code))
                languages += language;
        }
    }
    std::sort(languages.begin() + 1, languages.end(),
              [](const Language& one, const Language& other) { return one.code < other.code; });
    return languages;
}

QStringList languageCodes(const QList<Language>& languages)
{
    QStringList codes;
    for (const Language& language : languages)
        codes += language.code;
    return codes;
}

QString nearestLanguage(const QList<Language>& languages, const QString& wanted)
{
    if (find(languages, wanted))
        return wanted;
    const auto sameLanguage = std::ranges::find_if(languages, [&wanted](const Language& language) {
        return QLocale(language.code).language() == QLocale(wanted).language();
    });
    return sameLanguage != languages.end() ? sameLanguage->code : languages.first().code;
}

bool loadLanguage(QTranslator& translator, const QList<Language>& languages, const QString& code)
{
    const Language* language = find(languages, code);
    return language && !language->file.isEmpty() && translator.load(language->file);
}

} // namespace campanel::panel
