// SPDX-License-Identifier: Apache-2.0
#include "gateway/panel_line.h"

#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::gateway {

namespace {

constexpr auto retryPause = 300ms;
// The bytes that may wait for the panel before one more message: it may be a large offer.
constexpr qint64 maxWaitingBytes = 64 * 1024;

} // namespace

PanelLine::PanelLine(QString path)
    : m_path(std::move(path))
{
    m_retryTimer.setSingleShot(true);
    m_retryTimer.setInterval(retryPause);
    connect(&m_retryTimer, &QTimer::timeout, this, &PanelLine::start);
    connect(&m_socket, &QLocalSocket::connected, this, [this] {
        m_isConnected = true;
        emit connected();
    });
    connect(&m_socket, &QLocalSocket::readyRead, this, &PanelLine::read);
    connect(&m_socket, &QLocalSocket::disconnected, this, &PanelLine::end);
    connect(&m_socket, &QLocalSocket::errorOccurred, this, &PanelLine::end);
}

void PanelLine::start()
{
    m_reader = {};
    m_socket.abort();
    m_socket.connectToServer(m_path);
}

void PanelLine::renew()
{
    m_isConnected = false; // the loss is known
    m_socket.abort();
    m_retryTimer.start();
}

bool PanelLine::send(const plant::LocalMessage& message)
{
    if (!m_isConnected || m_socket.bytesToWrite() >= maxWaitingBytes)
        return false;
    m_socket.write(plant::encoded(message));
    return true;
}

void PanelLine::read()
{
    m_reader.add(m_socket.readAll());
    while (const auto message = m_reader.next()) {
        m_hasFailed = false;
        if (const auto* values = std::get_if<plant::ValueMessage>(&*message))
            emit received(*values);
    }
    if (const auto error = m_reader.error())
        fail(*error);
}

void PanelLine::fail(plant::LocalError error)
{
    if (!std::exchange(m_hasFailed, true))
        emit reported(error == plant::LocalError::OtherVersion
                          ? u"The panel is of another version. Restart panel and gateway."_s
                          : u"The panel sends what is not understood."_s);
    m_socket.abort();
}

void PanelLine::end()
{
    if (std::exchange(m_isConnected, false))
        emit lost();
    m_retryTimer.start();
}

} // namespace campanel::gateway
