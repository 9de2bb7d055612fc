// SPDX-License-Identifier: Apache-2.0
#include "app/shell/termination_signals.h"

#include <QCoreApplication>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace campanel::shell {
namespace {

constexpr std::array numbers{SIGTERM, SIGINT, SIGHUP};

// A signal handler may do very little, but it may write into a pipe.
int g_readEnd = -1;
int g_writeEnd = -1;

void noteSignal(int)
{
    const int before = errno;
    const char byte = 0;
    (void)!::write(g_writeEnd, &byte, 1);
    errno = before;
}

} // namespace

TerminationSignals::TerminationSignals()
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return; // without a pipe the signals end the process by default
    g_readEnd = ends[0];
    g_writeEnd = ends[1];
    m_notifier = std::make_unique<QSocketNotifier>(g_readEnd, QSocketNotifier::Read);
    // The byte stays in the pipe: after a nested event loop has ended, the next one ends too.
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(),
                     [] { QCoreApplication::exit(EXIT_SUCCESS); });
    struct sigaction action {};
    action.sa_handler = noteSignal;
    action.sa_flags = SA_RESTART;
    for (const int number : numbers)
        ::sigaction(number, &action, nullptr);
}

TerminationSignals::~TerminationSignals()
{
    if (!m_notifier)
        return;
    for (const int number : numbers)
        std::signal(number, SIG_DFL);
    m_notifier.reset();
    ::close(g_readEnd);
    ::close(g_writeEnd);
}

} // namespace campanel::shell
