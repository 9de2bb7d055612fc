// SPDX-License-Identifier: Apache-2.0
// `Maintenance` in QML: the maintenance figures of the line, and the controller's registers.
#pragma once

#include "app/panel/kit/report_files.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/maintenance/axis_measurement.h"
#include "app/panel/maintenance/cam_switches.h"
#include "app/panel/maintenance/dry_run.h"
#include "app/panel/maintenance/frame_list.h"
#include "app/panel/maintenance/homing.h"
#include "app/panel/maintenance/io_list.h"
#include "app/panel/maintenance/jog.h"
#include "app/panel/maintenance/line_figures.h"
#include "app/panel/maintenance/link_doctor.h"
#include "app/panel/maintenance/master_watch.h"
#include "app/panel/maintenance/output_try.h"
#include "app/panel/maintenance/register_inspector.h"
#include "app/panel/maintenance/simulated_faults.h"
#include "app/panel/maintenance/tower_fields.h"
#include "app/panel/packing/packing_setup.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Maintenance : public QObject, public Singleton<Maintenance> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::LinkDoctor* doctor READ doctor CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::LineFigures* figures READ figures CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RegisterInspector* inspector READ inspector CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::FrameList* frames READ frames CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::PackingSetup* packing READ packing CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::Jog* jog READ jog CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::Homing* homing READ homing CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::IoList* io READ io CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::OutputTry* outputTry READ outputTry CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::CamSwitches* switches READ switches CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::TowerFields* tower READ tower CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::MasterWatch* master READ master CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::AxisMeasurement* measurement READ measurement CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::DryRun* dryRun READ dryRun CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::SimulatedFaults* simulatedFaults READ simulatedFaults CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::ReportFiles* files READ files CONSTANT FINAL)

public:
    // Machine and settings must outlive the object. Reports are stored in a folder below `folder`.
    Maintenance(Controller& controller, Settings& settings, const QString& folder, QObject* parent);

    [[nodiscard]] LinkDoctor* doctor() { return &m_doctor; }
    [[nodiscard]] LineFigures* figures() { return &m_figures; }
    [[nodiscard]] RegisterInspector* inspector() { return &m_inspector; }
    [[nodiscard]] FrameList* frames() { return &m_frames; }
    [[nodiscard]] PackingSetup* packing() { return &m_packing; }
    [[nodiscard]] Jog* jog() { return &m_jog; }
    [[nodiscard]] Homing* homing() { return &m_homing; }
    [[nodiscard]] IoList* io() { return &m_io; }
    [[nodiscard]] OutputTry* outputTry() { return &m_outputTry; }
    [[nodiscard]] CamSwitches* switches() { return &m_switches; }
    [[nodiscard]] TowerFields* tower() { return &m_tower; }
    [[nodiscard]] MasterWatch* master() { return &m_master; }
    [[nodiscard]] AxisMeasurement* measurement() { return &m_measurement; }
    [[nodiscard]] DryRun* dryRun() { return &m_dryRun; }
    [[nodiscard]] SimulatedFaults* simulatedFaults() { return &m_simulatedFaults; }
    [[nodiscard]] ReportFiles* files() { return &m_files; }

private:
    ReportFiles m_files;
    LinkDoctor m_doctor;
    SimulatedFaults m_simulatedFaults;
    LineFigures m_figures;
    RegisterInspector m_inspector;
    FrameList m_frames;
    PackingSetup m_packing;
    Jog m_jog;
    Homing m_homing;
    IoList m_io;
    OutputTry m_outputTry;
    CamSwitches m_switches;
    TowerFields m_tower;
    MasterWatch m_master;
    AxisMeasurement m_measurement;
    DryRun m_dryRun;
};

} // namespace campanel::panel
