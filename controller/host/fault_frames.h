// SPDX-License-Identifier: Apache-2.0
// Modbus RTU frames, each corrupted in one way; pure functions except for the random numbers.
#pragma once

#include "fault_rules.h"

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace campanel::controller {

using FrameBytes = std::vector<std::uint8_t>;

// Returns a uniform number in 0 .. bound - 1; the same sequence with every standard library.
[[nodiscard]] std::size_t pickBelow(std::mt19937_64& random, std::size_t bound);
// Returns a uniform number in 0 .. 1, 1 excluded.
[[nodiscard]] double pickChance(std::mt19937_64& random);

[[nodiscard]] FrameBytes randomBytes(std::mt19937_64& random, std::size_t count);
// Truncates the frame: at least one byte is left, and at least one is missing.
[[nodiscard]] FrameBytes truncated(std::span<const std::uint8_t> frame, std::mt19937_64& random);
// Flips `bits` different bits so that the CRC-16 does not match by chance.
[[nodiscard]] FrameBytes corrupted(std::span<const std::uint8_t> frame, std::uint32_t bits,
                                   std::mt19937_64& random);
// Returns the frame as received at another baud rate: other bytes, and another number of them.
[[nodiscard]] FrameBytes garbled(std::span<const std::uint8_t> frame, std::mt19937_64& random);

// Return answers with a correct CRC-16 and another error.
[[nodiscard]] FrameBytes withWrongUnit(std::span<const std::uint8_t> answer, std::mt19937_64& random);
[[nodiscard]] FrameBytes withWrongFunction(std::span<const std::uint8_t> answer, std::mt19937_64& random);
// Changes a reading to one register more or less, or the count in the answer to a write.
[[nodiscard]] FrameBytes withWrongCount(std::span<const std::uint8_t> answer, std::mt19937_64& random);
[[nodiscard]] FrameBytes exceptionTo(std::span<const std::uint8_t> request, std::uint32_t code);

// Returns the answer of a controller with the rule's map version or device type, wherever the identity is
// read.
[[nodiscard]] FrameBytes withIdentity(std::span<const std::uint8_t> request,
                                      std::span<const std::uint8_t> answer, const FaultRule& rule);

// Returns a request of a second master to the same controller. Its answer is as long as the panel's own where
// that is harmless, but for other registers or with another tag.
[[nodiscard]] FrameBytes secondMasterRequest(std::span<const std::uint8_t> panelRequest,
                                             std::mt19937_64& random);

} // namespace campanel::controller
