// SPDX-License-Identifier: Apache-2.0
// The languages of the panel: English, which is in the sources, and one for each file campanel_<code>.qm in a
// folder of languages. A file names its language itself, so that no list of languages is in the sources.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

class QTranslator;

namespace campanel::panel {

struct Language {
    QString code; // of QLocale: "zh_CN"
    QString name; // in the language itself
    QString file; // empty: the language of the sources
};

// Returns the folders: "languages" in the panel's data, then the installed one beside the program.
[[nodiscard]] QStringList languageFolders();
// Returns English, then the languages of the folders by their codes. Of two files with one code, the one of
// the first folder is used. Skips a file that is damaged or does not name its language.
[[nodiscard]] QList<Language> languagesIn(const QStringList& folders);
[[nodiscard]] QStringList languageCodes(const QList<Language>& languages);
// Returns the code of the language that is used for the wanted one: itself, or one of the same language in
// another country, or "en".
[[nodiscard]] QString nearestLanguage(const QList<Language>& languages, const QString& wanted);
// Loads the texts. Returns false for a language without a file, whose texts are those of the sources.
[[nodiscard]] bool loadLanguage(QTranslator& translator, const QList<Language>& languages,
                                const QString& code);

} // namespace campanel::panel
