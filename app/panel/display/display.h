// SPDX-License-Identifier: Apache-2.0
// `Display` in QML: brightness, a screen that goes dark when nobody touches it and nothing moves, and half a
// minute in which it can be wiped: only Stop works then. The touch that wakes a dark screen does nothing
// else.
#pragma once

#include "app/panel/display/backlight.h"

#include "app/link/link_values.h"
#include "app/store/files/settings_file.h"

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Machine;
class Settings;

class Display : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // This computer has a backlight that can be set.
    Q_PROPERTY(bool adjustable READ adjustable NOTIFY changed FINAL)
    // Per cent; the next of `brightnessChoices`.
    Q_PROPERTY(int brightness READ brightness WRITE setBrightness NOTIFY changed FINAL)
    Q_PROPERTY(QList<int> brightnessChoices READ brightnessChoices CONSTANT FINAL)
    // Minutes without a touch; 0: never.
    Q_PROPERTY(int darkAfterMinutes READ darkAfterMinutes WRITE setDarkAfterMinutes NOTIFY changed FINAL)
    Q_PROPERTY(QList<int> darkChoices READ darkChoices CONSTANT FINAL)
    Q_PROPERTY(bool dark READ dark NOTIFY darkChanged FINAL)
    // Until touches count again; 0: they do.
    Q_PROPERTY(int wipeSeconds READ wipeSeconds NOTIFY wipeChanged FINAL)

public:
    static constexpr int wipeTimeS = 30;

    // Keeps what is set in the file of the settings. They and the machine must outlive it.
    Display(Machine& machine, Settings& settings, QObject* parent);

    // The instance that attachToEngine() gave to this engine.
    static Display* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // Instead of the one of this computer, for tests and captures.
    void setBacklight(const std::optional<Backlight>& backlight);

    [[nodiscard]] bool adjustable() const { return m_backlight.has_value(); }
    [[nodiscard]] int brightness() const { return m_brightness; }
    void setBrightness(int percent);
    [[nodiscard]] QList<int> brightnessChoices() const;
    [[nodiscard]] int darkAfterMinutes() const { return m_darkAfterMinutes; }
    void setDarkAfterMinutes(int minutes);
    [[nodiscard]] QList<int> darkChoices() const;
    [[nodiscard]] bool dark() const { return m_isDark; }
    [[nodiscard]] int wipeSeconds() const { return m_wipeSeconds; }

    Q_INVOKABLE void wipe();
    // Looks whether it is time to go dark; comes by itself once a second.
    void tick();

signals:
    void changed();
    void darkChanged();
    void wipeChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setDark(bool isDark);
    void light(int percent);
    [[nodiscard]] bool mayBeDark() const;

    Machine& m_machine;
    store::SettingsFile& m_file;
    std::optional<Backlight> m_backlight;
    QTimer m_timer;
    link::SteadyTime m_touchedAt;
    int m_brightness = 100;
    int m_darkAfterMinutes = 0;
    int m_wipeSeconds = 0;
    bool m_isDark = false;
    bool m_isWaking = false; // the finger that woke it is still there
};

} // namespace campanel::machine
