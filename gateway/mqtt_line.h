// SPDX-License-Identifier: Apache-2.0
// The connection to the broker by libmosquitto, in a thread of its own that connects again and again. Calls
// come from the main thread, and so do the handlers of the signals.
#pragma once

#include "gateway/arrivals.h"
#include "gateway/back_off.h"
#include "gateway/broker.h"
#include "gateway/gateway_settings.h"

#include <QObject>
#include <QThread>

#include <atomic>
#include <functional>

struct mosquitto;
struct mosquitto_message;

namespace campanel::gateway {

class MqttLine : public QObject, public Broker {
    Q_OBJECT

public:
    // The last will for a connection with this number. Called in the thread of the connection.
    using Death = std::function<Publication(int bdSeq)>;

    // A broker that does not hear of the gateway for one and a half of it sends its death.
    static constexpr int keepAliveS = 10;
    static constexpr int connectLimitMs = 10'000;
    // The pauses between attempts: the first one, and the longest ones without an answer and with one. A
    // broker that answers and then ends the connection is there: it does not want this gateway.
    static constexpr int firstPauseMs = 2000;
    static constexpr int maxPauseMs = 8000;
    static constexpr int maxAnsweredPauseMs = 120'000;
    // A connection that lasts for this time is a success.
    static constexpr int goodLifeMs = 10'000;

    // Without a file the number of the connection is not kept.
    MqttLine(GatewaySettings settings, QString clientId, QString bdSeqFile = {});
    // Ends the thread. A connection that is being made can delay that.
    ~MqttLine() override;

    // An observer has no death.
    void start(Death death = {});
    // Returns true when the thread has ended in this time.
    [[nodiscard]] bool stop(int limitMs);

    void publish(const Publication& publication) override;
    void subscribe(const QString& topic) override;
    void requestBarrier() override;
    void leave(int pauseMs) override;
    void drop() override;

signals:
    void opened(int bdSeq);
    // Emitted at the end of each connection and each attempt, with the reason as a sentence.
    void closed(const QString& sentence);
    void received(const QString& topic, const QByteArray& bytes);
    void barrierPassed();
    // Emitted when more messages came than could wait.
    void leftOut(qint64 messages);

private:
    void run();
    // Connects once and serves until the end. Returns the reason.
    [[nodiscard]] QString serve();
    void sayGoodbye();
    void rest();
    // Handles some of what has arrived, so that the panel is heard in between.
    void deliver();
    void wake();
    // Returns true while what is sent belongs to the connection that the main thread knows.
    [[nodiscard]] bool isServing() const { return m_known != 0 && m_known == m_connection; }
    static void onConnect(mosquitto*, void* line, int code);
    static void onMessage(mosquitto*, void* line, const mosquitto_message* message);
    static void onBarrier(mosquitto*, void* line, int id);
    static void onLog(mosquitto*, void* line, int level, const char* text);

    GatewaySettings m_settings;
    QString m_bdSeqFile;
    Death m_death;
    mosquitto* m_client = nullptr;
    QThread* m_thread = nullptr;
    std::atomic<bool> m_isEnding{false};
    std::atomic<bool> m_isDropWanted{false};
    std::atomic<int> m_leavePauseMs{-1}; // -1: nobody has left
    std::atomic<int> m_connection{0};    // counts the connections; 0: there is none
    Arrivals m_arrivals;
    int m_known = 0; // of the main thread
    // Members that only the thread of the connection uses.
    int m_connections = 0;
    BackOff m_backOff{firstPauseMs};
    bool m_isAccepted = false;
    bool m_isAnswered = false; // accepted or refused
    qint64 m_lifeMs = 0;       // of the last connection or attempt
    int m_bdSeq = 0;
    QString m_refusal;
};

} // namespace campanel::gateway
