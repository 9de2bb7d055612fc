// SPDX-License-Identifier: Apache-2.0
#include "app/panel/explain/explanations.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/engine_instances.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "profile/cutter/explain.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/ratios.h"
#include "profile/moves/position_move.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

// Returns the text when all numbers are known, else an empty one.
QString ifKnown(std::initializer_list<double> numbers, const QString& text)
{
    for (const double number : numbers) {
        if (!std::isfinite(number))
            return {};
    }
    return text;
}

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

} // namespace

QString Explanation::text() const
{
    QString lines = meaning + u"\n\n"_s + formula;
    if (!numbers.isEmpty())
        lines += u"\n= "_s + numbers;
    return lines + u"\n= "_s + (unit.isEmpty() ? value : value + u' ' + unit);
}

Explanations::Explanations(const Sources& sources, QObject* parent)
    : QObject(parent)
    , m_machine(sources.machine)
    , m_editor(sources.editor)
    , m_figures(sources.figures)
    , m_trends(sources.trends)
{
}

Explanations* Explanations::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<Explanations>(qmlEngine);
}

Explanation Explanations::of(int quantity) const
{
    const auto wanted = static_cast<Topic>(quantity);
    switch (wanted) {
    case Rate:
        return rate();
    case BagMean:
    case BagScatter:
    case BagsWithin:
    case BagDeviation:
        return bags(wanted);
    case MarkError:
    case FilmSaved:
        return packing(wanted);
    case FollowingError:
        return followingError();
    case Torque:
        return torque();
    case GoodStrokes:
        return goodStrokes();
    case FastestRate:
        return fastestRate();
    case PeakMotorSpeed:
    case PeakAcceleration:
    case PeakFrequency:
    case SyncWindow:
    case SealTime:
    case RmsAcceleration:
    case SpeedRatio:
    case BaseCircleSpeed:
    case PeakTorque:
    case RmsTorque:
    case SealError:
        return peak(wanted);
    case LiveSealTime:
        return liveSealTime();
    case Coefficients:
        return coefficients();
    case WireShare:
        return wireShare();
    case AnswersHalf:
    case Answers95:
    case Answers99:
    case AnswersLongest:
        return answers(wanted);
    case AnswerAllowance:
        return answerAllowance();
    }
    return {};
}

QList<int> Explanations::ofVerdict() const
{
    const auto cutter = cutterOf(m_editor.recipe());
    if (!cutter)
        return coefficientsOf(m_editor.recipe()) ? QList<int>{Coefficients} : QList<int>{};
    QList<int> told;
    if (profile::fastestRate(*cutter))
        told << FastestRate;
    told << PeakMotorSpeed << PeakAcceleration << RmsAcceleration << PeakFrequency << SpeedRatio
         << BaseCircleSpeed;
    if (cutter->machine.contactAngleDeg > 0)
        told << SyncWindow << SealTime;
    if (cutter->machine.inertiaKgCm2 > 0)
        told << PeakTorque << RmsTorque;
    if (cutter->machine.naturalFrequencyHz > 0)
        told << SealError;
    return told;
}

Explanation Explanations::rate() const
{
    const Format format;
    const double rate = m_machine.live().rateBagsPerMin;
    const double program = m_machine.active().rateBagsPerMin;
    const double master = m_machine.live().masterSpeedPercent;
    Explanation told;
    told.title = tr("Rate");
    told.value = format.number(rate, 1);
    told.unit = tr("bags/min");
    told.meaning = tr("Bags per minute at the present master speed. This value is calculated, not counted.");
    told.formula = tr("rate of the program × master speed");
    told.numbers = ifKnown({rate, program, master},
                           u"%1 × %2 %"_s.arg(format.compact(program, 1, 4), format.compact(master, 0, 1)));
    return told;
}

