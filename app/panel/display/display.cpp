// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/display.h"

#include "app/panel/controller/controller.h"
#include "app/panel/settings/settings.h"

#include <QCoreApplication>
#include <QEvent>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// After a touch that woke the screen: so long no other one acts.
constexpr auto wakingTime = 300ms;

} // namespace

Display::Display(Controller& controller, Settings& settings, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_backlight(Backlight::find())
    , m_touchedAt(controller.now())
{
    if (settings.isStored("display.brightness")) // else the system's brightness stays
        light(brightness());
    connect(&settings, &Settings::changed, this, [this] {
        if (!m_isDark && m_settings.isStored("display.brightness"))
            light(brightness());
    });
    m_timer.callOnTimeout(this, &Display::tick);
    m_timer.start(1s);
    connect(&controller, &Controller::stateChanged, this, [this] {
        if (!mayBeDark())
            setDark(false);
    });
    QCoreApplication::instance()->installEventFilter(this);
}

void Display::setBacklight(const std::optional<Backlight>& backlight)
{
    m_backlight = backlight;
    emit changed();
}

int Display::brightness() const
{
    return m_settings.values().whole("display.brightness");
}

int Display::darkAfterMinutes() const
{
    return m_settings.values().whole("display.dark_after_minutes");
}

void Display::light(int percent)
{
    if (m_backlight && !m_backlight->setPercent(percent))
        setBacklight({}); // the backlight is not adjustable any more
}

// Returns false while somebody must see or stop something without waking the screen first.
bool Display::mayBeDark() const
{
    switch (m_controller.state()) {
    case Controller::State::Unknown:
    case Controller::State::Idle:
    case Controller::State::Ready:
        return true;
    case Controller::State::Running:
    case Controller::State::Stopping:
    case Controller::State::Jogging:
    case Controller::State::Homing:
    case Controller::State::Fault:
        break;
    }
    return false;
}

void Display::setDark(bool isDark)
{
    if (m_isDark == isDark)
        return;
    m_isDark = isDark;
    if (!isDark)
        m_touchedAt = m_controller.now();
    light(isDark ? 0 : brightness());
    emit darkChanged();
}

void Display::wipe()
{
    m_wipeSeconds = wipeTimeS;
    emit wipeChanged();
}

void Display::tick()
{
    if (m_wipeSeconds > 0) {
        --m_wipeSeconds;
        emit wipeChanged();
    }
    if (!mayBeDark())
        m_touchedAt = m_controller.now(); // the time starts at standstill
    if (darkAfterMinutes() > 0 &&
        m_controller.now() - m_touchedAt >= std::chrono::minutes(darkAfterMinutes()))
        setDark(true);
}

bool Display::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::KeyPress: {
        m_touchedAt = m_controller.now();
        const bool isTouch = event->type() != QEvent::KeyPress;
        // The second touch of a double tap wakes too: nobody has seen yet what it would hit.
        const bool isSecond = isTouch && m_wokenAt && m_touchedAt - *m_wokenAt < wakingTime;
        if (isTouch && m_isDark)
            m_wokenAt = m_touchedAt;
        m_isWaking = isTouch && (m_isDark || isSecond);
        m_isFirst = m_isDark;
        if (m_isDark || isSecond) {
            setDark(false);
            return true;
        }
        break;
    }
    case QEvent::MouseMove:
    case QEvent::TouchUpdate:
        if (m_isWaking)
            return true;
        break;
    case QEvent::MouseButtonRelease:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        if (std::exchange(m_isWaking, false)) {
            if (m_isFirst)
                m_wokenAt = m_controller.now();
            return true;
        }
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace campanel::panel
