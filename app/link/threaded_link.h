// SPDX-License-Identifier: Apache-2.0
// The Link of the panel program: a LinkWorker in a thread of its own, used through queued signals only.
#pragma once

#include "app/link/link.h"

#include <QThread>

namespace campanel::link {

class ThreadedLink : public Link {
    Q_OBJECT

public:
    explicit ThreadedLink(QObject* parent);
    // Ends the thread after the present exchange; waiting requests get no outcome.
    ~ThreadedLink() override;

    void connectTo(const ConnectionSettings& settings) override { emit connectWanted(settings); }
    void request(const CommandRequest& request) override { emit requestWanted(request); }
    void readParameter(quint32 id, const std::string& name) override
    {
        emit parameterWanted({id, name, std::nullopt});
    }
    void writeParameter(quint32 id, const std::string& name, double value) override
    {
        emit parameterWanted({id, name, value});
    }
    void download(const std::vector<std::uint16_t>& bank) override { emit downloadWanted(bank); }
    void cancelDownload() override { emit cancelWanted(); }
    void withdrawStop() override { emit withdrawalWanted(); }
    // Sets the key. Its validity begins now, regardless of a delay in the link thread.
    void setJog(JogDirection direction) override
    {
        emit jogWanted({direction, std::chrono::steady_clock::now() + jogCounts});
    }
    void readRegisters(const ReadRequest& request) override { emit readWanted(request); }
    void compareProgram(const std::vector<std::uint16_t>& bank) override { emit comparisonWanted(bank); }
    void cancelComparison() override { emit comparisonCancelWanted(); }
    void startScan(modbus::ScanPlan::Depth depth) override { emit scanWanted(depth); }
    void cancelScan() override { emit scanCancelWanted(); }
    void simulateFaults(const QStringList& rules) override { emit faultsWanted(rules); }
    void measureSimulatedBag() override { emit rulerWanted(); }
    void ping(quint32 number) override { emit pingWanted(number); }
    void watchFigures(bool isWatched) override { emit figuresWatchWanted(isWatched); }
    void resetFigures() override { emit figuresResetWanted(); }
    void watchFrames(bool isWatched) override { emit framesWatchWanted(isWatched); }

signals:
    void connectWanted(const campanel::link::ConnectionSettings& settings);
    void requestWanted(const campanel::link::CommandRequest& request);
    void parameterWanted(const campanel::link::ParameterRequest& request);
    void downloadWanted(const std::vector<std::uint16_t>& bank);
    void cancelWanted();
    void withdrawalWanted();
    void jogWanted(const campanel::link::JogRequest& request);
    void readWanted(const campanel::link::ReadRequest& request);
    void comparisonWanted(const std::vector<std::uint16_t>& bank);
    void comparisonCancelWanted();
    void scanWanted(campanel::modbus::ScanPlan::Depth depth);
    void scanCancelWanted();
    void faultsWanted(const QStringList& rules);
    void rulerWanted();
    void pingWanted(quint32 number);
    void figuresWatchWanted(bool isWatched);
    void figuresResetWanted();
    void framesWatchWanted(bool isWatched);

private:
    QThread m_thread;
};

} // namespace campanel::link
