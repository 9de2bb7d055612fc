// SPDX-License-Identifier: Apache-2.0
// The gateway's end of the local socket. It connects to the panel again and again.
#pragma once

#include "app/plant/local_messages.h"

#include <QLocalSocket>
#include <QObject>
#include <QTimer>

namespace campanel::gateway {

class PanelLine : public QObject {
    Q_OBJECT

public:
    explicit PanelLine(QString path);

    void start();
    // Connects anew: the panel sends all values then.
    void renew();
    // Sends a refused command or an offer. Returns false without a connection, and while too much waits.
    bool send(const plant::LocalMessage& message);

signals:
    // Emitted when the panel can be sent to.
    void connected();
    void received(const campanel::plant::ValueMessage& message);
    // Emitted when an existing connection has ended.
    void lost();
    void reported(const QString& sentence);

private:
    void read();
    void end();
    void fail(plant::LocalError error);

    QString m_path;
    QTimer m_retryTimer{this};
    QLocalSocket m_socket{this}; // goes first: it may still report its end
    plant::LocalReader m_reader;
    bool m_isConnected = false;
    bool m_hasFailed = false; // since the last message; said once
};

} // namespace campanel::gateway
