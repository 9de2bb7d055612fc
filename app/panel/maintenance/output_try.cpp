// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/output_try.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"

#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto renewalPeriod = 150ms; // three times within the time of the controller

unsigned maskOf(int output)
{
    return 1U << static_cast<unsigned>(output);
}

QString nameInMap(int output)
{
    return QString::fromStdString(modbus::enumName(static_cast<modbus::OutputBit>(output)));
}

} // namespace

OutputTry::OutputTry(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_repeatTimer(this)
{
    LanguageNotifier::follow(this);
    m_repeatTimer.setInterval(renewalPeriod);
    m_repeatTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_repeatTimer, &QTimer::timeout, this, [this] {
        if (!m_isAsked)
            send(true);
    });
    for (const auto trigger :
         {&Controller::stateChanged, &Controller::freshChanged, &Controller::connectionChanged})
        connect(&controller, trigger, this, [this] {
            if (!possible())
                finish(End::Blocked, m_controller.blockedReason(Action::TryOutput));
            emit changed();
        });
    // The controller switches the output off with any other command.
    connect(&controller, &Controller::commandSending, this, [this] {
        m_mayBegin = false;
        finish(End::Stopped);
    });
}

bool OutputTry::offered() const
{
    const auto& identity = m_controller.identity();
    return identity && identity->mapMinor >= modbus::tryOutputMapMinor;
}

bool OutputTry::possible() const
{
    return m_controller.blockedReason(Action::TryOutput).isEmpty();
}

QString OutputTry::text() const
{
    if (!offered())
        return tr("A filled lamp means on. This controller cannot try outputs; update its firmware.");
    if (blocked())
        return m_reason;
    if (m_held >= 0)
        return tr("%1 is on while you hold the key.")
            .arg(ControllerSentences::text(static_cast<modbus::OutputBit>(m_held)));
    if (m_pressed != 0 && !m_mayBegin)
        return tr("Release the key before you try again.");
    return possible() ? tr("A filled lamp means on. Hold Try to switch an output on.")
                      : tr("A filled lamp means on. Outputs can be tried at standstill.");
}

void OutputTry::touch(int output)
{
    m_mayBegin = m_pressed == 0;
    m_pressed |= maskOf(output);
    m_reason = m_mayBegin ? m_controller.blockedReason(Action::TryOutput) : QString();
    if (!m_mayBegin)
        finish(End::BothKeys);
    emit changed();
}

void OutputTry::press(int output)
{
    if ((m_pressed & maskOf(output)) == 0)
        touch(output);
    if (!std::exchange(m_mayBegin, false))
        return;
    if (m_controller.accessCheck().require(Level::Technician)) {
        m_reason = m_controller.blockedReason(Action::TryOutput);
        if (m_reason.isEmpty()) {
            m_held = output;
            send(true);
            m_repeatTimer.start();
            emit begun(nameInMap(output));
        }
    }
    emit changed();
}

void OutputTry::release(int output)
{
    m_pressed &= ~maskOf(output);
    m_mayBegin = false;
    if (m_held == output)
        finish(End::Released);
    emit changed();
}

void OutputTry::letGo()
{
    m_pressed = 0;
    m_mayBegin = false;
    m_reason.clear();
    finish(End::LeftScreen);
    emit changed();
}

void OutputTry::send(bool isOn)
{
    m_isAsked = true;
    m_controller.link().request(
        {.command = modbus::Command::TryOutput,
         .arguments = {static_cast<std::uint16_t>(m_held), static_cast<std::uint16_t>(isOn ? 1 : 0), 0}},
        {this, [this](const link::CommandOutcome& outcome) { onAnswer(outcome); }});
}

// A lost answer is asked for again with the next request; the output goes off in the meantime.
void OutputTry::onAnswer(const link::CommandOutcome& outcome)
{
    m_isAsked = false;
    if (outcome.end == link::CommandEnd::Refused || outcome.end == link::CommandEnd::NotSent)
        finish(End::Blocked, ConnectionSentences::command(outcome));
}

void OutputTry::finish(End end, const QString& reason)
{
    if (m_held < 0)
        return;
    m_repeatTimer.stop();
    m_reason = reason;
    if (end != End::Stopped && end != End::Blocked)
        send(false);
    emit ended(nameInMap(std::exchange(m_held, -1)), end);
    emit changed();
}

} // namespace campanel::panel
