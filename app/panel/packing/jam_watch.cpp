// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/jam_watch.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/program/solved_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

using modbus::JamState;

constexpr auto readPeriod = 300ms; // faster numbers cannot be read
constexpr auto slowPeriod = 60s;   // 1000 bags take longer
constexpr double fullTurnDeg = 360;
// The picture without a band, around the cut.
constexpr double emptyReachDeg = 45;

struct StateSentence {
    JamState state;
    const char* sentence;
    bool hasCycles = false; // %1: those that are left
};

constexpr std::array stateSentences{
    StateSentence{JamState::Off, QT_TRANSLATE_NOOP("campanel::panel::JamWatch",
                                                   "Off. Switch jam detection on in the list of this page.")},
    StateSentence{
        JamState::NotReported,
        QT_TRANSLATE_NOOP(
            "campanel::panel::JamWatch",
            "The drive reports no torque: a jam cannot be seen. Connect its torque-limit output to the "
            "input Torque limit, which is monitored.")},
    StateSentence{
        JamState::TooSlow,
        QT_TRANSLATE_NOOP(
            "campanel::panel::JamWatch",
            "The drive reports its torque too seldom: a jam cannot be seen. Connect its torque-limit "
            "output to the input Torque limit, which is monitored.")},
    StateSentence{
        JamState::Learning,
        QT_TRANSLATE_NOOP("campanel::panel::JamWatch",
                          "Learning the torque of this program. Cycles at full speed until armed: %1"),
        true},
    StateSentence{JamState::Armed,
                  QT_TRANSLATE_NOOP("campanel::panel::JamWatch",
                                    "Armed. Torque beyond the band stops the machine while the jaws close.")},
};

QString percent(double value)
{
    return Format().measure(value, 1, u"%"_s);
}

QString degrees(double value)
{
    return Format().measure(value, 1, u"°"_s);
}

} // namespace

