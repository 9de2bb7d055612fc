// SPDX-License-Identifier: Apache-2.0
// The envelope of the recipe format. Reading stops at the first error, with the key and the expected value.
#include "app/store/recipes/recipe_json.h"

#include "app/program/cam_advance.h"
#include "app/program/recipe_master.h"
#include "app/store/database/names.h"
#include "app/store/files/json_keys.h"
#include "app/store/files/json_reader.h"
#include "app/store/recipes/program_json.h"

#include <QJsonDocument>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {
namespace {

using program::Recipe;

const QString recipeFormat = u"campanel-recipe"_s;

// Returns the first version of the format that has all keys of the recipe, so that older readers know whether
// they can read it. The confirmed advance is new in version 3, the master in version 4, trims in version 5,
// windows in version 6.
int formatVersionOf(const Recipe& recipe)
{
    if (!recipe.windows.empty())
        return recipeFormatVersion;
    if (recipe.trims != program::Trims{})
        return 5;
    if (recipe.master != program::RecipeMaster::Any)
        return 4;
    return program::confirmedAdvanceMm(recipe.program) == 0 ? 2 : 3;
}

std::optional<FileError> wrongFormat(const QJsonObject& root)
{
    if (root.value(u"format"_s).toString() != recipeFormat)
        return FileError{FileError::Kind::NotARecipe, {}, u"format"_s, {}, recipeFormat, 0};
    const int version = root.value(u"format_version"_s).toInt(0);
    if (version < 1)
        return FileError{FileError::Kind::WrongType,    {}, u"format_version"_s, {},
                         FileErrorText::aWholeNumber(), 0};
    if (version > recipeFormatVersion)
        return FileError{
            FileError::Kind::NewerVersion,        {}, u"format_version"_s, QString::number(version),
            QString::number(recipeFormatVersion), 0};
    return std::nullopt;
}

// Reads a code that a scanner reads; absent: none.
std::string codeIn(ObjectReader& reader, const QString& key)
{
    if (!reader.has(key))
        return {};
    const QString code = reader.text(key);
    const std::string bytes = code.toStdString();
    if (bytes.size() > program::maxCodeBytes)
        reader.fail(key, FileError::Kind::TooLong, code, QString::number(program::maxCodeBytes));
    if (!isScannable(code))
        reader.fail(key, FileError::Kind::WrongType, {}, FileErrorText::aText());
    return bytes;
}

// Reads the master that the machine must follow; absent: any.
program::RecipeMaster masterIn(ObjectReader& reader, const QString& key)
{
    if (!reader.has(key))
        return program::RecipeMaster::Any;
    const QString text = reader.text(key);
    const auto master = program::masterByKey(text.toStdString());
    if (!master) {
        QStringList keys;
        for (const std::string_view each : program::masterKeys)
            keys << toQString(each);
        reader.fail(key, FileError::Kind::NotAChoice, text, keys.join(u", "_s));
    }
    return master.value_or(program::RecipeMaster::Any);
}

QJsonObject trimsJson(const program::Trims& trims)
{
    QJsonObject object;
    for (std::size_t i = 0; i < trims.size(); ++i) {
        if (trims[i] != 0)
            object[toQString(program::trimTable[i].key)] = trims[i];
    }
    return object;
}

// Reads what an operator saved; what is absent is 0.
program::Trims trimsIn(const QJsonObject& object, std::optional<FileError>& failure)
{
    program::Trims trims{};
    ObjectReader reader(object, u"trims."_s, failure);
    for (std::size_t i = 0; i < trims.size(); ++i) {
        const QString key = toQString(program::trimTable[i].key);
        profile::FieldInfo limits;
        limits.max = program::maxTrimMm(static_cast<program::Trim>(i));
        limits.min = -limits.max;
        limits.unit = "mm";
        if (reader.has(key))
            trims[i] = reader.number(key, false, limits);
    }
    reader.refuseUnknownKeys();
    return trims;
}

QJsonObject windowsJson(const program::ApprovedWindows& windows)
{
    QJsonObject object;
    for (const auto& [field, window] : windows)
        object[idOf(field)] = QJsonObject{{u"min"_s, window.min}, {u"max"_s, window.max}};
    return object;
}

// Reads the windows of the recipe's inputs; the limits of an input are those of its window.
program::ApprovedWindows windowsIn(const QJsonObject& object, const Recipe& recipe,
                                   std::optional<FileError>& failure)
{
    program::ApprovedWindows windows;
    ObjectReader reader(object, u"windows."_s, failure);
    for (const profile::FieldInfo& info : profile::fields) {
        const QString id = idOf(info.field);
        if (!program::canHaveWindow(recipe, info.field) || !reader.has(id))
            continue;
        ObjectReader limits(reader.object(id), u"windows.%1."_s.arg(id), failure);
        program::ApprovedWindow window;
        window.min = limits.number(u"min"_s, false, info);
        window.max = limits.number(u"max"_s, false, info);
        if (window.min > window.max)
            limits.fail(u"max"_s, FileError::Kind::OutOfRange, QString::number(window.max, 'g', 9),
                        FileErrorText::range(window.min, info.max, toQString(info.unit)));
        limits.refuseUnknownKeys();
        windows[info.field] = window;
    }
    reader.refuseUnknownKeys();
    return windows;
}

QString nameIn(ObjectReader& reader, Names names)
{
    const QString text = reader.text(u"name"_s);
    const QString name = keptName(text);
    if (names == Names::Repair)
        return name.isEmpty() ? u"?"_s : name;
    if (const auto hidden = hiddenCharacter(text))
        reader.fail(u"name"_s, FileError::Kind::HiddenCharacter,
                    u"U+%1"_s.arg(QString::number(*hidden, 16).toUpper().rightJustified(4, u'0')), {});
    if (name.isEmpty())
        reader.fail(u"name"_s, FileError::Kind::WrongType, {}, FileErrorText::aVisibleText());
    return name;
}

} // namespace

