// SPDX-License-Identifier: Apache-2.0
// `SystemClock` in QML: sets the clock, the time zone and the time server of this computer, by
// systemd-timedated on the D-Bus (org.freedesktop.timedate1). For the level Service. Without the service
// nothing can be set, and `stateText` says so. Nothing waits for the bus.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/settings/system_service.h"

#include <QStringList>

namespace campanel::panel {

class SystemClock : public campanel::panel::SystemService, public Singleton<SystemClock> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    Q_PROPERTY(bool canUseTimeServer READ canUseTimeServer NOTIFY changed FINAL)
    Q_PROPERTY(bool usesTimeServer READ usesTimeServer NOTIFY changed FINAL)
    // True when the clock can be moved: the service is there, and no time server sets the clock.
    Q_PROPERTY(bool movable READ movable NOTIFY changed FINAL)
    Q_PROPERTY(QString zone READ zone NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    Q_PROPERTY(QStringList regions READ regions CONSTANT FINAL) // "Asia", "Europe" ... and "UTC"

public:
    // The check must outlive the object.
    SystemClock(AccessCheck& check, QObject* parent);

    [[nodiscard]] bool canUseTimeServer() const { return available() && m_canUseTimeServer; }
    [[nodiscard]] bool usesTimeServer() const { return m_usesTimeServer; }
    [[nodiscard]] bool movable() const { return available() && !m_usesTimeServer && !busy(); }
    [[nodiscard]] QString zone() const { return m_zone; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] static QStringList regions();

    // Returns the zones of a region as {key, text, note}: "Europe/Berlin", "Berlin", "UTC+01:00".
    Q_INVOKABLE QVariantList zonesOf(const QString& region) const;
    // Moves the clock.
    Q_INVOKABLE void move(int minutes);
    Q_INVOKABLE void setUsesTimeServer(bool isUsed);
    Q_INVOKABLE void setZone(const QString& zone);

signals:
    // Emitted when the clock was moved.
    void moved();

protected:
    void ask() override;

private:
    void take(const QDBusPendingCall& answer);
    void apply(const QString& method, const QVariantList& arguments, const Change& change);

    bool m_canUseTimeServer = false;
    bool m_usesTimeServer = false;
    bool m_isSynchronized = false;
    QString m_zone;
};

} // namespace campanel::panel
