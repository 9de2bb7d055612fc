// SPDX-License-Identifier: Apache-2.0
// Reading stops at the first thing that is wrong, with the key and what was expected.
#include "app/store/recipe_json.h"

#include "profile/laws.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

using namespace Qt::StringLiterals;

namespace campanel::store {
namespace {

using profile::Field;
using program::Recipe;

const QString formatName = u"campanel-recipe"_s;
const QString kindName = u"rotary_cutter"_s;

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString idOf(Field field)
{
    return toQString(profile::info(field).id);
}

// Counts; the other fields without decimals are measures that a person enters as whole numbers.
bool isWhole(Field field)
{
    constexpr std::array counts{Field::SlicesPerRamp, Field::Knives, Field::PulsesPerMotorRev,
                                Field::GearNumerator, Field::GearDenominator};
    return std::ranges::find(counts, field) != counts.end();
}

bool isPinnable(Field field)
{
    return std::ranges::find(program::pinnableFields, field) != program::pinnableFields.end();
}

// One object of the file; remembers which keys were asked for and the first thing that was wrong.
class ObjectReader {
public:
    ObjectReader(const QJsonObject& object, QString prefix, std::optional<FileError>& failure)
        : m_object(object)
        , m_prefix(std::move(prefix))
        , m_failure(failure)
    {
    }

    QJsonValue take(const QString& key)
    {
        m_asked.insert(key);
        return m_object.value(key);
    }

    bool has(const QString& key) { return !take(key).isNull() && !take(key).isUndefined(); }

    QJsonObject object(const QString& key)
    {
        const QJsonValue found = take(key);
        if (!found.isObject())
            fail(key, found.isUndefined() ? FileError::Kind::MissingKey : FileError::Kind::WrongType, {},
                 FileErrorText::anObject());
        return found.toObject();
    }

    QString text(const QString& key)
    {
        const QJsonValue found = take(key);
        if (!found.isString())
            fail(key, found.isUndefined() ? FileError::Kind::MissingKey : FileError::Kind::WrongType, {},
                 FileErrorText::aText());
        return found.toString();
    }

    double number(const QString& key, bool whole, const profile::FieldInfo& limits)
    {
        const QJsonValue found = take(key);
        const double value = found.toDouble();
        if (found.isUndefined() || found.isNull())
            fail(key, FileError::Kind::MissingKey, {}, {});
        else if (!found.isDouble())
            fail(key, FileError::Kind::WrongType, {},
                 whole ? FileErrorText::aWholeNumber() : FileErrorText::aNumber());
        else if (!(value >= limits.min && value <= limits.max))
            fail(key, FileError::Kind::OutOfRange, QString::number(value, 'g', 9),
                 FileErrorText::range(limits.min, limits.max, toQString(limits.unit)));
        else if (whole && value != std::floor(value))
            fail(key, FileError::Kind::WrongType, {}, FileErrorText::aWholeNumber());
        return value;
    }

    void refuseUnknownKeys()
    {
        for (const QString& key : m_object.keys()) {
            if (!m_asked.contains(key))
                fail(key, FileError::Kind::UnknownKey, {}, {});
        }
    }

