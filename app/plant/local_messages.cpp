// SPDX-License-Identifier: Apache-2.0
#include "app/plant/local_messages.h"

#include <QCborArray>
#include <QCborMap>
#include <QCborValue>
#include <QtEndian>

#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::plant {

namespace {

constexpr qsizetype lengthBytes = 4;

// The keys of the map.
enum Key : int { VersionKey = 0, ValuesKey = 1, CommandKey = 2, OfferKey = 3, GatewayKey = 4 };

QCborValue cborOf(const MetricValue& value)
{
    return std::visit(
        [](const auto& held) -> QCborValue {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, std::monostate>)
                return QCborValue(nullptr);
            else if constexpr (std::is_same_v<Held, QString>)
                return QCborValue(held.left(maxTextLength));
            else if constexpr (std::is_same_v<Held, std::int64_t>)
                return QCborValue(qint64(held));
            else
                return QCborValue(held);
        },
        value);
}

MetricValue valueOf(const QCborValue& value)
{
    if (value.isBool())
        return value.toBool();
    if (value.isInteger())
        return std::int64_t(value.toInteger());
    if (value.isDouble())
        return value.toDouble();
    if (value.isString())
        return value.toString().left(maxTextLength);
    return {};
}

// Returns the reading of [alias, value, age]; empty for another form. A value of another type is none.
std::optional<MetricReading> readingOf(const QCborValue& value)
{
    const QCborArray row = value.toArray();
    const qint64 alias = row.at(0).isInteger() ? row.at(0).toInteger() : 0;
    if (row.size() != 3 || alias < 1 || alias > qint64(metricCount) || !row.at(2).isInteger())
        return {};
    MetricReading reading{static_cast<Metric>(alias), valueOf(row.at(1)), row.at(2).toInteger()};
    if (!isOfType(reading.value, metricRow(reading.metric).type) || reading.ageMs < 0)
        return {};
    return reading;
}

std::optional<LocalMessage> messageOf(const QCborMap& map)
{
    const QCborValue values = map[int(ValuesKey)];
    if (values.isArray()) {
        ValueMessage message;
        for (const QCborValue& row : values.toArray()) {
            const auto reading = readingOf(row);
            if (!reading)
                return {};
            message.readings << *reading;
        }
        return message;
    }
    const QCborArray offer = map[int(OfferKey)].toArray();
    const qint64 kind = offer.at(2).toInteger(-1);
    if (offer.size() == 3 && offer.at(0).isString() && offer.at(1).isByteArray() && (kind == 0 || kind == 1))
        return OfferMessage{offer.at(0).toString().left(maxTextLength), offer.at(1).toByteArray(),
                            static_cast<OfferMessage::Kind>(kind)};
    if (map[int(GatewayKey)].isString())
        return GatewayMessage{map[int(GatewayKey)].toString().left(maxTextLength)};
    const QCborArray command = map[int(CommandKey)].toArray();
    if (command.size() != 2 || !command.at(0).isString() || !command.at(1).isString())
        return {};
    return CommandMessage{command.at(0).toString().left(maxTextLength),
                          command.at(1).toString().left(maxTextLength)};
}

} // namespace

QByteArray encoded(const LocalMessage& message)
{
    QCborMap map{{int(VersionKey), localVersion}};
    if (const auto* values = std::get_if<ValueMessage>(&message)) {
        QCborArray rows;
        for (const MetricReading& reading : values->readings)
            rows << QCborArray{int(reading.metric), cborOf(reading.value), qint64(reading.ageMs)};
        map.insert(int(ValuesKey), rows);
    } else if (const auto* command = std::get_if<CommandMessage>(&message)) {
        map.insert(int(CommandKey),
                   QCborArray{command->metric.left(maxTextLength), command->value.left(maxTextLength)});
    } else if (const auto* gateway = std::get_if<GatewayMessage>(&message)) {
        map.insert(int(GatewayKey), gateway->version.left(maxTextLength));
    } else {
        const auto& offer = std::get<OfferMessage>(message);
        map.insert(int(OfferKey),
                   QCborArray{offer.name.left(maxTextLength), offer.file.left(maxOfferBytes + 1),
                              static_cast<int>(offer.kind)});
    }
    const QByteArray body = map.toCborValue().toCbor();
    QByteArray bytes(lengthBytes, Qt::Uninitialized);
    qToBigEndian(static_cast<quint32>(body.size()), bytes.data());
    return bytes + body;
}

std::optional<LocalMessage> LocalReader::next()
{
    if (m_error || m_buffer.size() < lengthBytes)
        return {};
    const qsizetype length = qFromBigEndian<quint32>(m_buffer.constData());
    if (length > maxMessageBytes) {
        m_error = LocalError::TooLong;
        return {};
    }
    if (m_buffer.size() < lengthBytes + length)
        return {};
    QCborParserError parsed;
    const QCborMap map = QCborValue::fromCbor(m_buffer.sliced(lengthBytes, length), &parsed).toMap();
    m_buffer.remove(0, lengthBytes + length);
    if (parsed.error == QCborError::NoError && map.contains(int(VersionKey)) &&
        map[int(VersionKey)] != QCborValue(localVersion)) {
        m_error = LocalError::OtherVersion;
        return {};
    }
    const auto message =
        parsed.error == QCborError::NoError && map.contains(int(VersionKey)) ? messageOf(map) : std::nullopt;
    if (!message)
        m_error = LocalError::NotAMessage;
    return message;
}

} // namespace campanel::plant
