// SPDX-License-Identifier: Apache-2.0
// The state of the Sparkplug primary host, as it says itself: spBv1.0/STATE/HOST with JSON since Sparkplug 3,
// STATE/HOST with one word before.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <cstdint>

namespace campanel::gateway {

class PrimaryHost {
public:
    enum class Change { None, Online, Offline };

    // An empty name: no host is waited for.
    explicit PrimaryHost(QString name)
        : m_name(std::move(name))
    {
    }

    [[nodiscard]] QStringList topics() const;
    [[nodiscard]] bool isOnline() const { return m_name.isEmpty() || m_isOnline; }
    // Forgets the state; a broker sends it again after each connection.
    void forget()
    {
        m_isOnline = false;
        m_timestampMs = 0;
    }
    // Takes a message of one of the topics. A message that is not understood, or that is older than the last
    // one, changes nothing.
    [[nodiscard]] Change take(const QString& topic, const QByteArray& bytes);

private:
    [[nodiscard]] Change set(bool isOnline);

    QString m_name;
    bool m_isOnline = false;
    bool m_isOfVersion3 = false; // it has spoken in this form, so the older one is not heard any more
    std::int64_t m_timestampMs = 0;
};

} // namespace campanel::gateway
