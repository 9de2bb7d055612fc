// SPDX-License-Identifier: Apache-2.0
#include "app/link/threaded_link.h"

#include <QMetaMethod>

namespace campanel::link {

ThreadedLink::ThreadedLink(QObject* parent)
    : Link(parent)
    , m_worker(new LinkWorker)
{
    m_thread.setObjectName(QStringLiteral("link"));
    const QMetaObject& events = LinkEvents::staticMetaObject;
    for (int i = events.methodOffset(); i < events.methodCount(); ++i)
        connect(m_worker, events.method(i), this, events.method(i));
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start();
}

ThreadedLink::~ThreadedLink()
{
    m_thread.quit();
    m_thread.wait();
}

} // namespace campanel::link
