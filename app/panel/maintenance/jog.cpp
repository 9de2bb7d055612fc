// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/jog.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"

#include <limits>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto repeatPeriod = 50ms; // a quarter of link::jogCounts
constexpr auto patience = 600ms;
constexpr auto settleTime = 150ms; // an exchange and the controller's ramp

unsigned bitOf(int direction)
{
    return direction > 0 ? 1U : 2U;
}

link::JogDirection linkDirection(int direction)
{
    return direction == 0  ? link::JogDirection::None
           : direction > 0 ? link::JogDirection::Forward
                           : link::JogDirection::Reverse;
}

bool isPress(const Controller& controller)
{
    return controller.active().kind == static_cast<int>(profile::ProgramKind::Press);
}

bool isCutter(const Controller& controller)
{
    return controller.active().kind == static_cast<int>(profile::ProgramKind::RotaryCutter);
}

} // namespace

Jog::Jog(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_repeatTimer(this)
    , m_patienceTimer(this)
    , m_settleTimer(this)
{
    m_repeatTimer.setInterval(repeatPeriod);
    m_repeatTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_repeatTimer, &QTimer::timeout, this,
            [this] { m_controller.link().setJog(linkDirection(m_held)); });
    m_patienceTimer.setSingleShot(true);
    m_patienceTimer.setInterval(patience);
    connect(&m_patienceTimer, &QTimer::timeout, this, [this] {
        m_isRefused = m_controller.state() != Controller::State::Jogging;
        emit changed();
    });
    m_settleTimer.setInterval(settleTime);
    connect(&m_settleTimer, &QTimer::timeout, this, [this] {
        if (m_controller.state() != Controller::State::Jogging)
            reportEnd();
    });
    for (const auto trigger : {&Controller::stateChanged, &Controller::freshChanged,
                               &Controller::connectionChanged, &Controller::programChanged})
        connect(&controller, trigger, this, &Jog::check);
    connect(&controller, &Controller::liveChanged, this, &Jog::positionChanged);
    // Any command ends jogging, above all Stop.
    connect(&controller, &Controller::commandSending, this, [this] {
        m_mayBegin = false;
        finish(End::Stopped);
    });
    LanguageNotifier::follow(this);
}

bool Jog::possible() const
{
    return m_controller.blockedReason(Action::Jog).isEmpty();
}

bool Jog::blocked() const
{
    return !possible() || m_isRefused || (m_pressed != 0 && m_held == 0 && !m_mayBegin);
}

double Jog::positionPulses() const
{
    const auto pulses = m_controller.axisPosition().actualPulses();
    return pulses ? static_cast<double>(*pulses) : std::numeric_limits<double>::quiet_NaN();
}

QString Jog::forwardNote() const
{
    return isPress(m_controller) ? tr("towards the part") : QString();
}

QString Jog::reverseNote() const
{
    return isPress(m_controller) ? tr("away from the part") : QString();
}

QString Jog::endText() const
{
    switch (m_end) {
    case End::Stopped:
        return tr("Stop ended the jog. Release the key before you jog again.");
    case End::BothKeys:
        return tr("Two keys are pressed: no motion. Release both keys.");
    case End::Released:
    case End::Blocked:
    case End::LeftScreen:
        break;
    }
    return tr("Release the key before you jog again.");
}

QString Jog::text() const
{
    const QString reason = m_controller.blockedReason(Action::Jog);
    if (!reason.isEmpty())
        return reason;
    if (m_isRefused)
        return isPress(m_controller) && m_held > 0
                   ? tr("No motion: the press does not continue against its force.")
                   : tr("No motion. Release the key and try again.");
    if (m_held > 0)
        return tr("Moves forward while you hold the key.");
    if (m_held < 0)
        return tr("Moves in reverse while you hold the key.");
    if (m_pressed != 0 && !m_mayBegin)
        return endText();
    if (isCutter(m_controller))
        return tr("Hold a key to turn the knife. The film stays still, and the next start begins with the "
                  "reference run.");
    return isPress(m_controller) ? tr("Hold a key to move the ram.") : tr("Hold a key to move the axis.");
}

void Jog::touch(int direction)
{
    m_mayBegin = m_pressed == 0;
    m_pressed |= bitOf(direction);
    if (!m_mayBegin) {
        finish(End::BothKeys);
        m_end = End::BothKeys;
    }
    emit changed();
}

void Jog::press(int direction)
{
    if ((m_pressed & bitOf(direction)) == 0)
        touch(direction);
    if (!std::exchange(m_mayBegin, false))
        return;
    if (m_controller.accessCheck().require(Level::Technician) && possible()) {
        begin(direction);
    } else {
        m_end = End::Blocked;
        emit changed();
    }
}

void Jog::release(int direction)
{
    m_pressed &= ~bitOf(direction);
    m_mayBegin = false;
    if (m_held == direction)
        finish(End::Released);
    emit changed();
}

void Jog::letGo()
{
    m_pressed = 0;
    m_mayBegin = false;
    finish(End::LeftScreen);
    emit changed();
}

void Jog::begin(int direction)
{
    reportEnd(); // for the previous one
    m_held = direction;
    m_isRefused = false;
    m_controller.link().setJog(linkDirection(direction));
    m_repeatTimer.start();
    m_patienceTimer.start();
    emit begun(direction, positionPulses());
    emit changed();
}

void Jog::finish(End end)
{
    if (m_held == 0)
        return;
    m_endedDirection = std::exchange(m_held, 0);
    m_end = end;
    m_isRefused = false;
    m_repeatTimer.stop();
    m_patienceTimer.stop();
    m_controller.link().setJog(link::JogDirection::None);
    m_settleTimer.start();
    emit changed();
}

void Jog::check()
{
    if (!possible())
        finish(End::Blocked);
    if (m_held != 0 && m_controller.state() == Controller::State::Jogging)
        m_isRefused = false;
    if (m_endedDirection != 0 && !m_controller.isConnected())
        reportEnd();
    emit changed();
}

void Jog::reportEnd()
{
    m_settleTimer.stop();
    if (m_endedDirection != 0)
        emit ended(std::exchange(m_endedDirection, 0), m_end,
                   m_controller.isConnected() ? positionPulses() : std::numeric_limits<double>::quiet_NaN());
}

} // namespace campanel::panel
