// SPDX-License-Identifier: Apache-2.0
// `TouchCalibration` in QML: calibrates the touchscreen of the kiosk by four touched crosses. For the level
// Service, at standstill. A unit of systemd sets the result as root and restarts the panel, which then asks
// whether it stays; without an answer the calibration before returns.
#pragma once

#include "app/panel/display/touch_files.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/settings/system_service.h"

#include <QPointF>
#include <QTimer>

namespace campanel::panel {

class Controller;

class TouchCalibration : public campanel::panel::SystemService, public Singleton<TouchCalibration> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // Why it cannot be calibrated now; empty: it can.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    // True while a calibration that was made on the panel is in force.
    Q_PROPERTY(bool calibrated READ calibrated NOTIFY changed FINAL)
    // True while a cross or what came of the crosses is on the screen.
    Q_PROPERTY(bool open READ isOpen NOTIFY changed FINAL)
    // The cross to be touched, from 0; -1: none.
    Q_PROPERTY(int crossIndex READ crossIndex NOTIFY changed FINAL)
    Q_PROPERTY(int crossCount READ crossCount CONSTANT FINAL)
    // The place of that cross, in shares of the screen from its upper left corner as it is wired.
    Q_PROPERTY(QPointF cross MEMBER m_cross NOTIFY crossChanged FINAL)
    // The result of the crosses.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // The remaining seconds of the question whether the new calibration stays; 0: there is no question.
    Q_PROPERTY(int secondsLeft READ secondsLeft NOTIFY changed FINAL)
    // Why the calibration before could not return; empty: it did not have to, or could.
    Q_PROPERTY(QString notice READ notice NOTIFY changed FINAL)

public:
    static constexpr int trialTimeS = 20;
    static constexpr int idleTimeS = 60;
    static constexpr int crosses = 4;

    // The controller must outlive the object.
    TouchCalibration(Controller& controller, QObject* parent);

    // Sets the folders of the kiosk; nothing can be calibrated before.
    void setPlaces(const TouchPlaces& places) { m_places = places; }
    void setPatience(std::chrono::milliseconds patience) { m_patience.setInterval(patience); }
    // Begins the question when the panel was restarted for a new calibration.
    void resume();

    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] bool calibrated() const;
    [[nodiscard]] bool isOpen() const { return m_crossIndex >= 0 || m_end != End::None; }
    [[nodiscard]] int crossIndex() const { return m_crossIndex; }
    [[nodiscard]] static int crossCount() { return crosses; }
    [[nodiscard]] QString message() const;
    [[nodiscard]] bool failed() const { return m_end != End::None && m_end != End::Requested; }
    [[nodiscard]] int secondsLeft() const { return m_secondsLeft; }
    [[nodiscard]] QString notice() const { return m_notice; }

    Q_INVOKABLE void begin();
    // Takes a touch of the present cross, in shares of the screen as `cross`.
    Q_INVOKABLE void touch(QPointF place);
    Q_INVOKABLE void cancel();
    // Removes the calibration that was made on the panel.
    Q_INVOKABLE void remove();
    Q_INVOKABLE void keep();
    Q_INVOKABLE void goBack();
    Q_INVOKABLE void dismissNotice();
    // Ends a question, or crosses that nobody touches; runs once a second.
    void tick();

signals:
    void crossChanged();

protected:
    void ask() override;

private:
    enum class End { None, Requested, Missed, Implausible, NotSet };

    void setEnd(End end);
    void calculate();
    void apply(const QString& after);
    void request(const QString& wanted, const std::function<void(const QString& problem)>& done);
    void note(const TouchTrial& trial, const QString& outcome);

    Controller& m_controller;
    TouchPlaces m_places;
    bool m_hasTouchscreen = false;
    int m_crossIndex = -1;
    QPointF m_cross;
    QList<TouchPair> m_pairs;
    End m_end = End::None;
    int m_idleSeconds = 0;
    TouchTrial m_trial;
    int m_secondsLeft = 0;
    QString m_notice;
    QTimer m_timer;
    QTimer m_patience; // until the unit restarts the panel
};

} // namespace campanel::panel
