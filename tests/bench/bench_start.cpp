// SPDX-License-Identifier: Apache-2.0
// Start-up time and memory of the panel against an empty Qt Quick Controls window, both offscreen, in turn.
#include "bench_report.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>

#include <stdexcept>

namespace campanel::bench {
namespace {

using namespace Qt::StringLiterals;

constexpr int runs = 9;
constexpr int settleMs = 1500; // memory is read after the work of the first seconds

struct Start {
    double firstFrameMs = 0;
    double residentMb = 0;
};

Start startOnce(const QString& program, const QStringList& arguments, const QString& home)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_QPA_PLATFORM"_s, u"offscreen"_s);
    for (const QString& name : {u"XDG_DATA_HOME"_s, u"XDG_CONFIG_HOME"_s, u"XDG_STATE_HOME"_s})
        environment.insert(name, home);
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    QElapsedTimer timer;
    timer.start();
    process.start(program, arguments, QIODevice::ReadOnly);
    while (!process.canReadLine()) {
        if (!process.waitForReadyRead(20000))
            throw std::runtime_error("no first frame from " + program.toStdString());
    }
    Start result;
    result.firstFrameMs = static_cast<double>(timer.nsecsElapsed()) / 1e6;
    QThread::msleep(settleMs);
    result.residentMb = residentMb(process.processId());
    process.terminate();
    if (!process.waitForFinished(5000))
        process.kill();
    process.waitForFinished();
    return result;
}

} // namespace

Figures measureStart()
{
    const QTemporaryDir home;
    std::vector<double> panelMs, emptyMs, ratios, panelMb, emptyMb;
    for (int run = 0; run <= runs; ++run) {
        const Start empty = startOnce(QStringLiteral(CAMPANEL_EMPTY_WINDOW), {}, home.path());
        const Start panel =
            startOnce(QStringLiteral(CAMPANEL_PANEL), {u"--announce-first-frame"_s}, home.path());
        if (run == 0)
            continue; // fills the disk cache
        emptyMs.push_back(empty.firstFrameMs);
        panelMs.push_back(panel.firstFrameMs);
        ratios.push_back(panel.firstFrameMs / empty.firstFrameMs);
        emptyMb.push_back(empty.residentMb);
        panelMb.push_back(panel.residentMb);
    }
    const double medianEmptyMs = quantile(emptyMs, 0.5);
    return {{"start to first frame (median of " + std::to_string(runs) + ")",
             medianEmptyMs * quantile(ratios, 0.5), 2.2 * medianEmptyMs, "ms", "2.2 empty windows", true},
            {"memory above an empty window", quantile(panelMb, 0.5) - quantile(emptyMb, 0.5), 60.0, "MB",
             "resident", true}};
}

} // namespace campanel::bench
