// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/cutter_map.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/units.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "profile/cutter/paper_lengths.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

using profile::Field;

constexpr std::size_t lengthsOfMap = 200;
constexpr double secondsPerMin = 60;
const auto lineSpeedUnit = QStringLiteral("mm/s");

// Returns the recipe without what the map does not depend on, so that a drag computes no map again.
program::Recipe withoutDot(program::Recipe recipe, const profile::Machine& machine)
{
    const profile::RotaryCutterProgram defaults;
    profile::RotaryCutterProgram& cutter = recipe.cutter();
    cutter.pinned = defaults.pinned;
    cutter.bagLengthMm = defaults.bagLengthMm;
    cutter.rateBagsPerMin = defaults.rateBagsPerMin;
    if (cutter.ratioMode != profile::RatioMode::ByHand) { // the ramps follow the dot
        cutter.k.front() = defaults.k.front();
        cutter.k.back() = defaults.k.back();
        cutter.rampPositionPercent = defaults.rampPositionPercent;
    }
    recipe.machine = machine;
    return recipe;
}

} // namespace

CutterMap::CutterMap(QObject* parent)
    : Watched(parent)
{
    connect(this, &Watched::watchedChanged, this, [this] {
        updateMap();
        emit changed();
    });
}

void CutterMap::show(const program::Recipe& recipe, const Solution& solution,
                     const std::optional<modbus::Identity>& controller, std::optional<double> maxSpeedShare)
{
    const bool wasLed = m_maxSpeedShare.has_value();
    m_maxSpeedShare = maxSpeedShare;
    if (m_map && wasLed != m_maxSpeedShare.has_value())
        emit mapChanged();
    m_recipe = recipe;
    m_isKnown = recipe.isCutter() && solution.cutter() != nullptr;
    m_machine = controller ? program::withController(recipe.machine, *controller) : recipe.machine;
    updateMap();
    emit changed();
}

void CutterMap::updateMap()
{
    if (!watched() || !m_recipe.isCutter()) {
        m_mapOf.reset();
        setMap(nullptr);
        return;
    }
    program::Recipe wanted = withoutDot(m_recipe, m_machine);
    const bool isSeen =
        m_map && (!m_isKnown || (lengthMm() >= m_map->range.fromMm && lengthMm() <= m_map->range.toMm));
    if (isSeen && m_mapOf && sameRecipe(*m_mapOf, wanted))
        return;
    const profile::RotaryCutterProgram& cutter = m_recipe.cutter();
    auto map = profile::regimeMap(cutter, m_machine, profile::regimeRange(cutter, m_machine), lengthsOfMap);
    m_mapOf = std::move(wanted);
    setMap(map ? std::make_shared<const profile::RegimeMap>(std::move(*map)) : nullptr);
}

void CutterMap::setMap(std::shared_ptr<const profile::RegimeMap> map)
{
    const bool isSame = m_map == map;
    m_map = std::move(map);
    if (!isSame)
        emit mapChanged();
}

QVariant CutterMap::map() const
{
    if (!m_map || !m_maxSpeedShare)
        return m_map ? QVariant::fromValue(m_map) : QVariant();
    auto map = std::make_shared<profile::RegimeMap>(*m_map);
    map->maxRateBagsPerMin = 0;
    for (profile::RegimePoint& point : map->points) {
        point.rateBagsPerMin = toAxis(point.bagLengthMm, point.rateBagsPerMin);
        map->maxRateBagsPerMin = std::max(map->maxRateBagsPerMin, point.rateBagsPerMin);
    }
    return QVariant::fromValue(std::shared_ptr<const profile::RegimeMap>(std::move(map)));
}

// Returns the rate, or the speed of the line in the shown unit.
double CutterMap::toAxis(double lengthMm, double rateBagsPerMin) const
{
    return m_maxSpeedShare ? lengthMm * rateBagsPerMin / secondsPerMin * Units::of(lineSpeedUnit).factor
                           : rateBagsPerMin;
}

double CutterMap::onAxis() const
{
    return toAxis(lengthMm(), rateBagsPerMin());
}

