// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/master_sentences.h"

#include "app/panel/words/controller_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::panel {

using program::MasterRefusal;
using program::RecipeMaster;

namespace {

struct ParameterName {
    const char* name;
    const char* words;
};

constexpr std::array parameterNames{
    ParameterName{"master.source", QT_TRANSLATE_NOOP("MasterSentences", "Master")},
    ParameterName{"master.place", QT_TRANSLATE_NOOP("MasterSentences", "Place of the encoder")},
    ParameterName{"master.signal", QT_TRANSLATE_NOOP("MasterSentences", "Signal of the encoder")},
    ParameterName{"master.reversed", QT_TRANSLATE_NOOP("MasterSentences", "Encoder counts backward")},
    ParameterName{"master.counts", QT_TRANSLATE_NOOP("MasterSentences", "Counts per revolution")},
    ParameterName{"master.revolution", QT_TRANSLATE_NOOP("MasterSentences", "Film per revolution")},
    ParameterName{"master.lead", QT_TRANSLATE_NOOP("MasterSentences", "Delay compensation")},
    ParameterName{"master.delay", QT_TRANSLATE_NOOP("MasterSentences", "Delay of the drive")},
    ParameterName{"master.smoothing", QT_TRANSLATE_NOOP("MasterSentences", "Time constant of the position")},
    ParameterName{"master.engage", QT_TRANSLATE_NOOP("MasterSentences", "Stretch for engaging")},
    ParameterName{"master.speed_max", QT_TRANSLATE_NOOP("MasterSentences", "Max. speed of the master")},
    ParameterName{"master.backward", QT_TRANSLATE_NOOP("MasterSentences", "Cam follows backward")},
    ParameterName{"master.index_limit", QT_TRANSLATE_NOOP("MasterSentences", "Limit of the index mark")},
    ParameterName{"master.slip_limit", QT_TRANSLATE_NOOP("MasterSentences", "Limit of the wheel's slip")},
    ParameterName{"master.phase", QT_TRANSLATE_NOOP("MasterSentences", "Phase of the line")},
};

} // namespace

QString MasterSentences::refusal(MasterRefusal refusal)
{
    switch (refusal) {
    case MasterRefusal::None:
        return {};
    case MasterRefusal::NoInput:
        return ControllerSentences::refusal(modbus::Refusal::NoMasterInput);
    case MasterRefusal::CannotFollow:
        return ControllerSentences::refusal(modbus::Refusal::CannotFollowMaster);
    case MasterRefusal::NeedsInput:
        return tr("This recipe is for an encoder as the master, and the controller has no input for one. "
                  "Change the master of the recipe, or use another controller.");
    case MasterRefusal::NeedsEncoder:
        return tr("This recipe is for an encoder as the master, but the machine follows its clock. Set the "
                  "encoder as the master of the machine, or change the master of the recipe.");
    case MasterRefusal::NeedsClock:
        return tr("This recipe is for the clock, but an encoder leads the machine. Set the clock as the "
                  "master of the machine, or change the master of the recipe.");
    }
    return {};
}

QString MasterSentences::title()
{
    return tr("Master");
}

QString MasterSentences::name(RecipeMaster master)
{
    switch (master) {
    case RecipeMaster::Any:
        return tr("As the machine");
    case RecipeMaster::Clock:
        return tr("Clock of the controller");
    case RecipeMaster::Encoder:
        return tr("Encoder of the line");
    }
    return {};
}

QString MasterSentences::parameter(const QString& name)
{
    const auto found = std::ranges::find_if(
        parameterNames, [&name](const ParameterName& each) { return name == QLatin1String(each.name); });
    return found == parameterNames.end() ? QString() : tr(found->words);
}

QString MasterSentences::value(const modbus::RegisterInfo& info, double value)
{
    if (std::isnan(value))
        return Format::unknownText();
    if (!info.enumName.empty())
        return ControllerSentences::texts(info.enumName).value(static_cast<int>(value));
    if (info.maximum == 1)
        return value == 0 ? tr("Off") : tr("On");
    if (info.unit == "counts")
        return Format::joined(Format().grouped(value, 0), RecipeWords::unit(info.unit));
    return Format().compactMeasure(value, 0, RegisterWords::decimals(info), RecipeWords::unit(info.unit));
}

QString MasterSentences::rateOfLine()
{
    return tr("The line sets the rate: an encoder leads the machine. Change the speed of the line.");
}

} // namespace campanel::panel
