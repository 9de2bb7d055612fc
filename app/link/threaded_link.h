// SPDX-License-Identifier: Apache-2.0
// The Link of the panel program: a LinkWorker in a thread of its own, reached through its event queue only.
#pragma once

#include "app/link/link.h"
#include "app/link/link_worker.h"

#include <QThread>

namespace campanel::link {

class ThreadedLink : public Link {
    Q_OBJECT

public:
    explicit ThreadedLink(QObject* parent);
    // Ends the thread after the present exchange; waiting requests get no outcome.
    ~ThreadedLink() override;

    void connectTo(const ConnectionSettings& settings) override { post(&LinkWorker::connectTo, settings); }
    void download(const std::vector<std::uint16_t>& bank) override { post(&LinkWorker::download, bank); }
    void cancelDownload() override { post(&LinkWorker::cancelDownload); }
    void withdrawStop() override { post(&LinkWorker::withdrawStop); }
    // Sets the key. Its validity begins now, regardless of a delay in the link thread.
    void setJog(JogDirection direction) override
    {
        post(&LinkWorker::setJog, JogRequest{direction, std::chrono::steady_clock::now() + jogCounts});
    }
    void setPermit(std::uint16_t bits) override
    {
        post(&LinkWorker::setPermit, PermitRequest{bits, std::chrono::steady_clock::now() + permitCounts});
    }
    void compareProgram(const std::vector<std::uint16_t>& bank) override
    {
        post(&LinkWorker::compareProgram, bank);
    }
    void cancelComparison() override { post(&LinkWorker::cancelComparison); }
    void startScan(modbus::ScanPlan::Depth depth) override { post(&LinkWorker::startScan, depth); }
    void cancelScan() override { post(&LinkWorker::cancelScan); }
    void simulateFaults(const QStringList& rules) override { post(&LinkWorker::simulateFaults, rules); }
    void measureSimulatedBag() override { post(&LinkWorker::measureSimulatedBag); }
    void ping(quint32 number) override { post(&LinkWorker::pingAnswered, number); }
    void watchFigures(bool isWatched) override { post(&LinkWorker::watchFigures, isWatched); }
    void resetFigures() override { post(&LinkWorker::resetFigures); }
    void watchFrames(bool isWatched) override { post(&LinkWorker::watchFrames, isWatched); }

protected:
    void sendCommand(const CommandRequest& request) override { post(&LinkWorker::request, request); }
    void sendParameter(const ParameterRequest& request) override
    {
        post(&LinkWorker::requestParameter, request);
    }
    void sendRead(const ReadRequest& request) override { post(&LinkWorker::readRegisters, request); }

private:
    // Calls the worker's function in its thread.
    template <class Function, class... Arguments> void post(Function function, const Arguments&... arguments)
    {
        QMetaObject::invokeMethod(
            m_worker, [worker = m_worker, function, arguments...] { (worker->*function)(arguments...); },
            Qt::QueuedConnection);
    }

    QThread m_thread;
    LinkWorker* m_worker; // lives in m_thread and is deleted at its end
};

} // namespace campanel::link
