// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/torque_watch.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/program/solved_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto readPeriod = 300ms; // faster numbers cannot be read
constexpr double fullSpeedPercent = 99.99;
constexpr double cycleEndDeg = 359.99;

bool hasTorque(const ControllerProgram& program)
{
    return program.recipe.kind() != profile::ProgramKind::Press;
}

} // namespace

TorqueWatch::TorqueWatch(Controller& controller)
    : m_controller(controller)
    , m_followingLimit(controller.parameter("parameter.following_error_limit"))
    , m_pins(controller, this)
{
    connect(this, &Watched::watchedChanged, this, [this] {
        m_isPending = false;
        if (!watched()) {
            m_last = {};
            m_readings.clear();
        } else {
            m_followingLimit.readIfUncertain();
        }
        emit changed();
    });
    updateEvery(readPeriod, [this] { m_pins.read(); });
    connect(&m_pins, &IoPins::changed, this, &TorqueWatch::takePins);
    connect(&m_followingLimit, &Parameter::changed, this, &TorqueWatch::changed);
    LanguageNotifier::follow(this);
}

void TorqueWatch::setMachineData(const std::optional<profile::Machine>& machine)
{
    if (machine == m_machineData)
        return;
    m_machineData = machine;
    prepare();
}

void TorqueWatch::noteConnection()
{
    if (!m_controller.isConnected())
        m_isPending = false;
    else if (watched())
        m_followingLimit.readIfUncertain();
    emit changed();
}

void TorqueWatch::noteProgram()
{
    prepare();
}

// The motion is that of the table, which a cam runs backwards for a negative rate.
void TorqueWatch::prepare()
{
    m_motion = {};
    m_load = {};
    m_isPending = false;
    m_readings.clear();
    const auto& program = m_controller.program();
    if (program && hasTorque(*program) && isSameAxis() && m_machineData->ratedTorqueNm > 0) {
        program::Recipe recipe = program->recipe;
        recipe.machine = *m_machineData;
        if (const auto solved = program::solveProgram(recipe)) {
            m_motion = program::camSource(recipe, *solved).motion;
            m_load = solved->load;
        }
    }
    m_last.predictedPercent = predictedAt(m_last.angleDeg);
    emit changed();
}

double TorqueWatch::followingLimitMm() const
{
    const auto& program = m_controller.program();
    return program && program->pulsesPerMm > 0 ? m_followingLimit.lastValue() / program->pulsesPerMm
                                               : unknown;
}

double TorqueWatch::limitPercent() const
{
    return m_machineData && m_machineData->ratedTorqueNm > 0
               ? 100 * m_machineData->maxTorqueNm / m_machineData->ratedTorqueNm
               : unknown;
}

bool TorqueWatch::isSameAxis() const
{
    const auto& program = m_controller.program();
    return program && m_machineData &&
           profile::isSameScale(*m_machineData, program->recipe.machine,
                                program::kindInfo(program->recipe.kind()).machineFields);
}

bool TorqueWatch::isAtFullSpeed() const
{
    const auto& status = m_controller.status();
    const auto& program = m_controller.program();
    if (!status || !program || !m_controller.isConnected() || !m_controller.fresh() ||
        status->state != modbus::State::Running || status->masterSpeedPercent < fullSpeedPercent ||
        program->generation != status->generation || program->crc != status->activeCrc)
        return false;
    // A knife that waits for the film is not in its program.
    const auto& packer = m_controller.packing()->status();
    return !m_controller.packing()->recordsBags() ||
           (packer && packer->knifeGate == modbus::GateState::Running &&
            packer->filmGate == modbus::GateState::Running);
}

