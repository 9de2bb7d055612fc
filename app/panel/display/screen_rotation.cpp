// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/screen_rotation.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr Setting rotationSetting("display.rotation");

} // namespace

ScreenRotation::ScreenRotation(Controller& controller, Settings& settings, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
{
    m_timer.setInterval(1s);
    m_timer.callOnTimeout(this, &ScreenRotation::tick);
    connect(&settings, &Settings::changed, this, &ScreenRotation::changed);
    LanguageNotifier::follow(this);
    connect(&controller, &Controller::stateChanged, this, [this] {
        if (m_controller.isMoving())
            goBack(); // now, not in the middle of a run
        emit changed();
    });
}

void ScreenRotation::setScreen(QSize screen)
{
    if (std::exchange(m_screen, screen) != screen)
        emit changed();
}

QList<int> ScreenRotation::choices() const
{
    QList<int> choices;
    for (const int degrees : numbersOf(rotationSetting)) {
        const bool isAcross = degrees % 180 != 0;
        if (isAcross == (m_screen.height() > m_screen.width()))
            choices << degrees;
    }
    return choices;
}

// A rotation that does not fit this screen, as one from a configuration for another, is replaced.
int ScreenRotation::degrees() const
{
    const int wanted = m_tried.value_or(m_settings.values().whole(rotationSetting));
    const QList<int> possible = choices();
    return possible.contains(wanted) ? wanted : possible.first();
}

QString ScreenRotation::blockedReason() const
{
    return m_controller.blockedReason(Action::RotateScreen);
}

void ScreenRotation::tryOut(int degrees)
{
    if (!m_controller.accessCheck().require(Level::Service) || !choices().contains(degrees) ||
        degrees == this->degrees() || !blockedReason().isEmpty())
        return;
    m_tried = degrees;
    m_secondsLeft = trialTimeS;
    m_timer.start();
    emit changed();
}

void ScreenRotation::keep()
{
    if (!m_tried)
        return;
    m_settings.set(rotationSetting, settingText(*m_tried));
    goBack(); // to the rotation in the settings
}

void ScreenRotation::goBack()
{
    if (!m_tried)
        return;
    m_tried.reset();
    m_secondsLeft = 0;
    m_timer.stop();
    emit changed();
}

void ScreenRotation::tick()
{
    if (m_secondsLeft > 1) {
        --m_secondsLeft;
        emit changed();
    } else {
        goBack();
    }
}

} // namespace campanel::panel
