// SPDX-License-Identifier: Apache-2.0
// The messages between the panel and the gateway on their local socket. Each one is a length of four bytes,
// big-endian, and a CBOR map with the version of the protocol. Both directions are bounded.
#pragma once

#include "app/plant/metric_value.h"

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QString>

#include <optional>
#include <utility>
#include <variant>

namespace campanel::plant {

// The version of the protocol and of the metric table; a peer with another one is not understood.
inline constexpr int localVersion = 4;
// The largest file of an offer, that of all recipe files. A larger one is cut after one byte more, so that
// the panel can name the fault.
inline constexpr qsizetype maxOfferBytes = 1'000'000;
// The offers of each kind that the gateway passes on.
inline constexpr qsizetype maxOffers = 16;
// The largest message, without its length.
inline constexpr qsizetype maxMessageBytes = maxOfferBytes + 4096;
// The longest text of a value or a name; a longer one is cut.
inline constexpr qsizetype maxTextLength = 256;
// The panel repeats an empty message at this period, which says that all its values still hold.
inline constexpr int alivePeriodMs = 500;

// From the panel: the values that have changed, all of them in the first message.
struct ValueMessage {
    QList<MetricReading> readings;

    bool operator==(const ValueMessage&) const = default;
};

// From the gateway: somebody on the network has sent a command. It was not carried out.
struct CommandMessage {
    QString metric;
    QString value;

    bool operator==(const CommandMessage&) const = default;
};

// From the gateway: the file of a recipe or an order that the plant offers. Nothing is taken until a person
// accepts it.
struct OfferMessage {
    enum class Kind { Recipe, Order };
    QString name;    // of the offer; empty: all offers of the kind so far are withdrawn
    QByteArray file; // empty: the offer is withdrawn
    Kind kind = Kind::Recipe;

    bool operator==(const OfferMessage&) const = default;
};

// Applies the message to the offers of its kind that were received before: their files by their names, at
// most maxOffers.
template <typename File> void applyOffer(QMap<QString, File>& offers, const OfferMessage& offer, File file)
{
    if (offer.name.isEmpty())
        offers.clear();
    else if (offer.file.isEmpty())
        offers.remove(offer.name);
    else if (offers.contains(offer.name) || offers.size() < maxOffers)
        offers.insert(offer.name, std::move(file));
}

// From the gateway, once: the version of its program.
struct GatewayMessage {
    QString version;

    bool operator==(const GatewayMessage&) const = default;
};

using LocalMessage = std::variant<ValueMessage, CommandMessage, OfferMessage, GatewayMessage>;

// Returns the message with its length.
[[nodiscard]] QByteArray encoded(const LocalMessage& message);

enum class LocalError {
    TooLong,      // longer than maxMessageBytes
    NotAMessage,  // no CBOR, or not of the form of a message
    OtherVersion, // written by another version of the program
};

// Cuts a stream of bytes into messages.
class LocalReader {
public:
    // Adds received bytes. After an error the connection is of no further use.
    void add(const QByteArray& bytes) { m_buffer += bytes; }
    // Returns the next whole message; empty: more bytes are needed, or there is an error.
    [[nodiscard]] std::optional<LocalMessage> next();
    [[nodiscard]] std::optional<LocalError> error() const { return m_error; }

private:
    QByteArray m_buffer;
    std::optional<LocalError> m_error;
};

} // namespace campanel::plant
