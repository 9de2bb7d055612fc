// SPDX-License-Identifier: Apache-2.0
// A link that records all its signals, for tests against the real controller program.
#pragma once

#include "app/link/threaded_link.h"
#include "app/program/program_image.h"

#include <QTest>

#include <optional>

namespace campanel::test {

constexpr int timeoutMs = 15000;

inline link::ConnectionSettings portSettings(const QString& port, int unit = 1)
{
    link::ConnectionSettings settings;
    settings.simulated = false;
    settings.port = port;
    settings.unit = unit;
    return settings;
}

inline program::ProgramImage imageOf(double bagLengthMm)
{
    program::Recipe recipe;
    recipe.cutter().bagLengthMm = bagLengthMm;
    const auto image = program::buildProgram(recipe);
    if (!image)
        qFatal("%s", program::describe(image.error()).c_str());
    return *image;
}

// Records all signals of a link.
class Panel : public QObject {
public:
    explicit Panel(const link::ConnectionSettings& settings)
    {
        connect(&link, &link::Link::reported, this, [this](const link::LinkReport& said) { report = said; });
        connect(&link, &link::Link::statusReceived, this, [this](const link::StatusBatch& batch) {
            if (!batch.samples.isEmpty())
                status = batch.samples.last().status;
            statuses += batch.samples.size();
        });
        connect(&link, &link::Link::commandEnded, this, [this](const link::CommandOutcome& outcome) {
            if (outcome.id != 0) // unsolicited by the test
                outcomes << outcome;
        });
        connect(&link, &link::Link::downloadReported, this,
                [this](const link::DownloadReport& said) { download = said; });
        connect(&link, &link::Link::registersRead, this,
                [this](const link::ReadOutcome& outcome) { reads << outcome; });
        connect(&link, &link::Link::comparisonReported, this,
                [this](const link::ComparisonReport& said) { comparisons << said; });
        connect(&link, &link::Link::scanReported, this,
                [this](const link::ScanReport& said) { scans << said; });
        connect(&link, &link::Link::figuresReported, this,
                [this](const link::FiguresReport& said) { figures << said; });
        connect(&link, &link::Link::framesRecorded, this,
                [this](const QList<modbus::FrameRecord>& recorded) { frames += recorded; });
        connect(&link, &link::Link::faultsSimulated, this,
                [this](const link::FaultsOutcome& outcome) { faults << outcome; });
        link.connectTo(settings);
    }

    [[nodiscard]] bool isConnected() const { return report.state == link::LinkState::Connected && status; }
    [[nodiscard]] bool isIn(modbus::State state) const { return status && status->state == state; }
    [[nodiscard]] bool scanEnded() const { return !scans.isEmpty() && !scans.last().isRunning; }
    [[nodiscard]] bool comparisonEnded() const
    {
        return !comparisons.isEmpty() && comparisons.last().stage != link::ComparisonStage::Reading;
    }

    void run(const program::ProgramImage& image)
    {
        link.download(image.registers);
        QTRY_COMPARE_WITH_TIMEOUT(download.stage, link::DownloadStage::Active, timeoutMs);
        link.request({1, modbus::Command::Start, {}});
        QTRY_VERIFY_WITH_TIMEOUT(isIn(modbus::State::Running), timeoutMs);
        outcomes.clear();
    }

    link::ThreadedLink link{nullptr};
    link::LinkReport report;
    std::optional<modbus::StatusBlock> status;
    qsizetype statuses = 0;
    QList<link::CommandOutcome> outcomes;
    link::DownloadReport download;
    QList<link::ReadOutcome> reads;
    QList<link::ComparisonReport> comparisons;
    QList<link::ScanReport> scans;
    QList<link::FaultsOutcome> faults;
    QList<link::FiguresReport> figures;
    QList<modbus::FrameRecord> frames;
};

} // namespace campanel::test
