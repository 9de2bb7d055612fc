// SPDX-License-Identifier: Apache-2.0
#include "app/panel/plant/plant_server.h"

#include <QLocalSocket>

#include <algorithm>

namespace campanel::panel {

PlantServer::PlantServer(QObject* parent)
    : QObject(parent)
{
    m_server.setSocketOptions(QLocalServer::UserAccessOption | QLocalServer::GroupAccessOption);
    connect(&m_server, &QLocalServer::newConnection, this, &PlantServer::accept);
}

PlantServer::~PlantServer()
{
    for (const Client& client : m_clients)
        client.socket->disconnect(this);
}

QString PlantServer::listen(const QString& path)
{
    QLocalServer::removeServer(path); // of a panel that was killed
    return m_server.listen(path) ? QString() : m_server.errorString();
}

void PlantServer::accept()
{
    while (QLocalSocket* socket = m_server.nextPendingConnection()) {
        if (m_clients.size() >= maxClients) {
            socket->abort();
            socket->deleteLater();
            continue;
        }
        socket->setParent(this);
        socket->setReadBufferSize(2 * plant::maxMessageBytes);
        m_clients.push_back({socket, {}});
        connect(socket, &QLocalSocket::readyRead, this, [this, socket] { read(socket); });
        connect(socket, &QLocalSocket::disconnected, this, [this, socket] { remove(socket); });
        emit clientConnected();
    }
}

void PlantServer::send(const plant::ValueMessage& message)
{
    const QByteArray bytes = plant::encoded(message);
    std::vector<QLocalSocket*> stuck;
    for (const Client& client : m_clients) {
        if (client.socket->bytesToWrite() > maxWaitingBytes)
            stuck.push_back(client.socket);
        else
            client.socket->write(bytes);
    }
    for (QLocalSocket* socket : stuck)
        socket->abort();
}

void PlantServer::read(QLocalSocket* socket)
{
    const auto client = std::ranges::find(m_clients, socket, &Client::socket);
    if (client == m_clients.end())
        return;
    client->reader.add(socket->readAll());
    QList<plant::LocalMessage> messages;
    while (const auto message = client->reader.next())
        messages << *message;
    if (client->reader.error())
        socket->abort();
    for (const plant::LocalMessage& message : messages) {
        if (const auto* command = std::get_if<plant::CommandMessage>(&message))
            emit commandReceived(*command);
        else if (const auto* offer = std::get_if<plant::OfferMessage>(&message))
            emit offerReceived(*offer);
        else if (const auto* gateway = std::get_if<plant::GatewayMessage>(&message))
            emit gatewayChanged(gateway->version);
    }
}

void PlantServer::remove(QLocalSocket* socket)
{
    std::erase_if(m_clients, [socket](const Client& client) { return client.socket == socket; });
    socket->deleteLater();
    if (m_clients.empty())
        emit gatewayChanged({});
}

} // namespace campanel::panel
