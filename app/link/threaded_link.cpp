// SPDX-License-Identifier: Apache-2.0
#include "app/link/threaded_link.h"

#include "app/link/link_worker.h"

namespace campanel::link {

ThreadedLink::ThreadedLink(QObject* parent)
    : Link(parent)
{
    m_thread.setObjectName(QStringLiteral("link"));
    auto* worker = new LinkWorker; // deleted by its own thread, see the last connection
    worker->moveToThread(&m_thread);
    connect(this, &ThreadedLink::connectWanted, worker, &LinkWorker::connectTo);
    connect(this, &ThreadedLink::requestWanted, worker, &LinkWorker::request);
    connect(this, &ThreadedLink::parameterWanted, worker, &LinkWorker::requestParameter);
    connect(this, &ThreadedLink::downloadWanted, worker, &LinkWorker::download);
    connect(this, &ThreadedLink::cancelWanted, worker, &LinkWorker::cancelDownload);
    connect(worker, &LinkWorker::reported, this, &Link::reported);
    connect(worker, &LinkWorker::statusReceived, this, &Link::statusReceived);
    connect(worker, &LinkWorker::programRead, this, &Link::programRead);
    connect(worker, &LinkWorker::commandEnded, this, &Link::commandEnded);
    connect(worker, &LinkWorker::parameterEnded, this, &Link::parameterEnded);
    connect(worker, &LinkWorker::downloadReported, this, &Link::downloadReported);
    connect(&m_thread, &QThread::finished, worker, &QObject::deleteLater);
    m_thread.start();
}

ThreadedLink::~ThreadedLink()
{
    m_thread.quit();
    m_thread.wait();
}

} // namespace campanel::link
