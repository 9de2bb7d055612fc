// SPDX-License-Identifier: Apache-2.0
// Brings the QML module of the plots into the test program.
#include <QtQml/QQmlExtensionPlugin>

Q_IMPORT_QML_PLUGIN(CamPanel_PlotPlugin)
