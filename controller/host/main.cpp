// SPDX-License-Identifier: Apache-2.0
// campanel-controller: the simulated machine and its controller on a pseudo-terminal.
#include "file_flash.h"
#include "options.h"
#include "served_port.h"
#include "service.h"

#include <csignal>
#include <cstdio>
#include <sys/prctl.h>
#include <unistd.h>

using namespace campanel::controller;

namespace {

volatile std::sig_atomic_t stopRequested = 0;

// The timer slack. Linux may wake a sleeping thread 50 us late by default, which is half a character at
// 115200 baud.
constexpr unsigned long timerSlackNs = 1000;

int fail(const std::string& sentence)
{
    std::fprintf(stderr, "campanel-controller: %s\n", sentence.c_str());
    return 1;
}

// Blocks the signals except during the waits of the service; returns the mask to wait with.
sigset_t takeSignals()
{
    struct sigaction action {};
    action.sa_handler = [](int) { stopRequested = 1; };
    sigset_t held;
    sigset_t before;
    sigemptyset(&held);
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        sigaction(number, &action, nullptr);
        sigaddset(&held, number);
    }
    sigprocmask(SIG_BLOCK, &held, &before);
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        sigdelset(&before, number);
    return before;
}

} // namespace

int main(int argc, char** argv)
{
    const auto options = parseOptions(argc, argv);
    if (!options) {
        std::FILE* const stream = options.error().exitCode == 0 ? stdout : stderr;
        const bool isWritten =
            std::fputs(options.error().text.c_str(), stream) >= 0 && std::fflush(stream) == 0;
        return isWritten ? options.error().exitCode : fail("standard output cannot be written.");
    }
    const sigset_t waitMask = takeSignals();
    if (options->exitWithParent) {
        const pid_t parent = getppid();
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (getppid() != parent) // the parent ended before it could be watched
            return 0;
    }
    prctl(PR_SET_TIMERSLACK, timerSlackNs);
    auto flash = FileFlash::open(options->stateDirectory);
    if (!flash)
        return fail(flash.error());
    ServedPort port(options->link);
    if (const auto plugged = port.plug(); !plugged)
        return fail(plugged.error());

    Service service(*options, port, *flash);
    std::printf("%s\n", port.path().c_str());
    std::fflush(stdout);
    service.run(stopRequested, waitMask);
    return 0;
}
