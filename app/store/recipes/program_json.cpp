// SPDX-License-Identifier: Apache-2.0
// Writes and reads all kinds by their tables of fields and choices. The cutter adds which two of its four
// values are given, a cam its knots or segments.
#include "app/store/recipes/program_json.h"

#include "app/program/cam_advance.h"
#include "app/store/recipes/segments_file.h"
#include "profile/cam/cam_cycle.h"
#include "profile/laws/laws.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace campanel::store {
namespace {

using profile::Field;
using program::Choice;
using program::Recipe;

QJsonValue numberJson(const Recipe& recipe, Field field)
{
    const double value = program::value(recipe, field);
    return program::isCount(recipe, field) ? QJsonValue(static_cast<qint64>(value)) : QJsonValue(value);
}

QString lawId(const Recipe& recipe)
{
    return toQString(program::choiceInfo(recipe.kind(), Choice::Law).id);
}

const profile::Law* lawOf(const Recipe& recipe)
{
    return profile::findLaw(static_cast<profile::LawId>(program::choice(recipe.program, Choice::Law)));
}

void writeLaw(const Recipe& recipe, QJsonObject& object)
{
    const profile::Law* law = lawOf(recipe);
    const profile::LawParameters* values = program::lawParameters(recipe.program);
    if (law == nullptr || values == nullptr)
        return;
    QJsonObject parameters;
    for (std::size_t i = 0; i < law->parameters.size(); ++i)
        parameters[toQString(law->parameters[i].id)] = (*values)[i];
    object[lawId(recipe)] = toQString(law->key);
    object[lawId(recipe) + u"_parameters"_s] = parameters;
}

void writeChoices(const Recipe& recipe, QJsonObject& object)
{
    for (const program::ChoiceInfo& info : program::kindInfo(recipe.kind()).choices) {
        const auto option = std::ranges::find(info.options, program::choice(recipe.program, info.choice),
                                              &program::ChoiceOption::code);
        if (info.choice == Choice::Law)
            writeLaw(recipe, object);
        else if (option != info.options.end())
            object[toQString(info.id)] = toQString(option->key);
    }
}

void readPinned(ObjectReader& reader, Recipe& recipe)
{
    const QJsonArray pinned = reader.take(u"pinned"_s).toArray();
    std::vector<Field> fields;
    for (const QJsonValue& key : pinned) {
        const auto field = profile::fieldById(key.toString().toStdString());
        if (field && profile::isCycleField(*field) && std::ranges::find(fields, *field) == fields.end())
            fields.push_back(*field);
    }
    if (pinned.size() != 2 || fields.size() != 2)
        reader.fail(u"pinned"_s, FileError::Kind::WrongType, {}, FileErrorText::twoPinnedKeys());
    else
        recipe.cutter().pinned = {fields[0], fields[1]};
}

void readLaw(ObjectReader& reader, Recipe& recipe, std::optional<FileError>& failure)
{
    const QString id = lawId(recipe);
    const QString key = reader.text(id);
    const profile::Law* law = profile::findLaw(key.toStdString());
    if (law == nullptr || !program::isLawOf(recipe.kind(), *law)) {
        QStringList choices;
        for (const profile::Law& each : profile::laws()) {
            if (program::isLawOf(recipe.kind(), each))
                choices << toQString(each.key);
        }
        reader.fail(id, FileError::Kind::NotAChoice, key, choices.join(u", "_s));
        return;
    }
    program::setChoice(recipe.program, Choice::Law, static_cast<std::uint16_t>(law->id));
    profile::LawParameters& values = *program::lawParameters(recipe.program);
    values = profile::defaultParameters(*law);
    const QString parametersId = id + u"_parameters"_s;
    if (!reader.has(parametersId))
        return;
    ObjectReader parameters(reader.object(parametersId), u"program."_s + parametersId + u'.', failure);
    for (std::size_t i = 0; i < law->parameters.size(); ++i) {
        const profile::LawParameterInfo& info = law->parameters[i];
        profile::FieldInfo limits;
        limits.min = info.min;
        limits.max = info.max;
        if (parameters.has(toQString(info.id)))
            values[i] = parameters.number(toQString(info.id), false, limits);
    }
    parameters.refuseUnknownKeys();
}

void readChoice(ObjectReader& reader, Recipe& recipe, const program::ChoiceInfo& info)
{
    const QString id = toQString(info.id);
    if (!reader.has(id))
        return;
    const QString key = reader.text(id);
    const auto found = std::ranges::find(info.options, key.toStdString(), &program::ChoiceOption::key);
    if (found != info.options.end()) {
        program::setChoice(recipe.program, info.choice, found->code);
        return;
    }
    QStringList keys;
    for (const program::ChoiceOption& option : info.options)
        keys << toQString(option.key);
    reader.fail(id, FileError::Kind::NotAChoice, key, keys.join(u", "_s));
}

const QString confirmedAdvance = u"confirmed_advance_mm"_s;

void readConfirmedAdvance(ObjectReader& reader, Recipe& recipe)
{
    if (profile::camMaster(recipe.program) == nullptr || !reader.has(confirmedAdvance))
        return;
    profile::FieldInfo limits; // both ends of a cam, and the scale
    limits.max = 2 * profile::maxSlaveMm * profile::info(Field::SlaveScale).max;
    limits.min = -limits.max;
    program::setConfirmedAdvance(recipe.program, reader.number(confirmedAdvance, false, limits));
}

void readCamKnots(ObjectReader& reader, profile::PointCamProgram& cam)
{
    const QString id = u"knots"_s;
    if (!reader.has(id))
        return;
    const QJsonValue list = reader.take(id);
    if (!list.isArray())
        reader.fail(id, FileError::Kind::WrongType, {}, FileErrorText::pairsOfNumbers());
    cam.knots.clear();
    for (const QJsonValue& each : list.toArray()) {
        const QJsonArray pair = each.toArray();
        if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble())
            reader.fail(id, FileError::Kind::WrongType, {}, FileErrorText::pairsOfNumbers());
        cam.knots.push_back({pair.at(0).toDouble(), pair.at(1).toDouble()});
    }
}

} // namespace

