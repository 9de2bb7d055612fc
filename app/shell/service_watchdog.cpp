// SPDX-License-Identifier: Apache-2.0
#include "app/shell/service_watchdog.h"

namespace campanel::shell {
namespace {

// The number of rounds in the service manager's period: a single late one does not end the panel.
constexpr int turnsInPeriod = 4;

} // namespace

ServiceWatchdog::ServiceWatchdog(const ServiceManager& manager, link::Link& link, QQuickWindow& window)
    : m_manager(manager)
    , m_link(link)
    , m_window(window)
{
    if (!m_manager.isThere())
        return;
    // Painting may have its own thread; this object's slots run in the GUI thread.
    connect(&m_window, &QQuickWindow::frameSwapped, this, &ServiceWatchdog::notePainted);
    if (!m_manager.watchdogPeriod())
        return;
    connect(&m_link, &link::Link::pingAnswered, this, &ServiceWatchdog::noteAnswer);
    connect(&m_timer, &QTimer::timeout, this, &ServiceWatchdog::beginTurn);
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(*m_manager.watchdogPeriod()) /
                  turnsInPeriod);
}

void ServiceWatchdog::beginTurn()
{
    if (m_isOpen || !m_isReady)
        return;
    m_isOpen = true;
    m_isAnswered = false;
    m_isPainted = !m_window.isExposed(); // a hidden window paints nothing
    m_link.ping(++m_turn);
    m_window.update();
}

void ServiceWatchdog::noteAnswer(quint32 turn)
{
    if (turn != m_turn)
        return;
    m_isAnswered = true;
    feedWhenComplete();
}

void ServiceWatchdog::notePainted()
{
    if (!m_isReady) {
        m_isReady = true;
        m_manager.notify("READY=1");
    }
    m_isPainted = true;
    feedWhenComplete();
}

void ServiceWatchdog::feedWhenComplete()
{
    if (!m_isOpen || !m_isAnswered || !m_isPainted)
        return;
    m_isOpen = false;
    m_manager.notify("WATCHDOG=1");
}

} // namespace campanel::shell
