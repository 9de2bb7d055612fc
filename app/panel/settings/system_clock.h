// SPDX-License-Identifier: Apache-2.0
// `SystemClock` in QML: sets the clock, the time zone and the time server of this computer, by
// systemd-timedated on the D-Bus (org.freedesktop.timedate1). For the level Service. Without the service
// nothing can be set, and `stateText` says so. Nothing waits for the bus.
#pragma once

#include "app/store/logs/audit_log.h"

#include <QDBusConnection>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>

class QDBusMessage;
class QDBusPendingCall;
class QJSEngine;
class QQmlEngine;

namespace campanel::panel {

class AccessCheck;

class SystemClock : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True while it is on the screen; only then the service is asked.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    Q_PROPERTY(bool canUseTimeServer READ canUseTimeServer NOTIFY changed FINAL)
    Q_PROPERTY(bool usesTimeServer READ usesTimeServer NOTIFY changed FINAL)
    // True when the clock can be moved: the service is there, and no time server sets the clock.
    Q_PROPERTY(bool movable READ movable NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    Q_PROPERTY(QString zone READ zone NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    // Why the last change failed; empty: it was made.
    Q_PROPERTY(QString problem READ problem NOTIFY changed FINAL)
    Q_PROPERTY(QStringList regions READ regions CONSTANT FINAL) // "Asia", "Europe" ... and "UTC"

public:
    // The bus and the name of the service on it; empty on a connection between two programs.
    struct Bus {
        std::function<QDBusConnection()> connect;
        QString service;
    };

    // The check must outlive the object.
    SystemClock(AccessCheck& check, QObject* parent);

    static SystemClock* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // Replaces the system bus, for tests.
    void setBus(const Bus& bus) { m_bus = bus; }

    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    [[nodiscard]] bool available() const { return m_isAvailable; }
    [[nodiscard]] bool canUseTimeServer() const { return m_isAvailable && m_canUseTimeServer; }
    [[nodiscard]] bool usesTimeServer() const { return m_usesTimeServer; }
    [[nodiscard]] bool movable() const { return m_isAvailable && !m_usesTimeServer && !m_isBusy; }
    // Returns true when the service has answered, or has failed to.
    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    [[nodiscard]] bool busy() const { return m_isBusy; }
    [[nodiscard]] QString zone() const { return m_zone; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QString problem() const { return m_problem; }
    [[nodiscard]] static QStringList regions();

    // Returns the zones of a region as {key, text, note}: "Europe/Berlin", "Berlin", "UTC+01:00".
    Q_INVOKABLE QVariantList zonesOf(const QString& region) const;
    // Moves the clock.
    Q_INVOKABLE void move(int minutes);
    Q_INVOKABLE void setUsesTimeServer(bool isUsed);
    Q_INVOKABLE void setZone(const QString& zone);

signals:
    void changed();
    // Emitted when the clock was moved.
    void moved();
    // Emitted with a change, for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    struct Change {
        QString method;
        QVariantList arguments;
        QString object; // for the audit trail
        QString before;
        QString after;
    };

    void ask();
    void take(const QDBusPendingCall& answer);
    void apply(const Change& change);
    void finish(const Change& change, const QDBusPendingCall& answer);
    [[nodiscard]] QDBusPendingCall send(const QDBusMessage& call) const;
    [[nodiscard]] QDBusMessage callOf(const QString& interface, const QString& method) const;

    AccessCheck& m_check;
    Bus m_bus;
    QTimer m_timer;
    bool m_isWatched = false;
    bool m_isAsking = false;
    bool m_isAsked = false; // an answer or a failure is there
    bool m_isAvailable = false;
    bool m_canUseTimeServer = false;
    bool m_usesTimeServer = false;
    bool m_isSynchronized = false;
    bool m_isBusy = false;
    QString m_zone;
    QString m_problem;
};

} // namespace campanel::panel
