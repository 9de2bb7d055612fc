// SPDX-License-Identifier: Apache-2.0
// One row per option that is a single field; k, gear and law have their own form.
#include "app/cli/recipe_options.h"

#include "app/cli/invocation.h"
#include "app/store/recipe_file.h"
#include "profile/laws.h"

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

constexpr std::array fieldOptions{
    FieldOption{"bag-length-mm", Field::BagLength},
    FieldOption{"rate", Field::Rate},
    FieldOption{"base-speed-mm-per-s", Field::BaseSpeed},
    FieldOption{"film-speed-mm-per-s", Field::FilmSpeed},
    FieldOption{"sync-ratio", Field::SyncRatio},
    FieldOption{"slices", Field::SlicesPerRamp},
    FieldOption{"knife-radius-mm", Field::KnifeRadius},
    FieldOption{"knives", Field::Knives},
    FieldOption{"pulses-per-rev", Field::PulsesPerMotorRev},
    FieldOption{"max-motor-rpm", Field::MaxMotorRpm},
    FieldOption{"max-knife-acceleration-mm-per-s2", Field::MaxKnifeAcceleration},
    FieldOption{"max-pulse-frequency-hz", Field::MaxPulseFrequency},
    FieldOption{"max-rate", Field::MaxRate},
};

QString lawKeys()
{
    QStringList keys;
    for (const profile::Law& law : profile::laws()) {
        if (law.isSpeedLaw)
            keys << QString::fromUtf8(law.key.data(), static_cast<qsizetype>(law.key.size()));
    }
    return keys.join(u", "_s);
}

tl::unexpected<Failure> notANumber(const QString& option, const QString& text, const QString& form)
{
    return fail(ExitCode::Usage, u"--%1 takes %2, not \"%3\"."_s.arg(option, form, text));
}

// `count` numbers separated by commas.
tl::expected<QList<double>, Failure> numbers(const Invocation& call, const QString& option, qsizetype most,
                                             const QString& form)
{
    QList<double> values;
    for (const QString& part : call.value(option).split(u',')) {
        bool ok = false;
        values << part.trimmed().toDouble(&ok);
        if (!ok || !std::isfinite(values.last()))
            return notANumber(option, call.value(option), form);
    }
    if (values.size() > most)
        return notANumber(option, call.value(option), form);
    return values;
}

Outcome applyFields(const Invocation& call, program::Recipe& recipe)
{
    std::vector<Field> given;
    for (const FieldOption& option : fieldOptions) {
        const QString name = QString::fromLatin1(option.name);
        if (!call.isSet(name))
            continue;
        const auto value = numbers(call, name, 1, u"a number"_s);
        if (!value)
            return tl::unexpected(value.error());
        if (profile::info(option.field).decimals == 0 && std::floor(value->first()) != value->first())
            return notANumber(name, call.value(name), u"a whole number"_s);
        setValue(recipe, option.field, value->first());
        if (std::ranges::find(program::pinnableFields, option.field) != program::pinnableFields.end())
            given.push_back(option.field);
    }
    if (given.size() > 2)
        return fail(ExitCode::Usage,
                    u"Give at most two of --bag-length-mm, --rate, --base-speed-mm-per-s and "
                    "--film-speed-mm-per-s; the others follow from them."_s);
    auto& pinned = recipe.program.pinned;
    if (given.size() == 2)
        pinned = {given[0], given[1]};
    else if (given.size() == 1 && !profile::isPinned(recipe.program, given[0]))
        // The bag length is what a recipe is for: it stays when something else is given.
        pinned[pinned[0] == Field::BagLength ? 1 : 0] = given[0];
    return {};
}

Outcome applyGear(const Invocation& call, program::Recipe& recipe)
{
    if (!call.isSet(u"gear"_s))
        return {};
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
    const QString form = u"four numbers such as 4,2.5,1.6667,1.3333"_s;
    const auto values = numbers(call, u"k"_s, 4, form);
    if (!values)
        return tl::unexpected(values.error());
    if (values->size() != 4)
        return notANumber(u"k"_s, call.value(u"k"_s), form);
    std::copy(values->begin(), values->end(), recipe.program.k.begin());
    return {};
}

Outcome applyLaw(const Invocation& call, program::Recipe& recipe)
{
    if (call.isSet(u"law"_s)) {
        const profile::Law* law = profile::findLaw(call.value(u"law"_s).toStdString());
        if (law == nullptr || !law->isSpeedLaw)
            return fail(ExitCode::Usage, u"There is no speed law \"%1\"; choose one of: %2."_s.arg(
                                             call.value(u"law"_s), lawKeys()));
        recipe.program.speedLaw = law->id;
        recipe.program.speedLawParameters = profile::defaultParameters(*law);
    }
    if (!call.isSet(u"law-parameters"_s))
        return {};
    const profile::Law* law = profile::findLaw(recipe.program.speedLaw);
    const auto count = static_cast<qsizetype>(law->parameters.size());
    const auto values = numbers(call, u"law-parameters"_s, count, u"%1 numbers for this law"_s.arg(count));
    if (!values)
        return tl::unexpected(values.error());
    std::copy(values->begin(), values->end(), recipe.program.speedLawParameters.begin());
    return {};
}

} // namespace

QList<QCommandLineOption> recipeOptions()
{
    constexpr int shownDigits = 9;
    QList<QCommandLineOption> options;
    for (const FieldOption& option : fieldOptions) {
        const profile::FieldInfo& info = profile::info(option.field);
        const auto text = [](std::string_view view) {
            return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
        };
        const QString unit = info.unit.empty() ? QString() : u", "_s + text(info.unit);
        options << QCommandLineOption(QString::fromLatin1(option.name),
                                      u"%1 (%2 to %3%4)."_s.arg(text(info.name))
                                          .arg(info.min, 0, 'g', shownDigits)
                                          .arg(info.max, 0, 'g', shownDigits)
                                          .arg(unit),
                                      u"NUMBER"_s);
    }
    options << QCommandLineOption(u"gear"_s, u"Motor revolutions per knife revolution, such as 5/2."_s,
                                  u"A/B"_s)
            << QCommandLineOption(u"k"_s, u"Ratios k1 > k2 > k3 > k4 > 1."_s, u"K1,K2,K3,K4"_s)
            << QCommandLineOption(u"law"_s, u"Speed law: "_s + lawKeys() + u'.', u"LAW"_s)
            << QCommandLineOption(u"law-parameters"_s, u"Parameters of the speed law, separated by commas."_s,
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
    for (const auto apply : {applyFields, applyGear, applyRatios, applyLaw}) {
        if (const Outcome applied = apply(call, recipe); !applied)
            return tl::unexpected(applied.error());
    }
    return recipe;
}

} // namespace campanel::cli
