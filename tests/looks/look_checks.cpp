// SPDX-License-Identifier: Apache-2.0
// Loads every page and dialog and checks it; see look_checks.h.
#include "tests/looks/look_checks.h"

#include "tests/looks/scene_checks.h"

#include <cstdio>
#include <cstdlib>

namespace campanel::looks {
namespace {

QStringList g_warnings; // written by the message handler, which has no object

void noteMessage(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (type != QtDebugMsg && type != QtInfoMsg)
        g_warnings += message;
}

SceneLimits limitsOf(Stage& stage)
{
    const auto* size = stage.theme()->property("size").value<QObject*>();
    const auto* color = stage.theme()->property("color").value<QObject*>();
    const double touch = size->property("touch").toDouble();
    return {touch,
            touch / size->property("reach").toDouble(),
            size->property("commandKey").toDouble(),
            {color->property("textContrast").toDouble(), color->property("largeTextContrast").toDouble()}};
}

QStringList checkStop(Stage& stage)
{
    const qsizetype before = stage.link().stopRequests();
    stage.tap(QStringLiteral("stopKey"));
    return stage.link().stopRequests() > before ? QStringList()
                                                : QStringList(QStringLiteral("Stop cannot be reached"));
}

QStringList checkLook(const Look& look, const QList<Scene>& scenes)
{
    QStringList faults;
    Stage stage(look);
    if (!stage.isReady())
        return {QStringLiteral("the window cannot be loaded")};
    for (const Scene& scene : scenes) {
        enterScene(stage, scene);
        const QStringList found = checkScene(stage.root(), limitsOf(stage), stage.grab()) + checkStop(stage);
        for (const QString& fault : found)
            faults += QStringLiteral("%1: %2").arg(scene.name, fault);
    }
    return faults + stage.complaints();
}

} // namespace

int checkLooks(const QList<Look>& looks, const QList<Scene>& scenes)
{
    const QtMessageHandler before = qInstallMessageHandler(noteMessage);
    qsizetype faults = 0;
    for (const Look& look : looks) {
        g_warnings.clear();
        const QStringList found = checkLook(look, scenes) + g_warnings;
        for (const QString& fault : found)
            std::fprintf(stderr, "%s: %s\n", qPrintable(look.name()), qPrintable(fault));
        faults += found.size();
    }
    qInstallMessageHandler(before);
    std::printf("%lld pages and dialogs in %lld looks: %lld faults\n", static_cast<long long>(scenes.size()),
                static_cast<long long>(looks.size()), static_cast<long long>(faults));
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace campanel::looks
