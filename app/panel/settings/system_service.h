// SPDX-License-Identifier: Apache-2.0
// The base of what is set on this computer by a service of the operating system on the D-Bus. The service is
// asked while the object is on the screen. A change is for the level Service and noted for the audit trail.
// Nothing waits for the bus.
#pragma once

#include "app/panel/kit/watched.h"
#include "app/store/logs/audit_log.h"

#include <QDBusConnection>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>

class QDBusError;
class QDBusPendingCall;

namespace campanel::panel {

class AccessCheck;

class SystemService : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The base of SystemClock and SystemNetwork")
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // Why the last change failed; empty: it was made.
    Q_PROPERTY(QString problem READ problem NOTIFY changed FINAL)

public:
    using Handler = std::function<void(const QDBusPendingCall& answer)>;
    struct Call {
        QString path;
        QString interface;
        QString method;
        QVariantList arguments;
    };
    // The bus and the name of the service on it; empty on a connection between two programs.
    struct Bus {
        std::function<QDBusConnection()> connect;
        QString service;

        // Calls the handler with the answer, also without a bus, but not after the end of `context`.
        void send(const Call& call, QObject* context, const Handler& handler) const;
    };

    // Returns the sentence for a change that the operating system forbids; empty for another error.
    [[nodiscard]] static QString forbiddenText(const QDBusError& error);

    // Replaces the system bus, for tests.
    void setBus(const Bus& bus) { m_bus = bus; }

    [[nodiscard]] bool available() const { return m_isAvailable; }
    // Returns true when the service has answered, or has failed to.
    [[nodiscard]] bool isAsked() const { return m_isAsked; }
    [[nodiscard]] bool busy() const { return m_isBusy; }
    [[nodiscard]] QString problem() const { return m_problem; }

signals:
    void changed();
    // Emitted with a change, for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

protected:
    struct Change {
        QString object;
        QString before;
        QString after;
    };

    // The check must outlive the object.
    SystemService(AccessCheck& check, const QString& service, QObject* parent);

    // Sends the questions; the last answer calls setAnswer().
    virtual void ask() = 0;
    void refresh();
    void setAnswer(bool isAvailable);
    void send(const Call& call, const Handler& handler) { m_bus.send(call, this, handler); }
    // Returns false when a change may not begin.
    [[nodiscard]] bool begin();
    void finish(const Change& change, const QString& problem);
    // Returns the sentence for an error; empty: none.
    [[nodiscard]] static QString problemOf(const QDBusError& error);

private:
    AccessCheck& m_check;
    Bus m_bus;
    bool m_isAsking = false;
    bool m_isAsked = false; // an answer or a failure is there
    bool m_isAvailable = false;
    bool m_isBusy = false;
    QString m_problem;
};

} // namespace campanel::panel
