// SPDX-License-Identifier: Apache-2.0
// `ScreenRotation` in QML: turns the panel for a screen that is mounted upside down or upright. For the level
// Service, at standstill. A tried rotation goes back unless a person keeps it.
#pragma once

#include "app/panel/kit/singleton.h"

#include <QList>
#include <QObject>
#include <QSize>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Settings;

class ScreenRotation : public QObject, public Singleton<ScreenRotation> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // The size of the window, px, as the screen has it: not rotated.
    Q_PROPERTY(QSize screen READ screen WRITE setScreen NOTIFY changed FINAL)
    // The present rotation, clockwise: 0, 90, 180 or 270.
    Q_PROPERTY(int degrees READ degrees NOTIFY changed FINAL)
    // The rotations that give the panel its width on this screen.
    Q_PROPERTY(QList<int> choices READ choices NOTIFY changed FINAL)
    // The remaining seconds of the question whether the tried rotation stays; 0: none is tried.
    Q_PROPERTY(int secondsLeft READ secondsLeft NOTIFY changed FINAL)
    // Why it cannot be changed now; empty: it can.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)

public:
    static constexpr int trialTimeS = 15;

    // Stores its value in the settings file. Settings and machine must outlive the object.
    ScreenRotation(Controller& controller, Settings& settings, QObject* parent);

    [[nodiscard]] QSize screen() const { return m_screen; }
    void setScreen(QSize screen);
    [[nodiscard]] int degrees() const;
    [[nodiscard]] QList<int> choices() const;
    [[nodiscard]] int secondsLeft() const { return m_secondsLeft; }
    [[nodiscard]] QString blockedReason() const;

    Q_INVOKABLE void tryOut(int degrees);
    Q_INVOKABLE void keep();
    Q_INVOKABLE void goBack();
    // Ends a trial after its time; runs once a second.
    void tick();

signals:
    void changed();

private:
    Controller& m_controller;
    Settings& m_settings;
    QSize m_screen;
    std::optional<int> m_tried;
    int m_secondsLeft = 0;
    QTimer m_timer;
};

} // namespace campanel::panel
