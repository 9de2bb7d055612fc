// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/recipe_words.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "profile/laws/laws.h"

namespace campanel::panel {

using profile::Field;
using profile::LawId;

QString RecipeWords::inWords(std::string_view text)
{
    return text.empty() ? QString() : QCoreApplication::translate("Recipe", std::string(text).c_str());
}

QString RecipeWords::valueText(Field field, double value)
{
    if (value == 0 && profile::info(field).isUnknownAtZero)
        return Format::unknownText();
    const profile::FieldInfo& info = profile::info(field);
    const Format format;
    return info.decimals > 2 ? format.compactAmount(value, 2, info.decimals, unit(info.unit))
                             : format.amount(value, info.decimals, unit(info.unit));
}

QString RecipeWords::unit(std::string_view unit)
{
    if (unit == "mm/s^2")
        return QStringLiteral("mm/s²");
    if (unit == "deg")
        return QStringLiteral("°");
    if (unit == "mm/deg")
        return QStringLiteral("mm/°");
    if (unit == "mm/deg^2")
        return QStringLiteral("mm/°²");
    if (unit == "bags/min")
        return tr("bags/min");
    if (unit == "r/min")
        return tr("r/min");
    if (unit == "pulses")
        return tr("pulses");
    if (unit == "counts")
        return tr("counts");
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString RecipeWords::lawName(LawId law)
{
    const profile::Law* row = profile::findLaw(law);
    return row ? inWords(row->name) : QString();
}

QString RecipeWords::lawParameterName(std::string_view parameterId)
{
    const profile::LawParameterInfo* row = profile::findLawParameter(parameterId);
    return row ? inWords(row->name)
               : QString::fromUtf8(parameterId.data(), static_cast<qsizetype>(parameterId.size()));
}

QString RecipeWords::proposedName(const program::Recipe& recipe, bool isInch)
{
    if (!recipe.isCutter())
        return QString::fromUtf8(program::kindInfo(recipe.kind()).defaultName);
    const double lengthMm = recipe.cutter().bagLengthMm;
    QString length = Format().compact(lengthMm, 0, 1);
    if (isInch) {
        const QVariantMap inch = Units::rows(true).value(QStringLiteral("mm")).toMap();
        const double factor = inch.value(QStringLiteral("factor")).toDouble();
        length =
            Format().compact(lengthMm * factor, 0, 3) + u' ' + inch.value(QStringLiteral("unit")).toString();
    }
    return tr("Bag %1", "name of a recipe, length in mm").arg(length);
}

QString RecipeWords::proposedName(const program::Recipe& recipe)
{
    return proposedName(recipe, Units::isInch());
}

bool RecipeWords::isProposedName(const program::Recipe& recipe)
{
    const QString name = QString::fromStdString(recipe.name);
    return name == proposedName(recipe, false) || name == proposedName(recipe, true);
}

QString RecipeWords::listSize(const profile::Program& program)
{
    const program::ListInfo& list = *program::kindInfo(profile::kindOf(program)).list;
    const std::size_t size = list.size(program);
    if (&list == &program::segmentList)
        return size == 1 ? tr("1 segment") : tr("%1 segments").arg(size);
    return tr("%1 knots").arg(size);
}

} // namespace campanel::panel