double TorqueWatch::predictedAt(double angleDeg) const
{
    if (!m_load.isKnown() || m_motion.segments().empty() || std::isnan(angleDeg))
        return unknown;
    profile::MotionPoint point = m_motion.at(angleDeg / 360 * m_motion.durationS());
    const profile::Program& program = m_controller.program()->recipe.program;
    // The speed that a speed move has reached is held.
    if (std::holds_alternative<profile::SpeedMoveProgram>(program) && angleDeg >= cycleEndDeg)
        point.accelerationMmPerS2 = 0;
    const profile::CamMaster* cam = profile::camMaster(program);
    const bool isReversed = cam && (cam->masterRateRevPerMin < 0) !=
                                       (m_controller.direction()->way() == MasterDirection::Way::Backward);
    const double torqueNm =
        m_load.at(isReversed ? -point.velocityMmPerS : point.velocityMmPerS, point.accelerationMmPerS2);
    return 100 * torqueNm / m_machineData->ratedTorqueNm;
}

void TorqueWatch::takePins()
{
    m_last = {};
    m_isPending = false;
    const auto& pins = m_pins.status();
    if (watched() && pins && pins->torquePercent) {
        m_last.measuredPercent = *pins->torquePercent;
        if (pins->torqueAngleDeg && isAtFullSpeed()) {
            m_last.angleDeg = *pins->torqueAngleDeg;
            m_last.predictedPercent = predictedAt(m_last.angleDeg);
            m_isPending = std::isfinite(m_last.predictedPercent);
        }
    }
    emit changed();
}

// A reading counts between two statuses at full speed: the machine may have begun to stop just before it.
void TorqueWatch::noteStatus()
{
    if (!std::exchange(m_isPending, false) || !isAtFullSpeed())
        return;
    if (m_readings.size() >= maxReadings)
        m_readings.removeFirst();
    m_readings << m_last;
    emit changed();
}

double TorqueWatch::measuredPercent() const
{
    return m_controller.isConnected() ? m_last.measuredPercent : unknown;
}

std::optional<TorqueWatch::Reading> TorqueWatch::worst() const
{
    const auto found = std::ranges::max_element(
        m_readings, {}, [](const Reading& each) { return std::abs(each.difference()); });
    return found == m_readings.end() ? std::nullopt : std::optional(*found);
}

double TorqueWatch::differencePercent() const
{
    const auto found = worst();
    return found ? std::abs(found->difference()) : unknown;
}

QString TorqueWatch::missingText() const
{
    const auto& program = m_controller.program();
    if (!m_controller.isConnected() || !program || !hasTorque(*program))
        return {};
    const auto& pins = m_pins.status();
    if (!m_pins.present() || (pins && !pins->torquePercent))
        return tr("The drive reports no torque.");
    const bool hasInertia = m_machineData && m_machineData->inertiaKgCm2 > 0;
    const bool hasRated = m_machineData && m_machineData->ratedTorqueNm > 0;
    if (!hasInertia && !hasRated)
        return tr("Inertia and rated torque are missing in Settings, Machine.");
    if (!hasInertia)
        return tr("The inertia is missing in Settings, Machine.");
    if (!hasRated)
        return tr("The rated torque is missing in Settings, Machine.");
    if (!isSameAxis())
        return tr("The program was made for other machine data.");
    return {};
}

// Returns what is known without a prediction; its explanation says what is missing for one.
QString TorqueWatch::measuredText() const
{
    return std::isnan(measuredPercent()) ? QString()
                                         : tr("Torque %1 %").arg(Format().number(measuredPercent(), 0));
}

QString TorqueWatch::text() const
{
    const Format format;
    const QString measured = format.number(measuredPercent(), 0);
    if (std::isnan(predictedPercent()) || std::isnan(differencePercent()))
        return measuredText();
    return tr("Torque %1 % of rated, predicted %2 %, largest difference %3 %")
        .arg(measured, format.number(predictedPercent(), 0), format.number(differencePercent(), 1));
}

QString TorqueWatch::shortText() const
{
    const Format format;
    if (std::isnan(predictedPercent()) || std::isnan(differencePercent()))
        return measuredText();
    return tr("Torque %1 %, predicted %2 %, max. diff. %3 %")
        .arg(format.number(measuredPercent(), 0), format.number(predictedPercent(), 0),
             format.number(differencePercent(), 1));
}

} // namespace campanel::panel
