// SPDX-License-Identifier: Apache-2.0
// Messages on the local socket between panel and gateway: a stream of any bytes in any pieces.
#include "app/plant/local_messages.h"
#include "tests/fuzz/fuzz_target.h"

namespace campanel::fuzz {

void runTarget(std::span<const std::uint8_t> bytes)
{
    InputReader input(bytes);
    const std::size_t piece = 1u + input.byte();
    plant::LocalReader reader;
    while (!input.isAtEnd() && !reader.error()) {
        const auto part = input.take(piece);
        reader.add(
            QByteArray(reinterpret_cast<const char*>(part.data()), static_cast<qsizetype>(part.size())));
        while (const auto message = reader.next()) {
            require(!reader.error(), "a reader gives a message or an error");
            plant::LocalReader again;
            again.add(plant::encoded(*message));
            require(again.next().has_value(), "a message that was written is read");
        }
    }
}

std::vector<Bytes> targetSeeds()
{
    const plant::LocalMessage command =
        plant::CommandMessage{QStringLiteral("Node Control/Rebirth"), QStringLiteral("true")};
    const plant::LocalMessage values = plant::ValueMessage{{{plant::Metric{0}, QStringLiteral("running"), 5},
                                                            {plant::Metric{2}, 60.25, 0},
                                                            {plant::Metric{1}, {}, 0}}};
    std::vector<Bytes> seeds;
    for (const QByteArray& stream : {plant::encoded(command), plant::encoded(values),
                                     plant::encoded(values) + plant::encoded(command)}) {
        Bytes seed{40};
        seed.insert(seed.end(), stream.begin(), stream.end());
        seeds.push_back(seed);
    }
    return seeds;
}

} // namespace campanel::fuzz
