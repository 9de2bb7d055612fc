// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/packing_setup.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

constexpr auto phaseGainName = "parameter.phase_gain";
constexpr auto lengthLimitName = "parameter.length_limit";
constexpr double percent = 100.0;

} // namespace

PackingSetup::PackingSetup(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_fields(controller, this)
    , m_wizard(controller, m_fields, this)
    , m_sensor(controller, this)
    , m_edges(controller, m_sensor, this)
    , m_eyeRecords(controller, {0, modbus::eyeAddress, modbus::eyeRegisters}, this)
    , m_jam(controller, this)
{
    connect(controller.packing(), &PackingLine::changed, this, &PackingSetup::followMarks);
    connect(&controller, &Controller::stateChanged, this, &PackingSetup::changed);
    connect(&controller, &Controller::connectionChanged, this, [this] {
        if (!m_controller.isConnected())
            m_teaching = Teaching::No;
        emit changed();
    });
    // Another film needs another estimate.
    connect(&controller, &Controller::programChanged, this, [this] {
        m_estimate.clear();
        m_fields.suggest(std::nullopt, 0);
        followKnives();
        emit changed();
    });
    connect(controller.packing(), &PackingLine::bagRecorded, this, &PackingSetup::takeBag);
    // Bags of another place tell nothing of the new one.
    connect(&m_fields, &PackingFields::written, this, [this](const QString& name) {
        if (PackingFields::knifeOf(name.toStdString()) > 0)
            m_knives.begin(m_knives.knives());
    });
    connect(&m_sensor, &MarkSensor::edgesRead, this,
            [this] { m_fields.suggestDeadTime(m_sensor.estimate()); });
    connect(&m_eyeRecords, &SensorRecords::read, this, &PackingSetup::takeEye);
    connect(&m_eyeRecords, &SensorRecords::controllerChanged, this, [this] {
        m_eye = {};
        m_fields.suggestEyeDeadTimes(m_eye);
    });
    connect(&m_fields, &PackingFields::changed, this, &PackingSetup::changed);
    connect(&controller.link(), &link::Link::commandEnded, this, &PackingSetup::takeCommand);
    LanguageNotifier::follow(this, [this] { m_refusal.clear(); });
}

bool PackingSetup::available() const
{
    return m_controller.packing()->known() && m_controller.packing()->fresh();
}

void PackingSetup::open()
{
    m_fields.read();
}

void PackingSetup::takeEye(const std::vector<std::uint16_t>& registers)
{
    const auto edges = modbus::eyeEdges(registers, m_eye.last());
    for (const modbus::EyeEdge& edge : edges)
        m_eye.take(edge);
    if (!edges.empty())
        m_fields.suggestEyeDeadTimes(m_eye);
}

bool PackingSetup::canTeach() const
{
    return available() && m_controller.state() == Controller::State::Running && !teaching();
}

void PackingSetup::teach()
{
    if (!m_controller.accessCheck().require(Level::Technician) || !canTeach())
        return;
    m_refusal.clear();
    m_teaching = Teaching::Asked;
    m_controller.packing()->teach(marksToTeach);
    emit changed();
}

void PackingSetup::takeCommand(const link::CommandOutcome& outcome)
{
    if (outcome.command != modbus::Command::TeachMarks || m_teaching != Teaching::Asked)
        return;
    const bool isDone = outcome.end == link::CommandEnd::Done;
    m_refusal = isDone ? QString() : ConnectionSentences::command(outcome);
    m_teaching = isDone ? Teaching::Accepted : Teaching::No;
    emit changed();
}

// Waits for the second status: the first one may have been read before the command was accepted.
void PackingSetup::followTeaching()
{
    if (m_teaching == Teaching::Accepted)
        m_teaching = Teaching::UnderWay;
    else if (m_teaching == Teaching::UnderWay && m_controller.packing()->teachMarks() >= marksToTeach)
        m_teaching = Teaching::No;
}

// Another shaft has other knives.
void PackingSetup::followKnives()
{
    const auto& program = m_controller.program();
    const int knives = program && program->recipe.isCutter() ? program->recipe.machine.knives : 1;
    if (knives == m_knives.knives())
        return;
    m_knives.begin(knives);
    m_fields.setKnives(knives);
    if (knives > 1)
        m_fields.read();
}

void PackingSetup::takeBag(const modbus::BagRecord& bag)
{
    const auto& status = m_controller.packing()->status();
    const int knives = m_knives.knives();
    if (knives < 2 || !status || !status->knife || bag.isScrap() || bag.lengths > 1)
        return;
    const auto back = static_cast<int>(status->bagNumber - bag.number);
    m_knives.take((*status->knife - 1 - back % knives + knives) % knives + 1, bag.deviationMm);
    m_fields.suggestKnives(m_knives);
}

void PackingSetup::followMarks()
{
    followTeaching();
    const auto& status = m_controller.packing()->status();
    const double gain = m_fields.value(phaseGainName);
    if (status && std::isfinite(gain) &&
        m_controller.packing()->markState() == PackingLine::MarkState::Tracking) {
        const int before = m_estimate.bags();
        m_estimate.take({status->marks, status->marksMissing, status->lastMarkMm, status->markPitchMm}, gain);
        if (m_estimate.bags() != before)
            m_fields.suggest(m_estimate.suggestion(), m_estimate.bags());
    }
    emit changed();
}

double PackingSetup::teachProgress() const
{
    if (!available() || m_teaching == Teaching::Asked || m_teaching == Teaching::Accepted)
        return 0.0;
    return std::min(1.0, static_cast<double>(m_controller.packing()->teachMarks()) / marksToTeach);
}

bool PackingSetup::misfit() const
{
    const double bagMm = m_controller.active().bagLengthMm;
    const double limit = m_fields.value(lengthLimitName);
    const double pitchMm = m_controller.packing()->teachPitchMm();
    return !teaching() && std::isfinite(limit) && std::abs(pitchMm - bagMm) > bagMm * limit / percent;
}

QString PackingSetup::teachText() const
{
    const PackingLine& packing = *m_controller.packing();
    if (!available())
        return tr(
            "No packing machine data. Connect the controller and download a recipe of a rotary cutter.");
    if (!m_refusal.isEmpty())
        return m_refusal;
    if (teaching() && m_controller.state() != Controller::State::Running)
        return tr("Waiting: marks are measured while the film runs.");
    if (teaching())
        return tr("%1 of %2 marks measured …")
            .arg(std::lround(teachProgress() * marksToTeach))
            .arg(marksToTeach);
    if (!std::isfinite(packing.teachPitchMm()))
        return m_controller.state() == Controller::State::Running
                   ? tr("Measures the distances of the next %1 marks while the machine runs.")
                         .arg(marksToTeach)
                   : tr("Start the machine: marks are measured while the film runs, with mark tracking on or "
                        "off.");
    const Format format;
    const QString pitch = format.measure(packing.teachPitchMm(), 2, QStringLiteral("mm"));
    const QString scatter = format.measure(packing.teachScatterMm(), 2, QStringLiteral("mm"));
    const QString bag = format.compactMeasure(m_controller.active().bagLengthMm, 0, 2, QStringLiteral("mm"));
    if (misfit())
        return tr("The mark distance is %1 (±%2), the recipe cuts %3. The difference exceeds the "
                  "length limit: this film does not match this recipe.")
            .arg(pitch, scatter, bag);
    return tr("The mark distance is %1 (±%2), the recipe cuts %3.").arg(pitch, scatter, bag);
}

} // namespace campanel::panel
