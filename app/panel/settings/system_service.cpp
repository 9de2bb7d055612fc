// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/system_service.h"

#include "app/panel/kit/access_check.h"
#include "app/panel/kit/language_notifier.h"

#include <QDBusError>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>

#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr int patienceMs = 5000;

} // namespace

SystemService::SystemService(AccessCheck& check, const QString& service, QObject* parent)
    : Watched(parent)
    , m_check(check)
    , m_bus{[] { return QDBusConnection::systemBus(); }, service}
{
    connect(this, &Watched::watchedChanged, this, [this] {
        m_problem.clear();
        if (watched())
            m_isAsked = m_isAvailable = false; // the service may have come or gone
        emit changed();
    });
    updateEvery(2s, [this] { refresh(); });
    LanguageNotifier::follow(this);
}

void SystemService::refresh()
{
    if (!std::exchange(m_isAsking, true))
        ask();
}

void SystemService::setAnswer(bool isAvailable)
{
    m_isAsking = false;
    m_isAsked = true;
    m_isAvailable = isAvailable;
    emit changed();
}

// A call without a bus would never end.
void SystemService::Bus::send(const Call& call, QObject* context, const Handler& handler) const
{
    QDBusMessage message = QDBusMessage::createMethodCall(service, call.path, call.interface, call.method);
    message.setArguments(call.arguments);
    const QDBusConnection bus = connect();
    const QDBusPendingCall pending =
        bus.isConnected() ? bus.asyncCall(message, patienceMs)
                          : QDBusPendingCall::fromError({QDBusError::Disconnected, u"no D-Bus"_s});
    auto* watcher = new QDBusPendingCallWatcher(pending, context);
    QObject::connect(watcher, &QDBusPendingCallWatcher::finished, context,
                     [handler](QDBusPendingCallWatcher* finished) {
                         finished->deleteLater();
                         handler(*finished);
                     });
}

bool SystemService::begin()
{
    if (m_isBusy || !m_check.require(Level::Service))
        return false;
    m_isBusy = true;
    m_problem.clear();
    emit changed();
    return true;
}

void SystemService::finish(const Change& change, const QString& problem)
{
    m_isBusy = false;
    m_problem = problem;
    emit noted({.what = u"setting.change"_s,
                .object = change.object,
                .before = change.before,
                .after = change.after,
                .outcome = problem.isEmpty() ? u"done"_s : u"failed"_s});
    emit changed();
    refresh();
}

QString SystemService::forbiddenText(const QDBusError& error)
{
    const bool isForbidden = error.type() == QDBusError::AccessDenied ||
                             error.name() == u"org.freedesktop.DBus.Error.InteractiveAuthorizationRequired" ||
                             error.name().endsWith(u".PermissionDenied"); // NetworkManager's
    return isForbidden ? tr("The operating system does not allow the panel to do this. Install polkit and "
                            "the rule of the CamPanel package.")
                       : QString();
}

QString SystemService::problemOf(const QDBusError& error)
{
    if (!error.isValid())
        return {};
    const QString forbidden = forbiddenText(error);
    return forbidden.isEmpty() ? tr("Not set: %1").arg(error.message()) : forbidden;
}

} // namespace campanel::panel
