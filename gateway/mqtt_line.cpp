// SPDX-License-Identifier: Apache-2.0
#include "gateway/mqtt_line.h"

#include "app/plant/local_messages.h"
#include "gateway/bdseq_store.h"

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QTimer>

#include <algorithm>
#include <cerrno>
#include <utility>

#include <mosquitto.h>
#include <poll.h>
#include <sys/socket.h>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

namespace {

constexpr int loopMs = 100;
constexpr int maxMessagesAtOnce = 100;
constexpr int restStepMs = 50;
constexpr int maxGoodbyeRounds = 100;

// Returns true for what is only said live: no broker keeps commands, births and data. A kept one is forged.
bool isNeverRetained(const QString& topic)
{
    return Arrivals::isCommand(topic) ||
           (topic.startsWith(u"spBv1.0/") && !topic.startsWith(u"spBv1.0/STATE/"));
}

} // namespace

MqttLine::MqttLine(GatewaySettings settings, QString clientId, QString bdSeqFile)
    : m_settings(std::move(settings))
    , m_bdSeqFile(std::move(bdSeqFile))
{
    mosquitto_lib_init();
    m_client = mosquitto_new(clientId.toUtf8().constData(), true, this);
    mosquitto_threaded_set(m_client, true);
    if (!m_settings.user.isEmpty())
        mosquitto_username_pw_set(m_client, m_settings.user.toUtf8().constData(),
                                  m_settings.password.toUtf8().constData());
    mosquitto_connect_callback_set(m_client, &MqttLine::onConnect);
    mosquitto_message_callback_set(m_client, &MqttLine::onMessage);
    mosquitto_unsubscribe_callback_set(m_client, &MqttLine::onBarrier);
    mosquitto_log_callback_set(m_client, &MqttLine::onLog);
    connect(
        this, &MqttLine::closed, this, [this] { m_known = 0; }, Qt::QueuedConnection);
}

MqttLine::~MqttLine()
{
    m_isEnding = true;
    if (m_thread) {
        m_thread->wait();
        delete m_thread;
    }
    mosquitto_destroy(m_client);
    mosquitto_lib_cleanup();
}

void MqttLine::start(Death death)
{
    m_death = std::move(death);
    m_thread = QThread::create([this] { run(); });
    m_thread->start();
}

bool MqttLine::stop(int limitMs)
{
    m_isEnding = true;
    return !m_thread || m_thread->wait(static_cast<unsigned long>(limitMs));
}

// In the main thread ----------------------------------------------------------------------------------------

void MqttLine::publish(const Publication& publication)
{
    if (isServing())
        mosquitto_publish(m_client, nullptr, publication.topic.toUtf8().constData(),
                          static_cast<int>(publication.payload.size()), publication.payload.constData(),
                          publication.qos, false);
}

void MqttLine::subscribe(const QString& topic)
{
    if (isServing())
        mosquitto_subscribe(m_client, nullptr, topic.toUtf8().constData(), 1);
}

// A broker must answer, even for a topic without a subscription, and it answers in the order of the packets.
void MqttLine::requestBarrier()
{
    if (isServing())
        mosquitto_unsubscribe(m_client, nullptr, "campanel/barrier");
}

void MqttLine::leave(int pauseMs)
{
    m_leavePauseMs = pauseMs;
}

void MqttLine::drop()
{
    m_isDropWanted = true;
}

void MqttLine::deliver()
{
    for (int i = 0; i < maxMessagesAtOnce; ++i) {
        const auto arrival = m_arrivals.take(m_known);
        if (const qint64 dropped = m_arrivals.takeDropped(); dropped > 0)
            emit leftOut(dropped);
        if (!arrival)
            return;
        if (arrival->topic.isEmpty())
            emit barrierPassed();
        else
            emit received(arrival->topic, arrival->bytes);
    }
    QTimer::singleShot(0, this, &MqttLine::deliver);
}

// In the thread of the connection ---------------------------------------------------------------------------

void MqttLine::run()
{
    BdSeqStore numbers(m_bdSeqFile);
    bool isNumberUsed = true;
    while (!m_isEnding) {
        if (isNumberUsed) // not written again for each attempt
            m_bdSeq = numbers.take();
        m_refusal.clear();
        m_isAccepted = false;
        m_isAnswered = false;
        m_isDropWanted = false;
        m_leavePauseMs = -1;
        const QString reason = serve();
        isNumberUsed = m_isAccepted;
        m_connection = 0;
        emit closed(reason);
        if (!m_isEnding)
            rest();
    }
}

