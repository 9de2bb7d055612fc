// SPDX-License-Identifier: Apache-2.0
#include "app/panel/hand/hand_bags.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/controller_sentences.h"

namespace campanel::panel {

HandBags::HandBags(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_place(controller.parameter("master.place"))
{
    connect(&controller, &Controller::commandsChanged, this, &HandBags::changed);
    connect(&controller, &Controller::commandMessageChanged, this, &HandBags::changed);
    connect(&controller, &Controller::programChanged, this, &HandBags::changed);
    connect(&m_place, &Parameter::changed, this, &HandBags::changed);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &HandBags::changed);
    connect(controller.packing(), &PackingLine::changed, this, &HandBags::changed);
    LanguageNotifier::follow(this);
}

bool HandBags::offered() const
{
    const auto& identity = m_controller.identity();
    return m_controller.isConnected() && identity && identity->mapMinor >= modbus::bagsByHandMapMinor &&
           m_controller.program() && m_controller.program()->recipe.isCutter() &&
           m_controller.packing()->present();
}

QString HandBags::bagReason() const
{
    const bool isWheel = m_controller.masterSetting()->leads() &&
                         m_place.lastValue() == static_cast<double>(modbus::MasterPlace::Wheel);
    const QString reason = m_controller.blockedReason(Action::JogBag);
    return reason.isEmpty() && isWheel ? ControllerSentences::refusal(modbus::Refusal::FilmNotOurs) : reason;
}

QString HandBags::cutReason() const
{
    return m_controller.blockedReason(Action::SingleCut);
}

QString HandBags::takeReason() const
{
    return m_controller.blockedReason(Action::TakeBag);
}

QString HandBags::message() const
{
    return m_controller.commandMessage();
}

void HandBags::makeBag()
{
    if (m_controller.accessCheck().require(Level::Operator) && bagReason().isEmpty())
        m_controller.startBy(modbus::Command::JogBag);
}

void HandBags::cut()
{
    if (m_controller.accessCheck().require(Level::Operator) && cutReason().isEmpty())
        m_controller.startBy(modbus::Command::SingleCut);
}

void HandBags::take()
{
    if (m_controller.accessCheck().require(Level::Operator) && takeReason().isEmpty())
        m_controller.send(modbus::Command::TakeBag);
}

} // namespace campanel::panel
