// SPDX-License-Identifier: Apache-2.0
// The table of options, one row per field; k, gear and law have their own form.
#include "app/cli/recipe_options.h"

#include "app/cli/invocation.h"
#include "app/program/cam_advance.h"
#include "app/program/recipe_master.h"
#include "app/store/recipes/list_file.h"
#include "app/store/recipes/recipe_file.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using profile::Field;

struct FieldOption {
    const char* name;
    Field field;
};

// The fields with an option that is shorter than the key of the recipe file.
constexpr std::array shortOptions{
    FieldOption{"rate", Field::Rate},
    FieldOption{"slices", Field::SlicesPerRamp},
    FieldOption{"pulses-per-rev", Field::PulsesPerMotorRev},
    FieldOption{"max-rate", Field::MaxRate},
};

// Returns true for the fields with their own form: --k and --gear.
bool hasOwnForm(Field field)
{
    return profile::isRatio(field) || field == Field::GearNumerator || field == Field::GearDenominator;
}

QString fromText(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString optionOf(Field field)
{
    const auto found = std::ranges::find(shortOptions, field, &FieldOption::field);
    if (found != shortOptions.end())
        return QString::fromLatin1(found->name);
    return fromText(profile::info(field).id).replace(u'_', u'-');
}

// Returns every field of any kind that has an option, each once.
QList<Field> optionFields()
{
    QList<Field> fields;
    for (const program::KindInfo& kind : program::kinds()) {
        for (const auto list : {kind.programFields, kind.machineFields}) {
            for (const Field field : list) {
                if (!hasOwnForm(field) && !fields.contains(field))
                    fields << field;
            }
        }
    }
    return fields;
}

bool belongsTo(const program::KindInfo& kind, Field field)
{
    return std::ranges::find(kind.programFields, field) != kind.programFields.end() ||
           std::ranges::find(kind.machineFields, field) != kind.machineFields.end();
}

QString kindKeys()
{
    QStringList keys;
    for (const program::KindInfo& kind : program::kinds())
        keys << fromText(kind.key);
    return keys.join(u", "_s);
}

// Returns the choices of any kind that have an option, each once; the law has its own.
QList<program::ChoiceInfo> choiceOptions()
{
    QList<program::ChoiceInfo> found;
    for (const program::KindInfo& kind : program::kinds()) {
        for (const program::ChoiceInfo& info : kind.choices) {
            const auto same =
                std::ranges::find(found, info.id, [](const program::ChoiceInfo& each) { return each.id; });
            if (info.choice == program::Choice::Law)
                continue;
            if (same == found.end())
                found << info;
            else if (same->options.size() < info.options.size())
                *same = info; // a speed move has an additional choice
        }
    }
    return found;
}

QString optionKeys(const program::ChoiceInfo& info)
{
    QStringList keys;
    for (const program::ChoiceOption& option : info.options)
        keys << fromText(option.key);
    return keys.join(u", "_s);
}

QString lawKeys(const program::KindInfo* kind)
{
    QStringList keys;
    for (const profile::Law& law : profile::laws()) {
        if (kind == nullptr || program::isLawOf(kind->kind, law))
            keys << fromText(law.key);
    }
    return keys.join(u", "_s);
}

tl::unexpected<Failure> notANumber(const QString& option, const QString& text, const QString& form)
{
    return fail(ExitCode::Usage, u"--%1 takes %2, not \"%3\"."_s.arg(option, form, text));
}

// Parses `count` numbers separated by commas.
tl::expected<QList<double>, Failure> numbers(const Invocation& call, const QString& option, qsizetype max,
                                             const QString& form)
{
    QList<double> values;
    for (const QString& part : call.value(option).split(u',')) {
        bool ok = false;
        values << part.trimmed().toDouble(&ok);
        if (!ok || !std::isfinite(values.last()))
            return notANumber(option, call.value(option), form);
    }
    if (values.size() > max)
        return notANumber(option, call.value(option), form);
    return values;
}

Outcome pinGiven(const std::vector<Field>& given, program::Recipe& recipe)
{
    if (given.size() > 2)
        return fail(
            ExitCode::Usage,
            u"Give at most two of --bag-length-mm, --rate, --base-speed-mm-per-s and --film-speed-mm-per-s; the other values follow."_s);
    auto& pinned = recipe.cutter().pinned;
    if (given.size() == 2)
        pinned = {given[0], given[1]};
    else if (given.size() == 1 && !profile::isPinned(recipe.cutter(), given[0]))
        // The bag length stays pinned when another value is given: it is the purpose of a recipe.
        pinned[pinned[0] == Field::BagLength ? 1 : 0] = given[0];
    return {};
}

Outcome applyFields(const Invocation& call, program::Recipe& recipe)
{
    const program::KindInfo& kind = program::kindInfo(recipe.kind());
    std::vector<Field> given;
    for (const Field field : optionFields()) {
        const QString name = optionOf(field);
        if (!call.isSet(name))
            continue;
        if (!belongsTo(kind, field))
            return fail(ExitCode::Usage,
                        u"--%1 does not apply to a program of kind %2."_s.arg(name, fromText(kind.key)));
        const auto value = numbers(call, name, 1, u"a number"_s);
        if (!value)
            return tl::unexpected(value.error());
        if (profile::info(field).decimals == 0 && std::floor(value->first()) != value->first())
            return notANumber(name, call.value(name), u"a whole number"_s);
        setValue(recipe, field, value->first());
        if (profile::isCycleField(field))
            given.push_back(field);
    }
    return recipe.isCutter() ? pinGiven(given, recipe) : Outcome{};
}

Outcome applyGear(const Invocation& call, program::Recipe& recipe)
{
    if (!call.isSet(u"gear"_s))
        return {};
    if (!recipe.isCutter())
        return fail(ExitCode::Usage, u"--gear applies to a rotary cutter only."_s);
    const QStringList parts = call.value(u"gear"_s).split(u'/');
    bool numeratorOk = false;
    bool denominatorOk = true;
    const int numerator = parts[0].toInt(&numeratorOk);
    const int denominator = parts.size() > 1 ? parts[1].toInt(&denominatorOk) : 1;
    if (parts.size() > 2 || !numeratorOk || !denominatorOk)
        return notANumber(u"gear"_s, call.value(u"gear"_s), u"two whole numbers such as 5/2"_s);
    recipe.machine.gearNumerator = numerator;
    recipe.machine.gearDenominator = denominator;
    return {};
}

Outcome applyRatios(const Invocation& call, program::Recipe& recipe)
{
    if (!call.isSet(u"k"_s))
        return {};
    if (!recipe.isCutter())
        return fail(ExitCode::Usage, u"--k applies to a rotary cutter only."_s);
    const QString form = u"four numbers such as 4,2.5,1.6667,1.3333"_s;
    const auto values = numbers(call, u"k"_s, 4, form);
    if (!values)
        return tl::unexpected(values.error());
    if (values->size() != 4)
        return notANumber(u"k"_s, call.value(u"k"_s), form);
    std::copy(values->begin(), values->end(), recipe.cutter().k.begin());
    recipe.cutter().ratioMode = profile::RatioMode::ByHand;
    return {};
}

Outcome applyLaw(const Invocation& call, program::Recipe& recipe)
{
    if (!call.isSet(u"law"_s) && !call.isSet(u"law-parameters"_s))
        return {};
    const program::KindInfo& kind = program::kindInfo(recipe.kind());
    profile::LawParameters* parameters = program::lawParameters(recipe.program);
    if (parameters == nullptr)
        return fail(ExitCode::Usage, u"A program of kind %1 has no law."_s.arg(fromText(kind.key)));
    if (call.isSet(u"law"_s)) {
        const profile::Law* law = profile::findLaw(call.value(u"law"_s).toStdString());
        if (law == nullptr || !program::isLawOf(kind.kind, *law))
            return fail(ExitCode::Usage,
                        u"Unknown %1 law \"%2\"; choose one of: %3."_s.arg(
                            kind.kind == profile::ProgramKind::PositionMove ? u"displacement"_s : u"speed"_s,
                            call.value(u"law"_s), lawKeys(&kind)));
        program::setChoice(recipe.program, program::Choice::Law, static_cast<std::uint16_t>(law->id));
        *parameters = profile::defaultParameters(*law);
    }
    if (!call.isSet(u"law-parameters"_s))
        return {};
    const profile::Law* law =
        profile::findLaw(static_cast<profile::LawId>(program::choice(recipe.program, program::Choice::Law)));
    const auto count = static_cast<qsizetype>(law->parameters.size());
    const auto values = numbers(call, u"law-parameters"_s, count, u"%1 numbers for this law"_s.arg(count));
    if (!values)
        return tl::unexpected(values.error());
    std::copy(values->begin(), values->end(), parameters->begin());
    return {};
}

Outcome applyChoices(const Invocation& call, program::Recipe& recipe)
{
    const program::KindInfo& kind = program::kindInfo(recipe.kind());
    for (const program::ChoiceInfo& each : choiceOptions()) {
        const QString name = fromText(each.id).replace(u'_', u'-');
        if (!call.isSet(name))
            continue;
        const program::ChoiceInfo info = program::choiceInfo(kind.kind, each.choice);
        if (info.options.empty())
            return fail(ExitCode::Usage,
                        u"--%1 does not apply to a program of kind %2."_s.arg(name, fromText(kind.key)));
        const std::string key = call.value(name).toStdString();
        const auto found = std::ranges::find(info.options, key, &program::ChoiceOption::key);
        if (found == info.options.end())
            return fail(ExitCode::Usage, u"--%1 takes one of: %2."_s.arg(name, optionKeys(info)));
        program::setChoice(recipe.program, each.choice, found->code);
    }
    return {};
}

// Reads the list of a cam of this kind from the file of the option.
Outcome applyList(const Invocation& call, program::Recipe& recipe, const QString& option,
                  profile::ProgramKind kind, const QString& kindName)
{
    if (!call.isSet(option))
        return {};
    if (recipe.kind() != kind)
        return fail(ExitCode::Usage, u"--%1 applies to a %2 only."_s.arg(option, kindName));
    if (const auto read = store::readListCsv(call.value(option), recipe.program); !read)
        return fail(ExitCode::File, read.error());
    return {};
}

Outcome applyLists(const Invocation& call, program::Recipe& recipe)
{
    using Kind = profile::ProgramKind;
    if (Outcome outcome = applyList(call, recipe, u"knots-csv"_s, Kind::PointCam, u"point cam"_s); !outcome)
        return outcome;
    return applyList(call, recipe, u"segments-csv"_s, Kind::SegmentCam, u"segment cam"_s);
}

// Confirms the net advance of a cam, or closes the cam.
Outcome applyAdvance(const Invocation& call, program::Recipe& recipe)
{
    for (const auto& [option, apply] :
         {std::pair{u"close"_s, &program::closeCam}, std::pair{u"progressive"_s, &program::confirmAdvance}}) {
        if (!call.isSet(option))
            continue;
        if (profile::camMaster(recipe.program) == nullptr)
            return fail(ExitCode::Usage, u"--%1 applies to a cam only."_s.arg(option));
        apply(recipe.program);
    }
    if (call.isSet(u"close"_s) && call.isSet(u"progressive"_s))
        return fail(ExitCode::Usage, u"Give --progressive or --close, not both."_s);
    return {};
}

Outcome applyMaster(const Invocation& call, program::Recipe& recipe)
{
    if (!call.isSet(u"for-master"_s))
        return {};
    const auto master = program::masterByKey(call.value(u"for-master"_s).toStdString());
    if (!master)
        return fail(ExitCode::Usage, u"--for-master takes any, clock or encoder."_s);
    if (!program::hasMaster(recipe))
        return fail(ExitCode::Usage, u"A recipe of this kind has no master; --for-master does not apply."_s);
    recipe.master = *master;
    return {};
}

// Reads "rate_bags_per_min=55..70,k1=none": sets the approved windows, or removes one.
Outcome applyWindows(const Invocation& call, program::Recipe& recipe)
{
    const QString option = u"windows"_s;
    if (!call.isSet(option))
        return {};
    for (const QString& part : call.value(option).split(u',')) {
        const QString key = part.section(u'=', 0, 0).trimmed();
        const QString limits = part.section(u'=', 1);
        const auto info = std::ranges::find_if(
            profile::fields, [&key](const profile::FieldInfo& each) { return fromText(each.id) == key; });
        if (info == profile::fields.end() || !program::canHaveWindow(recipe, info->field))
            return fail(
                ExitCode::Usage,
                u"--windows: \"%1\" is no value of this kind of program that can have a window."_s.arg(key));
        if (limits == u"none") {
            recipe.windows.erase(info->field);
            continue;
        }
        bool isMin = false;
        bool isMax = false;
        const program::ApprovedWindow window{limits.section(u".."_s, 0, 0).toDouble(&isMin),
                                             limits.section(u".."_s, 1).toDouble(&isMax)};
        if (!isMin || !isMax)
            return notANumber(option, part, u"FIELD=LOWEST..HIGHEST or FIELD=none"_s);
        if (!(window.min <= window.max && window.min >= info->min && window.max <= info->max))
            return fail(
                ExitCode::Usage,
                u"--windows: %1 takes a lowest value that is not above the highest, both from %2 to %3."_s
                    .arg(key, QString::number(info->min, 'g', 9), QString::number(info->max, 'g', 9)));
        recipe.windows[info->field] = window;
    }
    return {};
}

} // namespace

