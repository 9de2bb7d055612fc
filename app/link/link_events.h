// SPDX-License-Identifier: Apache-2.0
// Declares the reports of the line: the signals of Link and of its worker.
#pragma once

#include "app/link/link_values.h"

#include <QObject>

namespace campanel::link {

class LinkEvents : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

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
