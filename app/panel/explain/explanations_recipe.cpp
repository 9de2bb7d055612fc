// SPDX-License-Identifier: Apache-2.0
// Explains the figures of the edited recipe: peaks, torque, fastest rate, coefficients; see explanations.h.
#include "app/panel/explain/explanations.h"

#include "app/panel/editor/editor.h"
#include "app/panel/words/recipe_words.h"
#include "profile/cutter/explain.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/ratios.h"
#include "profile/moves/position_move.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

std::optional<profile::RotaryCutter> cutterOf(const program::Recipe& recipe)
{
    if (!recipe.isCutter())
        return std::nullopt;
    const auto solved = program::solveProgram(recipe);
    return solved && solved->cutter ? solved->cutter : std::nullopt;
}

// A position move by a law that is one polynomial.
struct PolynomialMove {
    profile::PolynomialCoefficients coefficients{};
    double distanceMm = 0;
    double timeS = 0;
};

std::optional<PolynomialMove> coefficientsOf(const program::Recipe& recipe)
{
    const auto* move = std::get_if<profile::PositionMoveProgram>(&recipe.program);
    if (!move)
        return std::nullopt;
    const auto solved = profile::solve(*move, recipe.machine);
    if (!solved)
        return std::nullopt;
    const double timeS = solved->motion.durationS();
    const auto coefficients = profile::polynomialCoefficients(move->law, move->distanceMm, timeS);
    return coefficients ? std::optional(PolynomialMove{*coefficients, move->distanceMm, timeS})
                        : std::nullopt;
}

double vibrationOf(const Solution& solution, const program::Recipe& recipe)
{
    return solution.solved ? program::vibrationMm(recipe, *solution.solved)
                           : std::numeric_limits<double>::quiet_NaN();
}

// Returns the cutter with the ratios of its highest rate, at its own rate where they allow that.
profile::RotaryCutter atFastestRatios(const profile::RotaryCutter& cutter)
{
    if (cutter.program.ratioMode == profile::RatioMode::ByHand)
        return cutter;
    profile::RotaryCutterProgram fastest = profile::withFastestRatios(cutter);
    const auto atLowRate = profile::solve(fastest, cutter.machine);
    fastest.rateBagsPerMin = cutter.cycle.rateBagsPerMin;
    const auto solved = profile::solve(fastest, cutter.machine);
    return solved ? *solved : atLowRate.value_or(cutter);
}

// Explains the rate at which one of the ramps has the largest torque: friction adds to that of the ramp that
// speeds the knife up, and helps the other one.
void explainByTorque(Explanation& explanation, const QString& rate, const profile::Machine& machine,
                     const profile::Peaks& peaks)
{
    const Format format;
    const profile::TorqueLoad load = profile::knifeLoad(machine);
    const profile::AccelerationExtremes& extremes = peaks.extremes;
    const double friction = machine.frictionNm;
    const bool slows = load.slowingAllowance(machine.maxTorqueNm) * extremes.speedingMmPerS2 <
                       load.speedingAllowance(machine.maxTorqueNm) * extremes.slowingMmPerS2;
    const double peakNm = slows ? load.nmPerMmPerS2 * extremes.slowingMmPerS2 - friction
                                : load.nmPerMmPerS2 * extremes.speedingMmPerS2 + friction;
    explanation.formula =
        slows ? Explanations::tr("rate × √((allowed + friction) / (peak + friction)), rounded down")
              : Explanations::tr("rate × √((allowed − friction) / (peak − friction)), rounded down");
    explanation.numbers = u"%1 × √((%2 %5 %4) / (%3 %5 %4))"_s.arg(
        rate, format.compact(machine.maxTorqueNm, 0, 3), format.compact(peakNm, 0, 3),
        format.compact(friction, 0, 3), slows ? u"+"_s : u"−"_s);
}

} // namespace

QList<int> Explanations::ofVerdict() const
{
    const auto cutter = cutterOf(m_editor.recipe());
    QList<int> topics;
    if (!cutter) {
        if (coefficientsOf(m_editor.recipe()))
            topics << Coefficients;
        if (std::isfinite(vibrationOf(m_editor.solution(), m_editor.recipe())))
            topics << ShaftVibration;
        return topics;
    }
    if (profile::fastestRate(*cutter))
        topics << FastestRate;
    topics << PeakMotorSpeed << PeakAcceleration << RmsAcceleration << PeakFrequency << SpeedRatio
           << BaseCircleSpeed;
    if (cutter->machine.contactAngleDeg > 0)
        topics << SyncWindow << SealTime;
    if (cutter->machine.inertiaKgCm2 > 0)
        topics << PeakTorque << RmsTorque;
    if (cutter->machine.naturalFrequencyHz > 0)
        topics << SealError;
    return topics;
}