QList<QCommandLineOption> recipeOptions()
{
    constexpr int shownDigits = 9;
    QList<QCommandLineOption> options;
    for (const Field field : optionFields()) {
        const profile::FieldInfo& info = profile::info(field);
        const QString unit = info.unit.empty() ? QString() : u", "_s + fromText(info.unit);
        options << QCommandLineOption(
            optionOf(field),
            u"%1 (%2 to %3%4)."_s.arg(fromText(info.name), QString::number(info.min, 'g', shownDigits),
                                      QString::number(info.max, 'g', shownDigits), unit),
            u"NUMBER"_s);
    }
    for (const program::ChoiceInfo& info : choiceOptions())
        options << QCommandLineOption(fromText(info.id).replace(u'_', u'-'),
                                      u"One of: %1."_s.arg(optionKeys(info)), u"CHOICE"_s);
    options << QCommandLineOption(u"kind"_s,
                                  u"Kind of the default recipe, if no recipe is named: %1."_s.arg(kindKeys()),
                                  u"KIND"_s)
            << QCommandLineOption(u"knots-csv"_s, u"Knots of a point cam: lines of master_deg,slave_mm."_s,
                                  u"FILE"_s)
            << QCommandLineOption(u"segments-csv"_s,
                                  u"Segments of a segment cam, as printed by segments --format csv."_s,
                                  u"FILE"_s);
    options << QCommandLineOption(
        u"for-master"_s, u"What the machine must follow: any (whatever it follows), clock, encoder."_s,
        u"MASTER"_s);
    options << QCommandLineOption(
        u"windows"_s,
        u"Approved windows by the keys of the recipe file, such as rate_bags_per_min=55..70,k1=none."_s,
        u"WINDOWS"_s);
    options << QCommandLineOption(u"progressive"_s,
                                  u"Confirm that the cam moves its axis on in every cycle."_s)
            << QCommandLineOption(u"close"_s, u"End the cam where it began: no advance."_s);
    options << QCommandLineOption(u"gear"_s, u"Motor revolutions per knife revolution, such as 5/2."_s,
                                  u"A/B"_s)
            << QCommandLineOption(u"k"_s, u"Ratios k1 > k2 > k3 > k4 > 1."_s, u"K1,K2,K3,K4"_s)
            << QCommandLineOption(u"law"_s, u"Law: "_s + lawKeys(nullptr) + u'.', u"LAW"_s)
            << QCommandLineOption(u"law-parameters"_s, u"Parameters of the law, separated by commas."_s,
                                  u"NUMBERS"_s);
    return options;
}

