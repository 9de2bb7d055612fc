// SPDX-License-Identifier: Apache-2.0
// Sparkplug payloads from the network: any bytes are a payload or none, and a payload that is written again
// is read the same.
#include "gateway/payload.h"
#include "tests/fuzz/fuzz_target.h"

#include <QVariant>

namespace campanel::fuzz {

void runTarget(std::span<const std::uint8_t> bytes)
{
    const QByteArray raw(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    const auto payload = gateway::decodedPayload(raw);
    if (!payload)
        return;
    const QByteArray written = gateway::encodedPayload(*payload);
    const auto back = gateway::decodedPayload(written);
    require(back || written.size() > gateway::maxPayloadBytes, "a payload that was written is read");
    if (back)
        require(gateway::encodedPayload(*back) == written, "a payload comes back as it was written");
}

std::vector<Bytes> targetSeeds()
{
    const gateway::Payload payload{
        1'790'000'000'000,
        17,
        {{.name = QStringLiteral("Status/MachSpeed"),
          .alias = 3,
          .timestampMs = 1,
          .type = 10,
          .value = 60.25,
          .unit = QStringLiteral("bags/min")},
         {.name = QStringLiteral("n"),
          .timestampMs = 2,
          .type = 3,
          .value = std::int64_t(-5),
          .isHistorical = true},
         {.alias = 1, .timestampMs = 2, .type = 4, .value = std::int64_t(255)},
         {.name = QStringLiteral("t"), .timestampMs = 2, .type = 11, .value = true},
         {.name = QStringLiteral("Node Control/Rebirth"),
          .timestampMs = 2,
          .type = 12,
          .value = QStringLiteral("x")}}};
    std::vector<Bytes> seeds;
    const QByteArray whole = gateway::encodedPayload(payload);
    seeds.push_back(bytesOf({whole.constData(), static_cast<std::size_t>(whole.size())}));
    for (const gateway::PayloadMetric& metric : payload.metrics) {
        const QByteArray one = gateway::encodedPayload({1, {}, {metric}});
        seeds.push_back(bytesOf({one.constData(), static_cast<std::size_t>(one.size())}));
    }
    return seeds;
}

} // namespace campanel::fuzz
