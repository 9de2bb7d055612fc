// SPDX-License-Identifier: Apache-2.0
#include "app/shell/card.h"

#include "app/shell/configuration.h"

#include "app/store/files/files.h"
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/recipe_keys.h"
#include "app/store/recipes/signed_recipe.h"

#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace Qt::StringLiterals;

namespace campanel::shell {
namespace {

// The rule of the image's shell scripts: names need no quotes and are no options.
bool isPlainName(const QString& name)
{
    static const QRegularExpression plain(u"^[A-Za-z0-9_][A-Za-z0-9._ -]{0,99}$"_s);
    return plain.match(name).hasMatch();
}

QString configurationError(const QByteArray& text)
{
    const ReadConfiguration read = configurationFrom(text, u"campanel.toml"_s);
    if (!read.complaints.isEmpty())
        return read.complaints.join(u' ');
    const bool isNamed = read.values.isTrue("connection.simulated")
                             ? text.contains("simulated")
                             : !read.values.text("connection.port").isEmpty();
    return isNamed ? QString()
                   : u"It names no controller. Below [connection], write port = \"/dev/campanel-serial\", or "
                     "simulated = true."_s;
}

// RFC 1123, a label.
QString hostnameError(const QByteArray& text)
{
    static const QRegularExpression label(u"^[a-z0-9]([a-z0-9-]{0,61}[a-z0-9])?$"_s);
    return label.match(QString::fromUtf8(text).trimmed()).hasMatch()
               ? QString()
               : u"A name of the computer is one line of 1 to 63 small letters, digits and hyphens."_s;
}

QString errorOf(const QDir& folder, const QString& name)
{
    const QString place = name.section(u'/', 0, -2);
    if (!isPlainName(QFileInfo(name).fileName()))
        return u"A name of a file has letters of English, digits, spaces, dots, hyphens and underscores, at "
               "most 100. Rename it."_s;
    const bool isJson = name.endsWith(u".json", Qt::CaseInsensitive);
    const bool isRecipe = place == u"recipes" && isJson;
    const bool isKey = (place == u"recipe-keys" || place == u"package-keys") && isJson;
    if (!isRecipe && !isKey && name != u"campanel.toml" && name != u"hostname")
        return u"Nothing takes this file. There are campanel.toml, hostname, and files .json in recipes, "
               "recipe-keys and package-keys."_s;
    const auto text = store::readBytes(folder.filePath(name));
    if (!text)
        return store::FileErrorText::describe(text.error());
    if (isKey) {
        const auto key = store::publicKeyIn(*text);
        return key ? QString() : u"It is no public key: %1."_s.arg(key.error());
    }
    if (isRecipe) {
        const auto recipe = store::fromJson(*text, name);
        // The panel checks a signed one with its keys.
        return recipe || store::isSignedRecipe(*text) ? QString()
                                                      : store::FileErrorText::describe(recipe.error());
    }
    return name == u"hostname" ? hostnameError(*text) : configurationError(*text);
}

} // namespace

QList<CardFile> checkCard(const QString& folder)
{
    QStringList names;
    QDirIterator files(folder, QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        files.next();
        // Those of other computers' file managers.
        if (!files.fileName().startsWith(u'.') && files.fileName() != u"Thumbs.db" &&
            files.fileName() != u"desktop.ini")
            names << QDir(folder).relativeFilePath(files.filePath());
    }
    std::ranges::sort(names);
    QList<CardFile> checked;
    for (const QString& name : std::as_const(names))
        checked << CardFile{name, errorOf(QDir(folder), name)};
    return checked;
}

int printCard(const QString& folder)
{
    bool isGood = true;
    for (const CardFile& file : checkCard(folder)) {
        isGood = isGood && file.error.isEmpty();
        std::printf("%s\t%s\n", qPrintable(file.name.simplified()),
                    file.error.isEmpty() ? "ok" : qPrintable(file.error.simplified()));
    }
    return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace campanel::shell
