// SPDX-License-Identifier: Apache-2.0
// Brings the static QML modules into an executable; include in exactly one of its source files.
#pragma once

#include <QtQml/qqmlextensionplugin.h>

Q_IMPORT_QML_PLUGIN(CamPanel_ThemePlugin)
Q_IMPORT_QML_PLUGIN(CamPanel_ControlsPlugin)
Q_IMPORT_QML_PLUGIN(CamPanel_WidgetsPlugin)
Q_IMPORT_QML_PLUGIN(CamPanel_PagesPlugin)
Q_IMPORT_QML_PLUGIN(CamPanel_MachinePlugin)
Q_IMPORT_QML_PLUGIN(CamPanel_PlotPlugin)
