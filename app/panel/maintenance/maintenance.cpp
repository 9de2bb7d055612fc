// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/maintenance.h"

#include "app/panel/controller/controller.h"
#include "app/panel/settings/settings.h"

#include <QDir>

namespace campanel::panel {

Maintenance::Maintenance(Controller& controller, Settings& settings, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_files(QDir(folder).filePath(QStringLiteral("reports")), this)
    , m_doctor(controller, settings, this)
    , m_simulatedFaults(controller, this)
    , m_figures(controller.link(), controller.accessCheck(), m_files, this)
    , m_inspector(controller, this)
    , m_frames(controller.link(), m_files, this)
    , m_packing(controller, this)
    , m_jog(controller, this)
    , m_homing(controller, this)
    , m_io(controller, this)
    , m_outputTry(controller, this)
    , m_switches(controller, this)
    , m_tower(controller, this)
    , m_master(controller, this)
    , m_measurement(controller, this)
    , m_dryRun(this)
{
    m_files.guardBy(controller.accessCheck());
}

} // namespace campanel::panel
