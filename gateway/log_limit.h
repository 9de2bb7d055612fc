// SPDX-License-Identifier: Apache-2.0
// Limits the log: whoever can cause a line must not fill a disk with lines.
#pragma once

#include <QString>

#include <chrono>
#include <functional>
#include <map>
#include <utility>

namespace campanel::gateway {

// The kinds of lines; each has its own limit.
enum class LogKind {
    Connected,
    NotConnected,
    Panel,
    PanelStale,
    Command,
    NotACommand,
    LeftOut,
    Twin,
    TwinLeft,
    HostOnline,
    HostOffline,
    SlowBroker,
    Offer,
};

// Passes on one line of each kind a minute. The last of the other ones follows after the minute, with their
// number.
class LogLimit {
public:
    using Clock = std::chrono::steady_clock;

    static constexpr std::chrono::seconds pause{60};

    explicit LogLimit(std::function<void(const QString&)> write,
                      std::function<Clock::time_point()> now = &Clock::now)
        : m_write(std::move(write))
        , m_now(std::move(now))
    {
    }

    void report(LogKind kind, const QString& sentence)
    {
        Lines& lines = m_lines[kind];
        lines.last = sentence;
        ++lines.waiting;
        if (lines.isFirst || m_now() - lines.at >= pause)
            write(lines);
    }
    // Writes what has waited for a minute; call it often.
    void tick()
    {
        for (auto& [kind, lines] : m_lines) {
            if (lines.waiting > 0 && m_now() - lines.at >= pause)
                write(lines);
        }
    }
    // Writes what waits, at the end.
    void flush()
    {
        for (auto& [kind, lines] : m_lines) {
            if (lines.waiting > 0)
                write(lines);
        }
    }

private:
    struct Lines {
        Clock::time_point at{};
        bool isFirst = true;
        qint64 waiting = 0;
        QString last;
    };

    void write(Lines& lines)
    {
        m_write(lines.waiting == 1 ? lines.last
                                   : QStringLiteral("%2 (%1 more lines like this one were left out)")
                                         .arg(QString::number(lines.waiting - 1), lines.last));
        lines = {m_now(), false, 0, {}};
    }

    std::function<void(const QString&)> m_write;
    std::function<Clock::time_point()> m_now;
    std::map<LogKind, Lines> m_lines;
};

} // namespace campanel::gateway
