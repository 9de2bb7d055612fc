// SPDX-License-Identifier: Apache-2.0
#include "app/panel/hand/hand_speed.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/program/recipe_master.h"

#include <chrono>
#include <cmath>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto readPeriod = 2s;

QString text(double percent)
{
    return u"%1 %"_s.arg(percent);
}

} // namespace

HandSpeed::HandSpeed(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_percent(controller, "hand.speed")
{
    connect(&m_percent, &HandValue::changed, this, &HandSpeed::changed);
    connect(&m_percent, &HandValue::moved, this, [this](double before, double after) {
        emit noted({.what = u"hand.speed"_s, .before = text(before), .after = text(after)});
    });
    connect(&controller, &Controller::programChanged, this, &HandSpeed::changed);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &HandSpeed::changed);
    updateEvery(readPeriod, [this] {
        if (offered())
            m_percent.read();
    });
    LanguageNotifier::follow(this);
}

bool HandSpeed::offered() const
{
    const auto& program = m_controller.program();
    return m_controller.isConnected() && program && program::hasMaster(program->recipe) &&
           !m_controller.masterSetting()->leads() && !std::isnan(percent()) &&
           (m_controller.state() == Controller::State::Running || percent() < m_percent.info().maximum);
}

bool HandSpeed::canSlower() const
{
    return offered() && percent() > m_percent.info().minimum;
}

bool HandSpeed::canFaster() const
{
    return offered() && percent() < m_percent.info().maximum;
}

QString HandSpeed::rateText() const
{
    const double rate = m_controller.active().rateBagsPerMin;
    return std::isnan(rate) || std::isnan(percent())
               ? QString()
               : Format().measure(rate * percent() / m_percent.info().maximum, 1,
                                  RecipeWords::unit("bags/min"));
}

QString HandSpeed::message() const
{
    return m_percent.failure() ? ConnectionSentences::parameter(tr("Speed"), *m_percent.failure())
                               : QString();
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
    set(m_percent.info().maximum);
}

void HandSpeed::set(double percent)
{
    if (m_controller.accessCheck().require(Level::Operator) && offered())
        m_percent.set(percent);
}

} // namespace campanel::panel
