// SPDX-License-Identifier: Apache-2.0
// Modbus RTU frames made wrong, each in one way; pure functions but for the random numbers.
#pragma once

#include "fault_rules.h"

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace campanel::controller {

using FrameBytes = std::vector<std::uint8_t>;

// Uniform in 0 .. bound - 1; the same numbers with every standard library.
[[nodiscard]] std::size_t pickBelow(std::mt19937_64& random, std::size_t bound);
// Uniform in 0 .. 1, 1 excluded.
[[nodiscard]] double pickChance(std::mt19937_64& random);

[[nodiscard]] FrameBytes randomBytes(std::mt19937_64& random, std::size_t count);
// At least one byte is left, and at least one is missing.
[[nodiscard]] FrameBytes truncated(std::span<const std::uint8_t> frame, std::mt19937_64& random);
// `bits` different bits flipped; flipped so that the CRC-16 does not fit by chance.
[[nodiscard]] FrameBytes corrupted(std::span<const std::uint8_t> frame, std::uint32_t bits,
                                   std::mt19937_64& random);
// As a receiver at another baud rate hears it: other bytes, another number of them.
[[nodiscard]] FrameBytes garbled(std::span<const std::uint8_t> frame, std::mt19937_64& random);

// Answers with a right CRC-16 that are wrong otherwise.
[[nodiscard]] FrameBytes withWrongUnit(std::span<const std::uint8_t> answer, std::mt19937_64& random);
[[nodiscard]] FrameBytes withWrongFunction(std::span<const std::uint8_t> answer, std::mt19937_64& random);
// A reading one register longer or shorter; of a write the count that it names.
[[nodiscard]] FrameBytes withWrongCount(std::span<const std::uint8_t> answer, std::mt19937_64& random);
[[nodiscard]] FrameBytes exceptionTo(std::span<const std::uint8_t> request, std::uint32_t code);

// The answer of a controller with the rule's map version or device type, wherever the identity is read.
[[nodiscard]] FrameBytes withIdentity(std::span<const std::uint8_t> request,
                                      std::span<const std::uint8_t> answer, const FaultRule& rule);

// What a second master asks of the same controller: an answer as long as the panel's own where that is
// harmless, of other registers or with a tag of its own.
[[nodiscard]] FrameBytes secondMasterRequest(std::span<const std::uint8_t> panelRequest,
                                             std::mt19937_64& random);

} // namespace campanel::controller
