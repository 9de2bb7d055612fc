// SPDX-License-Identifier: Apache-2.0
// The complete panel with an operator who changes the bag length, saves, downloads, stops and starts at
// random; for test_day_of_production. Arguments: folder, port, seed. Prints what is confirmed. Takes lines
// from standard input: "full" and "room" for the disk, "clock SECONDS" to set the clock of this process.
#include "app/link/threaded_link.h"
#include "app/shell/fonts.h"
#include "app/shell/panel.h"
#include "app/store/logs/bag_log.h"
#include "tests/e2e/confirmed_facts.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QGuiApplication>
#include <QRandomGenerator>
#include <QSocketNotifier>
#include <QTimer>

#include <array>
#include <atomic>
#include <ctime>
#include <optional>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace producing_panel {

std::atomic<std::int64_t> clockOffsetS{0};

} // namespace producing_panel

// The clock of this process; Qt and the C++ library call these functions instead of those of the C library.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept
{
    const auto result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
    if (result == 0 && clock == CLOCK_REALTIME)
        time->tv_sec += producing_panel::clockOffsetS;
    return result;
}

extern "C" int gettimeofday(timeval* time, void*) noexcept
{
    timespec now{};
    const int result = clock_gettime(CLOCK_REALTIME, &now);
    *time = {now.tv_sec, now.tv_nsec / 1000};
    return result;
}

namespace producing_panel {

using namespace campanel;
using panel::Controller;

namespace {

constexpr std::chrono::milliseconds actionInterval{1500};
constexpr std::chrono::milliseconds reportInterval{500};
constexpr double shortestMm = 200;
constexpr int lengths = 60;
constexpr double rateBagsPerMin = 30;

// Returns the memory of this process in KiB.
QString residentKb()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith("VmRSS:"))
            return QString::fromLatin1(line.simplified().split(' ').value(1));
    }
    return {};
}

class Operator {
public:
    Operator(shell::Panel& panel, quint32 seed)
        : m_panel(panel)
        , m_random(seed)
    {
        m_timer.callOnTimeout(&panel, [this] { act(); });
        m_timer.start(actionInterval);
    }

private:
    void act()
    {
        Controller& machine = m_panel.controller();
        panel::Editor& editor = m_panel.editor();
        if (!machine.isConnected() || !machine.status())
            return;
        if (machine.faulted())
            machine.resetFault();
        else if (!machine.active().isPresent || m_random.bounded(3) == 0)
            changeProgram(editor);
        else if (m_random.bounded(6) == 0)
            machine.stop();
        else if (machine.canStart())
            machine.start();
        else if (machine.blockedReason(panel::Action::Home).isEmpty())
            machine.home();
        else if (machine.isConnected() && machine.fresh())
            editor.saveToFlash();
    }

    void changeProgram(panel::Editor& editor)
    {
        editor.bagLength()->set(shortestMm + m_random.bounded(lengths));
        editor.rate()->set(rateBagsPerMin);
        m_panel.recipes().save();
        if (editor.programDownload()->canDownload())
            editor.download();
    }

    shell::Panel& m_panel;
    QRandomGenerator m_random;
    QTimer m_timer;
};

// Prints each confirmed fact.
void report(shell::Panel& panel)
{
    test::sayConfirmed(panel.recipes(), panel.trail(), panel.editor());
    QObject::connect(&panel.controller(), &Controller::programChanged, [&panel] {
        if (const auto& status = panel.controller().status(); status && status->activeCrc)
            test::say(QStringLiteral("active %1 %2")
                          .arg(status->generation)
                          .arg(test::crcText(*status->activeCrc)));
    });
}

void reportBags(shell::Panel& panel)
{
    panel.trends().store().run(
        &panel, [](store::Database& database) { return store::BagLog(database).count(); },
        [](const tl::expected<qint64, store::StoreError>& count) {
            if (count)
                test::say(QStringLiteral("bags %1 %2").arg(*count).arg(residentKb()));
        });
}

} // namespace

static int producingPanel(int argc, char** argv)
{
    QGuiApplication application(argc, argv);
    const QStringList arguments = QGuiApplication::arguments();
    const QString& folder = arguments.at(1);
    shell::applyFonts();
    link::ThreadedLink link(nullptr);
    shell::Panel panel(link, {folder + QStringLiteral("/settings.ini"), folder});
    panel::ConnectionChoice choice;
    choice.simulated = false;
    choice.portName = arguments.at(2);
    panel.settings().overrideConnection(choice);
    report(panel);
    if (!panel.load({1024, 600}))
        return 1;
    panel.window().show();
    panel.open();

    std::optional<test::FullDisk> full;
    const auto obey = [&full](const QByteArray& line) {
        if (line == "full")
            full.emplace();
        else if (line == "room")
            full.reset();
        else if (line.startsWith("clock "))
            clockOffsetS += line.mid(6).toLongLong();
        else
            QCoreApplication::exit(1);
        test::say(QStringLiteral("time %1").arg(QDateTime::currentSecsSinceEpoch()));
    };
    QByteArray input;
    QSocketNotifier told(STDIN_FILENO, QSocketNotifier::Read);
    QObject::connect(&told, &QSocketNotifier::activated, &panel, [&input, &obey] {
        std::array<char, 256> bytes;
        const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
        if (count <= 0)
            QCoreApplication::quit();
        else
            input.append(bytes.data(), count);
        for (qsizetype end = input.indexOf('\n'); end >= 0; end = input.indexOf('\n')) {
            obey(input.left(end));
            input.remove(0, end + 1);
        }
    });
    QTimer bags;
    bags.callOnTimeout(&panel, [&] { reportBags(panel); });
    bags.start(reportInterval);
    const Operator human(panel, arguments.at(3).toUInt());
    return QGuiApplication::exec();
}

CAMPANEL_PROCESS("producing_panel", producingPanel)

} // namespace producing_panel
