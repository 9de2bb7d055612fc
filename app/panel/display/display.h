// SPDX-License-Identifier: Apache-2.0
// `Display` in QML: brightness, a screen that turns off when it is not touched and nothing moves, and half a
// minute for cleaning it. Only Stop works during cleaning. The touch that wakes a dark screen has no other
// effect.
#pragma once

#include "app/panel/display/backlight.h"
#include "app/panel/kit/singleton.h"

#include "app/link/link_values.h"

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;
class Settings;

class Display : public QObject, public Singleton<Display> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True when this computer has an adjustable backlight.
    Q_PROPERTY(bool adjustable READ adjustable NOTIFY changed FINAL)
    Q_PROPERTY(bool dark READ dark NOTIFY darkChanged FINAL)
    // The remaining seconds without touch input; 0: touch input is active.
    Q_PROPERTY(int wipeSeconds READ wipeSeconds NOTIFY wipeChanged FINAL)

public:
    static constexpr int wipeTimeS = 30;

    // Stores its values in the settings file. Settings and machine must outlive the object.
    Display(Controller& controller, Settings& settings, QObject* parent);

    // Replaces the backlight of this computer, for tests and captures.
    void setBacklight(const std::optional<Backlight>& backlight);

    [[nodiscard]] bool adjustable() const { return m_backlight.has_value(); }
    [[nodiscard]] bool dark() const { return m_isDark; }
    [[nodiscard]] int wipeSeconds() const { return m_wipeSeconds; }

    Q_INVOKABLE void wipe();
    // Turns the screen off after its idle time; runs once a second.
    void tick();

signals:
    void changed();
    void darkChanged();
    void wipeChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] int brightness() const;
    [[nodiscard]] int darkAfterMinutes() const;
    void setDark(bool isDark);
    void light(int percent);
    [[nodiscard]] bool mayBeDark() const;

    Controller& m_controller;
    Settings& m_settings;
    std::optional<Backlight> m_backlight;
    QTimer m_timer;
    link::SteadyTime m_touchedAt;
    int m_wipeSeconds = 0;
    bool m_isDark = false;
    std::optional<link::SteadyTime> m_wokenAt; // the end of the waking touch
    bool m_isWaking = false;                   // the waking touch, or the one after it, has not ended
    bool m_isFirst = false;                    // it is the one that woke the screen
};

} // namespace campanel::panel
