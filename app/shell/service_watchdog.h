// SPDX-License-Identifier: Apache-2.0
// Notifies the service manager that the panel is ready, and periodically that it works. It works when, since
// the last time, the GUI thread has run, the link thread has answered it, and a frame was painted. A panel
// with frozen numbers is restarted.
#pragma once

#include "app/link/link.h"
#include "app/shell/service_manager.h"

#include <QObject>
#include <QQuickWindow>
#include <QTimer>

namespace campanel::shell {

class ServiceWatchdog : public QObject {
    Q_OBJECT

public:
    // All arguments must outlive the object.
    ServiceWatchdog(const ServiceManager& manager, link::Link& link, QQuickWindow& window);

private:
    void beginTurn();
    void noteAnswer(quint32 turn);
    void notePainted();
    void feedWhenComplete();

    const ServiceManager& m_manager;
    link::Link& m_link;
    QQuickWindow& m_window;
    QTimer m_timer;
    quint32 m_turn = 0;
    bool m_isReady = false;
    bool m_isOpen = false; // this round waits for the two below
    bool m_isAnswered = false;
    bool m_isPainted = false;
};

} // namespace campanel::shell
