// SPDX-License-Identifier: Apache-2.0
// `Service` in QML: the maintenance figures of the line, and the controller's registers.
#pragma once

#include "app/panel/kit/report_files.h"
#include "app/panel/maintenance/dry_run.h"
#include "app/panel/maintenance/frame_list.h"
#include "app/panel/maintenance/homing.h"
#include "app/panel/maintenance/io_list.h"
#include "app/panel/maintenance/jog.h"
#include "app/panel/maintenance/line_faults.h"
#include "app/panel/maintenance/line_figures.h"
#include "app/panel/maintenance/link_doctor.h"
#include "app/panel/maintenance/register_inspector.h"
#include "app/panel/packing/packing_setup.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Service : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::machine::LinkDoctor* doctor READ doctor CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::LineFigures* figures READ figures CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::RegisterInspector* inspector READ inspector CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::FrameList* frames READ frames CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::PackingSetup* packing READ packing CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::Jog* jog READ jog CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::Homing* homing READ homing CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::IoList* io READ io CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::DryRun* dryRun READ dryRun CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::LineFaults* lineFaults READ lineFaults CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::ReportFiles* files READ files CONSTANT FINAL)

public:
    // Machine and settings must outlive the object. Reports are stored in a folder below `folder`.
    Service(Machine& machine, Settings& settings, const QString& folder, QObject* parent);

    static Service* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    [[nodiscard]] LinkDoctor* doctor() { return &m_doctor; }
    [[nodiscard]] LineFigures* figures() { return &m_figures; }
    [[nodiscard]] RegisterInspector* inspector() { return &m_inspector; }
    [[nodiscard]] FrameList* frames() { return &m_frames; }
    [[nodiscard]] PackingSetup* packing() { return &m_packing; }
    [[nodiscard]] Jog* jog() { return &m_jog; }
    [[nodiscard]] Homing* homing() { return &m_homing; }
    [[nodiscard]] IoList* io() { return &m_io; }
    [[nodiscard]] DryRun* dryRun() { return &m_dryRun; }
    [[nodiscard]] LineFaults* lineFaults() { return &m_lineFaults; }
    [[nodiscard]] ReportFiles* files() { return &m_files; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    ReportFiles m_files;
    LinkDoctor m_doctor;
    LineFaults m_lineFaults;
    LineFigures m_figures;
    RegisterInspector m_inspector;
    FrameList m_frames;
    PackingSetup m_packing;
    Jog m_jog;
    Homing m_homing;
    IoList m_io;
    DryRun m_dryRun;
};

} // namespace campanel::machine