QJsonObject programJson(const Recipe& recipe)
{
    const program::KindInfo& kind = program::kindInfo(recipe.kind());
    QJsonObject object{{u"kind"_s, toQString(kind.key)}};
    for (const Field field : kind.programFields) {
        const bool derived = recipe.isCutter() && !program::isRead(recipe.program, field);
        object[idOf(field)] = derived ? QJsonValue(QJsonValue::Null) : numberJson(recipe, field);
    }
    writeChoices(recipe, object);
    if (recipe.isCutter()) {
        QJsonArray pinned;
        for (const Field field : recipe.cutter().pinned)
            pinned.append(idOf(field));
        object[u"pinned"_s] = pinned;
    }
    if (const auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program)) {
        QJsonArray knots;
        for (const profile::Knot& knot : cam->knots)
            knots.append(QJsonArray{knot.masterDeg, knot.slaveMm});
        object[u"knots"_s] = knots;
    }
    if (const auto* cam = std::get_if<profile::SegmentCamProgram>(&recipe.program))
        object[u"segments"_s] = segmentsJson(cam->segments);
    if (const double confirmedMm = program::confirmedAdvanceMm(recipe.program); confirmedMm != 0)
        object[confirmedAdvance] = confirmedMm;
    return object;
}

QJsonObject machineJson(const Recipe& recipe)
{
    QJsonObject object;
    for (const Field field : program::kindInfo(recipe.kind()).machineFields)
        object[idOf(field)] = numberJson(recipe, field);
    return object;
}

void readProgram(const QJsonObject& object, Recipe& recipe, std::optional<FileError>& failure)
{
    ObjectReader reader(object, u"program."_s, failure);
    const QString key = reader.text(u"kind"_s);
    const program::KindInfo* kind = program::findKind(key.toStdString());
    if (kind == nullptr) {
        QStringList keys;
        for (const program::KindInfo& each : program::kinds())
            keys << toQString(each.key);
        reader.fail(u"kind"_s, FileError::Kind::NotAChoice, key, keys.join(u", "_s));
        return;
    }
    const Recipe start = program::defaultRecipe(kind->kind);
    recipe.program = start.program;
    recipe.machine = start.machine;
    if (recipe.isCutter())
        readPinned(reader, recipe);
    // First, because they decide which values are read.
    for (const program::ChoiceInfo& choice : kind->choices) {
        if (choice.choice == Choice::Law)
            readLaw(reader, recipe, failure);
        else
            readChoice(reader, recipe, choice);
    }
    for (const Field field : kind->programFields) {
        const bool needed =
            recipe.isCutter() && profile::isCycleField(field) && program::isRead(recipe.program, field);
        // Derived values are not read from the file.
        if (recipe.isCutter() && !program::isRead(recipe.program, field))
            reader.take(idOf(field));
        else if (needed || reader.has(idOf(field)))
            program::setValue(
                recipe, field,
                reader.number(idOf(field), program::isCount(recipe, field), profile::info(field)));
    }
    if (auto* cam = std::get_if<profile::PointCamProgram>(&recipe.program))
        readCamKnots(reader, *cam);
    if (auto* cam = std::get_if<profile::SegmentCamProgram>(&recipe.program))
        readSegmentsJson(reader, *cam, failure);
    readConfirmedAdvance(reader, recipe);
    reader.refuseUnknownKeys();
}

void readMachine(const QJsonObject& object, Recipe& recipe, std::optional<FileError>& failure)
{
    ObjectReader reader(object, u"machine."_s, failure);
    for (const Field field : program::kindInfo(recipe.kind()).machineFields) {
        if (reader.has(idOf(field)))
            program::setValue(
                recipe, field,
                reader.number(idOf(field), program::isCount(recipe, field), profile::info(field)));
    }
    reader.refuseUnknownKeys();
}

} // namespace campanel::store