Explanation Explanations::bags(Topic quantity) const
{
    const Format format;
    const auto series = m_machine.bags().series;
    const auto count = format.number(static_cast<double>(series.size()), 0);
    const double tolerance = m_machine.bags().toleranceMm;
    const double mean = m_machine.bags().meanDeviationMm;
    Explanation told;
    told.unit = tr("mm");
    switch (quantity) {
    case BagMean: {
        const double length = m_machine.bags().meanMm;
        told.title = tr("Mean bag length");
        told.value = format.number(length, 2);
        told.meaning =
            tr("Mean of the last bags (%1, at most 60) since the last change of the set length.").arg(count);
        told.formula = tr("set length + sum of their deviations / bags");
        told.numbers = ifKnown(
            {length, mean},
            u"%1 + %2 / %3"_s.arg(format.compact(length - mean, 1, 2),
                                  format.number(mean * static_cast<double>(series.size()), 2), count));
        break;
    }
    case BagScatter: {
        const double scatter = m_machine.bags().scatterMm;
        const double squares = scatter * scatter * static_cast<double>(series.size() - 1);
        told.title = tr("Standard deviation of the bag length");
        told.value = format.number(scatter, 2);
        told.meaning =
            tr("About two thirds of the last bags (%1) are closer to the mean than this value.").arg(count);
        told.formula = tr("√(sum of (deviation − mean deviation)² / (bags − 1))");
        told.numbers = ifKnown({scatter}, u"√(%1 / (%2 − 1))"_s.arg(format.compact(squares, 2, 4), count));
        break;
    }
    case BagsWithin:
        told.title = tr("Bags within the tolerance");
        told.value = format.number(m_machine.bags().within, 0);
        told.unit.clear();
        told.meaning =
            tr("Number of the last bags (%1) within ±%2 mm. Set the tolerance in Settings, Machine.")
                .arg(count, format.number(tolerance, 2));
        if (m_machine.bags().scrap > 0)
            told.meaning += u' ' + tr("Start-up scrap and bags of a change of program are left out: %1.")
                                       .arg(m_machine.bags().scrap);
        told.formula = tr("bags with a deviation within the tolerance");
        break;
    default: {
        const double deviation = m_machine.bags().deviationMm;
        const double length = m_machine.bags().lengthMm;
        told.title = tr("Deviation of the last bag");
        told.value = format.number(deviation, 2);
        told.meaning = tr("Positive: the bag is too long. With skipped cuts, the set length is the sum of "
                          "all lengths in the bag.");
        told.formula = tr("measured length − set length");
        told.numbers = ifKnown({deviation, length}, u"%1 − %2"_s.arg(format.number(length, 2),
                                                                     format.number(length - deviation, 2)));
        break;
    }
    }
    return told;
}

Explanation Explanations::packing(Topic quantity) const
{
    const Format format;
    const PackingLine& line = *m_machine.packing();
    Explanation told;
    if (quantity == MarkError) {
        told.title = tr("Mark error");
        told.value = format.number(line.markErrorMm(), 2);
        told.unit = tr("mm");
        told.meaning = tr("Mark error of the last cut with a mark, measured by the controller. Mark tracking "
                          "corrects a part of this error with each cut.");
        told.formula = tr("position of the cut − position required by its mark");
        return told;
    }
    const double saved = line.filmSavedM();
    const double bags = line.emptyBags();
    told.title = tr("Film saved");
    told.value = format.number(saved, 1);
    told.unit = tr("m");
    told.meaning = tr("Film that was not used because the film waited for missing products. Counted since "
                      "power-on of the controller.");
    told.formula = tr("skipped bags × their mean length");
    told.numbers = bags > 0
                       ? ifKnown({saved, bags},
                                 tr("%1 × %2 m").arg(format.number(bags, 0), format.number(saved / bags, 3)))
                       : QString();
    return told;
}

Explanation Explanations::followingError() const
{
    const Format format;
    const double error = m_machine.live().followingErrorMm;
    const double pulses = m_machine.live().followingErrorPulses;
    Explanation told;
    told.title = tr("Following error");
    told.value = format.number(error, 2);
    told.unit = tr("mm");
    told.meaning = tr("Last reported difference between commanded and actual position of the axis.");
    told.formula = tr("error in pulses / pulses per mm");
    if (m_machine.program())
        told.numbers = ifKnown({error, pulses},
                               u"%1 / %2"_s.arg(format.number(pulses, 0),
                                                format.compact(m_machine.program()->pulsesPerMm, 1, 3)));
    return told;
}

Explanation Explanations::torque() const
{
    const Format format;
    const TorqueWatch& torque = *m_machine.torque();
    const auto worst = torque.worst();
    Explanation told;
    told.title = tr("Torque, largest difference");
    told.value = format.number(torque.differencePercent(), 1);
    told.unit = u"%"_s;
    told.formula = tr("torque that the drive reports − (J α + friction), of the rated torque");
    const QString missing = torque.missingText();
    if (!missing.isEmpty())
        told.meaning = missing;
    else if (!worst)
        told.meaning = tr("Compared while the machine runs at full speed.");
    else
        told.meaning =
            tr("Largest of the last readings at full speed (%1), at %2° of the cycle. The drive lags "
               "behind the program, so the difference is largest where the acceleration changes fast.")
                .arg(torque.readings().size())
                .arg(format.number(worst->angleDeg, 0));
    if (worst)
        told.numbers = u"%1 % − %2 %"_s.arg(format.number(worst->measuredPercent, 1),
                                            format.number(worst->predictedPercent, 1));
    return told;
}

