// SPDX-License-Identifier: Apache-2.0
// The position of a cut. The controller cuts when distance + offset (its parameters) of film have passed
// since the sensor detected the mark. The mark has then passed the knife by distance + offset - true
// distance. So the true distance is distance + offset - measured distance behind the mark. Whole bag lengths
// make no difference: all marks are equal.
#include "app/panel/packing/mark_wizard.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/packing/packing_fields.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

constexpr auto distanceName = "parameter.mark_distance";
constexpr auto offsetName = "parameter.mark_offset";
constexpr auto phaseLimitName = "parameter.phase_limit";
constexpr int watchedBags = 5;
constexpr double rightWithinMm = 0.3; // tolerance of their mean mark error
// The bags until the correction has settled. The controller corrects a quarter of a mark's error
// (parameter.phase_gain): 0.75^20 of it remains.
constexpr int settlingBags = 20;
constexpr double scatterMm = 1.0; // measurements with a larger scatter are of other bags or marks
constexpr double umPerMm = 1000.0;

QString millimeters(double value, int decimals)
{
    return Format().measure(value, decimals, QStringLiteral("mm"));
}

} // namespace

MarkWizard::MarkWizard(Controller& controller, PackingFields& fields, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_fields(fields)
{
    connect(controller.packing(), &PackingLine::changed, this, &MarkWizard::followBags);
    connect(controller.packing(), &PackingLine::bagRecorded, this, [this](const modbus::BagRecord& bag) {
        if (m_step != Step::Watch || !m_firstBag || !bag.isTracked ||
            bag.number <= *m_firstBag + static_cast<std::uint32_t>(bagsUnderWay()))
            return;
        m_errorsMm << bag.markErrorMm;
        if (m_errorsMm.size() > watchedBags)
            m_errorsMm.removeFirst();
    });
    connect(&controller, &Controller::stateChanged, this, &MarkWizard::changed);
    connect(&controller, &Controller::connectionChanged, this, [this] {
        if (!m_controller.isConnected())
            m_isRulerAsked = false;
        emit changed();
    });
    connect(&fields, &PackingFields::changed, this, &MarkWizard::changed);
    connect(&fields, &PackingFields::written, this, &MarkWizard::takeWritten);
    connect(&m_measurement, &Value::setRequested, this, &MarkWizard::addMeasurement);
    connect(this, &MarkWizard::changed, this, &MarkWizard::updateMeasurement);
    updateMeasurement();
    connect(&controller.link(), &link::Link::rulerRead, this, &MarkWizard::takeRuler);
    LanguageNotifier::follow(this);
}

void MarkWizard::setStep(Step step)
{
    m_step = step;
    m_steppedAt = m_controller.now();
    const auto& status = m_controller.packing()->status();
    // Earlier readings are of bags cut with the old distance.
    m_firstBag.reset();
    if (status && step != Step::Watch)
        m_firstBag = status->bagNumber;
    m_errorsMm.clear();
    emit changed();
}

void MarkWizard::restart()
{
    m_measuredMm.clear();
    m_ruler.reset();
    m_isSameBag = false;
    m_failure.clear();
    m_newMm = unknown;
    m_fields.read();
    setStep(Step::Explain);
}

QString MarkWizard::blockedReason() const
{
    const bool needsRun = m_step == Step::Explain || m_step == Step::Cutting || m_step == Step::Watch;
    if (m_step == Step::Done || m_step == Step::Failed || m_step == Step::Writing)
        return {};
    if (const QString reason = m_controller.blockedReason(Action::SetUpMarks); !reason.isEmpty())
        return reason;
    if (!m_controller.packing()->known())
        return tr(
            "The controller has no program for a packing machine. Download a recipe of a rotary cutter.");
    const QString reason = needsRun ? m_controller.blockedReason(Action::MeasureMarks) : QString();
    if (!reason.isEmpty())
        return reason;
    if (needsRun && m_controller.packing()->markState() == PackingLine::MarkState::Off)
        return tr("Mark tracking is off. Switch mark tracking on first.");
    if (needsRun && m_controller.packing()->markState() != PackingLine::MarkState::Tracking)
        return tr("Waiting for the cuts to reach the marks …");
    if (!std::isfinite(m_fields.value(distanceName)) || !std::isfinite(m_fields.value(offsetName)))
        return tr("Waiting for the controller …");
    if (m_step == Step::Confirm && !std::isfinite(newDistanceMm()))
        return tr("The corrected distance is outside the controller's range. Measure again.");
    return {};
}

bool MarkWizard::canGoOn() const
{
    if (!blockedReason().isEmpty())
        return false;
    return m_step == Step::Explain || m_step == Step::Confirm ||
           (m_step == Step::Measure && !m_measuredMm.isEmpty());
}

void MarkWizard::goOn()
{
    if (!m_controller.accessCheck().require(Level::Technician) || !canGoOn())
        return;
    switch (m_step) {
    case Step::Explain:
        m_oldMm = m_fields.value(distanceName);
        m_offsetMm = m_fields.value(offsetName);
        setStep(Step::Cutting);
        return;
    case Step::Measure:
        setStep(Step::Confirm);
        return;
    case Step::Confirm:
        m_newMm = newDistanceMm();
        setStep(Step::Writing);
        m_fields.write(distanceName, m_newMm);
        return;
    default:
        return;
    }
}

int MarkWizard::bagsSinceStep() const
{
    const auto& status = m_controller.packing()->status();
    return status && m_firstBag && status->bagNumber >= *m_firstBag
               ? static_cast<int>(status->bagNumber - *m_firstBag)
               : 0;
}

// Returns the bags whose marks had passed the sensor before the new distance, and one for each end.
int MarkWizard::bagsUnderWay() const
{
    const double bagMm = m_controller.active().bagLengthMm;
    const double distanceMm = std::isfinite(m_newMm) ? m_newMm : 0.0;
    return bagMm > 0 ? static_cast<int>(std::ceil(distanceMm / bagMm)) + 2 : 0;
}

// Returns the maximum: until the cuts have moved by the whole correction and have settled.
int MarkWizard::bagsToWatch() const
{
    const double limitMm = m_fields.value(phaseLimitName);
    const double correctionMm = std::isfinite(m_newMm) ? std::abs(m_newMm - m_oldMm) : 0.0;
    const int moving = limitMm > 0 ? static_cast<int>(std::ceil(correctionMm / limitMm)) : 0;
    return bagsUnderWay() + moving + settlingBags + watchedBags;
}

void MarkWizard::followBags()
{
    const auto& status = m_controller.packing()->status();
    if (status && m_firstBag && status->bagNumber < *m_firstBag)
        m_firstBag = status->bagNumber; // the controller restarted its count
    // Untracked bags do not count.
    if (m_step == Step::Cutting && !blockedReason().isEmpty() && status)
        m_firstBag = status->bagNumber;
    if (m_step == Step::Cutting && bagsSinceStep() >= bagsToCut)
        setStep(Step::Measure);
    if (m_step == Step::Watch && status && !m_firstBag && m_controller.packing()->receivedAt() >= m_steppedAt)
        m_firstBag = status->bagNumber;
    if (m_step == Step::Watch && m_errorsMm.size() == watchedBags)
        judgeBags();
    emit changed();
}

// Judges the last bags: correct, or too late to become correct.
void MarkWizard::judgeBags()
{
    const double meanErrorMm = mean(m_errorsMm);
    if (std::abs(meanErrorMm) <= rightWithinMm) {
        setStep(Step::Done);
    } else if (bagsSinceStep() >= bagsToWatch()) {
        m_failure = tr("The distance was written, but the cuts of the last bags deviate by %1 from their "
                       "marks on average. Check gains and film before you measure again.")
                        .arg(millimeters(meanErrorMm, 2));
        setStep(Step::Failed);
    }
}

// Allows a bag length to either side.
void MarkWizard::updateMeasurement()
{
    const double bagMm = m_controller.active().bagLengthMm;
    const double maxMm = std::isfinite(bagMm) ? bagMm : 0.0;
    m_measurement.show({tr("Cut offset behind its mark"), QStringLiteral("mm"), Format::unknownText(), -maxMm,
                        maxMm, 0.0, 2});
}

void MarkWizard::addMeasurement(double behindMm)
{
    if (m_step != Step::Measure || m_measuredMm.size() >= maxMeasured || !m_measurement.isInRange(behindMm))
        return;
    m_measuredMm << behindMm;
    m_isSameBag = false;
    emit changed();
}

void MarkWizard::dropMeasurement()
{
    if (m_step != Step::Measure || m_measuredMm.isEmpty())
        return;
    m_measuredMm.removeLast();
    m_ruler.reset();
    m_isSameBag = false;
    emit changed();
}

bool MarkWizard::canReadRuler() const
{
    return m_step == Step::Measure && m_controller.simulated() && m_controller.isConnected() &&
           !m_isRulerAsked && m_measuredMm.size() < maxMeasured;
}

void MarkWizard::measureSimulatedBag()
{
    if (!canReadRuler())
        return;
    m_isRulerAsked = true;
    m_controller.link().measureSimulatedBag();
    emit changed();
}

void MarkWizard::takeRuler(const link::RulerOutcome& outcome)
{
    if (!m_isRulerAsked)
        return;
    m_isRulerAsked = false;
    const bool isSame = m_ruler && m_ruler->end == link::RulerEnd::Read &&
                        outcome.end == link::RulerEnd::Read && m_ruler->lengthMm == outcome.lengthMm &&
                        m_ruler->behindMarkMm == outcome.behindMarkMm;
    m_ruler = outcome;
    if (outcome.end == link::RulerEnd::Read && !isSame)
        addMeasurement(outcome.behindMarkMm);
    m_isSameBag = isSame;
    emit changed();
}

double MarkWizard::meanMm() const
{
    return mean(m_measuredMm);
}

double MarkWizard::newDistanceMm() const
{
    const double bagMm = m_controller.active().bagLengthMm;
    const modbus::RegisterInfo* info = modbus::findRegister(distanceName);
    if (!(bagMm > 0) || !info)
        return unknown;
    const double correctionMm = std::remainder(m_offsetMm - meanMm(), bagMm);
    const double wantedMm = std::round((m_oldMm + correctionMm) * umPerMm) / umPerMm;
    return wantedMm >= info->minimum && wantedMm <= info->maximum ? wantedMm : unknown;
}

void MarkWizard::takeWritten(const QString& name, bool isDone, const QString& sentence)
{
    if (m_step != Step::Writing || name != QLatin1String(distanceName))
        return;
    if (!isDone)
        m_failure = sentence;
    setStep(isDone ? Step::Watch : Step::Failed);
}

double MarkWizard::progress() const
{
    const int wanted = m_step == Step::Cutting ? bagsToCut : m_step == Step::Watch ? bagsToWatch() : 0;
    return wanted > 0 ? std::min(1.0, static_cast<double>(bagsSinceStep()) / wanted) : 0.0;
}

QString MarkWizard::measuredText() const
{
    QStringList texts;
    for (const double value : m_measuredMm)
        texts << Format().number(value, 2);
    return texts.join(QStringLiteral(" · "));
}

QString MarkWizard::meanText() const
{
    return millimeters(meanMm(), 2);
}

QString MarkWizard::offsetText() const
{
    return millimeters(m_offsetMm, 2);
}

QString MarkWizard::oldText() const
{
    return millimeters(m_oldMm, 2);
}

QString MarkWizard::newText() const
{
    return millimeters(std::isfinite(m_newMm) ? m_newMm : newDistanceMm(), 2);
}

QString MarkWizard::rulerText() const
{
    if (m_isSameBag)
        return tr("This bag has been measured already. Wait for the next bag.");
    if (!m_ruler || m_ruler->end == link::RulerEnd::Read)
        return {};
    return m_ruler->end == link::RulerEnd::NoBag ? tr("No bag has been cut yet.")
                                                 : tr("The simulated machine cannot be measured now.");
}

QString MarkWizard::watchedText() const
{
    return tr("The new distance is active, and the cuts of the last bags are within %1 of the target. "
              "Measure one more bag to be sure; without Save, the distance is lost at power-off.")
        .arg(millimeters(rightWithinMm, 1));
}

QString MarkWizard::text() const
{
    switch (m_step) {
    case Step::Explain:
        return tr("When all cuts deviate from their marks by the same distance, the distance from mark "
                  "sensor to knife is set wrong. The machine cuts a few bags, you measure the cuts from "
                  "their marks, and the panel corrects the distance after you confirm.");
    case Step::Cutting:
        return tr("%1 of %2 bags cut. Keep the bags in order and do not stretch them.")
            .arg(bagsSinceStep())
            .arg(bagsToCut);
    case Step::Measure: {
        const auto [least, most] = std::minmax_element(m_measuredMm.begin(), m_measuredMm.end());
        if (!rulerText().isEmpty())
            return rulerText();
        if (m_measuredMm.size() > 1 && *most - *least > scatterMm)
            return tr("The measurements differ by %1. Check that all of them start at the same edge of the "
                      "mark.")
                .arg(millimeters(*most - *least, 1));
        return tr("Measure from the printed mark to the cut: positive if the cut comes after its mark, "
                  "negative if the cut comes before its mark. The mean of up to %1 bags counts.")
            .arg(maxMeasured);
    }
    case Step::Confirm:
        return tr(
            "This value becomes the distance from mark sensor to knife. The cuts shift over the next bags.");
    case Step::Writing:
        return tr("Writing and reading back …");
    case Step::Watch:
        return tr("Written and read back. The new distance reaches the knife with bag %1 of at most %2.")
            .arg(bagsSinceStep())
            .arg(bagsToWatch());
    case Step::Done:
        return watchedText();
    case Step::Failed:
        return m_failure;
    }
    return {};
}

} // namespace campanel::panel
