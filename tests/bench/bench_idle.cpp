// SPDX-License-Identifier: Apache-2.0
// The processor time of the panel at 1024x600 on the software renderer, with a real controller program on its
// line: on each page while the machine waits, and while it runs. The link's thread is included.
#include "bench_report.h"

#include "app/link/threaded_link.h"
#include "tests/looks/touch_driver.h"
#include "tests/support/controller_process.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QQuickWindow>
#include <QTemporaryDir>
#include <QTimer>

#include <sys/resource.h>

#include <functional>
#include <optional>
#include <stdexcept>

namespace campanel::bench {
namespace {

using namespace Qt::StringLiterals;

constexpr int idleSettleMs = 2000;
constexpr int measureMs = 5000;
constexpr int idlePatienceMs = 20'000;

void passTime(int ms)
{
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

void awaitTrue(const std::function<bool()>& condition, const char* problem)
{
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        if (timer.elapsed() > idlePatienceMs)
            throw std::runtime_error(problem);
        passTime(20);
    }
}

double processorMs()
{
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto ms = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_usec) / 1e3;
    };
    return ms(used.ru_utime) + ms(used.ru_stime);
}

struct Costliest {
    double percent = 0;
    std::string page;
};

class RealPanel {
public:
    explicit RealPanel(const QString& port)
    {
        m_panel.settings().overrideValue("display.language", u"en"_s);
        panel::ConnectionChoice choice;
        choice.simulated = false;
        choice.portName = port;
        m_panel.settings().overrideConnection(choice);
        QObject::connect(&m_link, &link::Link::statusReceived, &m_panel,
                         [this](const link::StatusBatch& batch) {
                             if (!batch.samples.isEmpty())
                                 m_state = batch.samples.last().status.state;
                         });
        if (!m_panel.load({1024, 600}))
            throw std::runtime_error("the panel's window cannot be loaded");
        m_panel.window().show();
        m_touch.settle();
        m_panel.open();
        awaitTrue([this] { return m_panel.editor().programDownload()->canDownload(); },
                  "the panel has no connection");
    }

    void run(double bagsPerMin)
    {
        m_panel.editor().rate()->set(bagsPerMin);
        panel::ProgramDownload& download = *m_panel.editor().programDownload();
        m_touch.tap(u"nav_motion"_s);
        m_touch.tap(u"nextStep"_s);
        m_touch.tap(u"downloadStart"_s);
        awaitTrue([&] { return download.state() == panel::ProgramDownload::State::Applied; },
                  "the program was not downloaded");
        passTime(idleSettleMs);
        m_touch.touch(u"startKey"_s);
        passTime(600);
        m_touch.lift();
        awaitTrue([this] { return m_state == modbus::State::Running; }, "the machine did not start");
    }

    Costliest measure()
    {
        Costliest most;
        for (const char* page :
             {"run", "motion", "recipes", "trends", "stops", "alarms", "maintenance", "settings"}) {
            m_touch.frame()->setProperty("page", QString::fromLatin1(page));
            passTime(idleSettleMs);
            const double before = processorMs();
            QElapsedTimer timer;
            timer.start();
            passTime(measureMs);
            const double percent =
                100 * (processorMs() - before) / static_cast<double>(timer.nsecsElapsed()) * 1e6;
            if (percent > most.percent)
                most = {percent, page};
        }
        if (!m_touch.complaints().isEmpty())
            throw std::runtime_error(m_touch.complaints().constFirst().toStdString());
        return most;
    }

private:
    QTemporaryDir m_folder;
    link::ThreadedLink m_link{nullptr};
    shell::Panel m_panel{m_link, {m_folder.filePath(u"settings.ini"_s), m_folder.path()}};
    looks::TouchDriver m_touch{m_panel};
    std::optional<modbus::State> m_state;
};

} // namespace

Figures measureIdle()
{
    QQuickWindow::setGraphicsApi(QSGRendererInterface::Software);
    const test::ControllerProcess controller;
    RealPanel panel(controller.port());
    const Costliest idle = panel.measure();
    constexpr double bagsPerMin = 300;
    panel.run(bagsPerMin);
    const Costliest running = panel.measure();
    return {{"processor while the machine waits (page " + idle.page + ")", idle.percent, 1, "%", "of a core",
             true},
            {"processor at 300 bags/min (page " + running.page + ")", running.percent, 8, "%", "of a core",
             true}};
}

} // namespace campanel::bench