QString CutterMap::axisUnit() const
{
    return m_maxSpeedShare ? Units::of(lineSpeedUnit).unit : RecipeWords::unit("bags/min");
}

QString CutterMap::lineSpeedText(double lengthMm, double rateBagsPerMin) const
{
    return Format().measure(lengthMm * rateBagsPerMin / secondsPerMin, 0, lineSpeedUnit);
}

QStringList CutterMap::limitNames() const
{
    QStringList names;
    if (m_map) {
        for (const profile::Limit limit : m_map->limits)
            names << RecipeWords::limitName(limit);
    }
    return names;
}

QList<double> CutterMap::paperLengths() const
{
    QList<double> lengths;
    for (const profile::PaperLength& each : profile::paperLengths)
        lengths << each.bagLengthMm;
    return lengths;
}

double CutterMap::lengthMm() const
{
    return m_recipe.isCutter() && m_isKnown ? m_recipe.cutter().bagLengthMm : unknown;
}

double CutterMap::rateBagsPerMin() const
{
    return m_recipe.isCutter() && m_isKnown ? m_recipe.cutter().rateBagsPerMin : unknown;
}

QString CutterMap::title() const
{
    return m_isKnown ? tr("%1 · %2", "%1: bag length, %2: rate")
                           .arg(RefusalSentences::valueWithUnit(Field::BagLength, lengthMm()),
                                RefusalSentences::valueWithUnit(Field::Rate, rateBagsPerMin()))
                     : QString();
}

QString CutterMap::text() const
{
    if (!m_map || !m_isKnown)
        return {};
    const profile::RegimePoint point = profile::regimePoint(m_recipe.cutter(), m_machine, lengthMm());
    const QString limit = RecipeWords::limitName(point.limit);
    if (m_maxSpeedShare && point.rateBagsPerMin > 0)
        return tr("Line up to %1; limited by: %2. This program: %3; the run ends above %4.",
                  "%1, %3, %4: speeds, %2: name of the limit")
            .arg(lineSpeedText(lengthMm(), point.rateBagsPerMin), limit,
                 lineSpeedText(lengthMm(), rateBagsPerMin()),
                 lineSpeedText(lengthMm(), *m_maxSpeedShare * rateBagsPerMin()));
    return point.rateBagsPerMin > 0
               ? tr("Up to %1; limited by: %2.", "%1: rate, %2: name of the limit")
                     .arg(RefusalSentences::valueWithUnit(Field::Rate, point.rateBagsPerMin), limit)
               : tr("No rate is possible; limited by: %1.", "name of the limit").arg(limit);
}

QString CutterMap::linesText() const
{
    QStringList texts;
    if (!m_map)
        return {};
    const profile::CutterLengths& lengths = m_map->lengths;
    const auto add = [&](double lineMm, const QString& text) {
        if (lineMm > m_map->range.fromMm && lineMm < m_map->range.toMm)
            texts << text;
    };
    add(lengths.jawMm, tr("Lmin: the jaws just fill the window"));
    add(lengths.equalSpeedMm, tr("h/c: the knife turns evenly"));
    add(lengths.dwellMm, tr("Lcrit: the longest ramps stop the knife"));
    return texts.join(QStringLiteral(" · "));
}

void CutterMap::drag(double lengthMm, double onAxis)
{
    if (!m_map || !std::isfinite(lengthMm) || !std::isfinite(onAxis))
        return;
    const double rateBagsPerMin = onAxis / toAxis(lengthMm, 1);
    const double stepMm = Units::isInch() ? 1.27 : 1; // a twentieth of an inch
    emit dragged(profile::snapToGrid(Field::BagLength, std::round(lengthMm / stepMm) * stepMm),
                 profile::snapToGrid(Field::Rate, std::round(rateBagsPerMin)));
}

void CutterMap::endDrag()
{
    if (m_map && m_recipe.isCutter() &&
        profile::regimeRange(m_recipe.cutter(), m_machine).toMm != m_map->range.toMm)
        m_mapOf.reset(); // the range follows the length
    updateMap();
    emit dragEnded();
}

} // namespace campanel::panel
