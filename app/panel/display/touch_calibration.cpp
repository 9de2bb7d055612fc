// SPDX-License-Identifier: Apache-2.0
#include "app/panel/display/touch_calibration.h"

#include "app/panel/controller/controller.h"

#include <QDBusError>
#include <QDBusPendingReply>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

const QString unitName = QStringLiteral("campanel-touch.service");
const QString managerPath = QStringLiteral("/org/freedesktop/systemd1");
const QString managerInterface = QStringLiteral("org.freedesktop.systemd1.Manager");

} // namespace

TouchCalibration::TouchCalibration(Controller& controller, QObject* parent)
    : SystemService(controller.accessCheck(), u"org.freedesktop.systemd1"_s, parent)
    , m_controller(controller)
{
    m_timer.setInterval(1s);
    m_timer.callOnTimeout(this, &TouchCalibration::tick);
    m_patience.setSingleShot(true);
    m_patience.setInterval(15s);
    m_patience.callOnTimeout(this, [this] {
        removeTrial(m_places);
        removeTouchRequest(m_places);
        finish({u"touchscreen"_s, m_trial.before, m_trial.after},
               tr("The calibration was not set. Read journalctl -u campanel-touch."));
        setEnd(End::NotSet);
    });
    connect(&controller, &Controller::stateChanged, this, [this] {
        if (m_controller.isMoving() && m_crossIndex >= 0)
            cancel();
        emit changed();
    });
}

void TouchCalibration::ask()
{
    m_hasTouchscreen = touchscreenMatrix(m_places).has_value();
    if (m_places.requestFolder.isEmpty())
        return setAnswer(false);
    send({managerPath, managerInterface, u"GetUnitFileState"_s, {unitName}},
         [this](const QDBusPendingCall& answer) {
             const QDBusPendingReply<QString> reply(answer);
             setAnswer(!reply.isError() && reply.value() != u"masked");
         });
}

QString TouchCalibration::blockedReason() const
{
    if (!available())
        return tr("The touchscreen is calibrated in the operating system of this computer.");
    if (!m_hasTouchscreen)
        return tr("This computer has no touchscreen.");
    return m_controller.blockedReason(Action::CalibrateTouch);
}

bool TouchCalibration::calibrated() const
{
    return setCalibration(m_places) != noCalibration;
}

QString TouchCalibration::message() const
{
    switch (m_end) {
    case End::None:
        return {};
    case End::Requested:
        return tr("The panel closes, sets the calibration and comes back.");
    case End::Missed:
        return tr("A cross was missed. Touch the center of each cross.");
    case End::Implausible:
        return tr("The touches do not fit the screen. Touch each cross where it is shown.");
    case End::NotSet:
        break;
    }
    return problem();
}

void TouchCalibration::setEnd(End end)
{
    m_crossIndex = -1;
    m_end = end;
    m_timer.stop();
    emit changed();
}

void TouchCalibration::begin()
{
    if (!m_controller.accessCheck().require(Level::Service) || busy() || !blockedReason().isEmpty())
        return;
    setEnd(End::None);
    m_pairs.clear();
    m_crossIndex = 0;
    m_idleSeconds = 0;
    m_timer.start();
    emit changed();
}

void TouchCalibration::touch(QPointF place)
{
    if (m_crossIndex < 0)
        return;
    m_pairs << TouchPair{place, m_cross};
    m_idleSeconds = 0;
    ++m_crossIndex;
    if (m_crossIndex == crosses)
        calculate();
    emit changed();
}

// The touchscreen has reported the touches by the calibration in force; the new one comes after it.
void TouchCalibration::calculate()
{
    const auto fit = fitTouches(m_pairs);
    if (!fit)
        return setEnd(fit.error() == TouchFault::Missed ? End::Missed : End::Implausible);
    const TouchMatrix matrix = composed(*fit, touchscreenMatrix(m_places).value_or(plainTouch));
    if (!isUsable(matrix))
        return setEnd(End::Implausible);
    apply(matrixText(matrix));
}

void TouchCalibration::cancel()
{
    if (m_end != End::Requested)
        setEnd(End::None);
}

void TouchCalibration::remove()
{
    if (m_controller.accessCheck().require(Level::Service) && blockedReason().isEmpty() && calibrated())
        apply(noCalibration);
}

void TouchCalibration::apply(const QString& after)
{
    if (!SystemService::begin())
        return setEnd(End::None);
    setEnd(End::Requested);
    m_trial = {setCalibration(m_places), after};
    const auto endWith = [this](const QString& problem) {
        if (problem.isEmpty()) {
            note(m_trial, u"requested"_s);
            m_patience.start();
            return;
        }
        removeTrial(m_places);
        finish({u"touchscreen"_s, m_trial.before, m_trial.after}, problem);
        setEnd(End::NotSet);
    };
    if (writeTrial(m_places, m_trial))
        request(after, endWith);
    else
        endWith(tr("Not set: %1").arg(m_places.stateFolder));
}

void TouchCalibration::request(const QString& wanted, const std::function<void(const QString& problem)>& done)
{
    if (!writeTouchRequest(m_places, wanted))
        return done(tr("Not set: %1").arg(m_places.requestFolder));
    send({managerPath, managerInterface, u"StartUnit"_s, {unitName, u"replace"_s}},
         [this, done](const QDBusPendingCall& answer) {
             if (answer.isError())
                 removeTouchRequest(m_places);
             done(problemOf(answer.error()));
         });
}

// A power cut may have come before the unit has set the calibration, or after it has gone back.
void TouchCalibration::resume()
{
    const auto trial = readTrial(m_places);
    if (!trial || setCalibration(m_places) != trial->after || trial->before == trial->after)
        return removeTrial(m_places);
    m_trial = *trial;
    m_secondsLeft = trialTimeS;
    m_timer.start();
    emit changed();
}

void TouchCalibration::keep()
{
    if (m_secondsLeft == 0)
        return;
    removeTrial(m_places);
    note(m_trial, u"done"_s);
    m_secondsLeft = 0;
    setEnd(End::None);
}

// Needs no login: it was there when the calibration was made. The trial stays on the disk until the restart
// has shown that the calibration before is set.
void TouchCalibration::goBack()
{
    if (m_secondsLeft == 0)
        return;
    m_secondsLeft = 0;
    setEnd(End::None);
    request(m_trial.before, [this](const QString& problem) {
        note(m_trial, problem.isEmpty() ? u"withdrawn"_s : u"failed"_s);
        if (!problem.isEmpty())
            m_notice = tr("The earlier calibration of the touchscreen did not return. %1").arg(problem);
        emit changed();
    });
}

void TouchCalibration::dismissNotice()
{
    m_notice.clear();
    emit changed();
}

void TouchCalibration::tick()
{
    if (m_secondsLeft == 1)
        goBack();
    else if (m_secondsLeft > 0)
        --m_secondsLeft;
    else if (m_crossIndex >= 0 && ++m_idleSeconds >= idleTimeS)
        cancel();
    emit changed();
}

void TouchCalibration::note(const TouchTrial& trial, const QString& outcome)
{
    emit noted({.what = u"setting.change"_s,
                .object = u"touchscreen"_s,
                .before = trial.before,
                .after = trial.after,
                .outcome = outcome});
}

} // namespace campanel::panel
