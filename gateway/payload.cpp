// SPDX-License-Identifier: Apache-2.0
#include "gateway/payload.h"

#include "sparkplug_payload.pb-c.h"

#include <deque>
#include <memory>
#include <string_view>
#include <vector>

namespace campanel::gateway {

namespace {

using WirePayload = Campanel__Sparkplug__Payload;
using WireMetric = Campanel__Sparkplug__Metric;
using WireProperties = Campanel__Sparkplug__PropertySet;
using WireProperty = Campanel__Sparkplug__PropertyValue;

constexpr std::uint32_t stringType = static_cast<std::uint32_t>(plant::MetricType::String);

// The structures of one message, which point to one another. They stay where they are.
class Writer {
public:
    QByteArray bytesOf(const Payload& payload)
    {
        WirePayload wire = CAMPANEL__SPARKPLUG__PAYLOAD__INIT;
        wire.has_timestamp = 1;
        wire.timestamp = static_cast<std::uint64_t>(payload.timestampMs);
        wire.has_seq = payload.seq.has_value();
        wire.seq = static_cast<std::uint64_t>(payload.seq.value_or(0));
        std::vector<WireMetric*> metrics;
        for (const PayloadMetric& metric : payload.metrics)
            metrics.push_back(&add(metric));
        wire.n_metrics = metrics.size();
        wire.metrics = metrics.data();
        QByteArray bytes(static_cast<qsizetype>(campanel__sparkplug__payload__get_packed_size(&wire)),
                         Qt::Uninitialized);
        campanel__sparkplug__payload__pack(&wire, reinterpret_cast<std::uint8_t*>(bytes.data()));
        return bytes;
    }

private:
    struct Properties {
        WireProperty value = CAMPANEL__SPARKPLUG__PROPERTY_VALUE__INIT;
        WireProperty* values = &value;
        QByteArray key = "engUnit";
        char* keys = key.data();
        WireProperties set = CAMPANEL__SPARKPLUG__PROPERTY_SET__INIT;
    };

    char* text(const QString& text)
    {
        m_texts.push_back(text.toUtf8());
        return m_texts.back().data();
    }

    WireMetric& add(const PayloadMetric& metric)
    {
        WireMetric& wire = m_metrics.emplace_back();
        campanel__sparkplug__metric__init(&wire);
        if (!metric.name.isEmpty())
            wire.name = text(metric.name);
        wire.has_alias = metric.alias.has_value();
        wire.alias = metric.alias.value_or(0);
        wire.has_timestamp = 1;
        wire.timestamp = static_cast<std::uint64_t>(metric.timestampMs);
        wire.has_datatype = 1; // in data too, which widespread hosts need
        wire.datatype = metric.type;
        wire.has_is_historical = metric.isHistorical;
        wire.is_historical = metric.isHistorical;
        setValue(wire, metric);
        if (!metric.unit.isEmpty()) {
            Properties& properties = m_properties.emplace_back();
            properties.value.has_type = 1;
            properties.value.type = stringType;
            properties.value.string_value = text(metric.unit);
            properties.set.n_keys = 1;
            properties.set.keys = &properties.keys;
            properties.set.n_values = 1;
            properties.set.values = &properties.values;
            wire.properties = &properties.set;
        }
        return wire;
    }

    void setValue(WireMetric& wire, const PayloadMetric& metric)
    {
        if (const auto* truth = std::get_if<bool>(&metric.value)) {
            wire.has_boolean_value = 1;
            wire.boolean_value = *truth;
        } else if (const auto* whole = std::get_if<std::int64_t>(&metric.value)) {
            const bool isLong = metric.type == static_cast<std::uint32_t>(plant::MetricType::Int64) ||
                                metric.type == sparkplugUInt64;
            wire.has_long_value = isLong;
            wire.has_int_value = !isLong;
            if (isLong)
                wire.long_value = static_cast<std::uint64_t>(*whole);
            else
                wire.int_value = static_cast<std::uint32_t>(*whole);
        } else if (const auto* real = std::get_if<double>(&metric.value)) {
            wire.has_double_value = 1;
            wire.double_value = *real;
        } else if (const auto* words = std::get_if<QString>(&metric.value)) {
            wire.string_value = text(*words);
        } else {
            wire.has_is_null = 1;
            wire.is_null = 1;
        }
    }

    std::deque<QByteArray> m_texts;
    std::deque<WireMetric> m_metrics;
    std::deque<Properties> m_properties;
};

// Returns the data type; a metric with an alias alone has that of the table.
std::uint32_t typeOf(const WireMetric& wire)
{
    if (wire.has_datatype)
        return wire.datatype;
    const bool isOurs = wire.has_alias && wire.alias >= 1 && wire.alias <= plant::metricCount;
    return isOurs ? static_cast<std::uint32_t>(plant::metricTable[wire.alias - 1].type) : 0;
}

plant::MetricValue valueOf(const WireMetric& wire)
{
    if (wire.has_is_null && wire.is_null)
        return {};
    if (wire.has_boolean_value)
        return wire.boolean_value != 0;
    if (wire.has_int_value) {
        const bool isUnsigned = typeOf(wire) == sparkplugUInt32;
        return isUnsigned ? std::int64_t(wire.int_value)
                          : std::int64_t(static_cast<std::int32_t>(wire.int_value));
    }
    if (wire.has_long_value)
        return static_cast<std::int64_t>(wire.long_value);
    if (wire.has_float_value)
        return static_cast<double>(wire.float_value);
    if (wire.has_double_value)
        return wire.double_value;
    if (wire.string_value)
        return QString::fromUtf8(wire.string_value);
    return {};
}

QString unitOf(const WireMetric& wire)
{
    const WireProperties* set = wire.properties;
    for (std::size_t i = 0; set && i < set->n_keys && i < set->n_values; ++i) {
        if (std::string_view(set->keys[i]) == "engUnit" && set->values[i]->string_value)
            return QString::fromUtf8(set->values[i]->string_value);
    }
    return {};
}

} // namespace

QByteArray encodedPayload(const Payload& payload)
{
    return Writer().bytesOf(payload);
}

std::optional<Payload> decodedPayload(const QByteArray& bytes)
{
    if (bytes.size() > maxPayloadBytes)
        return {};
    const auto release = [](WirePayload* wire) {
        campanel__sparkplug__payload__free_unpacked(wire, nullptr);
    };
    const std::unique_ptr<WirePayload, decltype(release)> wire(
        campanel__sparkplug__payload__unpack(nullptr, static_cast<std::size_t>(bytes.size()),
                                             reinterpret_cast<const std::uint8_t*>(bytes.constData())),
        release);
    if (!wire)
        return {};
    Payload payload{static_cast<std::int64_t>(wire->timestamp), {}, {}};
    if (wire->has_seq)
        payload.seq = static_cast<int>(wire->seq & 0xFF);
    for (std::size_t i = 0; i < wire->n_metrics; ++i) {
        const WireMetric& metric = *wire->metrics[i];
        PayloadMetric read;
        if (metric.name)
            read.name = QString::fromUtf8(metric.name);
        if (metric.has_alias)
            read.alias = metric.alias;
        read.timestampMs = static_cast<std::int64_t>(metric.timestamp);
        read.type = typeOf(metric);
        read.value = valueOf(metric);
        read.unit = unitOf(metric);
        read.isHistorical = metric.has_is_historical && metric.is_historical;
        payload.metrics << read;
    }
    return payload;
}

} // namespace campanel::gateway
