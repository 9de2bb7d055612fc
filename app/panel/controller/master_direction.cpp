// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/master_direction.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/connection_sentences.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::panel {

namespace {

// The maximum change of the angle between two statuses that shows the direction without doubt.
constexpr double maxTellingDeg = 150;
constexpr double minTellingDeg = 0.05; // the resolution of the status is 0.01

} // namespace

MasterDirection::MasterDirection(Controller& controller)
    : QObject(&controller)
    , m_controller(controller)
    , m_parameter(controller.parameter("parameter.master_direction"))
{
    connect(&m_parameter, &Parameter::changed, this, &MasterDirection::changed);
    LanguageNotifier::follow(this);
}

std::optional<int> MasterDirection::programSign() const
{
    const auto* program = m_controller.program().get();
    const profile::CamMaster* cam = program ? profile::camMaster(program->recipe.program) : nullptr;
    return cam ? std::optional(cam->masterRateRevPerMin < 0 ? -1 : 1) : std::nullopt;
}

MasterDirection::Way MasterDirection::way() const
{
    const std::optional<int> sign = programSign();
    const std::optional<double> reversed = m_parameter.value();
    if (!sign || !reversed)
        return Way::Unknown;
    return (*sign < 0) != (*reversed != 0) ? Way::Backward : Way::Forward;
}

bool MasterDirection::turning() const
{
    return way() != Way::Unknown && m_controller.state() == Controller::State::Running && m_observed &&
           (*m_observed < 0) != (way() == Way::Backward);
}

QString MasterDirection::blockedReason() const
{
    if (const QString reason = m_controller.blockedReason(Action::ReverseMaster); !reason.isEmpty())
        return reason;
    if (m_controller.masterSetting()->leads())
        return tr("The line sets the direction: an encoder leads the machine.");
    if (m_parameter.isMissing())
        return tr("This controller cannot reverse its master. Update its firmware.");
    return way() == Way::Unknown ? tr("Waiting for the controller …") : QString();
}

QString MasterDirection::text() const
{
    const QString reason = blockedReason();
    if (!reason.isEmpty())
        return reason;
    const bool isBackward = way() == Way::Backward;
    if (turning())
        return isBackward ? tr("Changing to reverse …") : tr("Changing to forward …");
    if (m_controller.state() != Controller::State::Running)
        return isBackward ? tr("starts in reverse") : tr("starts forward");
    if (!m_observed)
        return isBackward ? tr("set to reverse") : tr("set to forward");
    return isBackward ? tr("runs in reverse") : tr("runs forward");
}

QString MasterDirection::advanceText() const
{
    const double advanceMm = programSign() ? m_controller.program()->advanceMm : 0;
    const bool isReversed = m_parameter.value().value_or(0) != 0;
    return advanceMm == 0 ? QString() : CamSentences::signedMm(isReversed ? -advanceMm : advanceMm);
}

void MasterDirection::turn(Way wanted)
{
    if (!m_controller.accessCheck().require(Level::Technician))
        return;
    const std::optional<int> sign = programSign();
    if (wanted == Way::Unknown || wanted == way() || !canChange() || !sign)
        return;
    const bool isReversed = (wanted == Way::Backward) != (*sign < 0);
    m_parameter.write(isReversed ? 1 : 0,
                      {this, [this](const link::ParameterOutcome& outcome) {
                           if (outcome.end != link::ParameterEnd::Done)
                               emit failed(ConnectionSentences::parameter(tr("Master direction"), outcome));
                       }});
}

void MasterDirection::noteConnection()
{
    if (!m_controller.isConnected()) {
        m_observed.reset();
        m_before.reset();
    }
    readWhenUnknown();
    emit changed();
}

void MasterDirection::noteProgram()
{
    m_observed.reset();
    m_before.reset();
    readWhenUnknown();
    emit changed();
}

void MasterDirection::noteStatus(const link::StatusBatch& batch)
{
    for (const auto& [receivedAt, status, latency] : batch.samples) {
        if (status.masterAngleDeg)
            observe({*status.masterAngleDeg, status.masterSpeedPercent, status.sampleTimeMs});
    }
    readWhenUnknown();
    emit changed();
}

void MasterDirection::observe(const Sample& now)
{
    const auto before = std::exchange(m_before, now);
    const auto& program = m_controller.program();
    if (!before || !program || program->cycleSeconds <= 0)
        return;
    const double seconds = static_cast<std::uint16_t>(now.timeMs - before->timeMs) / 1000.0;
    const double share = std::max(now.speedPercent, before->speedPercent) / 100;
    const double turnedDeg = std::remainder(now.angleDeg - before->angleDeg, 360);
    if (360 * share * seconds / program->cycleSeconds > maxTellingDeg)
        m_observed.reset();
    else if (std::abs(turnedDeg) >= minTellingDeg)
        m_observed = turnedDeg < 0 ? -1 : 1;
}

void MasterDirection::readWhenUnknown()
{
    if (programSign())
        m_parameter.readIfUncertain();
}

} // namespace campanel::panel