Explanation Explanations::fastestRate() const
{
    const Format format;
    Explanation explanation;
    explanation.title = tr("Maximum possible rate");
    explanation.value = Format::unknownText();
    explanation.unit = tr("bags/min");
    const auto edited = cutterOf(m_editor.recipe());
    const auto fastest = edited ? profile::fastestRate(*edited) : std::nullopt;
    if (!fastest)
        return explanation;
    const std::optional cutter = atFastestRatios(*edited);
    explanation.value = format.compact(fastest->rateBagsPerMin, 1, 2);
    explanation.meaning =
        tr("Maximum rate with this bag length, law and machine; limited by: %1. Speeds rise with "
           "the rate, acceleration with its square.")
            .arg(RecipeWords::limitName(fastest->limitedBy));
    const profile::Peaks peaks = profile::peaks(*cutter);
    const profile::Machine& machine = cutter->machine;
    const QString rate = format.compact(cutter->cycle.rateBagsPerMin, 1, 2);
    const auto share = [&](double allowed, double actual) {
        explanation.formula = tr("rate × allowed / peak, rounded down");
        explanation.numbers =
            u"%1 × %2 / %3"_s.arg(rate, format.compact(allowed, 0, 2), format.compact(actual, 0, 2));
    };
    switch (fastest->limitedBy) {
    case profile::Limit::MotorSpeed:
        share(machine.maxMotorRpm, peaks.motorRpm);
        break;
    case profile::Limit::PulseFrequency:
        share(machine.maxPulseFrequencyHz / 1000, peaks.pulseFrequencyHz / 1000);
        break;
    case profile::Limit::KnifeAcceleration:
        explanation.formula = tr("rate × √(allowed / peak), rounded down");
        explanation.numbers =
            u"%1 × √(%2 / %3)"_s.arg(rate, format.compact(machine.maxKnifeAccelerationMmPerS2 / 1000, 0, 2),
                                     format.compact(peaks.accelerationMmPerS2 / 1000, 0, 2));
        break;
    case profile::Limit::SealTime:
        explanation.formula = tr("rate × seal time / required seal time, rounded down");
        explanation.numbers =
            u"%1 × %2 / %3"_s.arg(rate, format.compact(profile::sealTimeMs(cutter->cycle, machine), 0, 2),
                                  format.compact(cutter->program.minSealTimeMs, 0, 0));
        break;
    case profile::Limit::MotorTorque:
        explainByTorque(explanation, rate, machine, peaks);
        break;
    case profile::Limit::RmsTorque:
        explanation.formula = tr("rate × ((allowed² − friction²) / (RMS² − friction²))^(1/4), rounded down");
        explanation.numbers = u"%1 × ((%2² − %4²) / (%3² − %4²))^(1/4)"_s.arg(
            rate, format.compact(machine.ratedTorqueNm, 0, 3), format.compact(peaks.rmsTorqueNm, 0, 3),
            format.compact(machine.frictionNm, 0, 3));
        break;
    case profile::Limit::NaturalFrequency:
        share(machine.naturalFrequencyHz, 1 / cutter->cycle.cycleTimeS);
        break;
    case profile::Limit::FieldRange:
        share(profile::info(profile::Field::BaseSpeed).max, peaks.speedMmPerS);
        break;
    default:
        explanation.formula = tr("the limit itself");
        break;
    }
    return explanation;
}