    void fail(const QString& key, FileError::Kind kind, const QString& found, const QString& expected)
    {
        if (!m_failure)
            m_failure = FileError{kind, {}, m_prefix + key, found, expected, 0};
    }

private:
    QJsonObject m_object;
    QString m_prefix;
    QSet<QString> m_asked;
    std::optional<FileError>& m_failure;
};

void readPinned(ObjectReader& reader, Recipe& recipe)
{
    const QJsonArray pinned = reader.take(u"pinned"_s).toArray();
    std::vector<Field> fields;
    for (const QJsonValue& key : pinned) {
        const auto field = profile::fieldById(key.toString().toStdString());
        if (field && isPinnable(*field) && std::ranges::find(fields, *field) == fields.end())
            fields.push_back(*field);
    }
    if (pinned.size() != 2 || fields.size() != 2)
        reader.fail(u"pinned"_s, FileError::Kind::WrongType, {}, FileErrorText::twoPinnedKeys());
    else
        recipe.program.pinned = {fields[0], fields[1]};
}

void readLaw(ObjectReader& reader, Recipe& recipe, std::optional<FileError>& failure)
{
    const QString key = reader.text(u"speed_law"_s);
    const profile::Law* law = profile::findLaw(key.toStdString());
    if (law == nullptr || !law->isSpeedLaw) {
        QStringList choices;
        for (const profile::Law& each : profile::laws()) {
            if (each.isSpeedLaw)
                choices << toQString(each.key);
        }
        reader.fail(u"speed_law"_s, FileError::Kind::NotAChoice, key, choices.join(u", "_s));
        return;
    }
    recipe.program.speedLaw = law->id;
    recipe.program.speedLawParameters = profile::defaultParameters(*law);
    if (!reader.has(u"speed_law_parameters"_s))
        return;
    ObjectReader parameters(reader.object(u"speed_law_parameters"_s), u"program.speed_law_parameters."_s,
                            failure);
    for (std::size_t i = 0; i < law->parameters.size(); ++i) {
        const profile::LawParameterInfo& info = law->parameters[i];
        const QString id = toQString(info.id);
        profile::FieldInfo limits;
        limits.min = info.min;
        limits.max = info.max;
        if (parameters.has(id))
            recipe.program.speedLawParameters[i] = parameters.number(id, false, limits);
    }
    parameters.refuseUnknownKeys();
}

void readProgram(const QJsonObject& object, Recipe& recipe, std::optional<FileError>& failure)
{
    ObjectReader reader(object, u"program."_s, failure);
    if (const QString kind = reader.text(u"kind"_s); kind != kindName)
        reader.fail(u"kind"_s, FileError::Kind::NotAChoice, kind, kindName);
    readPinned(reader, recipe);
    for (const Field field : program::programFields) {
        const bool needed = profile::isPinned(recipe.program, field);
        // Values that are not pinned follow from the others: whatever stands there is not looked at.
        if (isPinnable(field) && !needed)
            reader.take(idOf(field));
        else if (needed || reader.has(idOf(field)))
            setValue(recipe, field, reader.number(idOf(field), isWhole(field), profile::info(field)));
    }
    readLaw(reader, recipe, failure);
    reader.refuseUnknownKeys();
}

void readMachine(const QJsonObject& object, Recipe& recipe, std::optional<FileError>& failure)
{
    ObjectReader reader(object, u"machine."_s, failure);
    for (const Field field : program::machineFields) {
        if (reader.has(idOf(field)))
            setValue(recipe, field, reader.number(idOf(field), isWhole(field), profile::info(field)));
    }
    reader.refuseUnknownKeys();
}

std::optional<FileError> wrongFormat(const QJsonObject& root)
{
    if (root.value(u"format"_s).toString() != formatName)
        return FileError{FileError::Kind::NotARecipe, {}, u"format"_s, {}, formatName, 0};
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

} // namespace

QByteArray toJson(const Recipe& recipe)
{
    const auto numberOf = [&recipe](Field field) -> QJsonValue {
        const double value = program::value(recipe, field);
        return isWhole(field) ? QJsonValue(static_cast<qint64>(value)) : QJsonValue(value);
    };
    QJsonObject programObject{{u"kind"_s, kindName}};
    QJsonArray pinned;
    for (const Field field : recipe.program.pinned)
        pinned.append(idOf(field));
    programObject[u"pinned"_s] = pinned;
    for (const Field field : program::programFields) {
        const bool derived = isPinnable(field) && !profile::isPinned(recipe.program, field);
        programObject[idOf(field)] = derived ? QJsonValue(QJsonValue::Null) : numberOf(field);
    }
    QJsonObject parameters;
    if (const profile::Law* law = profile::findLaw(recipe.program.speedLaw)) {
        programObject[u"speed_law"_s] = toQString(law->key);
        for (std::size_t i = 0; i < law->parameters.size(); ++i)
            parameters[toQString(law->parameters[i].id)] = recipe.program.speedLawParameters[i];
    }
    programObject[u"speed_law_parameters"_s] = parameters;
    QJsonObject machineObject;
    for (const Field field : program::machineFields)
        machineObject[idOf(field)] = numberOf(field);
    return QJsonDocument(QJsonObject{{u"format"_s, formatName},
                                     {u"format_version"_s, recipeFormatVersion},
                                     {u"name"_s, QString::fromStdString(recipe.name)},
                                     {u"version"_s, recipe.version},
                                     {u"program"_s, programObject},
                                     {u"machine"_s, machineObject}})
        .toJson();
}

tl::expected<Recipe, FileError> fromJson(const QByteArray& json, const QString& path)
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
    if (const auto wrong = wrongFormat(root))
        return refuse(*wrong);

    Recipe recipe;
    std::optional<FileError> failure;
    ObjectReader reader(root, {}, failure);
    reader.take(u"format"_s);
    reader.take(u"format_version"_s);
    const QString name = reader.text(u"name"_s);
    recipe.name = name.toStdString();
    if (recipe.name.size() > program::longestNameBytes)
        reader.fail(u"name"_s, FileError::Kind::TooLong, name, QString::number(program::longestNameBytes));
    profile::FieldInfo versions;
    versions.min = 1;
    versions.max = program::largestVersion;
    if (reader.has(u"version"_s))
        recipe.version = static_cast<int>(reader.number(u"version"_s, true, versions));
    readProgram(reader.object(u"program"_s), recipe, failure);
    if (reader.has(u"machine"_s))
        readMachine(reader.object(u"machine"_s), recipe, failure);
    reader.refuseUnknownKeys();
    if (failure)
        return refuse(*failure);
    return recipe;
}

} // namespace campanel::store
