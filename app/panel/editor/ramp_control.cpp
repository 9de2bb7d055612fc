// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/ramp_control.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "profile/cutter/ratios.h"

#include <QtNumeric>

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

constexpr double windowStep = 0.01; // of the cycle
constexpr double mmPerM = 1000;

// Returns the machine's number behind a limit of a cutter.
std::optional<profile::Field> machineField(profile::Limit limit)
{
    using profile::Field;
    using profile::Limit;
    switch (limit) {
    case Limit::MotorSpeed:
        return Field::MaxMotorRpm;
    case Limit::KnifeAcceleration:
        return Field::MaxKnifeAcceleration;
    case Limit::PulseFrequency:
        return Field::MaxPulseFrequency;
    case Limit::MachineRate:
        return Field::MaxRate;
    case Limit::MotorTorque:
        return Field::MaxTorque;
    case Limit::RmsTorque:
        return Field::RatedTorque;
    case Limit::NaturalFrequency:
        return Field::NaturalFrequency;
    case Limit::JawWindow:
    case Limit::SealTime:
        return Field::ContactAngle;
    default:
        return std::nullopt; // a number of the recipe
    }
}

// Returns the machine's number that is exceeded, or that sets the highest rate.
std::optional<profile::Field> limitOf(const Solution& solution)
{
    if (!solution.refusals.empty())
        return machineField(solution.refusals.front().limit);
    return solution.fastest ? machineField(solution.fastest->limitedBy) : std::nullopt;
}

QString ratioModeName(profile::RatioMode mode)
{
    const auto options =
        program::choiceInfo(profile::ProgramKind::RotaryCutter, program::Choice::Ratios).options;
    const auto option =
        std::ranges::find(options, static_cast<std::uint16_t>(mode), &program::ChoiceOption::code);
    return option == options.end() ? QString() : RecipeWords::inWords(option->name);
}

} // namespace

RampControl::RampControl(QObject* parent)
    : QObject(parent)
{
}

void RampControl::show(const program::Recipe& recipe, const Solution& solution)
{
    m_isCutter = recipe.isCutter();
    m_program = m_isCutter ? recipe.cutter() : profile::RotaryCutterProgram{};
    m_machine = solution.solved ? solution.solved->machine : recipe.machine;
    m_offer = solution.refusals.empty() ? std::nullopt : solution.refusals.front().ramps;
    m_position = solution.cutter() ? profile::rampPosition(*solution.cutter()) : qQNaN();
    const auto limit = m_isCutter ? limitOf(solution) : std::nullopt;
    m_limitField = limit ? QString::fromUtf8(profile::info(*limit).id) : QString();
    showFigures(solution);
    emit changed();
}

void RampControl::showFigures(const Solution& solution)
{
    double acceleration = qQNaN();
    double rms = qQNaN();
    double speed = qQNaN();
    if (const auto* cutter = solution.cutter()) {
        acceleration = solution.solved->peaks.accelerationMmPerS2;
        rms = profile::rmsAcceleration(cutter->cycle, cutter->program);
        speed = solution.solved->peaks.motorRpm;
    }
    const Format format;
    m_figures.setRows(
        {{tr("Peak acceleration"), format.measure(acceleration / mmPerM, 2, QStringLiteral("m/s²"))},
         {tr("RMS acceleration"), format.measure(rms / mmPerM, 2, QStringLiteral("m/s²"))},
         {tr("Peak speed"), tr("%1 r/min").arg(format.number(speed, 0))},
         {tr("Highest rate"), solution.fastest ? RefusalSentences::valueWithUnit(
                                                     profile::Field::Rate, solution.fastest->rateBagsPerMin)
                                               : Format::unknownText()}});
}

QStringList RampControl::presets() const
{
    const auto with = [this](profile::RatioMode mode) {
        profile::RotaryCutterProgram program = m_program;
        program.ratioMode = mode;
        return profile::solve(profile::withRatios(program, m_machine), m_machine);
    };
    const auto slow = with(profile::RatioMode::Slow);
    const auto cool = with(profile::RatioMode::Cool);
    const auto gentle = with(profile::RatioMode::Gentle);
    if (!m_isCutter || !slow || !cool || !gentle)
        return {Format::unknownText(), Format::unknownText(), Format::unknownText()};
    const Format format;
    const auto acceleration = [&format](double mmPerS2) {
        return format.measure(mmPerS2 / mmPerM, 2, QStringLiteral("m/s²"));
    };
    return {tr("%1 r/min").arg(format.number(profile::peaks(*slow).motorRpm, 0)),
            acceleration(profile::rmsAcceleration(cool->cycle, cool->program)),
            acceleration(profile::peaks(*gentle).accelerationMmPerS2)};
}

QString RampControl::stateText() const
{
    const QString name = ratioModeName(m_program.ratioMode);
    if (m_program.ratioMode == profile::RatioMode::Between)
        return tr("Ratios: %1 %", "position between slow and gentle")
            .arg(Format().number(m_program.rampPositionPercent, 0));
    return tr("Ratios: %1", "set by hand, gentle, cool or slow").arg(name.toLower());
}

QString RampControl::windowText() const
{
    return tr("%1 %").arg(Format().number(100 * windowShare(), 1));
}

QString RampControl::offerName() const
{
    return m_offer ? RefusalSentences::rampsName(*m_offer) : QString();
}

QString RampControl::offerRate() const
{
    return m_offer ? RefusalSentences::rampsRate(*m_offer) : QString();
}

void RampControl::choose(int mode)
{
    if (!m_isCutter || mode < Gentle || mode > Slow)
        return;
    profile::RotaryCutterProgram program = m_program;
    program.ratioMode = static_cast<profile::RatioMode>(mode);
    emit edited(program);
}

void RampControl::begin()
{
    const profile::RotaryCutterProgram untouched;
    if (m_program.ratioMode == untouched.ratioMode && m_program.k == untouched.k)
        choose(Gentle);
}

void RampControl::drag(double position)
{
    if (!m_isCutter || !std::isfinite(position))
        return;
    profile::RotaryCutterProgram program = m_program;
    program.ratioMode = profile::RatioMode::Between;
    program.rampPositionPercent = profile::snapToGrid(profile::Field::RampPosition, position);
    emit dragged(program);
}

void RampControl::endDrag()
{
    emit dragEnded();
}

void RampControl::changeWindow(double change)
{
    if (!m_isCutter)
        return;
    const double step = std::round((windowShare() + change) / windowStep) * windowStep;
    if (step > 0)
        emit edited(profile::withWindow(m_program, m_machine, step));
}

void RampControl::widenWindow()
{
    changeWindow(windowStep);
}

void RampControl::narrowWindow()
{
    changeWindow(-windowStep);
}

void RampControl::takeOffer()
{
    if (!m_isCutter || !m_offer)
        return;
    profile::RotaryCutterProgram program = m_program;
    program.ratioMode = profile::RatioMode::Gentle;
    if (profile::isPinned(program, profile::Field::Rate))
        program.rateBagsPerMin = std::min(program.rateBagsPerMin, m_offer->rateBagsPerMin);
    emit edited(program);
}

} // namespace campanel::panel