Explanation Explanations::peak(Topic quantity) const
{
    const Format format;
    Explanation explanation;
    explanation.value = Format::unknownText();
    const auto cutter = cutterOf(m_editor.recipe());
    const auto take = [&](const QString& title, profile::CutterQuantity which) {
        explanation.title = title;
        if (!cutter)
            return;
        const profile::Explanation explained = profile::explain(*cutter, which);
        explanation.formula = QString::fromStdString(explained.formula);
        explanation.numbers =
            std::isfinite(explained.result) ? QString::fromStdString(explained.numbers) : QString();
        const bool isSmall = quantity == PeakTorque || quantity == RmsTorque || quantity == SealError;
        explanation.setMeasure(explained.result, 0, isSmall ? 3 : 2, RecipeWords::unit(explained.unit));
    };
    if (quantity == PeakMotorSpeed) {
        take(tr("Peak motor speed"), profile::CutterQuantity::PeakMotorRpm);
        explanation.meaning = tr("Motor speed at the maximum knife speed.");
    } else if (quantity == PeakAcceleration) {
        take(tr("Peak knife acceleration"), profile::CutterQuantity::PeakAcceleration);
        explanation.meaning = tr("Acceleration at the fastest change of the knife speed.");
    } else if (quantity == SyncWindow) {
        take(tr("Sync window"), profile::CutterQuantity::SyncWindow);
        explanation.meaning =
            tr("Angle over which the knife moves at film speed. It must exceed the contact angle of "
               "the jaws by 2°.");
    } else if (quantity == SealTime) {
        take(tr("Seal time"), profile::CutterQuantity::SealTime);
        explanation.meaning = tr("Time of the jaws on the film at this rate.");
    } else if (quantity == RmsAcceleration) {
        take(tr("RMS knife acceleration"), profile::CutterQuantity::RmsAcceleration);
        explanation.meaning =
            tr("Root mean square of the acceleration over a cycle. It heats the motor; I2 is the "
               "integral of the squared slope of the law.");
    } else if (quantity == SpeedRatio) {
        take(tr("Speed ratio k0"), profile::CutterQuantity::SpeedRatio);
        explanation.meaning =
            tr("Film speed divided by base speed, equation (9) of the paper. It follows from the "
               "recipe.");
    } else if (quantity == BaseCircleSpeed) {
        take(tr("Speed of the base circle ω"), profile::CutterQuantity::BaseCircleSpeed);
        explanation.meaning =
            tr("Angular speed of the knife at base speed, equation (7) of the paper. Its base circle "
               "has the knife radius.");
    } else if (quantity == PeakTorque) {
        take(tr("Peak motor torque"), profile::CutterQuantity::PeakTorque);
        explanation.meaning = tr("Maximum torque at the motor. Friction adds to it while the knife speeds "
                                 "up, and helps while the knife slows down.");
    } else if (quantity == RmsTorque) {
        take(tr("RMS motor torque"), profile::CutterQuantity::RmsTorque);
        explanation.meaning =
            tr("Root mean square over one cycle. It heats the motor, so it stays below the rated "
               "torque.");
    } else if (quantity == SealError) {
        take(tr("Error while sealing"), profile::CutterQuantity::SealError);
        explanation.meaning =
            tr("Vibration of the knife shaft, peak to peak, between both ends of the sealing window.");
    } else {
        take(tr("Peak pulse frequency"), profile::CutterQuantity::PeakFrequency);
        explanation.meaning = tr("Output frequency of the controller at the maximum knife speed.");
    }
    return explanation;
}

Explanation Explanations::coefficients() const
{
    Explanation explanation;
    explanation.title = tr("Coefficients C0 to C%1");
    explanation.value = Format::unknownText();
    const auto move = coefficientsOf(m_editor.recipe());
    if (!move)
        return explanation;
    constexpr int digits = 6;
    std::size_t degree = move->coefficients.size() - 1;
    while (degree > 0 && move->coefficients[degree] == 0)
        --degree;
    QStringList names;
    QStringList terms;
    QStringList numbers;
    for (std::size_t i = 0; i <= degree; ++i) {
        const QString number = QString::number(move->coefficients[i], 'g', digits);
        names << u"C%1 = %2"_s.arg(i).arg(number);
        if (move->coefficients[i] == 0)
            continue;
        terms << u"C%1 T^%1"_s.arg(i);
        numbers << u"%1 × %2^%3"_s.arg(number).arg(1000 * move->timeS, 0, 'g', digits).arg(i);
    }
    explanation.title = explanation.title.arg(degree);
    explanation.meaning =
        tr("The law is the polynomial s = C0 + C1 t + C2 t^2 … of the paper, s in mm and t in ms: %1.")
            .arg(names.join(u", "_s));
    explanation.formula = u"s(T) = "_s + terms.join(u" + "_s);
    explanation.numbers = numbers.join(u" + "_s);
    explanation.setMeasure(move->distanceMm, 1, 3, u"mm"_s);
    return explanation;
}

// The equation is that of the sealing error; a move is observed after its end, without damping.
Explanation Explanations::shaftVibration() const
{
    const Format format;
    const program::Recipe& recipe = m_editor.recipe();
    const bool isCam = profile::camMaster(recipe.program) != nullptr;
    Explanation explanation;
    explanation.title = isCam ? tr("Vibration over the cycle") : tr("Vibration after the move");
    explanation.meaning = isCam ? tr("Error of the load behind the shaft, peak to peak over one cycle.")
                                : tr("Amplitude of the load behind the shaft after the end of the move.");
    const double vibrationMm = vibrationOf(m_editor.solution(), recipe);
    explanation.setMeasure(vibrationMm, 0, 3, u"mm"_s);
    explanation.formula = isCam ? u"max e − min e, e'' + 2 ζ ω e' + ω² e = −a − 2 ζ ω v, ω = 2 π f0"_s
                                : u"|∫ a e^(−i ω t) dt| / ω, ω = 2 π f0"_s;
    if (!std::isfinite(vibrationMm))
        return explanation;
    const profile::Machine& machine = m_editor.solution().solved->machine;
    const QString frequency = format.compact(machine.naturalFrequencyHz, 0, 1);
    const QString duration = format.compact(m_editor.solution().solved->cycleS(), 0, 4);
    explanation.numbers = isCam ? tr("f0 = %1 Hz, ζ = %2, T = %3 s")
                                      .arg(frequency, format.compact(machine.dampingRatio, 0, 3), duration)
                                : tr("f0 = %1 Hz, T = %2 s").arg(frequency, duration);
    return explanation;
}

} // namespace campanel::panel
