// SPDX-License-Identifier: Apache-2.0
// A Sparkplug B payload as a value, and its bytes. protobuf-c is used in payload.cpp only.
#pragma once

#include "app/plant/metric_value.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <cstdint>
#include <optional>

namespace campanel::gateway {

// The data types besides those of the metric table.
inline constexpr std::uint32_t sparkplugUInt32 = 7;
inline constexpr std::uint32_t sparkplugUInt64 = 8;
inline constexpr std::uint32_t sparkplugFloat = 9;

struct PayloadMetric {
    QString name = {}; // empty: the alias stands for it
    std::optional<std::uint64_t> alias{};
    std::int64_t timestampMs = 0; // since 1970 UTC
    std::uint32_t type = 0;       // of Sparkplug B
    plant::MetricValue value{};   // empty: null
    QString unit = {};            // property engUnit; empty: none
    bool isHistorical = false;

    bool operator==(const PayloadMetric&) const = default;
};

struct Payload {
    std::int64_t timestampMs = 0; // since 1970 UTC
    std::optional<int> seq{};     // 0 to 255; a death certificate has none
    QList<PayloadMetric> metrics{};

    bool operator==(const Payload&) const = default;
};

// The largest payload that is read. Commands have some hundred bytes.
inline constexpr qsizetype maxPayloadBytes = 64 * 1024;

[[nodiscard]] QByteArray encodedPayload(const Payload& payload);
// Returns empty for bytes that are no payload, and for more than maxPayloadBytes.
[[nodiscard]] std::optional<Payload> decodedPayload(const QByteArray& bytes);

} // namespace campanel::gateway
