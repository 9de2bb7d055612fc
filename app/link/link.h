// SPDX-License-Identifier: Apache-2.0
// The seam between the panel and the line: verbs return at once, what comes of them arrives as signals in the
// caller's thread. ThreadedLink is the real one; tests put a fake in its place.
#pragma once

#include "app/link/link_values.h"

#include <QObject>

namespace campanel::link {

class Link : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    // Leaves the present connection, if any, and keeps trying for this one from now on.
    virtual void connectTo(const campanel::link::ConnectionSettings& settings) = 0;
    // Ends in exactly one commandEnded() with the request's id.
    virtual void request(const campanel::link::CommandRequest& request) = 0;
    // The physical value of a register, proven by reading it. Ends in exactly one parameterEnded() with that
    // id; the other verb too.
    virtual void readParameter(quint32 id, const std::string& name) = 0;
    // Writes a physical value into a register of the group "parameter" and reads it back.
    virtual void writeParameter(quint32 id, const std::string& name, double value) = 0;
    // Stages the bank (header and rows), compares CRC-32 and applies it at the next cycle. Ends in exactly
    // one downloadReported() with stage Active, Failed or Canceled; one at a time: a second one fails at
    // once.
    virtual void download(const std::vector<std::uint16_t>& bank) = 0;
    virtual void cancelDownload() = 0;
    // Takes back a Stop that waits for the line (LinkReport::pendingStop); it then ends as Withdrawn.
    virtual void withdrawStop() = 0;
    // The jog key that is held now. Counts for `jogCounts` and is told again before that; None when it is let
    // go. Any Stop, a lost connection and a scan end it too: after them, and when the time was over, nothing
    // moves before a None.
    virtual void setJog(campanel::link::JogDirection direction) = 0;

    // Ends in exactly one registersRead(). Reads share the line evenly with the status polls and go after
    // commands; at most 32 wait.
    virtual void readRegisters(const campanel::link::ReadRequest& request) = 0;
    // Reads the whole active bank back and compares it with `bank`, what was downloaded; with an empty one
    // only its CRC-32 with the controller's own. Ends in exactly one comparisonReported() with another stage
    // than Reading.
    virtual void compareProgram(const std::vector<std::uint16_t>& bank) = 0;
    virtual void cancelComparison() = 0;

    // Why there is no connection, or a search for a controller on all ports. The connection is closed
    // meanwhile and comes back after; a scan under way is replaced. Ends in exactly one scanReported() that
    // is not running.
    virtual void startScan(campanel::modbus::ScanPlan::Depth depth) = 0;
    virtual void cancelScan() = 0;

    // Rules for what goes wrong on the line to the simulated controller, see controller/README.md; they
    // replace those before, an empty list clears them. They outlive a restart of the controller, not
    // connectTo(). Ends in exactly one faultsSimulated(); while the controller is not serving, at once.
    virtual void simulateFaults(const QStringList& rules) = 0;

    // What somebody with a ruler finds at the last bag of the simulated machine. Ends in exactly one
    // rulerRead(); a link that has no simulated machine says so at once.
    virtual void readRuler() { emit rulerRead({RulerEnd::NotSimulated}); }

    // Ends in one pingAnswered() with that number when what serves the line comes round to it; until it does,
    // in none.
    virtual void ping(quint32 number) { emit pingAnswered(number); }

    // While watched: figuresReported() once a second, the first one at once.
    virtual void watchFigures(bool isWatched) = 0;
    virtual void resetFigures() = 0;
    // While watched: framesRecorded() ten times a second when there are any; first with all that are still
    // known.
    virtual void watchFrames(bool isWatched) = 0;

signals:
    void reported(const campanel::link::LinkReport& report);
    void statusReceived(const campanel::link::StatusBatch& batch);
    void programRead(const campanel::link::ActiveProgram& program);
    void commandEnded(const campanel::link::CommandOutcome& outcome);
    void parameterEnded(const campanel::link::ParameterOutcome& outcome);
    void downloadReported(const campanel::link::DownloadReport& report);
    void registersRead(const campanel::link::ReadOutcome& outcome);
    void comparisonReported(const campanel::link::ComparisonReport& report);
    void scanReported(const campanel::link::ScanReport& report);
    void faultsSimulated(const campanel::link::FaultsOutcome& outcome);
    void rulerRead(const campanel::link::RulerOutcome& outcome);
    void figuresReported(const campanel::link::FiguresReport& report);
    void framesRecorded(const QList<campanel::modbus::FrameRecord>& frames);
    void pingAnswered(quint32 number);
};

} // namespace campanel::link