tl::expected<program::Recipe, Failure> recipeOf(const Invocation& call)
{
    program::Recipe recipe;
    if (!call.arguments().isEmpty()) {
        auto read = store::readRecipe(call.arguments().first());
        if (!read)
            return fail(read.error());
        recipe = std::move(*read);
    }
    if (call.isSet(u"kind"_s)) {
        const program::KindInfo* kind = program::findKind(call.value(u"kind"_s).toStdString());
        if (kind == nullptr)
            return fail(ExitCode::Usage, u"--kind takes one of: %1."_s.arg(kindKeys()));
        if (call.arguments().isEmpty())
            recipe = program::defaultRecipe(kind->kind);
        else if (recipe.kind() != kind->kind)
            return fail(ExitCode::Usage,
                        u"The recipe is of kind %1."_s.arg(fromText(program::kindInfo(recipe.kind()).key)));
    }
    for (const auto apply : {applyFields, applyGear, applyRatios, applyLaw, applyChoices, applyLists,
                             applyAdvance, applyMaster, applyWindows}) {
        if (const Outcome applied = apply(call, recipe); !applied)
            return tl::unexpected(applied.error());
    }
    // The ratios of a file without options are those that were saved.
    if (call.arguments().isEmpty() || std::ranges::any_of(recipeOptions(), [&call](const auto& option) {
            return call.isSet(option.names().first());
        }))
        program::followRatios(recipe);
    return recipe;
}

} // namespace campanel::cli
