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

signals:
    void reported(const campanel::link::LinkReport& report);
    void statusReceived(const campanel::link::StatusBatch& batch);
    void programRead(const campanel::link::ActiveProgram& program);
    void commandEnded(const campanel::link::CommandOutcome& outcome);
    void parameterEnded(const campanel::link::ParameterOutcome& outcome);
    void downloadReported(const campanel::link::DownloadReport& report);
};

} // namespace campanel::link
