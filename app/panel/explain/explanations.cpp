// SPDX-License-Identifier: Apache-2.0
#include "app/panel/explain/explanations.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/packing/mark_edge_list.h"
#include "app/panel/words/refusal_sentences.h"
#include "profile/cutter/jaw.h"

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

} // namespace

QString Explanation::text() const
{
    QString lines = meaning + u"\n\n"_s + formula;
    if (!numbers.isEmpty())
        lines += u"\n= "_s + numbers;
    const QString known = Format::joined(value, unit);
    return lines + u"\n= "_s + (result.isEmpty() ? known : result + u" = "_s + known);
}

void Explanation::setMeasure(double number, int least, int most, const QString& metricUnit)
{
    const Format format;
    const ShownUnit shown = Units::of(metricUnit);
    value = least == most ? format.amount(number, most, metricUnit)
                          : format.compactAmount(number, least, most, metricUnit);
    unit = shown.unit;
    if (shown.isConverted() && std::isfinite(number))
        result = Format::joined(format.compact(number, least, most), metricUnit);
}

Explanations::Explanations(const Sources& sources, QObject* parent)
    : QObject(parent)
    , m_controller(sources.controller)
    , m_editor(sources.editor)
    , m_figures(sources.figures)
    , m_trends(sources.trends)
    , m_stops(sources.stops)
    , m_edges(sources.edges)
{
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
    case MarkDistance:
        return markDistance();
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
    case ShaftVibration:
        return shaftVibration();
    case WireShare:
        return wireShare();
    case AnswersHalf:
    case Answers95:
    case Answers99:
    case AnswersLongest:
        return answers(wanted);
    case AnswerAllowance:
        return answerAllowance();
    case Availability:
    case Performance:
    case Quality:
    case Oee:
        return effectiveness(wanted);
    }
    return {};
}

Explanation Explanations::rate() const
{
    const Format format;
    const double rate = m_controller.live().rateBagsPerMin;
    const double program = m_controller.active().rateBagsPerMin;
    const double master = m_controller.live().masterSpeedPercent;
    Explanation explanation;
    explanation.title = tr("Rate");
    explanation.value = format.number(rate, 1);
    explanation.unit = tr("bags/min");
    explanation.meaning =
        tr("Bags per minute at the present master speed. This value is calculated, not counted.");
    explanation.formula = tr("rate of the program × master speed");
    explanation.numbers = ifKnown({rate, program, master}, u"%1 × %2 %"_s.arg(format.compact(program, 1, 4),
                                                                              format.compact(master, 0, 1)));
    return explanation;
}

Explanation Explanations::bags(Topic quantity) const
{
    const Format format;
    const int counted = m_controller.bags().counted;
    const auto count = format.number(counted, 0);
    const double tolerance = m_controller.bags().toleranceMm;
    const double mean = m_controller.bags().meanDeviationMm;
    Explanation explanation;
    switch (quantity) {
    case BagMean: {
        const double length = m_controller.bags().meanMm;
        explanation.title = tr("Mean bag length");
        explanation.setMeasure(length, 2, 2, u"mm"_s);
        explanation.meaning =
            tr("Mean of the last bags (%1, at most 60) since the last change of the set length.").arg(count);
        explanation.formula = tr("set length + sum of their deviations / bags");
        explanation.numbers =
            ifKnown({length, mean}, u"%1 + %2 / %3"_s.arg(format.compact(length - mean, 1, 2),
                                                          format.number(mean * counted, 2), count));
        break;
    }
    case BagScatter: {
        const double scatter = m_controller.bags().scatterMm;
        const double squares = scatter * scatter * (counted - 1);
        explanation.title = tr("Standard deviation of the bag length");
        explanation.setMeasure(scatter, 2, 2, u"mm"_s);
        explanation.meaning =
            tr("About two thirds of the last bags (%1) are closer to the mean than this value.").arg(count);
        explanation.formula = tr("√(sum of (deviation − mean deviation)² / (bags − 1))");
        explanation.numbers =
            ifKnown({scatter}, u"√(%1 / (%2 − 1))"_s.arg(format.compact(squares, 2, 4), count));
        break;
    }
    case BagsWithin:
        explanation.title = tr("Bags within the tolerance");
        explanation.value = format.number(m_controller.bags().within, 0);
        explanation.meaning =
            tr("Number of the last bags (%1) within ±%2. Set the tolerance in Settings, Machine.")
                .arg(count, format.measure(tolerance, 2, u"mm"_s));
        if (m_controller.bags().scrap > 0)
            explanation.meaning += u' ' + tr("Start-up scrap, bags of a change of program and those at jaws "
                                             "that stood or jammed are left out: %1.")
                                              .arg(m_controller.bags().scrap);
        explanation.formula = tr("bags with a deviation within the tolerance");
        break;
    default: {
        const double deviation = m_controller.bags().deviationMm;
        const double length = m_controller.bags().lengthMm;
        explanation.title = tr("Deviation of the last bag");
        explanation.setMeasure(deviation, 2, 2, u"mm"_s);
        explanation.meaning =
            tr("Positive: the bag is too long. With skipped cuts, the set length is the sum of "
               "all lengths in the bag.");
        explanation.formula = tr("measured length − set length");
        explanation.numbers =
            ifKnown({deviation, length},
                    u"%1 − %2"_s.arg(format.number(length, 2), format.number(length - deviation, 2)));
        break;
    }
    }
    return explanation;
}

