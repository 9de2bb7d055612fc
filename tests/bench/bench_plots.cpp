// SPDX-License-Identifier: Apache-2.0
// The time from an edited field to its frame: the real Motion page at 1024x600 on the software renderer.
#include "bench_report.h"

#include "tests/looks/test_window.h"

#include <QElapsedTimer>
#include <QEventLoop>

#include <stdexcept>

namespace campanel::bench {
namespace {

constexpr int edits = 600;
constexpr int warmUp = 20;

// Returns the time from each change to its painted frame, in ms.
template <typename Change> std::vector<double> framesOf(looks::TestWindow& window, Change change)
{
    QEventLoop untilShown;
    QObject::connect(&window.window(), &QQuickWindow::frameSwapped, &untilShown, &QEventLoop::quit);
    std::vector<double> frameMs;
    for (int edit = 0; edit < warmUp + edits; ++edit) {
        QElapsedTimer timer;
        timer.start();
        change(edit);
        untilShown.exec();
        if (edit >= warmUp)
            frameMs.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    }
    return frameMs;
}

} // namespace

Figures measurePlots()
{
    // The offscreen platform would wait 5 ms before each frame.
    qputenv("QT_QPA_UPDATE_IDLE_TIME", "0");
    looks::TestWindow window({QStringLiteral("en"), QStringLiteral("light"), QSize(1024, 600)});
    if (!window.isReady())
        throw std::runtime_error("the panel's window cannot be loaded");
    window.tap(QStringLiteral("nav_motion"));
    window.settle();

    panel::EditorField& bagLength = *window.panel().editor().bagLength();
    const std::vector<double> frameMs =
        framesOf(window, [&](int edit) { bagLength.set(150.0 + edit % 200); });
    for (const char* name : {"more", "mapButton"})
        window.tap(QString::fromLatin1(name));
    window.settle();
    const QQuickItem* dot = window.find(QStringLiteral("regimeDot"));
    if (dot == nullptr)
        throw std::runtime_error("the regime map has no dot");
    const QPointF start = dot->mapToScene(dot->boundingRect().center());
    window.touch(QStringLiteral("regimeDot"));
    const std::vector<double> dragMs =
        framesOf(window, [&](int edit) { window.slide(start + QPointF(1 + edit % 200, -(edit % 90))); });
    window.lift();
    return {{"edit to painted Motion page at 1024x600, p99 of " + std::to_string(edits),
             quantile(frameMs, 0.99), 5.0, "ms", "five milliseconds", true},
            {"the same, median", quantile(frameMs, 0.5), 5.0, "ms", "five milliseconds", true},
            {"dragged dot to painted regime map, p99 of " + std::to_string(edits), quantile(dragMs, 0.99),
             8.3, "ms", "one frame at 120 Hz", true}};
}

} // namespace campanel::bench
