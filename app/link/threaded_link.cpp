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
    connect(this, &ThreadedLink::withdrawalWanted, worker, &LinkWorker::withdrawStop);
    connect(this, &ThreadedLink::jogWanted, worker, &LinkWorker::setJog);
    connect(this, &ThreadedLink::readWanted, worker, &LinkWorker::readRegisters);
    connect(this, &ThreadedLink::comparisonWanted, worker, &LinkWorker::compareProgram);
    connect(this, &ThreadedLink::comparisonCancelWanted, worker, &LinkWorker::cancelComparison);
    connect(this, &ThreadedLink::scanWanted, worker, &LinkWorker::startScan);
    connect(this, &ThreadedLink::scanCancelWanted, worker, &LinkWorker::cancelScan);
    connect(this, &ThreadedLink::faultsWanted, worker, &LinkWorker::simulateFaults);
    connect(this, &ThreadedLink::rulerWanted, worker, &LinkWorker::measureSimulatedBag);
    connect(this, &ThreadedLink::pingWanted, worker, &LinkWorker::pingAnswered);
    connect(this, &ThreadedLink::figuresWatchWanted, worker, &LinkWorker::watchFigures);
    connect(this, &ThreadedLink::figuresResetWanted, worker, &LinkWorker::resetFigures);
    connect(this, &ThreadedLink::framesWatchWanted, worker, &LinkWorker::watchFrames);
    connect(worker, &LinkWorker::reported, this, &Link::reported);
    connect(worker, &LinkWorker::statusReceived, this, &Link::statusReceived);
    connect(worker, &LinkWorker::programRead, this, &Link::programRead);
    connect(worker, &LinkWorker::commandEnded, this, &Link::commandEnded);
    connect(worker, &LinkWorker::parameterEnded, this, &Link::parameterEnded);
    connect(worker, &LinkWorker::downloadReported, this, &Link::downloadReported);
    connect(worker, &LinkWorker::registersRead, this, &Link::registersRead);
    connect(worker, &LinkWorker::comparisonReported, this, &Link::comparisonReported);
    connect(worker, &LinkWorker::scanReported, this, &Link::scanReported);
    connect(worker, &LinkWorker::faultsSimulated, this, &Link::faultsSimulated);
    connect(worker, &LinkWorker::rulerRead, this, &Link::rulerRead);
    connect(worker, &LinkWorker::figuresReported, this, &Link::figuresReported);
    connect(worker, &LinkWorker::framesRecorded, this, &Link::framesRecorded);
    connect(worker, &LinkWorker::pingAnswered, this, &Link::pingAnswered);
    connect(&m_thread, &QThread::finished, worker, &QObject::deleteLater);
    m_thread.start();
}

ThreadedLink::~ThreadedLink()
{
    m_thread.quit();
    m_thread.wait();
}

} // namespace campanel::link
