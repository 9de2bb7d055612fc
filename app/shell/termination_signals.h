// SPDX-License-Identifier: Apache-2.0
// Ends the event loop properly on SIGTERM, SIGINT and SIGHUP, as sent by a shutdown, Ctrl-C and a closed
// terminal.
#pragma once

#include <QSocketNotifier>

#include <memory>

namespace campanel::shell {

class TerminationSignals {
public:
    // Needs the application; only one instance may exist at a time.
    TerminationSignals();
    ~TerminationSignals();
    TerminationSignals(const TerminationSignals&) = delete;
    TerminationSignals& operator=(const TerminationSignals&) = delete;

private:
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace campanel::shell
