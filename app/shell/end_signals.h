// SPDX-License-Identifier: Apache-2.0
// Ends the event loop properly on SIGTERM, SIGINT and SIGHUP, as sent by a shutdown, Ctrl-C and a closed
// terminal.
#pragma once

#include <QSocketNotifier>

#include <memory>

namespace campanel::panel {

class EndSignals {
public:
    // Needs the application; only one instance may exist at a time.
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace campanel::panel