bool isScannable(const QString& code)
{
    const auto letters = code.toUcs4();
    return code == code.trimmed() && std::ranges::all_of(letters, [](char32_t letter) {
               return QChar::isPrint(letter) && letter != QChar::ReplacementCharacter;
           });
}

QByteArray toJson(const Recipe& recipe)
{
    QJsonObject root{{u"format"_s, recipeFormat},
                     {u"format_version"_s, formatVersionOf(recipe)},
                     {u"name"_s, QString::fromStdString(recipe.name)},
                     {u"version"_s, recipe.version},
                     {u"program"_s, programJson(recipe)},
                     {u"machine"_s, machineJson(recipe)}};
    if (!recipe.scanCode.empty())
        root[u"scan_code"_s] = QString::fromStdString(recipe.scanCode);
    if (!recipe.filmCode.empty())
        root[u"film_code"_s] = QString::fromStdString(recipe.filmCode);
    if (recipe.master != program::RecipeMaster::Any)
        root[u"master"_s] = toQString(program::masterKeys[static_cast<std::size_t>(recipe.master)]);
    if (recipe.trims != program::Trims{})
        root[u"trims"_s] = trimsJson(recipe.trims);
    if (!recipe.windows.empty())
        root[u"windows"_s] = windowsJson(recipe.windows);
    return QJsonDocument(root).toJson();
}

tl::expected<Recipe, FileError> fromJson(const QByteArray& json, const QString& path, Names names)
{
    const auto refuse = [&path](FileError error) {
        error.path = path;
        return tl::unexpected(error);
    };
    QJsonParseError parseError;
    const QJsonDocument document = QJsonDocument::fromJson(json, &parseError);
    if (parseError.error != QJsonParseError::NoError)
        return refuse({FileError::Kind::NotJson, {}, {}, parseError.errorString(), {}, parseError.offset});
    const QJsonObject root = document.object();
    if (const auto key = repeatedKey(json))
        return refuse({FileError::Kind::RepeatedKey, {}, *key, {}, {}, 0});
    if (const auto wrong = wrongFormat(root))
        return refuse(*wrong);

    Recipe recipe;
    std::optional<FileError> failure;
    ObjectReader reader(root, {}, failure);
    reader.take(u"format"_s);
    reader.take(u"format_version"_s);
    const QString name = nameIn(reader, names);
    recipe.name = name.toStdString();
    if (recipe.name.size() > program::longestNameBytes)
        reader.fail(u"name"_s, FileError::Kind::TooLong, name, QString::number(program::longestNameBytes));
    profile::FieldInfo versions;
    versions.min = 1;
    versions.max = program::maxVersion;
    if (reader.has(u"version"_s))
        recipe.version = static_cast<int>(reader.number(u"version"_s, true, versions));
    recipe.scanCode = codeIn(reader, u"scan_code"_s);
    recipe.filmCode = codeIn(reader, u"film_code"_s);
    recipe.master = masterIn(reader, u"master"_s);
    const QJsonObject program = reader.object(u"program"_s);
    readProgram(program, recipe, failure);
    if (reader.has(u"machine"_s))
        readMachine(reader.object(u"machine"_s), recipe, failure);
    if (reader.has(u"trims"_s))
        recipe.trims = trimsIn(reader.object(u"trims"_s), failure);
    if (reader.has(u"windows"_s))
        recipe.windows = windowsIn(reader.object(u"windows"_s), recipe, failure);
    if (!program.contains(idOf(profile::Field::K1)) && !program.contains(idOf(profile::Field::K4)))
        program::followRatios(recipe);
    reader.refuseUnknownKeys();
    if (failure)
        return refuse(*failure);
    return recipe;
}

} // namespace campanel::store