Explanation Explanations::goodStrokes() const
{
    const Format format;
    StrokeModel& strokes = *m_machine.strokes();
    Explanation told;
    told.title = tr("Good strokes");
    told.value = strokes.rows()->count() > 0 ? format.number(strokes.goodCount(), 0) : Format::unknownText();
    told.meaning =
        tr("Number of the last strokes (%1) that ended at the press position with a force of %2 to %3 N.")
            .arg(format.number(strokes.rows()->count(), 0),
                 format.number(m_machine.active().minStopForceN, 0),
                 format.number(m_machine.active().maxStopForceN, 0));
    told.formula = tr("strokes that the controller evaluated as good");
    return told;
}

Explanation Explanations::fastestRate() const
{
    const Format format;
    Explanation told;
    told.title = tr("Maximum possible rate");
    told.value = Format::unknownText();
    told.unit = tr("bags/min");
    const auto edited = cutterOf(m_editor.recipe());
    const auto fastest = edited ? profile::fastestRate(*edited) : std::nullopt;
    if (!fastest)
        return told;
    const std::optional cutter = atFastestRatios(*edited);
    told.value = format.compact(fastest->rateBagsPerMin, 1, 2);
    told.meaning = tr("Maximum rate with this bag length, law and machine; limited by: %1. Speeds rise with "
                      "the rate, acceleration with its square.")
                       .arg(RecipeWords::limitName(fastest->limitedBy));
    const profile::Peaks peaks = profile::peaks(*cutter);
    const profile::Machine& machine = cutter->machine;
    const QString rate = format.compact(cutter->cycle.rateBagsPerMin, 1, 2);
    const auto share = [&](double allowed, double actual) {
        told.formula = tr("rate × allowed / peak, rounded down");
        told.numbers =
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
        told.formula = tr("rate × √(allowed / peak), rounded down");
        told.numbers =
            u"%1 × √(%2 / %3)"_s.arg(rate, format.compact(machine.maxKnifeAccelerationMmPerS2 / 1000, 0, 2),
                                     format.compact(peaks.accelerationMmPerS2 / 1000, 0, 2));
        break;
    case profile::Limit::SealTime:
        told.formula = tr("rate × seal time / required seal time, rounded down");
        told.numbers =
            u"%1 × %2 / %3"_s.arg(rate, format.compact(profile::sealTimeMs(cutter->cycle, machine), 0, 2),
                                  format.compact(cutter->program.minSealTimeMs, 0, 0));
        break;
    case profile::Limit::MotorTorque:
        told.formula = tr("rate × √((allowed − friction) / (peak − friction)), rounded down");
        told.numbers = u"%1 × √((%2 − %4) / (%3 − %4))"_s.arg(rate, format.compact(machine.maxTorqueNm, 0, 3),
                                                              format.compact(peaks.torqueNm, 0, 3),
                                                              format.compact(machine.frictionNm, 0, 3));
        break;
    case profile::Limit::RmsTorque:
        told.formula = tr("rate × ((allowed² − friction²) / (RMS² − friction²))^(1/4), rounded down");
        told.numbers = u"%1 × ((%2² − %4²) / (%3² − %4²))^(1/4)"_s.arg(
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
        told.formula = tr("the limit itself");
        break;
    }
    return told;
}

Explanation Explanations::peak(Topic quantity) const
{
    const Format format;
    Explanation told;
    told.value = Format::unknownText();
    const auto cutter = cutterOf(m_editor.recipe());
    const auto take = [&](const QString& title, profile::CutterQuantity which) {
        told.title = title;
        if (!cutter)
            return;
        const profile::Explanation explained = profile::explain(*cutter, which);
        told.formula = QString::fromStdString(explained.formula);
        told.numbers = ifKnown({explained.result}, QString::fromStdString(explained.numbers));
        const bool isSmall = quantity == PeakTorque || quantity == RmsTorque || quantity == SealError;
        told.value = format.compact(explained.result, 0, isSmall ? 3 : 2);
        told.unit = RecipeWords::unit(explained.unit);
    };
    if (quantity == PeakMotorSpeed) {
        take(tr("Peak motor speed"), profile::CutterQuantity::PeakMotorRpm);
        told.meaning = tr("Motor speed at the maximum knife speed.");
    } else if (quantity == PeakAcceleration) {
        take(tr("Peak knife acceleration"), profile::CutterQuantity::PeakAcceleration);
        told.meaning = tr("Acceleration at the fastest change of the knife speed.");
    } else if (quantity == SyncWindow) {
        take(tr("Sync window"), profile::CutterQuantity::SyncWindow);
        told.meaning =
            tr("Angle over which the knife moves at film speed. It must exceed the contact angle of "
               "the jaws by 2°.");
    } else if (quantity == SealTime) {
        take(tr("Seal time"), profile::CutterQuantity::SealTime);
        told.meaning = tr("Time of the jaws on the film at this rate.");
    } else if (quantity == RmsAcceleration) {
        take(tr("RMS knife acceleration"), profile::CutterQuantity::RmsAcceleration);
        told.meaning = tr("Root mean square of the acceleration over a cycle. It heats the motor; I2 is the "
                          "integral of the squared slope of the law.");
    } else if (quantity == SpeedRatio) {
        take(tr("Speed ratio k0"), profile::CutterQuantity::SpeedRatio);
        told.meaning = tr("Film speed divided by base speed, equation (9) of the paper. It follows from the "
                          "recipe.");
    } else if (quantity == BaseCircleSpeed) {
        take(tr("Speed of the base circle ω"), profile::CutterQuantity::BaseCircleSpeed);
        told.meaning =
            tr("Angular speed of the knife at base speed, equation (7) of the paper. Its base circle "
               "has the knife radius.");
    } else if (quantity == PeakTorque) {
        take(tr("Peak motor torque"), profile::CutterQuantity::PeakTorque);
        told.meaning = tr("Torque at the motor for the peak acceleration, plus friction.");
    } else if (quantity == RmsTorque) {
        take(tr("RMS motor torque"), profile::CutterQuantity::RmsTorque);
        told.meaning = tr("Root mean square over one cycle. It heats the motor, so it stays below the rated "
                          "torque.");
    } else if (quantity == SealError) {
        take(tr("Error while sealing"), profile::CutterQuantity::SealError);
        told.meaning =
            tr("Vibration of the knife shaft, peak to peak, between both ends of the sealing window.");
    } else {
        take(tr("Peak pulse frequency"), profile::CutterQuantity::PeakFrequency);
        told.meaning = tr("Output frequency of the controller at the maximum knife speed.");
    }
    return told;
}

Explanation Explanations::liveSealTime() const
{
    const Format format;
    const double time = m_machine.live().sealTimeMs;
    Explanation told;
    told.title = tr("Seal time");
    told.value = format.number(time, 0);
    told.unit = tr("ms");
    told.meaning =
        tr("Time of the jaws on the film at the present rate. The contact angle is that of the recipe "
           "on the Motion page.");
    told.formula = tr("60 000 × arc of the jaws / (sync ratio × bag length × rate)");
    if (const auto& program = m_machine.program(); program && program->recipe.isCutter()) {
        profile::Machine machine = program->recipe.machine;
        machine.contactAngleDeg = m_machine.contactAngleDeg();
        told.numbers = ifKnown({time}, u"60 000 × %1 / (%2 × %3 × %4)"_s.arg(
                                           format.compact(profile::jawArcMm(machine), 0, 2),
                                           format.compact(program->recipe.cutter().syncRatio, 0, 3),
                                           format.compact(program->bagLengthMm, 0, 2),
                                           format.compact(m_machine.live().rateBagsPerMin, 0, 2)));
    }
    return told;
}

Explanation Explanations::coefficients() const
{
    Explanation told;
    told.title = tr("Coefficients C0 to C%1");
    told.value = Format::unknownText();
    const auto move = coefficientsOf(m_editor.recipe());
    if (!move)
        return told;
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
    told.title = told.title.arg(degree);
    told.meaning =
        tr("The law is the polynomial s = C0 + C1 t + C2 t^2 … of the paper, s in mm and t in ms: %1.")
            .arg(names.join(u", "_s));
    told.formula = u"s(T) = "_s + terms.join(u" + "_s);
    told.numbers = numbers.join(u" + "_s);
    told.value = Format().compact(move->distanceMm, 1, 3);
    told.unit = tr("mm");
    return told;
}

} // namespace campanel::panel
