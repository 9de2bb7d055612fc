// SPDX-License-Identifier: Apache-2.0
#include "app/panel/hand/hand_speed.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/program/recipe_master.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto readPeriod = 2s;
// Touches that follow each other within this time are one row of the audit trail.
constexpr auto rowTime = 5s;

QString text(double percent)
{
    return u"%1 %"_s.arg(percent);
}

} // namespace

HandSpeed::HandSpeed(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_parameter(controller.parameter("hand.speed"))
{
    m_rowTimer.setSingleShot(true);
    m_rowTimer.setInterval(rowTime);
    connect(&m_rowTimer, &QTimer::timeout, this, &HandSpeed::note);
    connect(&m_parameter, &Parameter::changed, this, &HandSpeed::changed);
    connect(&controller, &Controller::connectionChanged, this, &HandSpeed::read);
    connect(&controller, &Controller::stateChanged, this, &HandSpeed::read);
    connect(&controller, &Controller::programChanged, this, &HandSpeed::changed);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &HandSpeed::changed);
    updateEvery(readPeriod, [this] {
        if (offered() && !m_wanted)
            m_parameter.read(); // somebody else may have set it
    });
    LanguageNotifier::follow(this);
}

void HandSpeed::read()
{
    const auto& identity = m_controller.identity();
    if (!m_controller.isConnected())
        m_wanted = m_sent = std::nullopt;
    else if (identity && identity->hasRegister(m_parameter.info().name))
        m_parameter.readIfUncertain();
    emit changed();
}

bool HandSpeed::offered() const
{
    const auto& program = m_controller.program();
    return m_controller.isConnected() && program && program::hasMaster(program->recipe) &&
           !m_controller.masterSetting()->leads() && !std::isnan(percent()) &&
           (m_controller.state() == Controller::State::Running || percent() < m_parameter.info().maximum);
}

double HandSpeed::percent() const
{
    return m_wanted.value_or(m_parameter.lastValue());
}

bool HandSpeed::canSlower() const
{
    return offered() && percent() > m_parameter.info().minimum;
}

bool HandSpeed::canFaster() const
{
    return offered() && percent() < m_parameter.info().maximum;
}

QString HandSpeed::rateText() const
{
    const double rate = m_controller.active().rateBagsPerMin;
    return std::isnan(rate) || std::isnan(percent())
               ? QString()
               : Format().measure(rate * percent() / m_parameter.info().maximum, 1,
                                  RecipeWords::unit("bags/min"));
}

void HandSpeed::slower()
{
    set(percent() - stepPercent);
}

void HandSpeed::faster()
{
    set(percent() + stepPercent);
}

void HandSpeed::full()
{
    set(m_parameter.info().maximum);
}

void HandSpeed::set(double wanted)
{
    if (!m_controller.accessCheck().require(Level::Operator) || !offered())
        return;
    if (!m_before)
        m_before = percent();
    m_rowTimer.start();
    m_message.clear();
    m_wanted = std::clamp(wanted, m_parameter.info().minimum, m_parameter.info().maximum);
    send();
    emit changed();
}

void HandSpeed::send()
{
    if (m_sent || !m_wanted)
        return;
    m_sent = m_wanted;
    m_controller.link().exchange(
        {0, std::string(m_parameter.info().name), m_wanted},
        {this, [this](const link::ParameterOutcome& outcome) { onAnswer(outcome); }});
}

void HandSpeed::onAnswer(const link::ParameterOutcome& outcome)
{
    const auto sent = std::exchange(m_sent, std::nullopt);
    if (outcome.end != link::ParameterEnd::Done) {
        m_wanted.reset();
        m_message = ConnectionSentences::parameter(tr("Speed"), outcome);
        m_parameter.read();
    } else if (m_wanted == sent) {
        m_wanted.reset();
    }
    send();
    emit changed();
}

void HandSpeed::note()
{
    const auto before = std::exchange(m_before, std::nullopt);
    if (before && *before != percent())
        emit noted({.what = u"hand.speed"_s, .before = text(*before), .after = text(percent())});
}

} // namespace campanel::panel
