// SPDX-License-Identifier: Apache-2.0
// Loads every page and dialog and checks it; see look_checks.h.
#include "tests/looks/variant_checks.h"

#include "tests/looks/checks/key_places.h"
#include "tests/looks/checks/screen_checks.h"

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

// The long texts are no real language, so they may be elided.
ScreenLimits limitsOf(TestWindow& window, const Variant& variant)
{
    const auto* size = window.theme()->property("size").value<QObject*>();
    const auto* color = window.theme()->property("color").value<QObject*>();
    const double touch = size->property("touch").toDouble();
    return {touch,
            touch / size->property("reach").toDouble(),
            size->property("commandKey").toDouble(),
            {color->property("textContrast").toDouble(), color->property("largeTextContrast").toDouble()},
            size->property("smallestText").toDouble(),
            variant.language == QLatin1String("long")};
}

QStringList checkStop(TestWindow& window)
{
    const qsizetype before = window.link().stopRequests();
    window.tap(QStringLiteral("stopKey"));
    return window.link().stopRequests() > before ? QStringList()
                                                 : QStringList(QStringLiteral("Stop cannot be reached"));
}

QStringList checkVariant(const Variant& variant, const QList<Screen>& screens)
{
    QStringList faults;
    KeyPlaces places;
    TestWindow window(variant);
    if (!window.isReady())
        return {QStringLiteral("the window cannot be loaded")};
    for (const Screen& screen : screens) {
        enterScreen(window, screen);
        const QImage picture = window.grab();
        QStringList found =
            checkScreen(window.root(), limitsOf(window, variant), picture) + checkCovered(window.root());
        places.add(screen.name, window.root());
        if (calmScreens().contains(screen.name))
            found += checkCalm(picture);
        found += checkStop(window);
        for (const QString& fault : found)
            faults += QStringLiteral("%1: %2").arg(screen.name, fault);
    }
    return faults + places.faults() + window.complaints();
}

} // namespace

QStringList calmScreens()
{
    QStringList names;
    for (const char* name :
         {"run", "run-stopped", "run-position", "run-cam", "motion", "motion-all-curves", "motion-operator",
          "recipes", "trends", "alarms-none", "settings-display", "jog", "homing", "io", "dry-run"})
        names << QString::fromLatin1(name);
    return names;
}

int checkVariants(const QList<Variant>& variants, const QList<Screen>& screens)
{
    const QtMessageHandler before = qInstallMessageHandler(noteMessage);
    qsizetype faults = 0;
    for (const Variant& variant : variants) {
        g_warnings.clear();
        const QStringList found = checkVariant(variant, screens) + g_warnings;
        for (const QString& fault : found)
            std::fprintf(stderr, "%s: %s\n", qPrintable(variant.name()), qPrintable(fault));
        faults += found.size();
    }
    qInstallMessageHandler(before);
    std::printf("%lld pages and dialogs in %lld variants: %lld faults\n",
                static_cast<long long>(screens.size()), static_cast<long long>(variants.size()),
                static_cast<long long>(faults));
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace campanel::looks
