// SPDX-License-Identifier: Apache-2.0
// Ends the event loop in order on SIGTERM, SIGINT and SIGHUP, as a shutdown, Ctrl-C and a closed terminal
// send them.
#pragma once

#include <QSocketNotifier>

#include <memory>

namespace campanel::panel {

class EndSignals {
public:
    // Needs the application; one of it at a time.
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace campanel::panel
