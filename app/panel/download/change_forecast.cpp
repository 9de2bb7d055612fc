// SPDX-License-Identifier: Apache-2.0
#include "app/panel/download/change_forecast.h"

#include "app/panel/controller/controller.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace campanel::panel {

namespace {

// In the order of the enum.
constexpr std::array names{"parameter.knife_step",      "parameter.film_step",   "parameter.infeed_step",
                           "parameter.film_pulses",     "parameter.film_feed",   "parameter.flight_pulses",
                           "parameter.mark_tracking",   "parameter.ramp_time",   "parameter.master_direction",
                           "parameter.anti_cut",        "parameter.phase_limit", "parameter.cut_clearance",
                           "parameter.product_distance"};
enum class Index {
    KnifeStep,
    FilmStep,
    InfeedStep,
    FilmPulses,
    FilmFeed,
    FlightPulses,
    MarkTracking,
    RampTime,
    Direction,
    AntiCut,
    PhaseLimit,
    CutClearance,
    ProductDistance,
};
constexpr std::array masterNames{"master.source", "master.speed_max", "master.engage"};
enum class Master { Source, SpeedMax, Engage };

} // namespace

ChangeForecast::ChangeForecast(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
{
    for (const char* name : names) {
        m_parameters.push_back(&controller.parameter(name));
        connect(m_parameters.back(), &Parameter::changed, this, &ChangeForecast::changed);
    }
    for (const char* name : masterNames) {
        m_master.push_back(&controller.parameter(name));
        connect(m_master.back(), &Parameter::changed, this, &ChangeForecast::changed);
    }
}

// Returns the encoder that leads the machine, if one does.
std::optional<program::LeadingLine> ChangeForecast::line() const
{
    const auto value = [this](Master index) {
        return m_master[static_cast<std::size_t>(index)]->lastValue();
    };
    if (m_master.front()->isMissing() ||
        value(Master::Source) != static_cast<double>(modbus::MasterSource::Encoder))
        return std::nullopt;
    return program::LeadingLine{.share = m_controller.live().masterSpeedPercent / 100,
                                .maxShare = value(Master::SpeedMax) / 100,
                                .engage = value(Master::Engage) / 100};
}

std::optional<program::ChangeParameters> ChangeForecast::parameters() const
{
    const auto isKnown = [](const Parameter* each) { return each->value().has_value(); };
    if (!std::ranges::all_of(m_parameters, isKnown) ||
        !(m_master.front()->isMissing() || std::ranges::all_of(m_master, isKnown)))
        return std::nullopt;
    using enum Index;
    const auto value = [this](Index index) {
        return m_parameters[static_cast<std::size_t>(index)]->lastValue();
    };
    const bool hasFilm = m_controller.packing()->present();
    return program::ChangeParameters{
        .knifeStepHz = value(KnifeStep),
        .filmStepHz = value(FilmStep),
        .infeedStepHz = value(InfeedStep),
        .filmPulsesPerMm = hasFilm ? value(FilmPulses) / value(FilmFeed) : 0.0,
        .flightPulses = value(FlightPulses),
        .rampS = value(RampTime) / 1000,
        .isReversed = value(Direction) != 0,
        .hasAntiCut = value(AntiCut) != 0,
        .line = line(),
    };
}

// Products are as long as the longest that the controller sees.
program::PriceParameters ChangeForecast::priceParameters() const
{
    using enum Index;
    const auto value = [this](Index index) {
        return m_parameters[static_cast<std::size_t>(index)]->lastValue();
    };
    double productMm = 0;
    for (const QPointF& product : m_controller.packing()->seenProducts())
        productMm = std::max(productMm, std::abs(product.y() - product.x()));
    return {.tracksMarks = value(MarkTracking) != 0,
            .phaseLimitMm = value(PhaseLimit),
            .productMm = productMm,
            .clearanceMm = value(CutClearance),
            .layDistanceMm = value(ProductDistance),
            .hasAntiCut = value(AntiCut) != 0};
}

void ChangeForecast::update(const program::ProgramImage* wanted)
{
    m_isKnown = false;
    m_price.reset();
    const auto& active = m_controller.program();
    if (wanted == nullptr || !active || m_controller.state() != Controller::State::Running ||
        !program::changesWhileRunning(active->recipe, wanted->recipe))
        return;
    for (Parameter* parameter : m_parameters)
        parameter->readIfUncertain();
    for (Parameter* parameter : m_master)
        parameter->readIfUncertain();
    const auto known = parameters();
    const auto solved = program::solveProgram(active->recipe);
    if (!known || !solved)
        return;
    m_isKnown = true;
    m_change = program::programChange(active->recipe, *solved, wanted->recipe, wanted->solved, *known);
    const bool hasBags = wanted->recipe.isCutter();
    m_rateBagsPerMin = hasBags ? wanted->cutter().cycle.rateBagsPerMin : 0.0;
    if (!m_change || !hasBags || !m_controller.packing()->known())
        return;
    m_price = program::changePrice(*solved, wanted->solved, *m_change, priceParameters());
    m_film = program::changeFilm(*solved, wanted->solved, *m_change, *m_price);
}

QString ChangeForecast::text() const
{
    const QString change = ControllerSentences::programChange(
        m_isKnown && m_change ? *m_change : program::ProgramChange{}, m_rateBagsPerMin);
    return m_price ? change + u' ' + ControllerSentences::changePrice(*m_price) : change;
}

QList<QPointF> ChangeForecast::speeds() const
{
    if (!m_isKnown || !m_change || !(m_change->timeS > 0))
        return {};
    const bool rests = m_change->way == program::ChangeWay::LeavesLine;
    const double boundary = rests ? 0.0 : m_change->shareBefore / m_change->speedBefore;
    const double behind = rests ? 1.0 : m_change->speedRatio;
    return {{0, 100}, {m_change->slowingS, 100 * boundary}, {m_change->timeS, 100 * behind}};
}

QString ChangeForecast::refusal() const
{
    if (!m_isKnown)
        return {};
    if (!m_change)
        return ControllerSentences::refusal(modbus::Refusal::StepTooLarge);
    return m_change->way == program::ChangeWay::TooFast
               ? ControllerSentences::refusal(modbus::Refusal::MasterTooFast)
               : QString();
}

} // namespace campanel::panel