QString MqttLine::serve()
{
    if (m_settings.isEncrypted()) {
        const auto pathOf = [](const QByteArray& path) {
            return path.isEmpty() ? nullptr : path.constData();
        };
        const QByteArray ca = m_settings.ca.toUtf8();
        const QByteArray certificate = m_settings.certificate.toUtf8();
        const QByteArray key = m_settings.key.toUtf8();
        if (mosquitto_tls_set(m_client, pathOf(ca), nullptr, pathOf(certificate), pathOf(key), nullptr) !=
            MOSQ_ERR_SUCCESS)
            return u"The certificates cannot be read."_s;
    }
    if (m_death) {
        const Publication death = m_death(m_bdSeq);
        mosquitto_will_set(m_client, death.topic.toUtf8().constData(), static_cast<int>(death.payload.size()),
                           death.payload.constData(), death.qos, false);
    }
    bool isGoodbyeSaid = false;
    QElapsedTimer since;
    since.start();
    int code = mosquitto_connect(m_client, m_settings.host.toUtf8().constData(), m_settings.port, keepAliveS);
    while (code == MOSQ_ERR_SUCCESS) {
        if (m_leavePauseMs >= 0 && m_isAccepted && !std::exchange(isGoodbyeSaid, true))
            sayGoodbye();
        const bool isLate = !m_isAccepted && since.elapsed() > connectLimitMs;
        if (m_isDropWanted || isLate || (m_isEnding && !m_isAccepted))
            ::shutdown(mosquitto_socket(m_client), SHUT_RDWR);
        code = mosquitto_loop(m_client, loopMs, 1);
    }
    m_lifeMs = since.elapsed();
    if (m_leavePauseMs >= 0)
        return u"Left the broker."_s;
    if (!m_refusal.isEmpty())
        return m_refusal;
    const QString why =
        code == MOSQ_ERR_ERRNO ? qt_error_string(errno) : QString::fromUtf8(mosquitto_strerror(code));
    return (m_isAccepted ? u"The connection to the broker is lost: %1"_s
                         : u"No connection to the broker: %1"_s)
        .arg(why);
}

// Handles what the broker has sent before it disconnects: a connection that is closed with unread bytes is
// reset, and a broker that finds it reset may take the goodbye for a failure and send the death of the node.
void MqttLine::sayGoodbye()
{
    for (int round = 0; round < maxGoodbyeRounds; ++round) {
        pollfd socket{mosquitto_socket(m_client), POLLIN, 0};
        if (!mosquitto_want_write(m_client) && ::poll(&socket, 1, loopMs) == 0)
            break;
        if (mosquitto_loop(m_client, 0, 1) != MOSQ_ERR_SUCCESS)
            return;
    }
    mosquitto_disconnect(m_client);
}

// Waits before the next attempt: longer after each failure, and not at the same time as other gateways.
void MqttLine::rest()
{
    if (m_isAccepted && m_lifeMs >= goodLifeMs)
        m_backOff.reset();
    const int longest = m_backOff.next(m_isAnswered ? maxAnsweredPauseMs : maxPauseMs);
    const int pause =
        std::max(m_leavePauseMs.load(), longest / 2 + QRandomGenerator::global()->bounded(longest / 2));
    for (int waited = 0; waited < pause && !m_isEnding; waited += restStepMs)
        QThread::msleep(restStepMs);
}

void MqttLine::wake()
{
    QMetaObject::invokeMethod(this, &MqttLine::deliver, Qt::QueuedConnection);
}

void MqttLine::onConnect(mosquitto*, void* line, int code)
{
    auto* self = static_cast<MqttLine*>(line);
    self->m_isAnswered = true;
    if (code != 0) {
        self->m_refusal =
            u"The broker refuses the connection: %1"_s.arg(QString::fromUtf8(mosquitto_connack_string(code)));
        return;
    }
    self->m_isAccepted = true;
    const int connection = ++self->m_connections;
    self->m_connection = connection;
    QMetaObject::invokeMethod(
        self,
        [self, connection, bdSeq = self->m_bdSeq] {
            self->m_known = connection;
            emit self->opened(bdSeq);
            self->deliver();
        },
        Qt::QueuedConnection);
}

void MqttLine::onMessage(mosquitto*, void* line, const mosquitto_message* message)
{
    auto* self = static_cast<MqttLine*>(line);
    const QString topic = QString::fromUtf8(message->topic);
    if (message->retain && isNeverRetained(topic))
        return;
    const auto size = std::min<qsizetype>(message->payloadlen, plant::maxOfferBytes + 1);
    if (self->m_arrivals.add(
            {self->m_connection, topic, QByteArray(static_cast<const char*>(message->payload), size)}))
        self->wake();
}

void MqttLine::onBarrier(mosquitto*, void* line, int)
{
    auto* self = static_cast<MqttLine*>(line);
    if (self->m_arrivals.add({self->m_connection, {}, {}}))
        self->wake();
}

void MqttLine::onLog(mosquitto*, void* line, int level, const char* text)
{
    if (level == MOSQ_LOG_ERR)
        static_cast<MqttLine*>(line)->m_refusal =
            u"No connection to the broker: %1"_s.arg(QString::fromUtf8(text).simplified());
}

} // namespace campanel::gateway