JamWatch::JamWatch(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_closing(controller.parameter("parameter.jam_closing"))
    , m_pins(controller, this)
    , m_slowTimer(this)
{
    connect(&m_slowTimer, &QTimer::timeout, this, &JamWatch::read);
    m_slowTimer.start(slowPeriod);
    connect(this, &Watched::watchedChanged, this, [this] {
        m_readings.clear();
        emit changed();
    });
    updateEvery(readPeriod, [this] { read(); });
    connect(&m_pins, &IoPins::changed, this, &JamWatch::takePins);
    connect(&m_closing, &Parameter::changed, this, &JamWatch::changed);
    connect(&controller, &Controller::connectionChanged, this, &JamWatch::noteConnection);
    connect(&controller, &Controller::programChanged, this, &JamWatch::noteProgram);
    connect(controller.packing(), &PackingLine::changed, this, [this] {
        if (watched() && !m_status)
            emit changed(); // emptyText() depends on it
    });
    LanguageNotifier::follow(this);
}

bool JamWatch::isReported() const
{
    const auto& identity = m_controller.identity();
    return m_controller.packing()->recordsBags() && identity->mapMinor >= modbus::jamMapMinor;
}

void JamWatch::noteConnection()
{
    m_isAsked = false;
    if (!m_controller.isConnected())
        m_status.reset();
    if (!m_controller.identity())
        m_residueNumber.reset(); // another controller
    emit changed();
}

// The torque of another program is another one.
void JamWatch::noteProgram()
{
    m_readings.clear();
    m_cutter.reset();
    m_status.reset();
    const auto& program = m_controller.program();
    if (program && program->recipe.isCutter()) {
        if (const auto solved = program::solveProgram(program->recipe))
            m_cutter = solved->cutter;
    }
    emit changed();
}

void JamWatch::read()
{
    if (m_isAsked || !isReported())
        return;
    if (watched()) {
        m_closing.readIfUncertain();
        m_pins.read();
    }
    m_isAsked = true;
    m_controller.link().readRegisters(
        {0, modbus::jamAddress, modbus::jamRegisters},
        {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
}

void JamWatch::takeRead(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    if (outcome.end != link::ReadEnd::Done || outcome.registers.size() != modbus::jamRegisters)
        return;
    m_status = modbus::decodeJam(outcome.registers);
    followResidue();
    emit changed();
}

// The first reading tells no new record: it may be of the time before the panel was started.
void JamWatch::followResidue()
{
    const auto before = std::exchange(m_residueNumber, m_status->residueNumber);
    if (before && before != m_residueNumber && m_status->residuePercent)
        emit residueRecorded(*m_status->residuePercent);
}

double JamWatch::fromCutDeg(double masterDeg) const
{
    if (!m_cutter)
        return unknown;
    const double spanDeg = fullTurnDeg / m_cutter->machine.knives;
    return std::remainder(knifeDegAt(*m_cutter, masterDeg) - m_controller.active().cutAngleDeg, spanDeg);
}

void JamWatch::takePins()
{
    const auto& pins = m_pins.status();
    if (!watched() || !pins || !pins->torquePercent || !pins->torqueAngleDeg ||
        m_controller.state() != Controller::State::Running)
        return;
    const double angleDeg = fromCutDeg(*pins->torqueAngleDeg);
    if (std::isnan(angleDeg))
        return;
    if (m_readings.size() >= maxReadings)
        m_readings.removeFirst();
    m_readings << QPointF(angleDeg, *pins->torquePercent);
    emit changed();
}

QList<QPointF> JamWatch::expected() const
{
    QList<QPointF> points;
    for (const auto& part : m_status ? m_status->band : std::vector<modbus::JamStatus::Part>())
        points << QPointF(part.angleDeg, part.expectedPercent);
    return points;
}

QList<double> JamWatch::halfWidths() const
{
    QList<double> widths;
    for (const auto& part : m_status ? m_status->band : std::vector<modbus::JamStatus::Part>())
        widths << part.halfWidthPercent;
    return widths;
}

QPointF JamWatch::jam() const
{
    const bool isSeen = m_status && m_status->last && m_status->last->source == modbus::JamSource::Torque;
    return isSeen ? QPointF(m_status->last->angleDeg, m_status->last->torquePercent)
                  : QPointF(unknown, unknown);
}

double JamWatch::limitPercent() const
{
    return m_status && m_status->last ? m_status->last->limitPercent : unknown;
}

double JamWatch::fromDeg() const
{
    const bool hasBand = m_status && m_status->toDeg > m_status->fromDeg;
    return hasBand ? m_status->fromDeg : std::min(-emptyReachDeg, closingDeg());
}

double JamWatch::toDeg() const
{
    const bool hasBand = m_status && m_status->toDeg > m_status->fromDeg;
    return hasBand ? m_status->toDeg : emptyReachDeg;
}

double JamWatch::closingDeg() const
{
    return -m_closing.lastValue();
}

bool JamWatch::blind() const
{
    return m_status && (m_status->state == JamState::NotReported || m_status->state == JamState::TooSlow);
}

QString JamWatch::stateText() const
{
    if (!m_status)
        return Format::unknownText();
    const auto* found = std::ranges::find(stateSentences, m_status->state, &StateSentence::state);
    if (found == stateSentences.end())
        return tr("The controller reports a state that this panel does not know. Update the panel.");
    const QString sentence = tr(found->sentence);
    return found->hasCycles ? sentence.arg(m_status->cyclesLeft) : sentence;
}

QString JamWatch::intervalText() const
{
    return m_status && m_status->intervalMs ? Format().compactMeasure(*m_status->intervalMs, 0, 2, u"ms"_s)
                                            : Format::unknownText();
}

QString JamWatch::countText() const
{
    return m_status ? QString::number(m_status->jams) : Format::unknownText();
}

QString JamWatch::lastText() const
{
    if (!m_status || !m_status->last)
        return m_status ? tr("No jam since power-up.") : Format::unknownText();
    const modbus::JamStatus::Jam& jam = *m_status->last;
    const QString distance = degrees(std::abs(jam.angleDeg));
    const QString place =
        jam.angleDeg > 0 ? tr("%1 behind the cut").arg(distance) : tr("%1 before the cut").arg(distance);
    const QString runOn = degrees(jam.runOnDeg);
    switch (jam.source) {
    case modbus::JamSource::TorqueLimit:
        return tr("Torque-limit input on %1. The knife stood after another %2.", "%1: a place")
            .arg(place, runOn);
    case modbus::JamSource::Torque:
        return tr("Torque %1, %2; the band ends at %3. The knife stood after another %4.", "%2: a place")
            .arg(percent(jam.torquePercent), place, percent(jam.limitPercent), runOn);
    case modbus::JamSource::None:
        break;
    }
    return tr("%1, for a reason that this panel does not know. Update the panel.", "%1: a place").arg(place);
}

QString JamWatch::residueText() const
{
    if (!m_status || !m_status->residuePercent)
        return m_status ? tr("Not known before the first 1000 bags.") : Format::unknownText();
    const double value = *m_status->residuePercent;
    const QString sign = value > 0 ? u"+"_s : QString();
    return tr("%1: mean torque at the cut of 1000 bags, less that of the first 20. It is recorded only; "
              "nothing is concluded from it.")
        .arg(sign + Format().measure(value, 2, u"%"_s));
}

QString JamWatch::emptyText() const
{
    if (!m_controller.packing()->known())
        return tr("No packing machine data. Connect the controller and download a recipe of a rotary "
                  "cutter.");
    if (!isReported() && m_controller.isConnected())
        return tr("This controller does not monitor the torque of its knife. Update the controller: its "
                  "register map must be 1.6 or newer.");
    return {};
}

} // namespace campanel::panel