Explanation Explanations::packing(Topic quantity) const
{
    const Format format;
    Explanation explanation;
    if (quantity == MarkError) {
        explanation.title = tr("Mark error");
        explanation.setMeasure(m_controller.telemetry()->number("packer.mark_error"), 2, 2, u"mm"_s);
        explanation.meaning =
            tr("Mark error of the last cut with a mark, measured by the controller. Mark tracking "
               "corrects a part of this error with each cut.");
        explanation.formula = tr("position of the cut − position required by its mark");
        return explanation;
    }
    const double saved = m_controller.telemetry()->number("packer.film_saved");
    explanation.title = tr("Film saved");
    explanation.setMeasure(saved, 1, 1, u"m"_s);
    explanation.meaning =
        tr("Film that was not used because the film waited for missing products. Counted since "
           "power-on of the controller.");
    explanation.formula = tr("missing products × bag length at that time");
    return explanation;
}

Explanation Explanations::markDistance() const
{
    Explanation explanation;
    explanation.title = tr("Distance from the expected mark");
    explanation.setMeasure(m_edges.newestOffMm(), 2, 2, u"mm"_s);
    explanation.meaning =
        tr("The distance of the newest edge of the mark sensor from the place where the controller expected "
           "the mark. An edge inside the window is taken as the mark, any other is not.");
    explanation.formula = tr("place of the edge − place of the expected mark");
    return explanation;
}

Explanation Explanations::followingError() const
{
    const Format format;
    const double error = m_controller.live().followingErrorMm;
    const double pulses = m_controller.live().followingErrorPulses;
    Explanation explanation;
    explanation.title = tr("Following error");
    explanation.setMeasure(error, 2, 2, u"mm"_s);
    explanation.meaning = tr("Last reported difference between commanded and actual position of the axis.");
    explanation.formula = tr("error in pulses / pulses per mm");
    if (m_controller.program())
        explanation.numbers = ifKnown(
            {error, pulses}, u"%1 / %2"_s.arg(format.number(pulses, 0),
                                              format.compact(m_controller.program()->pulsesPerMm, 1, 3)));
    return explanation;
}

Explanation Explanations::torque() const
{
    const Format format;
    const TorqueWatch& torque = *m_controller.torque();
    const auto worst = torque.worst();
    Explanation explanation;
    explanation.title = tr("Torque, largest difference");
    explanation.value = format.number(torque.differencePercent(), 1);
    explanation.unit = u"%"_s;
    explanation.formula = tr("torque that the drive reports − (J α + friction), of the rated torque");
    const QString missing = torque.missingText();
    if (!missing.isEmpty())
        explanation.meaning = missing;
    else if (!worst)
        explanation.meaning = tr("Compared while the machine runs at full speed.");
    else
        explanation.meaning =
            tr("Largest of the last readings at full speed (%1), at %2° of the cycle. The drive lags "
               "behind the program, so the difference is largest where the acceleration changes fast.")
                .arg(torque.readings().size())
                .arg(format.number(worst->angleDeg, 0));
    if (worst)
        explanation.numbers = u"%1 % − %2 %"_s.arg(format.number(worst->measuredPercent, 1),
                                                   format.number(worst->predictedPercent, 1));
    return explanation;
}

Explanation Explanations::goodStrokes() const
{
    const Format format;
    StrokeModel& strokes = *m_controller.strokes();
    Explanation explanation;
    explanation.title = tr("Good strokes");
    explanation.value =
        strokes.rows()->count() > 0 ? format.number(strokes.goodCount(), 0) : Format::unknownText();
    explanation.meaning =
        tr("Number of the last strokes (%1) that ended at the press position with a force of %2 to %3 N.")
            .arg(format.number(strokes.rows()->count(), 0),
                 format.number(m_controller.active().minStopForceN, 0),
                 format.number(m_controller.active().maxStopForceN, 0));
    explanation.formula = tr("strokes that the controller evaluated as good");
    return explanation;
}

Explanation Explanations::liveSealTime() const
{
    const Format format;
    const double time = m_controller.live().sealTimeMs;
    Explanation explanation;
    explanation.title = tr("Seal time");
    explanation.value = format.number(time, 0);
    explanation.unit = tr("ms");
    explanation.meaning =
        tr("Time of the jaws on the film at the present rate. The contact angle is that of the recipe "
           "on the Motion page.");
    explanation.formula = tr("60 000 × arc of the jaws / (sync ratio × bag length × rate)");
    if (const auto& program = m_controller.program(); program && program->recipe.isCutter()) {
        profile::Machine machine = program->recipe.machine;
        machine.contactAngleDeg = m_controller.contactAngleDeg();
        explanation.numbers = ifKnown({time}, u"60 000 × %1 / (%2 × %3 × %4)"_s.arg(
                                                  format.compact(profile::jawArcMm(machine), 0, 2),
                                                  format.compact(program->recipe.cutter().syncRatio, 0, 3),
                                                  format.compact(program->bagLengthMm, 0, 2),
                                                  format.compact(m_controller.live().rateBagsPerMin, 0, 2)));
    }
    return explanation;
}

} // namespace campanel::panel
