// SPDX-License-Identifier: Apache-2.0
// Messages of the broker that wait for the main thread. Bounded, whatever is published: commands have few
// places of their own and come last, so that they are lost before anything else is.
#pragma once

#include <QByteArray>
#include <QString>

#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace campanel::gateway {

struct Arrival {
    int connection = 0; // it came by this one
    QString topic;      // empty: the broker has answered a barrier
    QByteArray bytes;
};

class Arrivals {
public:
    static constexpr qsizetype maxMessages = 2000;
    static constexpr qsizetype maxBytes = 20'000'000; // all offers, and more than all commands
    static constexpr qsizetype maxCommands = 100;
    static constexpr qsizetype maxCommandBytes = 16 * 1024; // of one

    // Returns true for a message that asks for something: it may be lost.
    [[nodiscard]] static bool isCommand(const QString& topic)
    {
        return topic.section(u'/', 2, 2) == u"NCMD" || topic.endsWith(u"/rebirth");
    }

    // Adds a message, or drops it when there is no room. Returns true when the reader has to be woken.
    bool add(Arrival arrival)
    {
        const std::scoped_lock lock(m_mutex);
        if (arrival.topic.isEmpty()) {
            m_barrier = arrival.connection;
            return !std::exchange(m_isReaderWoken, true);
        }
        const bool isSecond = isCommand(arrival.topic);
        const qsizetype size = sizeOf(arrival);
        if (isSecond ? count(m_commands) >= maxCommands || size > maxCommandBytes
                     : count(m_others) >= maxMessages || m_bytes + size > maxBytes) {
            ++m_dropped;
        } else {
            m_bytes += size;
            (isSecond ? m_commands : m_others).push_back(std::move(arrival));
        }
        return !std::exchange(m_isReaderWoken, true);
    }
    // Removes and returns the next message of this connection, and removes those of earlier ones. Without one
    // the reader has to be woken again.
    std::optional<Arrival> take(int connection)
    {
        const std::scoped_lock lock(m_mutex);
        if (m_barrier == connection && connection != 0)
            return Arrival{std::exchange(m_barrier, 0), {}, {}};
        for (std::deque<Arrival>* queue : {&m_others, &m_commands}) {
            while (!queue->empty() && queue->front().connection <= connection) {
                Arrival next = std::move(queue->front());
                queue->pop_front();
                m_bytes -= sizeOf(next);
                if (next.connection == connection)
                    return next;
            }
        }
        m_isReaderWoken = false;
        return {};
    }
    // Returns how many were dropped since the last call.
    qint64 takeDropped()
    {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_dropped, 0);
    }
    [[nodiscard]] qsizetype messages() const
    {
        const std::scoped_lock lock(m_mutex);
        return count(m_others) + count(m_commands);
    }
    [[nodiscard]] qsizetype bytes() const
    {
        const std::scoped_lock lock(m_mutex);
        return m_bytes;
    }

private:
    [[nodiscard]] static qsizetype sizeOf(const Arrival& arrival)
    {
        return arrival.bytes.size() + qsizetype(sizeof(QChar)) * arrival.topic.size();
    }
    [[nodiscard]] static qsizetype count(const std::deque<Arrival>& queue)
    {
        return static_cast<qsizetype>(queue.size());
    }

    mutable std::mutex m_mutex;
    std::deque<Arrival> m_others;
    std::deque<Arrival> m_commands;
    qsizetype m_bytes = 0;
    int m_barrier = 0; // the connection whose broker has answered one; 0: none
    qint64 m_dropped = 0;
    bool m_isReaderWoken = false;
};

} // namespace campanel::gateway
