// SPDX-License-Identifier: Apache-2.0
// The panel's end of the local socket. It sends to whoever is connected and waits for nobody: a gateway that
// does not read is disconnected.
#pragma once

#include "app/plant/local_messages.h"

#include <QLocalServer>
#include <QObject>

#include <vector>

class QLocalSocket;

namespace campanel::panel {

class PlantServer : public QObject {
    Q_OBJECT

public:
    // The gateway, and others that look at the values.
    static constexpr std::size_t maxClients = 4;
    // The bytes that may wait for a client: some minutes of values.
    static constexpr qint64 maxWaitingBytes = 512 * 1024;

    explicit PlantServer(QObject* parent);
    ~PlantServer() override;

    // Listens. The socket is open to the group of the panel. Returns the reason of the system when it is not
    // possible; empty: it listens.
    [[nodiscard]] QString listen(const QString& path);
    [[nodiscard]] bool hasClients() const { return !m_clients.empty(); }
    // Sends to all clients.
    void send(const plant::ValueMessage& message);

signals:
    // Emitted for a new client; it gets the next message that is sent.
    void clientConnected();
    void commandReceived(const campanel::plant::CommandMessage& command);
    void offerReceived(const campanel::plant::OfferMessage& offer);
    // Emitted with the version of a gateway that has told it; empty: the last client has left.
    void gatewayChanged(const QString& version);

private:
    struct Client {
        QLocalSocket* socket = nullptr; // a child
        plant::LocalReader reader;
    };

    void accept();
    void read(QLocalSocket* socket);
    void remove(QLocalSocket* socket);

    QLocalServer m_server{this};
    std::vector<Client> m_clients;
};

} // namespace campanel::panel
